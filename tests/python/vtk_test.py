"""VTK's own objects, where VTK's Python module is there."""
import pathlib
import tempfile
import tracemalloc
import unittest

import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Bricks, Sheet, same

vtkCommonCore = pytest.importorskip("vtkmodules.vtkCommonCore")
vtkCommonDataModel = pytest.importorskip("vtkmodules.vtkCommonDataModel")
numpy_to_vtk = pytest.importorskip("vtkmodules.util.numpy_support").numpy_to_vtk


def poly_data(sheet):
    data = vtkCommonDataModel.vtkPolyData()
    points = vtkCommonCore.vtkPoints()
    points.SetData(numpy_to_vtk(sheet.points, deep=True))
    data.SetPoints(points)
    polygons = vtkCommonDataModel.vtkCellArray()
    for triangle in sheet.triangles:
        polygons.InsertNextCell(3, [int(corner) for corner in triangle])
    data.SetPolys(polygons)
    add(data.GetPointData(), "tau", sheet.tau)
    add(data.GetPointData(), "q", sheet.q)
    return data


def unstructured(bricks, kind=vtkCommonDataModel.vtkUnstructuredGrid, index="i8"):
    (offsets, corners), types = bricks.mixed()
    data = kind()
    points = vtkCommonCore.vtkPoints()
    points.SetData(numpy_to_vtk(bricks.points, deep=True))
    data.SetPoints(points)
    cells = vtkCommonDataModel.vtkCellArray()
    cells.SetData(numpy_to_vtk(offsets.astype(index), deep=True), numpy_to_vtk(corners.astype(index), deep=True))
    data.SetCells(numpy_to_vtk(types, deep=True), cells)
    add(data.GetPointData(), "U", bricks.u)
    add(data.GetPointData(), "p", bricks.p)
    return data


class UnstructuredGrid(vtkCommonDataModel.vtkUnstructuredGrid):
    """As PyVista's class of this name: VTK's own, with numpy's arrays as attributes."""

    @property
    def points(self):
        raise AssertionError("what VTK has needs no attribute")

    cells = celltypes = point_data = points

    def __len__(self):
        return self.GetNumberOfPoints()


def add(attributes, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    attributes.AddArray(array)


class Vtk(unittest.TestCase):
    def setUp(self):
        self.sheet, self.box = Sheet(), Box()
        self.expected = aeolic.render(aeolic.Surface(self.sheet.points, self.sheet.triangles, point_data={
            "tau": self.sheet.tau, "q": self.sheet.q}), color_by="q", **SMALL)

    def image(self, shift=0):
        data = vtkCommonDataModel.vtkImageData()
        data.SetExtent(shift, shift + 8, 0, 7, 0, 4)
        data.SetOrigin(self.box.origin[0] - shift * self.box.spacing[0], *self.box.origin[1:])
        data.SetSpacing(*self.box.spacing)
        add(data.GetPointData(), "U", self.box.u.reshape(-1, 3))
        add(data.GetPointData(), "p", self.box.p.reshape(-1))
        return data

    def test_poly_data_is_a_surface(self):
        self.assertTrue(same(aeolic.render(poly_data(self.sheet), color_by="q", **SMALL), self.expected))

    def test_lines_before_the_polygons_shift_the_cells_values(self):
        data = poly_data(self.sheet)
        lines = vtkCommonDataModel.vtkCellArray()
        lines.InsertNextCell(2, [0, 1])
        data.SetLines(lines)
        add(data.GetCellData(), "c", numpy.concatenate([[1e6], self.sheet.cell]).astype("f4"))
        expected = aeolic.render(aeolic.Surface(self.sheet.points, self.sheet.triangles, point_data={
            "tau": self.sheet.tau}, cell_data={"c": self.sheet.cell}), color_by="c", **SMALL)
        self.assertTrue(same(aeolic.render(data, color_by="c", **SMALL), expected))

    def test_strips_are_cut_into_triangles(self):
        data = poly_data(self.sheet)
        strips = vtkCommonDataModel.vtkCellArray()
        strips.InsertNextCell(4, [0, 1, 5, 6])
        data.SetPolys(vtkCommonDataModel.vtkCellArray())
        data.SetStrips(strips)
        self.assertEqual(aeolic.Renderer(data, **SMALL).info["triangles"], 2)

    def test_active_vectors_are_taken(self):
        data = poly_data(self.sheet)
        add(data.GetPointData(), "other", self.sheet.tau[:, ::-1].copy())
        with self.assertRaisesRegex(aeolic.InputError, "several arrays of vectors and none is active"):
            aeolic.render(data, **SMALL)
        data.GetPointData().SetActiveVectors("tau")
        self.assertTrue(same(aeolic.render(data, color_by="q", **SMALL), self.expected))

    def test_derived_classes_are_taken(self):
        class Mesh(vtkCommonDataModel.vtkPolyData):
            pass
        mesh = Mesh()
        mesh.ShallowCopy(poly_data(self.sheet))
        self.assertTrue(same(aeolic.render(mesh, color_by="q", **SMALL), self.expected))

    def test_image_data_is_a_field(self):
        grid = aeolic.Grid(self.box.origin, self.box.spacing, {"U": self.box.u, "p": self.box.p})
        for surface in ("slice:0.5,0.5,0.3:0,0.2,1", "isosurface:p=0.5"):
            expected = aeolic.render(surface, field=grid, color_by="p", **SMALL)
            for shift in (0, 16):
                drawn = aeolic.render(surface, field=self.image(shift), color_by="p", **SMALL)
                self.assertTrue(same(drawn, expected), (surface, shift))

    def test_data_live_as_long_as_they_are_needed(self):
        renderer = aeolic.Renderer("slice:0.5,0.5,0.3:0,0.2,1", field=self.image(), **SMALL)
        before = renderer.render()
        filler = [self.image() for _ in range(20)]
        self.assertTrue(same(renderer.render(), before))
        self.assertEqual(len(filler), 20)

    def test_what_numpys_interface_wraps_is_taken(self):
        dsa = pytest.importorskip("vtkmodules.numpy_interface.dataset_adapter")
        wrapped = dsa.WrapDataObject(poly_data(self.sheet))
        self.assertTrue(same(aeolic.render(wrapped, color_by="q", **SMALL), self.expected))
        for grid in (unstructured(Bricks()), self.image()):
            self.assertTrue(same(aeolic.render("sphere", field=dsa.WrapDataObject(grid), **SMALL),
                                 aeolic.render("sphere", field=grid, **SMALL)))
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkUnstructuredGrid; expected a vtkPolyData"):
            aeolic.render(dsa.WrapDataObject(unstructured(Bricks())))

    def test_other_data_sets_are_refused(self):
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkImageData; expected a vtkPolyData"):
            aeolic.render(self.image())
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkPolyData; expected a vtkImageData, vtkUnstructured"):
            aeolic.render("sphere", field=poly_data(self.sheet))
        with self.assertRaisesRegex(aeolic.InputError, "field in memory: found a vtkHyperTreeGrid"):
            aeolic.render("sphere", field=vtkCommonDataModel.vtkHyperTreeGrid())
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkUnstructuredGrid; expected a vtkPolyData"):
            aeolic.render(unstructured(Bricks()))
        turned = self.image()
        turned.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        with self.assertRaisesRegex(aeolic.InputError, "its axes are turned"):
            aeolic.render("sphere", field=turned)
        with self.assertRaisesRegex(aeolic.InputError, "no array 'tau'"):
            aeolic.render(vtkCommonDataModel.vtkPolyData(), vectors="tau")


@pytest.mark.parametrize("surface", ["boundary", "slice:0.1,0,0.2:0,0.3,1", "isosurface:p=0.2", "sphere"])
@pytest.mark.parametrize("kind, index", [(vtkCommonDataModel.vtkUnstructuredGrid, "i8"), (UnstructuredGrid, "i4")])
def test_an_unstructured_grid_is_a_volume(surface, kind, index, tmp_path):
    bricks = Bricks()
    file = bricks.write(tmp_path / "bricks.vtu", *bricks.mixed())
    drawn = aeolic.render(surface, field=unstructured(bricks, kind, index), color_by="p", **SMALL)
    assert same(drawn, aeolic.render(surface, field=file, color_by="p", **SMALL))


def structured(kind):
    """Bricks as a structured grid, or the box with uneven steps as a rectilinear one."""
    data = getattr(vtkCommonDataModel, kind)()
    if kind == "vtkStructuredGrid":
        bricks = Bricks()
        data.SetDimensions(5, 5, 4)
        points = vtkCommonCore.vtkPoints()
        points.SetData(numpy_to_vtk(bricks.points, deep=True))
        data.SetPoints(points)
        u, p = bricks.u, bricks.p
    else:
        box = Box()
        data.SetDimensions(9, 8, 5)
        for axis, start, step, count in zip("XYZ", box.origin, box.spacing, (9, 8, 5)):
            getattr(data, f"Set{axis}Coordinates")(
                numpy_to_vtk(start + step * count * (numpy.arange(count) / count) ** 1.5, deep=True))
        u, p = box.u.reshape(-1, 3), box.p.reshape(-1)
    add(data.GetPointData(), "U", u)
    add(data.GetPointData(), "p", p)
    add(data.GetCellData(), "c", numpy.arange(data.GetNumberOfCells(), dtype="f4"))
    return data


@pytest.mark.parametrize("hidden", [False, True])
@pytest.mark.parametrize("kind, suffix", [("vtkStructuredGrid", "vts"), ("vtkRectilinearGrid", "vtr")])
def test_structured_and_rectilinear_grids_are_volumes(kind, suffix, hidden, tmp_path):
    vtkIOXML = pytest.importorskip("vtkmodules.vtkIOXML")
    data = structured(kind)
    if hidden:
        ghosts = numpy.zeros(data.GetNumberOfCells(), "u1")
        ghosts[20:40] = 32  # HIDDENCELL
        add(data.GetCellData(), "vtkGhostType", ghosts)
    writer = getattr(vtkIOXML, kind.replace("vtk", "vtkXML") + "Writer")()
    writer.SetFileName(str(tmp_path / f"a.{suffix}"))
    writer.SetInputData(data)
    writer.Write()
    # VTK shows the walls around what is hidden for cells of any shape alone, and means of cells beside it differ.
    scenes = [("sphere", "p"), ("slice:0.1,0.2,0.3:1,0.5,2", "p" if hidden else "c")] + [("boundary", "U:mag")] * (not hidden)
    for surface, color_by in scenes:
        drawn, by_file = (aeolic.render(surface, field=field, color_by=color_by, **SMALL)
                          for field in (data, tmp_path / f"a.{suffix}"))
        assert same(drawn, by_file), surface


def test_hidden_cells_are_cut_by_nothing():
    """Neither as cells that are marked, nor as what VTK makes of them: cells of type 0 with corners."""
    filters = pytest.importorskip("vtkmodules.vtkFiltersCore")
    data = structured("vtkStructuredGrid")
    ghosts = numpy.zeros(data.GetNumberOfCells(), "u1")
    ghosts[20:40] = 32  # HIDDENCELL
    add(data.GetCellData(), "vtkGhostType", ghosts)

    def appended(grid):
        append = filters.vtkAppendFilter()
        append.SetInputData(grid)
        append.Update()
        return append.GetOutput()

    without, marked = appended(data), appended(structured("vtkStructuredGrid"))
    assert without.GetCellType(20) == 0 and without.GetCell(20).GetNumberOfPoints() == 8
    add(marked.GetCellData(), "vtkGhostType", ghosts)
    for surface in ("slice:0.1,0.2,0.3:1,0.5,2", "isosurface:p=0.3", "boundary"):
        one, other = (aeolic.Renderer(surface, field=field, color_by="c", **SMALL) for field in (without, marked))
        assert one.info["triangles"] == other.info["triangles"], surface
        assert same(one.render(), other.render()), surface


def test_broken_structured_grids_are_refused():
    data = vtkCommonDataModel.vtkStructuredGrid()
    data.SetDimensions(5, 5, 4)
    with pytest.raises(aeolic.InputError, match="volume in memory: 0 points; expected 100, which are 5 x 5 x 4"):
        aeolic.render("sphere", field=data)
    for kind in ("vtkStructuredGrid", "vtkRectilinearGrid"):
        with pytest.raises(aeolic.InputError, match="volume in memory: 0 points and 0 cells; expected a grid with cells"):
            aeolic.render("sphere", field=getattr(vtkCommonDataModel, kind)())


def test_polyhedra_of_vtk_are_taken():
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
    bricks, data = Bricks(), vtkCommonDataModel.vtkUnstructuredGrid()
    points = vtkCommonCore.vtkPoints()
    points.SetData(numpy_to_vtk(bricks.points, deep=True))
    data.SetPoints(points)
    for i, brick in enumerate(bricks.hexahedra.tolist()):
        if i % 3:
            data.InsertNextCell(12, 8, brick)
            continue
        faces = vtkCommonCore.vtkIdList()
        faces.InsertNextId(6)
        for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
            for number in (4, *(brick[k] for k in face)):
                faces.InsertNextId(number)
        data.InsertNextCell(42, faces)
    add(data.GetPointData(), "U", bricks.u)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(data)
    writer.WriteToOutputStringOn()
    writer.Write()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "a.vtu"
        file.write_text(writer.GetOutputString(), encoding="latin-1")
        for surface in ("sphere", "boundary"):
            assert same(aeolic.render(surface, field=data, **SMALL), aeolic.render(surface, field=file, **SMALL))


def test_active_vectors_of_an_unstructured_grid_are_taken():
    data = unstructured(Bricks())
    expected = aeolic.render("sphere", field=data, **SMALL)
    add(data.GetPointData(), "other", Bricks().u[:, ::-1].copy())
    with pytest.raises(aeolic.InputError, match="several arrays of vectors and none is active"):
        aeolic.render("sphere", field=data, **SMALL)
    data.GetPointData().SetActiveVectors("U")
    assert same(aeolic.render("sphere", field=data, **SMALL), expected)


def test_an_empty_unstructured_grid_is_refused():
    with pytest.raises(aeolic.InputError, match="volume in memory: 0 points and 0 cells"):
        aeolic.render("sphere", field=vtkCommonDataModel.vtkUnstructuredGrid(), **SMALL)


@pytest.mark.parametrize("kind", ["f4", "f8"])
@pytest.mark.parametrize("way", ["numpy", "vtk"])
def test_contiguous_arrays_are_not_copied_on_their_way_in(way, kind):
    """numpy tells tracemalloc of its memory; what the library takes is not counted."""
    sheet = Sheet(100)
    sheet.points, sheet.tau, sheet.q = (array.astype(kind) for array in (sheet.points, sheet.tau, sheet.q))
    surface = poly_data(sheet) if way == "vtk" else None
    tracemalloc.start()
    try:
        if way == "numpy":
            surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau, "q": sheet.q})
        aeolic.Renderer(surface, vectors="tau", color_by="q", **SMALL)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 0.5 * sheet.q.nbytes, "the smallest array"
