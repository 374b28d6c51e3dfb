"""Cells in memory draw what a .vtu with the same contents draws."""
import gc
import weakref

import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Bricks, Sheet, same

SURFACES = ["boundary", "slice:0.1,0,0.2:0,0.3,1", "isosurface:p=0.2", "sphere"]


@pytest.fixture
def bricks():
    return Bricks()


def data(bricks, **changes):
    return {"point_data": {"U": bricks.u, "p": bricks.p, **changes}}


def of_one_kind(cells, count):
    return numpy.arange(0, cells.size + 1, cells.shape[1]), cells.reshape(-1)


@pytest.mark.parametrize("surface", SURFACES)
def test_cells_of_one_kind(bricks, tmp_path, surface):
    for cells, kind in ((bricks.hexahedra, 12), (bricks.tetrahedra, 10)):
        file = bricks.write(tmp_path / f"{kind}.vtu", of_one_kind(cells, len(cells)), numpy.full(len(cells), kind))
        volume = aeolic.Volume(bricks.points, cells, **data(bricks))
        for color_by in (None, "p", "U:mag"):
            assert same(aeolic.render(surface, field=volume, color_by=color_by, **SMALL),
                        aeolic.render(surface, field=file, color_by=color_by, **SMALL)), (kind, color_by)


def test_wedges_and_pyramids_are_told_by_their_corners():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]]
    wedge = aeolic.Volume(points, [[0, 1, 2, 3, 4, 5]], point_data={"U": numpy.ones((6, 3))})
    assert wedge._memory["types"].tolist() == [13]
    assert aeolic.Renderer("boundary", field=wedge, **SMALL).info["triangles"] >= 8
    pyramid = aeolic.Volume(points, [[0, 1, 4, 3, 5]], point_data={"U": numpy.ones((6, 3))})
    assert pyramid._memory["types"].tolist() == [14]


@pytest.mark.parametrize("surface", SURFACES)
def test_cells_of_several_kinds(bricks, tmp_path, surface):
    cells, types = bricks.mixed()
    file = bricks.write(tmp_path / "mixed.vtu", cells, types)
    drawn = aeolic.render(surface, field=aeolic.Volume(bricks.points, cells, types, **data(bricks)), color_by="p", **SMALL)
    assert same(drawn, aeolic.render(surface, field=file, color_by="p", **SMALL))


def test_a_polyhedron_is_a_stream_of_faces():
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], "f8")
    faces = [6] + sum(([4, *face] for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                                               (3, 0, 4, 7))), [])
    u = numpy.stack([1 + corners[:, 1], corners[:, 0], corners[:, 2]], -1)
    cut = "slice:0.5,0.5,0.4:0,0.1,1"
    brick = aeolic.Volume(corners, [list(range(8))], point_data={"U": u})
    polyhedron = aeolic.Volume(corners, ([0, 8], list(range(8))), 42, faces=(faces, [0]), point_data={"U": u})
    assert numpy.asarray(aeolic.render(cut, field=polyhedron, **SMALL)).std() > 5
    assert aeolic.Renderer("boundary", field=polyhedron, **SMALL).info["triangles"] == \
        aeolic.Renderer("boundary", field=brick, **SMALL).info["triangles"]


def test_arrays_may_lie_as_they_like(bricks):
    cells, types = bricks.mixed()
    plain = aeolic.render("sphere", field=aeolic.Volume(bricks.points, cells, types, **data(bricks)), **SMALL)
    padded = numpy.full((len(bricks.points), 5), numpy.nan, "f4")
    padded[:, 1:4] = bricks.points
    for name, points, kinds, u in (
            ("float64", bricks.points.astype("f8"), types.astype("i8"), bricks.u.astype("f8")),
            ("gaps", padded[:, 1:4], types.astype("u4"), numpy.asfortranarray(bricks.u)),
            ("lists", bricks.points.tolist(), types.tolist(), bricks.u.tolist()),
            ("big-endian", bricks.points.astype(">f4"), types.astype(">i4"), bricks.u.astype(">f8"))):
        volume = aeolic.Volume(points, tuple(row.astype("i2") for row in cells), kinds, **data(bricks, U=u))
        assert same(aeolic.render("sphere", field=volume, **SMALL), plain), name


def test_contiguous_arrays_are_not_copied_and_go_with_the_call(bricks):
    cells, types = bricks.mixed()
    volume = aeolic.Volume(bricks.points, cells, types, **data(bricks))
    memory = volume._memory
    for kept, given in ((memory["points"], bricks.points), (memory["connectivity"], cells[1]), (memory["types"], types),
                        (memory["point_data"][0][1], bricks.u)):
        assert numpy.shares_memory(kept, given)
    table = aeolic.Volume(bricks.points, bricks.tetrahedra, **data(bricks))
    assert numpy.shares_memory(table._memory["connectivity"], bricks.tetrahedra)
    gone = weakref.ref(bricks.u)
    renderer = aeolic.Renderer("boundary", field=volume, **SMALL)
    before = renderer.render()
    bricks.u = None
    del volume, memory, table, kept, given
    gc.collect()
    assert gone() is None
    assert same(renderer.render(), before)


def test_new_values_between_frames(bricks):
    first = aeolic.Volume(bricks.points, bricks.hexahedra, **data(bricks))
    second = aeolic.Volume(bricks.points, bricks.hexahedra, **data(bricks, U=bricks.u[:, ::-1]))
    renderer = aeolic.Renderer("sphere", field=first, **SMALL)
    before = renderer.render()
    renderer.set_data(field=second)
    assert same(renderer.render(), aeolic.render("sphere", field=second, **SMALL))
    renderer.set_data(field=first)
    assert same(renderer.render(), before)
    box = Box()
    with pytest.raises(aeolic.InputError, match="made without one"):
        renderer.set_data(field=aeolic.Grid(box.origin, box.spacing, {"U": box.u}))
    with pytest.raises(aeolic.InputError, match="made without one"):
        aeolic.Renderer("sphere", field=aeolic.Grid(box.origin, box.spacing, {"U": box.u}), **SMALL).set_data(field=first)


@pytest.mark.parametrize("given, words", [
    (lambda b: (b.points[:, :2], b.hexahedra), "points: found shape (100, 2); expected (points, 3)"),
    (lambda b: (b.points, b.hexahedra[:, :7]), "cells: found shape (48, 7); expected (cells, 4), (cells, 5)"),
    (lambda b: (b.points, b.hexahedra.astype(float)), "cells: found values of type float64; expected whole numbers"),
    (lambda b: (b.points, None), "cells: found None"),
    (lambda b: (b.points, b.hexahedra + 60), "which does not exist; expected points from 0 to 99"),
    (lambda b: (b.points, -b.hexahedra), "cell 0 refers to point -"),
    (lambda b: (b.points, b.mixed()[0]), "types: found None; expected VTK's numbers of cell types"),
    (lambda b: (b.points, (b.mixed()[0][0],), 12), "cells: expected a pair (offsets, connectivity)"),
    (lambda b: (b.points, b.mixed()[0], 12), "of type 12 has 4 corners; expected 8"),
    (lambda b: (b.points, b.mixed()[0], b.mixed()[1][1:]), "types: 143 values; expected 144, one for each of the cells"),
    (lambda b: (b.points, b.mixed()[0], 300), "cell 0 has the type 300; expected a linear or quadratic cell"),
    (lambda b: (b.points, b.mixed()[0], 1.5), "types: found values of type float64; expected whole numbers"),
    (lambda b: (b.points, ([0, 8, 4], list(range(8))), [12, 12]), "offsets: they do not rise from 0 to the number of indices"),
    (lambda b: (b.points, ([0, 8], list(range(8))), 42), "cell 0 is a polyhedron without sound faces"),
    (lambda b: (numpy.full_like(b.points, numpy.nan), b.hexahedra), "none of its cells has a volume and finite corners"),
    (lambda b: (b.points, b.hexahedra[:0]), "100 points and 0 cells; expected a grid with cells"),
    (lambda b: (b.points, [[0, 1, 5, 25]], [5]), "cell 0 of type 5 has 4 corners; expected 3"),
    (lambda b: (b.points, ([0, 3], [0, 1, 5]), [5]), "none of its 1 cells has a volume"),
])
def test_wrong_volumes_are_named(bricks, given, words):
    with pytest.raises(aeolic.InputError) as caught:
        points, *cells = given(bricks)
        aeolic.render("sphere", field=aeolic.Volume(points, *cells, point_data={"U": bricks.u}), **SMALL)
    said = str(caught.value)
    assert words in said
    assert said.startswith("volume in memory: ") and "\n" not in said


def test_wrong_arrays_are_named(bricks):
    for arrays, words in (({"point_data": {"U": bricks.u[1:]}}, "array 'U' has 99 values; expected 100, one for each of the points"),
                          ({"cell_data": {"c": bricks.p}}, "array 'c' has 100 values; expected 48, one for each of the cells"),
                          ({"point_data": {"U": bricks.u[None]}}, "array 'U': found shape (1, 100, 3)"),
                          ({"point_data": {"p": bricks.p}}, "no array of vectors")):
        with pytest.raises(aeolic.InputError, match="volume in memory: ") as caught:
            aeolic.render("sphere", field=aeolic.Volume(bricks.points, bricks.hexahedra, **arrays), **SMALL)
        assert words in str(caught.value)
    sheet = Sheet()
    with pytest.raises(TypeError):
        aeolic.render(aeolic.Volume(bricks.points, bricks.hexahedra), field=None)
    with pytest.raises(TypeError, match="an aeolic.Grid or an aeolic.Volume, or a VTK object"):
        aeolic.render("sphere", field=aeolic.Surface(sheet.points, sheet.triangles))


def test_masked_values_and_values_that_are_not_finite_are_left_out(bricks):
    u = numpy.ma.array(bricks.u, mask=numpy.zeros_like(bricks.u, bool))
    u[55] = numpy.ma.masked
    holes = bricks.u.copy()
    holes[55] = numpy.inf
    masked = aeolic.render("boundary", field=aeolic.Volume(bricks.points, bricks.hexahedra, **data(bricks, U=u)), **SMALL)
    infinite = aeolic.render("boundary", field=aeolic.Volume(bricks.points, bricks.hexahedra, **data(bricks, U=holes)), **SMALL)
    whole = aeolic.render("boundary", field=aeolic.Volume(bricks.points, bricks.hexahedra, **data(bricks)), **SMALL)
    assert same(masked, infinite)
    assert not same(masked, whole)
    assert numpy.isinf(holes[55]).all(), "nobody writes to the caller's arrays"
