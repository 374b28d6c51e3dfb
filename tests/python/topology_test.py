"""aeolic.topology(): critical points and the lines between them."""
import numpy
import pytest

import aeolic


def square(n=41, flow=None):
    """A plane of points in which the flow turns around the middle and stops at two saddles, or flow(x, y)."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(-2, 2, n), numpy.linspace(-2, 2, n)))
    points = numpy.stack([x, y, 0 * x], axis=1)
    corner = (numpy.arange(n - 1)[:, None] * n + numpy.arange(n - 1)).ravel()
    triangles = numpy.concatenate([numpy.stack([corner, corner + 1, corner + n + 1], axis=1),
                                   numpy.stack([corner, corner + n + 1, corner + n], axis=1)])
    # A node at (0, 0.01) that repels, saddles at x = ±1.
    along_x, along_y = flow(x, y) if flow else (x * (1 - x * x), y - 0.01)
    vectors = numpy.stack([along_x, along_y, 0 * x], axis=1)
    return aeolic.Surface(points, triangles, point_data={"U": vectors, "p": x})


def test_points_and_lines_as_arrays():
    found = aeolic.topology(square(), vectors="U", color_by="p")
    order = numpy.argsort(found.positions[:, 0])
    assert [found.kinds[i] for i in order] == ["saddle", "node", "saddle"]
    numpy.testing.assert_allclose(found.positions[order], [[-1, 0.01, 0], [0, 0.01, 0], [1, 0.01, 0]], atol=0.01)
    assert list(found.indices[order]) == [-1, 1, -1] and list(found.attracts[order]) == [0, -1, 0]
    numpy.testing.assert_allclose(found.scalars[order], [-1, 0, 1], atol=0.01)
    assert found.scalar_name == "p" and found.vectors.shape == (3, 3)
    assert sorted(line.kind for line in found.lines) == 4 * ["attachment"] + 4 * ["separation"]
    inner = [line for line in found.lines if line.end is not None]
    assert len(inner) == 2 and all(line.kind == "attachment" and found.kinds[line.end] == "node" for line in inner)
    for line in found.lines:
        assert line.positions.shape == line.vectors.shape == (len(line.scalars), 3)
        numpy.testing.assert_allclose(line.positions[0], found.positions[line.saddle], atol=1e-12)
        assert line.length == pytest.approx(numpy.linalg.norm(numpy.diff(line.positions, axis=0), axis=1).sum(), rel=1e-6)
    assert repr(found) == "<aeolic.Topology of 3 points and 8 lines>"


def test_of_a_renderer_at_its_moment_and_persistence():
    renderer = aeolic.Renderer(square(), vectors="U", persistence=0, size=(16, 16))
    assert len(renderer.topology().kinds) == 3
    renderer.set(persistence=1)
    assert len(renderer.topology().kinds) < 3
    assert renderer.topology().scalars is None and renderer.topology().lines[0].scalars is None


def test_nothing_where_nothing_stands_still():
    found = aeolic.topology("torus:500", field="rotation:8,8,8")
    assert found.positions.shape == (0, 3) and found.kinds == () and found.lines == ()


def test_files_are_those_of_the_command_line(tmp_path):
    found = aeolic.topology(square(), vectors="U")
    found.save(tmp_path / "a.csv")
    found.save(tmp_path / "a.vtp")
    rows = (tmp_path / "a.csv").read_text().splitlines()
    assert rows[0].startswith("line,type,attracts") and len(rows) == 1 + 3 + sum(len(line.positions) for line in found.lines)
    assert (tmp_path / "a.vtp").read_bytes().startswith(b"<VTKFile")
    with pytest.raises(aeolic.InputError, match="path: found 'a.obj'; expected a name ending in .vtp or .csv"):
        found.save("a.obj")
    with pytest.raises(OSError):
        found.save(tmp_path / "none" / "a.csv")


def test_open_lines_where_streamlines_gather():
    gathered = square(flow=lambda x, y: (1 + 0 * x, -1.5 * y))
    found = aeolic.separation(gathered, vectors="U", color_by="p")
    assert len(found.kinds) == 0 and len(found.lines) == 1 and found.scalar_name == "p"
    line = found.lines[0]
    assert line.kind == "separation" and line.saddle is None and line.end is None and line.strength > 0.69
    assert abs(line.positions[:, 1]).max() < 0.1 and (numpy.diff(line.positions[:, 0]) > 0).all()
    renderer = aeolic.Renderer(gathered, vectors="U", overlay="separation", size=(120, 90))
    assert len(renderer.separation().lines) == 1
    with_line = numpy.asarray(renderer.render()).copy()
    renderer.set(overlay="none")
    assert (numpy.asarray(renderer.render()) != with_line).any()
