"""aeolic.streamlines(): evenly spaced lines as arrays."""
import numpy
import pytest

import aeolic


def test_lines_run_downstream_and_keep_their_distance():
    found = aeolic.streamlines("plane:2000", field="uniform:8,8,8", overlay="streamlines:60", color_by="uniform:mag")
    assert len(found.lines) > 4 and found.spacing > 0 and found.scalar_name == "|uniform|"
    heights = []
    for line in found.lines:
        assert line.positions.shape == line.vectors.shape == (len(line.scalars), 3) and not line.closed
        assert (numpy.diff(line.positions[:, 0]) > 0).all()
        assert line.length == pytest.approx(numpy.linalg.norm(numpy.diff(line.positions, axis=0), axis=1).sum(), rel=1e-3)
        heights.append(line.positions[0, 1])
    assert numpy.diff(numpy.unique(numpy.round(heights, 6))).min() > 0.5 * found.spacing
    assert repr(found) == f"<aeolic.Streamlines, {len(found.lines)} lines {found.spacing:.6g} apart>"


def test_of_a_renderer_by_its_spacing():
    renderer = aeolic.Renderer("torus:2000", field="rotation:16,16,16", overlay="streamlines:80", size=(200, 200))
    wide = renderer.streamlines()
    assert any(line.closed for line in wide.lines) and wide.lines[0].scalars is None
    renderer.set(overlay="streamlines:20")
    assert renderer.streamlines().spacing < wide.spacing


def test_files_are_those_of_the_command_line(tmp_path):
    found = aeolic.streamlines("torus:2000", field="abc:16,16,16")
    found.save(tmp_path / "a.csv")
    found.save(tmp_path / "a.vtp")
    rows = (tmp_path / "a.csv").read_text().splitlines()
    assert rows[0] == "line,length,closed,x,y,z,vector x,vector y,vector z"
    assert len(rows) == 1 + sum(len(line.positions) for line in found.lines)
    assert (tmp_path / "a.vtp").read_bytes().startswith(b"<VTKFile")
    with pytest.raises(aeolic.InputError, match="path: found 'a.obj'; expected a name ending in .vtp or .csv"):
        found.save("a.obj")


def test_nothing_where_nothing_flows():
    points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
    still = aeolic.Surface(points, [[0, 1, 2]], point_data={"U": numpy.zeros((3, 3))})
    assert aeolic.streamlines(still, vectors="U").lines == ()
