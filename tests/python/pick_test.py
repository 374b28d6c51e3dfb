"""Renderer.pick(): what a picture shows at a pixel."""
import numpy
import pytest

import aeolic


def test_values_at_a_pixel():
    points = numpy.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
    values = {"U": points @ numpy.array([[0, 1, 0], [2, 0, 0], [0, 0, 0]]) + [0, 0, 1], "p": points[:, 0] + 10 * points[:, 1]}
    surface = aeolic.Surface(points, numpy.array([[0, 1, 2], [0, 2, 3]]), point_data=values)
    renderer = aeolic.Renderer(surface, vectors="U", color_by="p", size=(80, 60), camera="top")
    place = renderer.pick(30, 20)
    x, y, z = place.position
    assert 0 < x < 4 and 0 < y < 4 and abs(z) < 1e-6
    assert place.vector == pytest.approx((2 * y, x, 1), rel=1e-5)
    assert place.tangential == pytest.approx((2 * y, x, 0), rel=1e-5, abs=1e-6)
    assert place.normal == pytest.approx((0, 0, 1)) and place.triangle in (0, 1)
    assert place.scalar == pytest.approx(x + 10 * y, rel=1e-5) and place.scalar_name == "p"
    assert renderer.pick(0, 0) is None
    assert renderer.pick(30, 20, camera={"azimuth": 20, "elevation": 60}).position != place.position
    with pytest.raises(aeolic.InputError, match="pick: pixel 80,0; expected 0,0 to 79,59"):
        renderer.pick(80, 0)
