"""VTK's own objects, and objects derived from them, as surfaces, grids and volumes in memory. VTK is imported only here,
and only where the caller has such an object anyway."""
import numpy

from ._data import Grid, InputError, Surface, Volume


def is_vtk(value, kind="vtkDataObject"):
    is_a = getattr(value, "IsA", None)
    return callable(is_a) and bool(is_a(kind))


def unwrapped(value):
    """The VTK object that VTK's numpy interface has wrapped, as a programmable filter gets it; other things as they are."""
    inner = getattr(value, "VTKObject", None)
    return inner if is_vtk(inner) else value


def _view(array):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if array.IsA("vtkBitArray"):  # Eight values a byte, which numpy has no view of.
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
        bits, array = array, vtkUnsignedCharArray()
        array.DeepCopy(bits)
    return vtk_to_numpy(array)  # Shares the array's memory and keeps it.


def _arrays(attributes, part=slice(None)):
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)  # None for texts.
        if array is not None and array.GetName():
            found[array.GetName()] = _view(array)[part]
    return found


def _with_active(made, data):
    """What is made of the data, where its active vectors and normals are known to be that."""
    for key, attributes in (("point_data", data.GetPointData()), ("cell_data", data.GetCellData())):
        for what, array in (("vectors", attributes.GetVectors()), ("normals", attributes.GetNormals())):
            if array is not None and array.GetName():
                made._memory["active"][key, what] = array.GetName()
    return made


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
    if normals is not None and not normals.GetName():
        point_data["Normals"] = _view(normals)
    return _with_active(Surface(
        numpy.empty((0, 3)) if points is None else _view(points.GetData()),
        polygons=(_view(polygons.GetOffsetsArray()), _view(polygons.GetConnectivityArray())) if count else ([], []),
        point_data=point_data, cell_data=_arrays(data.GetCellData(), slice(first, first + count))), data)


def field_of(data, cells=False):
    """A Grid of a vtkImageData or an even vtkRectilinearGrid, or a Volume of another one, a vtkUnstructuredGrid or a
    vtkStructuredGrid. cells: a Volume of an even one, too."""
    for kind, convert in (("vtkUnstructuredGrid", volume_of), ("vtkImageData", grid_of),
                          ("vtkStructuredGrid", structured_of),
                          ("vtkRectilinearGrid", uneven_of if cells else rectilinear_of)):
        if is_vtk(data, kind):
            return convert(data)
    raise InputError(f"field in memory: found a {data.GetClassName()}; expected a vtkImageData, vtkUnstructuredGrid, "
                     "vtkStructuredGrid or vtkRectilinearGrid, or a file's name")


def volume_of(data):
    """A Volume of a vtkUnstructuredGrid."""
    points, cells, types = data.GetPoints(), data.GetCells(), data.GetCellTypesArray()
    empty = data.GetNumberOfCells() == 0
    faces = None
    if not empty and data.GetFaces() is not None:
        faces = _view(data.GetFaces()), _view(data.GetFaceLocations())
    return _with_active(Volume(
        numpy.empty((0, 3)) if points is None else _view(points.GetData()),
        ([], []) if empty else (_view(cells.GetOffsetsArray()), _view(cells.GetConnectivityArray())),
        [] if empty else _view(types), faces=faces,
        point_data=_arrays(data.GetPointData()), cell_data=_arrays(data.GetCellData())), data)


def _dims(data):
    """Points along x, y and z."""
    extent = data.GetExtent()
    return [extent[2 * c + 1] - extent[2 * c] + 1 for c in range(3)]


def _axes(data):
    """The coordinates of a rectilinear grid along x, y and z."""
    return [_view(axis) for axis in (data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates())]


def _structured(data, points, axes):
    arrays = [_arrays(attributes) for attributes in (data.GetPointData(), data.GetCellData())]
    return _with_active(Volume._structured(_dims(data), points, axes, *arrays), data)


def structured_of(data):
    """A Volume of a vtkStructuredGrid."""
    points = data.GetPoints()
    return _structured(data, None if points is None else _view(points.GetData()), None)


def uneven_of(data):
    """A Volume of a vtkRectilinearGrid."""
    return _structured(data, None, _axes(data) if min(_dims(data)) > 0 else None)


def grid_of(data):
    """A Grid of a vtkImageData."""
    where = "grid in memory"
    matrix = data.GetDirectionMatrix()
    if not matrix.IsIdentity():
        raise InputError(f"{where}: its axes are turned (the Direction attribute is not the identity); "
                         "expected samples along x, y and z, or a structured grid")
    extent, spacing, origin = data.GetExtent(), data.GetSpacing(), data.GetOrigin()
    return _grid(data, _dims(data), [origin[c] + extent[2 * c] * spacing[c] for c in range(3)], spacing)


def rectilinear_of(data):
    """A Grid where samples are as far apart everywhere, which is what a file of them becomes, or a Volume."""
    axes = _axes(data)
    steps = [_step(axis) for axis in axes]
    if None in steps or tuple(len(axis) for axis in axes) != data.GetDimensions():
        return uneven_of(data)
    return _grid(data, data.GetDimensions(), *zip(*steps))


def _step(axis):
    """(first coordinate, distance) where all are as far apart, to 1e-5 of it as in files (uniform_grid.cpp), or
    None."""
    places = axis.astype("f8")
    if len(places) < 2:
        return None
    step = (places[-1] - places[0]) / (len(places) - 1)
    even = step > 0 and (abs(places - (places[0] + numpy.arange(len(places)) * step)) <= 1e-5 * step).all()
    return (places[0], step) if even else None


def _grid(data, dims, origin, spacing):
    def shaped(attributes, counts, what):
        count = counts[0] * counts[1] * counts[2]
        arrays = _arrays(attributes)
        for name, array in arrays.items():
            if len(array) != count:
                raise InputError(f"grid in memory: array {name!r} has {len(array)} values; "
                                 f"expected {count}, one for each of the {what}")
        return {name: array.reshape(*reversed(counts), *array.shape[1:]) for name, array in arrays.items()}

    grid = Grid(origin, spacing, shaped(data.GetPointData(), dims, "points"),
                shaped(data.GetCellData(), [max(count - 1, 1) for count in dims], "cells"))
    grid._memory["dims"] = tuple(dims)  # Cells alone do not say whether the grid is flat.
    return _with_active(grid, data)
