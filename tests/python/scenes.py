"""Small scenes for the tests of the Python module, as files and as arrays with the same contents."""
import numpy

SMALL = {"size": (48, 36), "steps": 9, "backend": "cpu", "threads": 1}


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

    def write(self, path):
        def array(name, values):
            return (f'<DataArray type="Float32" Name="{name}" NumberOfComponents="{values.size // len(values)}" '
                    f'format="ascii">{" ".join(repr(float(v)) for v in values.reshape(-1))}</DataArray>')
        cells = " ".join(str(i) for i in self.triangles.reshape(-1))
        offsets = " ".join(str(3 * (i + 1)) for i in range(len(self.triangles)))
        path.write_text(
            '<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
            f'<PolyData><Piece NumberOfPoints="{len(self.points)}" NumberOfPolys="{len(self.triangles)}">'
            f'<PointData>{array("tau", self.tau)}{array("q", self.q)}</PointData><CellData>{array("c", self.cell)}</CellData>'
            f'<Points>{array("Points", self.points)}</Points>'
            f'<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{cells}</DataArray>'
            f'<DataArray type="Int64" Name="offsets" format="ascii">{offsets}</DataArray></Polys>'
            '</Piece></PolyData></VTKFile>')
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
        def array(name, values, components):
            return (f'<DataArray type="Float32" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                    f'{" ".join(repr(float(v)) for v in values.reshape(-1))}</DataArray>')
        path.write_text(
            '<?xml version="1.0"?><VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
            f'<ImageData WholeExtent="0 8 0 7 0 4" Origin="{" ".join(map(str, self.origin))}" '
            f'Spacing="{" ".join(map(str, self.spacing))}"><Piece Extent="0 8 0 7 0 4"><PointData>'
            f'{array("U", self.u, 3)}{array("p", self.p, 1)}</PointData></Piece></ImageData></VTKFile>')
        return path


def same(one, other):
    return numpy.array_equal(numpy.asarray(one), numpy.asarray(other))
