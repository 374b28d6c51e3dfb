"""Writes Aeolic's teapot as a .vtp with an ABC flow at its points, for programs that sample no 3D field.

Arguments: OUT.vtp [SEGMENTS]. Every patch becomes SEGMENTS x SEGMENTS quads, each two triangles; the default 20 is the size of
the built-in teapot. The control points are read from Aeolic's own source, so there is one teapot.
"""
import pathlib
import re
import sys

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src/data/builtin/teapot_patches.h"


def table(name, numbers):
    """The C++ table `name`: parts of four rows of `numbers` numbers each."""
    body = re.search(name + r"\{\{(.*?)\}\};", SOURCE.read_text(), re.S).group(1)
    return np.array([float(n) for n in re.findall(r"-?\d+\.?\d*", body)]).reshape(-1, 4, numbers)


def patches():
    """[32, 4 (v), 4 (u), 3] control points; turning and mirroring as src/data/builtin/teapot.cpp does."""
    found = []
    for quarter in table("teapotQuarters", 3):
        patch = np.array([[(r, 0, z), (r, -t, z), (t, -r, z), (0, -r, z)] for r, t, z in quarter])
        for _ in range(4):
            found.append(patch)
            patch = np.stack([patch[..., 1], -patch[..., 0], patch[..., 2]], axis=-1)
    for half in table("teapotHalves", 5):
        found.append(np.array([[(a, 0, b), (a, -w, b), (c, -w, d), (c, 0, d)] for a, b, c, d, w in half]))
        found.append(np.array([[(c, 0, d), (c, w, d), (a, w, b), (a, 0, b)] for a, b, c, d, w in half]))
    return np.array(found)


def triangulated(segments):
    t = np.linspace(0, 1, segments + 1)
    bernstein = np.stack([(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t * t, t ** 3], axis=1)
    points = np.einsum("vi,uj,pijc->pvuc", bernstein, bernstein, patches()).reshape(-1, 3)
    side = segments + 1
    corner = (np.arange(32)[:, None, None] * side + np.arange(segments)[:, None]) * side + np.arange(segments)
    a, b, c, d = (corner + k for k in (0, 1, side + 1, side))
    return points, np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)


def abc_flow(points):
    """Arnold-Beltrami-Childress with A = sqrt 3, B = sqrt 2, C = 1; the teapot is about one period long."""
    x, y, z = points.T
    a, b, c = np.sqrt(3), np.sqrt(2), 1
    return np.stack([a * np.sin(z) + c * np.cos(y), b * np.sin(x) + a * np.cos(z), c * np.sin(y) + b * np.cos(x)], axis=1)


def main():
    points, triangles = triangulated(int(sys.argv[2]) if len(sys.argv) > 2 else 20)
    mesh = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    mesh.SetPoints(holder)
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    mesh.SetPolys(cells)
    clean = vtkCleanPolyData()  # Joins the patches and drops the triangles that vanish at the poles.
    clean.SetInputData(mesh)
    clean.ConvertPolysToLinesOff()
    clean.Update()
    mesh = clean.GetOutput()
    vectors = numpy_to_vtk(abc_flow(vtk_to_numpy(mesh.GetPoints().GetData())).astype(np.float32), deep=True)
    vectors.SetName("abc")
    mesh.GetPointData().SetVectors(vectors)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputData(mesh)
    writer.Write()


main()
