"""examples/paraview/aeolic_macro.py in ParaView's own Python: its pictures show what ParaView's views show."""
import json
import os
import pathlib
import shutil
import subprocess

import numpy
import pytest

from scenes import Sheet

HERE = pathlib.Path(__file__).resolve().parent
UNPACKED = pathlib.Path(os.environ.get("PEER_PREFIX", "/opt/peer-paraview"))


def pvpython():
    """How to run ParaView's Python: that of the path, or what bench/peers/unpack has unpacked."""
    if not shutil.which("xvfb-run"):
        pytest.skip("no xvfb-run: ParaView needs a display")
    if (UNPACKED / "usr/bin/pvpython").exists():
        return [HERE.parents[1] / "bench/peers/pvpython"]
    if shutil.which("pvpython"):
        return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", "pvpython"]
    pytest.skip("no pvpython: neither installed nor unpacked by bench/peers/unpack")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """The folder with all pictures, what the script found, and what it printed."""
    words = pvpython()
    folder = tmp_path_factory.mktemp("paraview")
    Sheet(32).write(folder / "body.vtp")
    Sheet(32, bend=-0.5).write(folder / "other.vtp")
    steps = "".join(f'<DataSet timestep="{i}" file="{name}.vtp"/>' for i, name in enumerate(("body", "other")))
    (folder / "series.pvd").write_text('<?xml version="1.0"?><VTKFile type="Collection" version="0.1"><Collection>'
                                       f"{steps}</Collection></VTKFile>")
    # A sanitizer's runtime is for the module alone.
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("LD_PRELOAD", "PYTHONPATH", "XDG_CONFIG_HOME")}
    done = subprocess.run([*words, HERE / "in_paraview.py", folder], capture_output=True, text=True, timeout=240,
                          env={**environment, "AEOLIC": os.environ["AEOLIC_PROGRAM"], "TMPDIR": str(folder),
                               "HOME": str(folder)})  # ParaView's settings are another user's.
    assert done.returncode == 0, done.stderr[-3000:]
    return folder, json.loads((folder / "facts.json").read_text()), done.stdout


def pictures(folder, name):
    return numpy.load(folder / f"{name}-view.npy").astype(float), numpy.load(folder / f"{name}-macro.npy").astype(float)


def covered(picture):
    return (abs(picture - picture[0, 0]) > 12).any(2)


def blocks(view, drawn, side=10):
    """The squares that the surface covers in both pictures."""
    both = covered(view) & covered(drawn)
    for y in range(0, view.shape[0] - side, side):
        for x in range(0, view.shape[1] - side, side):
            if both[y:y + side, x:x + side].all():
                yield view[y:y + side, x:x + side], drawn[y:y + side, x:x + side]


@pytest.mark.parametrize("name", ["points", "log", "cells", "component", "parts", "time"])
def test_the_surface_is_where_the_view_has_it(run, name):
    view, drawn = pictures(run[0], name)
    here, there = covered(view), covered(drawn)
    assert here.sum() > 5000
    assert (here & there).sum() > 0.98 * (here | there).sum()
    assert abs(view[0, 0] - drawn[0, 0]).max() <= 1, "the background"


@pytest.mark.parametrize("name", ["points", "log", "component", "parts", "time"])
def test_the_colours_are_those_of_the_view(run, name):
    found = list(blocks(*pictures(run[0], name)))
    assert len(found) > 50
    for block, other in found:  # Light and streaks change how bright a colour is.
        ours, theirs = block.mean((0, 1)), other.mean((0, 1))
        assert ours @ theirs > 0.97 * numpy.linalg.norm(ours) * numpy.linalg.norm(theirs)


def test_values_beyond_the_range_have_the_views_colours(run):
    _, drawn = pictures(run[0], "cells")
    red, green, blue = (drawn[covered(drawn)] > 100).T
    assert (red & blue & ~green).mean() > 0.3, "above"
    assert (blue & ~red & ~green).mean() > 0.01, "below"
    assert (red & green & ~blue).mean() > 0.05, "within"


def test_a_legend_is_there_where_the_view_has_one(run):
    plain, drawn = numpy.load(run[0] / "cells-macro.npy"), numpy.load(run[0] / "legend-macro.npy")
    changed = (plain != drawn).any(2)
    assert changed[:, 200:].sum() > 300
    assert not changed[covered(plain)].any()


def test_there_are_streaks(run):
    """A view of one colour: what is left are light and streaks."""
    spread = numpy.array([[view.std(), drawn.std()] for view, drawn in blocks(*pictures(run[0], "time"))]).mean(0)
    assert spread[0] < 1
    assert spread[1] > 10


def test_streaks_follow_what_surface_lic_follows(run):
    folder, facts, _ = run
    if "no Surface LIC" in facts:
        pytest.skip(facts["no Surface LIC"])
    along, across = pictures(folder, "first")[1], numpy.load(folder / "chosen-macro.npy").astype(float)
    assert (covered(along) == covered(across)).mean() > 0.99

    def roughness(picture, axis):
        return abs(numpy.diff(picture[80:120, 130:160, 0], axis=axis)).mean()
    assert roughness(along, 1) < 0.7 * roughness(along, 0)
    assert roughness(across, 0) < 0.7 * roughness(across, 1)


def test_the_picture_is_shown_beside_the_view(run):
    folder, facts, _ = run
    assert facts["shown"] == {"views": 1, "source": True, "view": True}
    shown = numpy.load(folder / "shown.npy").astype(float)
    assert abs(shown - numpy.load(folder / "points-macro.npy")).mean() < 1
    assert facts["points"]["active"] and facts["points"]["sources"] == 1, "nothing stays in the pipeline browser"


def test_the_menu_runs_it(run):
    folder, _, printed = run
    path = pathlib.Path(printed.strip())
    assert path.parent.parent == folder
    assert path.read_bytes() == (folder / "points.png").read_bytes()


@pytest.mark.parametrize("case, words", [
    ("no source", "there is no active source"), ("no vectors", "the active source has no vectors; expected an array of three"),
    ("no surface", "the active source has no surface"), ("no program", "there is no program aeolic on the path"),
    ("no folder", "none.png: the folder"), ("of itself", "the active source is Aeolic's own picture")])
def test_what_cannot_be_drawn_gets_one_line(run, case, words):
    said = run[1][case]
    assert words in said
    assert "\n" not in said
