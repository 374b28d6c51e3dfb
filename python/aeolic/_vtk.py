"""VTK's own objects, and what is derived from them, as surfaces, grids and volumes in memory. VTK is imported only here, and only
by who has such an object anyway."""
import numpy

from ._data import Grid, InputError, Surface, Volume


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


def field_of(data):
    """A Grid of a vtkImageData, or a Volume of a vtkUnstructuredGrid, vtkStructuredGrid or vtkRectilinearGrid."""
    for kind, convert in (("vtkUnstructuredGrid", volume_of), ("vtkImageData", grid_of),
                          ("vtkStructuredGrid", hexahedra_of), ("vtkRectilinearGrid", hexahedra_of)):
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
    volume = Volume(
        numpy.empty((0, 3)) if points is None else _view(points.GetData()),
        ([], []) if empty else (_view(cells.GetOffsetsArray()), _view(cells.GetConnectivityArray())),
        [] if empty else _view(types), faces=faces,
        point_data=_arrays(data.GetPointData()), cell_data=_arrays(data.GetCellData()))
    volume._vectors = _active_vectors(data.GetPointData(), data.GetCellData())
    return volume


def _places(data, dims):
    """(n, 3): the points of a structured or rectilinear grid, x fastest."""
    if is_vtk(data, "vtkStructuredGrid"):
        points = data.GetPoints()
        return numpy.empty((0, 3)) if points is None else _view(points.GetData())
    z, y, x = numpy.meshgrid(*(_view(axis) for axis in (data.GetZCoordinates(), data.GetYCoordinates(), data.GetXCoordinates())),
                             indexing="ij")
    return numpy.stack([x, y, z], -1).reshape(-1, 3)


def hexahedra_of(data):
    """A Volume of a vtkStructuredGrid or vtkRectilinearGrid. Its hexahedra take 32 bytes a cell."""
    extent = data.GetExtent()
    dims = [extent[2 * c + 1] - extent[2 * c] + 1 for c in range(3)]
    if min(dims) < 2:
        raise InputError(f"field in memory: found a {data.GetClassName()} of {' x '.join(map(str, dims))} points; expected 2 or "
                         "more in each direction")
    places = _places(data, dims)
    if len(places) != dims[0] * dims[1] * dims[2]:
        raise InputError(f"field in memory: found {len(places)} points in a {data.GetClassName()} of "
                         f"{' x '.join(map(str, dims))}; expected {dims[0] * dims[1] * dims[2]}")
    number = numpy.arange(len(places), dtype="i4" if len(places) < 2**31 else "i8").reshape(*reversed(dims))
    lower, upper = number[:-1], number[1:]
    corners = [layer[:, y:dims[1] - 1 + y, x:dims[0] - 1 + x]
               for layer in (lower, upper) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    volume = Volume(places, numpy.stack(corners, -1).reshape(-1, 8), point_data=_arrays(data.GetPointData()),
                    cell_data=_arrays(data.GetCellData()))
    volume._vectors = _active_vectors(data.GetPointData(), data.GetCellData())
    return volume


def grid_of(data):
    """A Grid of a vtkImageData."""
    where = "grid in memory"
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
