"""save_animation(): the same files as the command line's."""
import os
import subprocess

import pytest

import aeolic

SMALL = {"surface": "sphere:800", "field": "rotation:8,8,8", "size": (60, 50), "steps": 20, "backend": "cpu"}


@pytest.mark.parametrize("name, options", [
    ("a.apng", {"frames": 3}),
    ("a.webp", {"flow": "loop", "frames": 5}),
    ("a.webp", {"flow": "loop"}),
    ("a.html", {"flow": "loop", "frames": 12}),
])
def test_gives_the_command_lines_bytes(tmp_path, name, options):
    renderer, ours, theirs = aeolic.Renderer(**SMALL, **options), tmp_path / name, tmp_path / f"by-program-{name}"
    before = renderer.render()._repr_png_()
    renderer.save_animation(ours)
    words = ["--surface", "sphere:800", "--field", "rotation:8,8,8", "--size", "60x50", "--steps", "20", "--backend", "cpu"]
    for key, value in options.items():
        words += [f"--{key}", str(value)]
    subprocess.run([os.environ["AEOLIC_PROGRAM"], "render", *words, "-o", str(theirs)], check=True)
    assert ours.read_bytes() == theirs.read_bytes()
    assert renderer.render()._repr_png_() == before, "the renderer is as it was"


def test_what_cannot_be_written_is_told_before_anything_is_drawn(tmp_path):
    renderer = aeolic.Renderer(**SMALL, frames=4)
    turning = aeolic.Renderer(**SMALL, flow="loop", orbit=90)
    with pytest.raises(aeolic.InputError, match="save_animation: found a cycle of streaks with orbit or time_range"):
        turning.save_animation(tmp_path / "a.apng")
    for name, told in [("a.gif", "save_animation: found"), ("a.html", "save_animation: found a .html of pictures that are not one cycle"),
                       ("none/a.apng", "the folder")]:
        with pytest.raises(aeolic.InputError, match=told):
            renderer.save_animation(tmp_path / name)
    assert os.listdir(tmp_path) == []


def test_an_error_in_progress_ends_it_and_leaves_nothing(tmp_path):
    seen = []

    def progress(what, part):
        seen.append((what, part))
        if part >= 0.5:
            raise KeyError("enough")

    renderer = aeolic.Renderer(**SMALL, flow="loop")
    with pytest.raises(KeyError):
        renderer.save_animation(tmp_path / "a.html", progress)
    assert seen[0] == ("frames", 0) and len(seen) == 5
    assert os.listdir(tmp_path) == []
    assert renderer.render() is not None
