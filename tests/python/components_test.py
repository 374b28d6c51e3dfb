"""Vectors as numpy users have them: of two components where the data are flat, and of whole numbers."""
import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Sheet, same

FLAT = Sheet(bend=0)


def surface(**arrays):
    return aeolic.Surface(FLAT.points, FLAT.triangles, point_data=arrays)


def plane(**arrays):
    """A field of one layer."""
    return aeolic.Grid((0, 0, 0), (0.25, 0.25, 1), arrays)


def padded(vectors):
    return numpy.concatenate([vectors, numpy.zeros_like(vectors[..., :1])], -1)


@pytest.mark.parametrize("kind", ["f4", "f8", "i4", "i2"])
def test_two_components_are_vectors_of_the_plane(kind):
    uv = (10 * FLAT.tau[:, :2]).astype(kind)
    expected = aeolic.render(surface(U=padded(uv)), vectors="U", **SMALL)
    assert same(aeolic.render(surface(U=uv), **SMALL), expected), "it is the only one"
    assert same(aeolic.render(surface(U=uv, p=FLAT.q), vectors="U", **SMALL), expected)
    cells = numpy.repeat(uv[:1], len(FLAT.triangles), 0)
    on_cells = [aeolic.Surface(FLAT.points, FLAT.triangles, cell_data={"U": values}) for values in (cells, padded(cells))]
    assert same(*(aeolic.render(data, vectors="U", **SMALL) for data in on_cells))


def test_two_components_of_a_grid_and_of_a_volume():
    deep, uv = Box().u[..., :2], Box().u[:1, :, :, :2]
    grids = [aeolic.Grid(Box.origin, Box.spacing, {"U": values}) for values in (deep, padded(deep))]
    assert same(*(aeolic.render("plane", field=grid, vectors="U", color_by="U:mag", **SMALL) for grid in grids))
    assert same(aeolic.render("image", field=plane(U=uv), **SMALL), aeolic.render("image", field=plane(U=padded(uv)), **SMALL))
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], "f4")
    volumes = [aeolic.Volume(corners, [[0, 1, 2, 3], [1, 2, 3, 4]], point_data={"U": values})
               for values in (corners[:, :2], padded(corners[:, :2]))]
    assert same(*(aeolic.render("boundary", field=volume, vectors="U", **SMALL) for volume in volumes))


def test_the_walls_shear_of_two_components():
    uv = Box().u[..., :2]
    assert same(*(aeolic.render("sphere:500", field=aeolic.Grid(Box.origin, Box.spacing, {"U": values}),
                                vectors="wallShear(U)", **SMALL) for values in (uv, padded(uv))))


@pytest.mark.parametrize("kind", ["i8", "i4", "i2", "u2"])
def test_whole_numbers_are_vectors_and_scalars(kind):
    whole = (3 * FLAT.tau).astype(kind)
    expected = aeolic.render(surface(U=whole.astype("f4"), n=whole[:, 0].astype("f4")), color_by="n", **SMALL)
    assert same(aeolic.render(surface(U=whole, n=whole[:, 0]), color_by="n", **SMALL), expected)
    grid = {name: whole[None, :, :].reshape(1, 5, 5, 3).astype(name) for name in ("f4", kind)}
    assert same(*(aeolic.render("image", field=plane(U=values), **SMALL) for values in grid.values()))


def test_what_was_drawn_before_still_is():
    """An array of three floats goes before arrays that nobody has named."""
    tau = FLAT.tau
    expected = aeolic.render(surface(tau=tau), **SMALL)
    assert same(aeolic.render(surface(tau=tau, uv=tau[:, :2], ids=tau.astype("i4")), **SMALL), expected)
    with pytest.raises(aeolic.InputError, match="several arrays of vectors"):
        aeolic.render(surface(a=tau, b=tau, uv=tau[:, :2]), **SMALL)


def test_bytes_are_flow_only_where_they_are_named():
    colors = (100 * FLAT.tau).astype("u1")
    with pytest.raises(aeolic.InputError, match="no array of vectors"):
        aeolic.render(surface(RGB=colors), **SMALL)
    assert same(*(aeolic.render(surface(RGB=values), vectors="RGB", **SMALL) for values in (colors, colors.astype("f4"))))


def test_places_in_a_texture_are_no_flow():
    for name in ("Texture Coordinates", "TCoords", "TextureCoords"):
        with pytest.raises(aeolic.InputError, match="no array of vectors"):
            aeolic.render(surface(**{name: FLAT.tau[:, :2]}), **SMALL)
    bent = Sheet()
    with pytest.raises(aeolic.InputError, match="two are enough in flat data"):
        aeolic.render(aeolic.Surface(bent.points, bent.triangles, point_data={"uv": bent.tau[:, :2]}), **SMALL)
    with pytest.raises(aeolic.InputError, match="array 'q' has 4 components"):
        aeolic.render(surface(q=numpy.ones((len(FLAT.points), 4))), vectors="q", **SMALL)


def test_the_next_data_may_have_two_components_too():
    uv, later = FLAT.tau[:, :2], FLAT.tau[:, 1::-1]
    renderer = aeolic.Renderer(surface(U=uv), **SMALL)
    renderer.set_data(surface(U=later))
    assert same(renderer.render(), aeolic.render(surface(U=padded(later)), **SMALL))


def test_reversed_vectors_of_two_components():
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 0, 1]], "f4")
    uv = numpy.array([[1, 0.5], [0.2, 1], [1, 1]], "f4")
    surfaces = [aeolic.Surface(corners, [[0, 1, 2]], point_data={"U": values}) for values in (uv, padded(uv))]
    pictures = [aeolic.render(surface, vectors="reversed(U)", style="oriented", **SMALL) for surface in surfaces]
    assert same(*pictures)
    assert not same(pictures[0], aeolic.render(surfaces[0], vectors="U", style="oriented", **SMALL))
