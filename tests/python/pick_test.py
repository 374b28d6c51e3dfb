"""Renderer.pick() and buffers(): what a picture shows, as numbers."""
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
    assert place.vector_name == "U"
    assert renderer.pick(0, 0) is None
    assert renderer.pick(30, 20, camera={"azimuth": 20, "elevation": 60}).position != place.position
    with pytest.raises(aeolic.InputError, match="pick: pixel 80,0; expected 0,0 to 79,59"):
        renderer.pick(80, 0)


def test_buffers_of_all_pixels():
    points = numpy.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
    values = {"U": numpy.tile([1.0, 0, 1], (4, 1)), "p": points[:, 0]}
    surface = aeolic.Surface(points, numpy.array([[0, 1, 2], [0, 2, 3]]), point_data=values)
    renderer = aeolic.Renderer(surface, vectors="U", color_by="p", size=(80, 60), camera="top", antialias=False)
    seen = renderer.buffers()
    assert seen.depth.shape == seen.lic.shape == seen.scalar.shape == seen.covered.shape == (60, 80)
    assert seen.normal.shape == (60, 80, 3) and seen.flow.shape == (60, 80, 2)
    assert seen.surface.dtype == numpy.int32 and (seen.surface == numpy.where(seen.covered, 0, -1)).all()
    assert seen.covered[30, 40] and not seen.covered[0, 0] and numpy.isnan(seen.depth[0, 0])
    for x, y in ((30, 20), (50, 40)):
        place = renderer.pick(x, y)
        assert seen.depth[y, x] == pytest.approx(place.depth, rel=1e-5)
        assert seen.scalar[y, x] == pytest.approx(place.scalar, abs=1e-4)
        assert seen.normal[y, x] == pytest.approx((0, 0, 1), abs=1e-4)
        assert seen.flow[y, x, 0] > 0.5 and abs(seen.flow[y, x, 1]) < 0.01
    assert (renderer.buffers(camera={"azimuth": 20, "elevation": 60}).covered != seen.covered).any()
    plain = aeolic.Renderer(surface, vectors="U", size=(80, 60)).buffers()
    assert plain.scalar is None
    del renderer, surface
    assert numpy.isfinite(seen.depth[seen.covered]).all()
