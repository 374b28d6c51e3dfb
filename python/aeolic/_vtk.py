"""VTK's own objects, and what is derived from them, as surfaces and grids in memory. VTK is imported only here, and only
by who has such an object anyway."""
import numpy

from ._data import Grid, InputError, Surface


def is_vtk(value, kind="vtkDataObject"):
    is_a = getattr(value, "IsA", None)
    return callable(is_a) and bool(is_a(kind))


def _view(array):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(array)  # Shares the array's memory and keeps it.


def _arrays(attributes, part=slice(None)):
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)  # None for texts.
        if array is not None and array.GetName():
            found[array.GetName()] = _view(array)[part]
    return found


def _active_vectors(*attributes):
    for one in attributes:
        vectors = one.GetVectors()
        if vectors is not None and vectors.GetName():
            return vectors.GetName()
    return None


def surface_of(data):
    """A Surface of a vtkPolyData. Lines and vertices are left out; strips are cut into triangles."""
    if data.GetNumberOfStrips() > 0:
        from vtkmodules.vtkFiltersCore import vtkTriangleFilter
        cut = vtkTriangleFilter()
        cut.SetInputData(data)
        cut.PassVertsOff()
        cut.PassLinesOff()
        cut.Update()
        data = cut.GetOutput()
    first = data.GetNumberOfVerts() + data.GetNumberOfLines()  # VTK numbers cells in this order.
    count = data.GetNumberOfPolys()
    points = data.GetPoints()
    polygons = data.GetPolys()
    point_data = _arrays(data.GetPointData())
    normals = data.GetPointData().GetNormals()
    if normals is not None:
        point_data["Normals"] = _view(normals)
    surface = Surface(
        numpy.empty((0, 3)) if points is None else _view(points.GetData()),
        polygons=(_view(polygons.GetOffsetsArray()), _view(polygons.GetConnectivityArray())) if count else ([], []),
        point_data=point_data, cell_data=_arrays(data.GetCellData(), slice(first, first + count)))
    surface._vectors = _active_vectors(data.GetPointData(), data.GetCellData())
    return surface


def grid_of(data):
    """A Grid of a vtkImageData."""
    where = "grid in memory"
    if not is_vtk(data, "vtkImageData"):
        raise InputError(f"{where}: found a {data.GetClassName()}; expected a vtkImageData, or a file's name")
    matrix = data.GetDirectionMatrix()
    if not matrix.IsIdentity():
        raise InputError(f"{where}: its axes are turned (the Direction attribute is not the identity); "
                         "expected samples along x, y and z, or a structured grid")
    extent, spacing, origin = data.GetExtent(), data.GetSpacing(), data.GetOrigin()
    dims = [extent[2 * c + 1] - extent[2 * c] + 1 for c in range(3)]

    def shaped(attributes, counts):
        return {name: array.reshape(*reversed(counts), *array.shape[1:]) for name, array in _arrays(attributes).items()
                if len(array) == counts[0] * counts[1] * counts[2]}

    grid = Grid([origin[c] + extent[2 * c] * spacing[c] for c in range(3)], spacing, shaped(data.GetPointData(), dims),
                shaped(data.GetCellData(), [max(count - 1, 1) for count in dims]) if min(dims) > 1 else None)
    grid._vectors = _active_vectors(data.GetPointData(), data.GetCellData())
    return grid
