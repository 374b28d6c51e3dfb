"""Surfaces, grids and volumes in memory: numpy arrays, looked at but not copied where that is possible."""
import numpy

from . import _core
from ._checks import suggesting, text

InputError = _core.InputError

_TYPES = ("f4", "f8", "i4", "i8", "u4", "u1")  # What the library reads as it is.


def _numbers(where, value, indices=False):
    """The values as an array of a type that the library reads; the array itself where it has one."""
    if value is None:
        raise InputError(f"{where}: found None; expected numbers")
    if numpy.ma.isMaskedArray(value):
        if indices and numpy.ma.is_masked(value):
            raise InputError(f"{where}: found masked values; expected whole numbers")
        bare = numpy.ma.getdata(value)
        value = bare if indices or bare.dtype.kind not in "fiub" else value.astype(float).filled(numpy.nan)
    try:
        array = numpy.asarray(value)
    except ValueError as error:  # Rows of different lengths.
        raise InputError(f"{where}: {error}; expected an array of numbers") from None
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind not in "fiub":
        raise InputError(f"{where}: found values of type {array.dtype}; expected numbers")
    if array.dtype.str[1:] not in _TYPES:
        small = size < 4
        array = array.astype({"f": "f4" if small else "f8", "i": "i4" if small else "i8", "b": "u1",
                              "u": "i4" if small else "i8" if indices else "f8"}[kind])
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _tuples(array):
    """The array with nothing between the components of a tuple; itself where that is so."""
    steps, size = array.strides, array.itemsize
    width = size * (array.shape[1] if array.ndim == 2 else 1)
    fits = (array.ndim == 1 or array.shape[1] <= 1 or steps[1] == size) and (array.shape[0] <= 1 or steps[0] >= width)
    return array if fits and array.flags.aligned else numpy.ascontiguousarray(array)


def _table(where, value, columns, what, indices=False):
    array = _numbers(where, value, indices)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(f"{where}: found shape {array.shape}; expected ({what}, {columns})")
    return _tuples(array)


def _row(where, value):
    array = _numbers(where, value, indices=True)
    if array.ndim != 1:
        raise InputError(f"{where}: found shape {array.shape}; expected one row of numbers")
    return _tuples(array)


def _whole(where, array):
    if array.size == 0:
        return array.astype("i8")
    if array.dtype.str[1:] not in ("i4", "i8", "u4"):
        if array.dtype.kind not in "iu":
            raise InputError(f"{where}: found values of type {array.dtype}; expected whole numbers")
        array = array.astype("i8")  # Beyond 2^63 they become negative, and point nowhere all the same.
    return array


def _named(where, data):
    if data is None:
        return []
    if not hasattr(data, "items"):
        raise InputError(f"{where}: found {type(data).__name__}; expected a dict of arrays by name")
    arrays = []
    for name, value in data.items():
        if not isinstance(name, str):
            raise InputError(f"{where}: found {name!r} as a name; expected a text")
        arrays.append((text(f"{where}: name of an array", name), _numbers(f"{where}: array {name!r}", value)))
    return arrays


def _flat(where, data):
    """Arrays of points or cells: (n,) or (n, components)."""
    arrays = []
    for name, array in _named(where, data):
        if array.ndim not in (1, 2):
            raise InputError(f"{where}: array {name!r}: found shape {array.shape}; expected (n,) or (n, components)")
        arrays.append((name, _tuples(array)))
    return arrays


def _places(where, points):
    place = _table(f"{where}: points", points, 3, "points")
    return place if place.dtype.kind == "f" else place.astype("f8")


def _pair(where, names, given):
    """Two rows of whole numbers."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise InputError(f"{where}: expected a pair ({', '.join(names)})")
    where = where.split(": ")[0]
    return [_whole(f"{where}: {name}", _row(f"{where}: {name}", value)) for name, value in zip(names, given)]


class Surface:
    """A surface of triangles or polygons in memory.

    points: (n, 3) numbers, world units.
    triangles: (m, 3) whole numbers, the indices of their points. Or, instead of them,
    polygons: a pair (offsets, connectivity): where in connectivity each polygon begins (m + 1 numbers, the last one is
        the length of connectivity), and the indices of all polygons' points, one polygon after the other.
    point_data, cell_data: dicts of arrays by name, (n,) or (n, components), and (m,) or (m, components).

    Values that are not finite, and masked values of masked arrays, are left out of the picture. A point array called
    "Normals" is used as such. Contiguous arrays of float32, float64, int32, int64 and uint32 are not copied here; a
    Renderer copies what it needs of them, so later changes do not show (see Renderer.set_data).

    Raises InputError for arrays of a wrong shape or type. Indices and lengths are checked by the Renderer.
    """

    @suggesting
    def __init__(self, points, triangles=None, *, polygons=None, point_data=None, cell_data=None):
        where = "surface in memory"
        offsets = connectivity = corners = None
        if polygons is not None:
            if triangles is not None:
                raise InputError(f"{where}: triangles and polygons; expected one or the other")
            offsets, connectivity = _pair(f"{where}: polygons", ("offsets", "connectivity"), polygons)
        else:
            corners = _whole(f"{where}: triangles", _table(f"{where}: triangles", triangles, 3, "triangles", indices=True))
        self._memory = {
            "points": _places(where, points), "triangles": corners, "offsets": offsets, "connectivity": connectivity,
            "point_data": _flat(f"{where}: point_data", point_data),
            "cell_data": _flat(f"{where}: cell_data", cell_data), "active": {}}

    def __repr__(self):
        cells = self._memory["triangles"]
        count = max(len(self._memory["offsets"]) - 1, 0) if cells is None else len(cells)
        return f"<aeolic.Surface of {len(self._memory['points'])} points and {count} cells>"


class Grid:
    """Samples on a uniform grid in memory.

    origin: 3 numbers, the world position of the first sample.
    spacing: 3 numbers, or one for all directions: world units between samples.
    point_data: a dict of arrays by name: vectors (nz, ny, nx, 3), scalars (nz, ny, nx). array[k, j, i] is the sample at
        origin + (i, j, k) * spacing.
    cell_data: the same with a value for each cell: (nz - 1, ny - 1, nx - 1, …), 1 where there is one sample.

    Contiguous vectors of float32 that are all finite are not copied at all: do not change them while a Renderer uses
    them, but give it others by Renderer.set_data(). All others are copied, by numpy or by the Renderer.

    Raises InputError for arrays of a wrong shape or type.
    """

    @suggesting
    def __init__(self, origin, spacing, point_data, cell_data=None):
        where = "grid in memory"
        steps = _numbers(f"{where}: spacing", spacing)
        steps = numpy.repeat(steps, 3) if steps.ndim == 0 else steps
        self._memory = {"origin": self._three(f"{where}: origin", origin),
                        "spacing": self._three(f"{where}: spacing", steps), "active": {}}
        dims = None
        for key, data, less in (("point_data", point_data, 0), ("cell_data", cell_data, 1)):
            arrays = []
            for name, array in _named(f"{where}: {key}", data):
                if array.ndim not in (3, 4):
                    raise InputError(f"{where}: array {name!r}: found shape {array.shape}; "
                                     "expected (nz, ny, nx) or (nz, ny, nx, components)")
                dims = dims or tuple(count + less for count in array.shape[:3])
                expected = tuple(max(count - less, min(count, 1)) for count in dims)
                if array.shape[:3] != expected:
                    raise InputError(f"{where}: array {name!r}: found shape {array.shape}; expected "
                                     f"{expected + array.shape[3:]} beside the other arrays")
                components = array.shape[3] if array.ndim == 4 else 1
                count = array.shape[0] * array.shape[1] * array.shape[2]
                rows = numpy.ascontiguousarray(array).reshape(count, components)
                arrays.append((name, _tuples(rows)))
            self._memory[key] = arrays
        self._memory["dims"] = tuple(reversed(dims or (0, 0, 0)))

    @staticmethod
    def _three(where, value):
        array = _numbers(where, value)
        if array.shape != (3,):
            raise InputError(f"{where}: found shape {array.shape}; expected 3 numbers")
        return [float(number) for number in array]

    def __repr__(self):
        return "<aeolic.Grid of {} x {} x {} samples>".format(*self._memory["dims"])


_CORNERS = {4: 10, 5: 14, 6: 13, 8: 12}  # VTK's type of the cell with so many corners.


class Volume:
    """Cells in space in memory, such as tetrahedra and hexahedra. Values are looked up in the cells as they are.

    points: (n, 3) numbers, world units.
    cells: (m, 4) whole numbers, the corners of tetrahedra; (m, 5) of pyramids, (m, 6) of wedges, (m, 8) of hexahedra, in
        VTK's order. Or a tuple (offsets, connectivity): where in connectivity each cell begins (m + 1 numbers, the last one
        is the length of connectivity), and the corners of all cells, one cell after the other.
    types: (m,) VTK's numbers of cell types (10 tetrahedron, 12 hexahedron, 13 wedge, 14 pyramid, 42 polyhedron …), or one
        for all. None: as the number of corners says.
    faces: of polyhedra alone, a pair (faces, locations), as vtkUnstructuredGrid has them: for each polyhedron the number
        of its faces, and for each of these the number of its corners and the corners; and (m,) where in faces each cell
        begins, -1 for other cells.
    point_data, cell_data: dicts of arrays by name, (n,) or (n, components), and (m,) or (m, components).

    Contiguous arrays of float32, float64, int32, int64, uint32 and uint8 are not copied here; a Renderer copies what it
    needs of them, so later changes do not show (see Renderer.set_data).

    Raises InputError for arrays of a wrong shape or type. Indices and lengths are checked by the Renderer.
    """

    @suggesting
    def __init__(self, points, cells, types=None, *, faces=None, point_data=None, cell_data=None):
        where = "volume in memory"
        if isinstance(cells, tuple):
            offsets, connectivity = _pair(f"{where}: cells", ("offsets", "connectivity"), cells)
            if types is None:
                raise InputError(f"{where}: types: found None; expected VTK's numbers of cell types beside (offsets, connectivity)")
        else:
            offsets, connectivity, kind = self._of_one_kind(f"{where}: cells", cells)
            types = kind if types is None else types
        count = max(len(offsets) - 1, 0)
        kinds = _numbers(f"{where}: types", types, indices=True)
        kinds = _row(f"{where}: types", numpy.full(count, kinds) if kinds.ndim == 0 else kinds)
        if kinds.dtype != numpy.uint8:
            kinds = _whole(f"{where}: types", kinds)
        stream, locations = (None, None) if faces is None else _pair(f"{where}: faces", ("faces", "locations"), faces)
        self._memory = {
            "points": _places(where, points), "types": kinds, "offsets": offsets, "connectivity": connectivity,
            "faces": stream, "face_locations": locations, "point_data": _flat(f"{where}: point_data", point_data),
            "cell_data": _flat(f"{where}: cell_data", cell_data), "active": {}, "dims": (0, 0, 0), "axes": (None,) * 3}

    @classmethod
    def _structured(cls, dims, points, axes, point_data, cell_data):
        """A structured grid of dims points, or a rectilinear one with axes in the place of points."""
        where = "volume in memory"
        volume = cls(numpy.empty((0, 3)) if points is None else points, ([], []), [], point_data=point_data, cell_data=cell_data)
        volume._memory["dims"] = tuple(dims)
        if axes is not None:
            volume._memory["axes"] = tuple(_row(f"{where}: coordinates", axis) for axis in axes)
        return volume

    @staticmethod
    def _of_one_kind(where, cells):
        """(offsets, connectivity, type) of (m, corners) numbers."""
        table = _numbers(where, cells, indices=True)
        if table.ndim != 2 or table.shape[1] not in _CORNERS:
            raise InputError(f"{where}: found shape {table.shape}; expected (cells, 4), (cells, 5), (cells, 6) or (cells, 8), "
                             "or a tuple (offsets, connectivity)")
        corners = table.shape[1]
        flat = numpy.ascontiguousarray(_whole(where, table)).reshape(-1)
        return numpy.arange(0, flat.size + 1, corners, dtype="i8"), flat, _CORNERS[corners]

    def __repr__(self):
        dims = self._memory["dims"]
        if max(dims) > 0:
            return "<aeolic.Volume of {} x {} x {} points>".format(*dims)
        return f"<aeolic.Volume of {len(self._memory['points'])} points and {len(self._memory['types'])} cells>"
