"""VTK's own objects, where VTK's Python module is there."""
import sys
import unittest

import numpy

import aeolic
from scenes import SMALL, Box, Sheet, same

try:
    from vtkmodules import vtkCommonCore, vtkCommonDataModel
    from vtkmodules.util.numpy_support import numpy_to_vtk
except ImportError as error:
    print(f"skipped: {error}", file=sys.stderr)
    sys.exit(77)


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

    def test_other_data_sets_are_refused(self):
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkImageData; expected a vtkPolyData"):
            aeolic.render(self.image())
        with self.assertRaisesRegex(aeolic.InputError, "found a vtkPolyData; expected a vtkImageData"):
            aeolic.render("sphere", field=poly_data(self.sheet))
        turned = self.image()
        turned.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        with self.assertRaisesRegex(aeolic.InputError, "its axes are turned"):
            aeolic.render("sphere", field=turned)
        with self.assertRaisesRegex(aeolic.InputError, "no array 'tau'"):
            aeolic.render(vtkCommonDataModel.vtkPolyData(), vectors="tau")


if __name__ == "__main__":
    unittest.main()
