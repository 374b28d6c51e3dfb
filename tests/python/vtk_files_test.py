"""VTK's own objects draw what the files that VTK writes of them do."""
import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Bricks, Sheet, same

vtkIOXML = pytest.importorskip("vtkmodules.vtkIOXML")
vtkCommonCore = pytest.importorskip("vtkmodules.vtkCommonCore")
vtkCommonDataModel = pytest.importorskip("vtkmodules.vtkCommonDataModel")
from vtk_test import add, numpy_to_vtk, poly_data, structured, unstructured  # noqa: E402

SUFFIXES = {"vtkPolyData": "vtp", "vtkImageData": "vti", "vtkRectilinearGrid": "vtr", "vtkUnstructuredGrid": "vtu"}


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
    with pytest.raises(aeolic.InputError, match="found 360 points in a vtkRectilinearGrid of 9 x 8 x 6; expected 432"):
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
