"""renderer.time and frames() of data that change."""
import time

import pytest

import aeolic
from scenes import SMALL, same
from show_test import picture_at

MOVING = {"surface": "wave", "field": "gyre", **SMALL}


@pytest.fixture(name="expected")
def _expected():
    return list(aeolic.Renderer(**MOVING, frames=4, time_range=(0, 3)).frames())


def still(moment):
    return aeolic.Renderer(**MOVING, time=moment).render()


def test_a_moment_leaves_the_animation_as_it_is(expected):
    movie = aeolic.Renderer(**MOVING, frames=4, time_range=(0, 3))
    movie.time = 1
    assert same(movie.render(), still(1))
    assert all(map(same, movie.frames(), expected))
    assert movie.time == 1
    assert same(movie.render(), still(1))
    assert movie.scene["time"] == {"range": [0, 3]}


def test_a_moment_within_the_animation(expected):
    movie = aeolic.Renderer(**MOVING, frames=4, time_range=(0, 3))
    frames = movie.frames()
    assert same(next(frames), expected[0])
    movie.time = 2
    assert same(next(frames), expected[1])
    assert same(movie.render(), still(2))
    assert same(next(frames), expected[2])


def test_without_an_animation_in_time_the_scene_tells_the_moment():
    renderer = aeolic.Renderer(**MOVING)
    renderer.time = 1.5
    assert renderer.scene["time"] == {"moment": 1.5}
    assert same(aeolic.Renderer(**MOVING, frames=3, time=1.5).render(), renderer.render())


def test_viewers_see_the_moment_and_not_the_animation():
    movie = aeolic.Renderer(**MOVING, frames=4, time_range=(0, 3))
    with movie.show(browser=False) as viewer:
        assert picture_at(viewer) == still(0)._repr_png_()
        movie.time = 1
        time.sleep(0.2)
        assert picture_at(viewer) == still(1)._repr_png_()
        list(movie.frames())
        assert picture_at(viewer) == still(1)._repr_png_()
        assert same(movie.render(), still(1))
