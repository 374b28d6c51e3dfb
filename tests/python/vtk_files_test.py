"""VTK's own objects draw what the files that VTK writes of them do."""
import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Bricks, Sheet, same

vtkIOXML = pytest.importorskip("vtkmodules.vtkIOXML")
vtkCommonCore = pytest.importorskip("vtkmodules.vtkCommonCore")
vtkCommonDataModel = pytest.importorskip("vtkmodules.vtkCommonDataModel")
from vtk_test import add, numpy_to_vtk, poly_data, structured, unstructured  # noqa: E402

SUFFIXES = {"vtkPolyData": "vtp", "vtkImageData": "vti", "vtkRectilinearGrid": "vtr", "vtkStructuredGrid": "vts",
            "vtkUnstructuredGrid": "vtu"}


def assert_same(folder, data, surface=None, **options):
    kind = data.GetClassName()
    writer = getattr(vtkIOXML, kind.replace("vtk", "vtkXML") + "Writer")()
    writer.SetFileName(str(folder / f"a.{SUFFIXES[kind]}"))
    writer.SetInputData(data)
    writer.Write()
    drawn, by_file = (aeolic.render(surface or source, field=source if surface else None, **SMALL, **options)
                      for source in (data, folder / f"a.{SUFFIXES[kind]}"))
    assert same(drawn, by_file)


def even_grid(turned=False):
    box, data = Box(), vtkCommonDataModel.vtkRectilinearGrid()
    data.SetDimensions(9, 8, 5)
    for axis, start, step, count in zip("XYZ", box.origin, box.spacing, (9, 8, 5)):
        places = start + step * numpy.arange(count)
        getattr(data, f"Set{axis}Coordinates")(numpy_to_vtk(places[::-1].copy() if turned else places, deep=True))
    add(data.GetPointData(), "U", box.u.reshape(-1, 3))
    add(data.GetCellData(), "c", numpy.arange(data.GetNumberOfCells(), dtype="f4"))
    return data


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("surface", ["sphere", "slice:0.1,0,0.2:0,0.3,1", "boundary"])
def test_even_rectilinear_grids(surface, turned, tmp_path):
    assert_same(tmp_path, even_grid(turned), surface, color_by="c")


def test_a_rectilinear_grid_may_become_even():
    renderer = aeolic.Renderer("sphere", field=structured("vtkRectilinearGrid"), **SMALL)
    before = renderer.render()
    renderer.set_data(field=even_grid())
    assert not same(renderer.render(), before)


def test_a_rectilinear_grid_whose_coordinates_do_not_fit_is_refused():
    data = even_grid()
    data.SetDimensions(9, 8, 6)
    with pytest.raises(aeolic.InputError, match="coordinates along z: 5 values; expected 6, for 9 x 8 x 6 points"):
        aeolic.render("sphere", field=data, **SMALL)


@pytest.mark.parametrize("name", ["N", "Normals"])
def test_active_normals_are_no_vectors(name, tmp_path):
    for data, surface, count in ((poly_data(Sheet()), None, 25), (unstructured(Bricks()), "boundary", 100)):
        add(data.GetPointData(), name, numpy.tile(numpy.float32([0, 0.3, 1]), (count, 1)))
        data.GetPointData().SetActiveNormals(name)
        assert_same(tmp_path, data, surface)


def image(dims, box):
    data = vtkCommonDataModel.vtkImageData()
    data.SetDimensions(*dims)
    add(data.GetPointData(), "U", box.u[:dims[2]].reshape(-1, 3))
    return data


def test_cells_of_a_flat_image_keep_their_arrays(tmp_path):
    data = image((9, 8, 1), Box())
    add(data.GetCellData(), "C", numpy.tile(numpy.float32([1, 1, 0]), (56, 1)))
    for vectors in ("U", "C"):
        assert_same(tmp_path, data, "image", vectors=vectors)
    data.GetPointData().RemoveArray("U")
    assert_same(tmp_path, data, "image")


def test_an_image_whose_arrays_do_not_fit_is_refused():
    data = image((9, 8, 5), Box())
    data.SetDimensions(9, 8, 6)
    with pytest.raises(aeolic.InputError, match="array 'U' has 360 values; expected 432, one for each of the points"):
        aeolic.render("sphere", field=data, **SMALL)


def test_bits_are_numbers():
    data, bits = poly_data(Sheet()), vtkCommonCore.vtkBitArray()
    bits.SetName("b")
    for number in range(25):
        bits.InsertNextValue(number % 3 == 0)
    data.GetPointData().AddArray(bits)
    add(data.GetPointData(), "bytes", (numpy.arange(25) % 3 == 0).astype("u1"))
    assert same(aeolic.render(data, color_by="b", **SMALL), aeolic.render(data, color_by="bytes", **SMALL))


def test_active_vectors_may_be_on_cells_beside_those_of_the_same_name_on_points(tmp_path):
    for data, surface, count in ((poly_data(Sheet()), None, 32), (image((9, 8, 5), Box()), "sphere", 224),
                                 (structured("vtkStructuredGrid"), "slice:0.1,0.2,0.3:1,0.5,2", 48)):
        name = "tau" if surface is None else "U"
        add(data.GetCellData(), name, numpy.tile(numpy.float32([1, -1, 0.5]), (count, 1)))
        on_points = aeolic.render(surface or data, field=data if surface else None, vectors=name, **SMALL)
        data.GetCellData().SetActiveVectors(name)
        assert_same(tmp_path, data, surface)
        assert not same(aeolic.render(surface or data, field=data if surface else None, **SMALL), on_points)
        data.GetPointData().SetActiveVectors(name)
        assert_same(tmp_path, data, surface)
        assert same(aeolic.render(surface or data, field=data if surface else None, **SMALL), on_points)


def test_normals_alone_are_no_vectors():
    data = poly_data(Sheet())
    data.GetPointData().RemoveArray("tau")
    add(data.GetPointData(), "N", numpy.tile(numpy.float32([0, 0.3, 1]), (25, 1)))
    data.GetPointData().SetActiveNormals("N")
    with pytest.raises(aeolic.InputError, match="surface in memory: no array of vectors"):
        aeolic.render(data, **SMALL)
    assert aeolic.render(data, vectors="N", **SMALL).shape == (36, 48, 3)


def test_other_data_have_the_active_vectors_of_the_first():
    first, second = poly_data(Sheet()), poly_data(Sheet(bend=0.6))
    for data in (first, second):
        add(data.GetPointData(), "other", Sheet().tau[:, ::-1].copy())
    first.GetPointData().SetActiveVectors("tau")
    second.GetPointData().SetActiveVectors("other")
    sheet = Sheet(bend=0.6)
    plain = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau, "other": sheet.tau[:, ::-1]})
    shown = []
    for after in (second, plain):
        renderer = aeolic.Renderer(first, **SMALL)
        renderer.set_data(after)
        shown.append(renderer.render())
    named = aeolic.Renderer(first, vectors="tau", **SMALL)
    named.set_data(second)
    assert same(shown[0], named.render()) and same(shown[1], named.render())
    assert plain._memory["active"] == {}, "what is the caller's stays as it is"


HIDDEN = {"points": 2, "cells": 32}  # HIDDENPOINT, HIDDENCELL.


@pytest.mark.parametrize("hidden", HIDDEN)
@pytest.mark.parametrize("kind", ["vtkStructuredGrid", "vtkRectilinearGrid"])
def test_what_is_blanked_is_left_out_of_structured_grids(kind, hidden, tmp_path):
    data = structured(kind)
    whole = [aeolic.render(surface, field=data, **SMALL) for surface in ("boundary", "slice:0.1,0.2,0.3:1,0.5,2")]
    attributes = data.GetPointData() if hidden == "points" else data.GetCellData()
    ghosts = numpy.zeros(attributes.GetArray(0).GetNumberOfTuples(), "u1")
    ghosts[::11] = HIDDEN[hidden]
    add(attributes, "vtkGhostType", ghosts)
    for surface in ("boundary", "slice:0.1,0.2,0.3:1,0.5,2", "isosurface:p=0.2", "sphere"):
        for color_by in (None, "p", "c"):
            assert_same(tmp_path, data, surface, color_by=color_by)
    for surface, before in zip(("boundary", "slice:0.1,0.2,0.3:1,0.5,2"), whole):
        assert not same(aeolic.render(surface, field=data, **SMALL), before)


def flat(kind):
    data = getattr(vtkCommonDataModel, kind)()
    data.SetDimensions(9, 8, 1)
    y, x = numpy.meshgrid(numpy.arange(8.0), numpy.arange(9.0) ** 1.2, indexing="ij")
    if kind == "vtkStructuredGrid":
        points = vtkCommonCore.vtkPoints()
        points.SetData(numpy_to_vtk(numpy.stack([x, y + 0.1 * x, 0 * x], -1).reshape(-1, 3), deep=True))
        data.SetPoints(points)
    else:
        for axis, places in zip("XYZ", (x[0], y[:, 0], numpy.zeros(1))):
            getattr(data, f"Set{axis}Coordinates")(numpy_to_vtk(places.copy(), deep=True))
    add(data.GetPointData(), "U", numpy.stack([1 + y, x, 0 * x], -1).reshape(-1, 3).astype("f4"))
    add(data.GetCellData(), "c", numpy.arange(56, dtype="f4"))
    return data


@pytest.mark.parametrize("kind", ["vtkStructuredGrid", "vtkRectilinearGrid"])
def test_flat_structured_grids_are_drawn(kind, tmp_path):
    data = flat(kind)
    for color_by in ("U:mag", "c"):
        assert_same(tmp_path, data, "boundary", color_by=color_by)
    ghosts = numpy.zeros(72, "u1")
    ghosts[20:25] = HIDDEN["points"]  # Land.
    before = aeolic.render("boundary", field=data, **SMALL)
    add(data.GetPointData(), "vtkGhostType", ghosts)
    assert_same(tmp_path, data, "boundary", color_by="c")
    assert not same(aeolic.render("boundary", field=data, **SMALL), before)
