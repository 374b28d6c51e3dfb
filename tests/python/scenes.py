"""Small scenes for the tests of the Python module, as files and as arrays with the same contents."""
import base64
import struct

import numpy

SMALL = {"size": (48, 36), "steps": 9, "backend": "cpu", "threads": 1}


def data_array(name, values):
    """A <DataArray> of VTK's XML files, (n,) or (n, components)."""
    packed = base64.b64encode(struct.pack("<Q", values.nbytes) + numpy.ascontiguousarray(values).tobytes()).decode()
    kind = {"f4": "Float32", "f8": "Float64", "i8": "Int64", "u1": "UInt8"}[values.dtype.str[1:]]
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{values.size // max(len(values), 1)}" '
            f'format="binary">{packed}</DataArray>')


def vtk_file(kind, body):
    return (f'<?xml version="1.0"?><VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
            f"{body}</VTKFile>")


class Sheet:
    """n x n quads over [0, 1]^2, bent, with vectors and scalars on points and cells."""

    def __init__(self, n=4, bend=0.3):
        y, x = numpy.meshgrid(numpy.linspace(0, 1, n + 1), numpy.linspace(0, 1, n + 1), indexing="ij")
        z = bend * x * y
        self.points = numpy.stack([x, y, z], -1).reshape(-1, 3).astype("f4")
        corner = numpy.arange((n + 1) * n).reshape(n, n + 1)[:, :n].reshape(-1)
        quads = numpy.stack([corner, corner + 1, corner + n + 2, corner + n + 1], -1)
        self.triangles = numpy.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]], 1).reshape(-1, 3)
        self.tau = numpy.stack([1 + y, x, z], -1).reshape(-1, 3).astype("f4")
        self.q = (x + 2 * y).reshape(-1).astype("f4")
        self.cell = numpy.arange(len(self.triangles), dtype="f4")

    def write(self, path, **point_data):
        """A .vtp with tau, q and c, and with other arrays on points."""
        arrays = "".join(data_array(name, values) for name, values in {"tau": self.tau, "q": self.q, **point_data}.items())
        ends = 3 * numpy.arange(1, len(self.triangles) + 1)
        path.write_text(vtk_file("PolyData", (
            f'<PolyData><Piece NumberOfPoints="{len(self.points)}" NumberOfPolys="{len(self.triangles)}">'
            f'<PointData Vectors="tau">{arrays}</PointData><CellData>{data_array("c", self.cell)}</CellData>'
            f'<Points>{data_array("Points", self.points)}</Points>'
            f'<Polys>{data_array("connectivity", self.triangles.reshape(-1).astype("i8"))}'
            f'{data_array("offsets", ends.astype("i8"))}</Polys></Piece></PolyData>')))
        return path


class Box:
    """Samples of a flow around the sheet."""

    origin, spacing = (-0.5, -0.5, -0.5), (0.25, 0.25, 0.5)

    def __init__(self):
        z, y, x = numpy.meshgrid(numpy.arange(5) * 0.5 - 0.5, numpy.arange(8) * 0.25 - 0.5, numpy.arange(9) * 0.25 - 0.5,
                                 indexing="ij")
        self.u = numpy.stack([1 + y, x - z, x * y], -1).astype("f4")
        self.p = (x + y * z).astype("f4")

    def write(self, path):
        """A .vti, or a .vtr, whose samples lie closer at its beginning."""
        arrays = f'<PointData>{data_array("U", self.u.reshape(-1, 3))}{data_array("p", self.p.reshape(-1))}</PointData>'
        if path.suffix == ".vtr":
            places = [start + step * count * (numpy.arange(count) / count) ** 1.5
                      for start, step, count in zip(self.origin, self.spacing, (9, 8, 5))]
            path.write_text(vtk_file("RectilinearGrid", (
                f'<RectilinearGrid WholeExtent="0 8 0 7 0 4"><Piece Extent="0 8 0 7 0 4">{arrays}<Coordinates>'
                f'{"".join(data_array(name, values) for name, values in zip("xyz", places))}</Coordinates></Piece>'
                '</RectilinearGrid>')))
            return path
        path.write_text(vtk_file("ImageData", (
            f'<ImageData WholeExtent="0 8 0 7 0 4" Origin="{" ".join(map(str, self.origin))}" '
            f'Spacing="{" ".join(map(str, self.spacing))}"><Piece Extent="0 8 0 7 0 4">{arrays}</Piece></ImageData>')))
        return path


class Bricks:
    """Hexahedra and tetrahedra around the sheet, with the flow of the box."""

    def __init__(self, stretch=0.1):
        z, y, x = numpy.meshgrid(numpy.arange(4) * 0.6 - 0.5, numpy.arange(5) * 0.5 - 0.5, numpy.arange(5) * 0.4 - 0.5,
                                 indexing="ij")
        x = x + stretch * x * x
        self.points = numpy.stack([x, y, z], -1).reshape(-1, 3).astype("f4")
        first = (numpy.arange(3)[:, None, None] * 25 + numpy.arange(4)[:, None] * 5 + numpy.arange(4)).reshape(-1)
        corners = first[:, None] + numpy.array([0, 1, 6, 5, 25, 26, 31, 30])
        self.hexahedra = corners.astype("i4")
        split = numpy.array([[0, 1, 3, 4], [1, 2, 3, 6], [4, 6, 5, 1], [4, 7, 6, 3], [1, 3, 4, 6]])
        self.tetrahedra = corners[:, split].reshape(-1, 4).astype("i8")
        self.u = numpy.stack([1 + y, x - z, x * y], -1).reshape(-1, 3).astype("f4")
        self.p = (x + y * z).reshape(-1).astype("f4")

    def mixed(self):
        """(offsets, connectivity), types: every second brick as tetrahedra."""
        kinds, parts = [], []
        for i, brick in enumerate(self.hexahedra):
            cells = [(12, brick)] if i % 2 else [(10, cell) for cell in self.tetrahedra[5 * i:5 * i + 5]]
            kinds += [kind for kind, _ in cells]
            parts += [corners for _, corners in cells]
        ends = numpy.cumsum([0] + [len(part) for part in parts])
        return (ends, numpy.concatenate(parts)), numpy.array(kinds, "u1")

    def write(self, path, cells, types):
        """A .vtu of the cells (offsets, connectivity) of these types."""
        offsets, connectivity = (numpy.asarray(row).astype("i8") for row in cells)
        path.write_text(vtk_file("UnstructuredGrid", (
            f'<UnstructuredGrid><Piece NumberOfPoints="{len(self.points)}" NumberOfCells="{len(types)}">'
            f'<PointData>{data_array("U", self.u)}{data_array("p", self.p)}</PointData>'
            f'<Points>{data_array("Points", self.points)}</Points><Cells>{data_array("connectivity", connectivity)}'
            f'{data_array("offsets", offsets[1:])}{data_array("types", types.astype("u1"))}</Cells></Piece></UnstructuredGrid>')))
        return path


def same(one, other):
    return numpy.array_equal(numpy.asarray(one), numpy.asarray(other))
