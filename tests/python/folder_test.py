"""A program that goes to another folder after it has made a Renderer of files with relative names."""
import os

import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Sheet


def bytes_of(picture):
    return numpy.asarray(picture).tobytes()


@pytest.fixture
def series(tmp_path, monkeypatch):
    """Three steps of a sheet and of a flow in a folder of the process; others of the same names in one it goes to."""
    for folder, bend in (("here", 0.3), ("there", 0.9)):
        (tmp_path / folder / "run").mkdir(parents=True)
        for step in range(3):
            Sheet(bend=bend + 0.2 * step).write(tmp_path / folder / "run" / f"sheet_{step}.vtp")
            box = Box()
            box.u = box.u * numpy.float32(1 + step * bend)
            box.write(tmp_path / folder / "run" / f"box_{step}.vti")
    monkeypatch.chdir(tmp_path / "here")
    return tmp_path


def pictures(go, **sources):
    renderer = aeolic.Renderer(**sources, **SMALL)
    shown = [bytes_of(renderer.render())]
    go()
    for moment in (1, 2, 0.5, 0):
        renderer.time = moment
        shown.append(bytes_of(renderer.render()))
    return shown


@pytest.mark.parametrize("sources", [
    {"surface": "run/sheet_%d.vtp"},
    {"surface": "run/sheet_*.vtp", "field": "run/box_%d.vti", "color_by": "p"},
    {"surface": "run/all.pvd"},
])
def test_other_moments_are_those_of_the_first_folder(series, sources):
    if sources["surface"].endswith(".pvd"):
        steps = "".join(f'<DataSet timestep="{i}" file="sheet_{i}.vtp"/>' for i in range(3))
        for folder in ("here", "there"):
            (series / folder / "run" / "all.pvd").write_text(
                f'<VTKFile type="Collection"><Collection>{steps}</Collection></VTKFile>')
    stayed = pictures(lambda: None, **sources)
    assert len(set(stayed)) == 4  # The moments differ.
    assert pictures(lambda: os.chdir(series / "there"), **sources) == stayed


def test_messages_have_the_names_that_were_given(series):
    renderer = aeolic.Renderer("run/sheet_%d.vtp", **SMALL)
    os.chdir(series)
    (series / "here" / "run" / "sheet_2.vtp").unlink()
    with pytest.raises(aeolic.InputError) as told:
        renderer.time = 2
    assert str(told.value).startswith("run/sheet_2.vtp: ")


def test_a_colour_map_is_read_from_the_folder_in_which_it_is_named(series):
    """And once: the same name means the same colours from then on."""
    red, blue = "0,0,0,0\n1,255,0,0\n", "0,0,0,0\n1,0,0,255\n"
    (series / "here" / "mine.csv").write_text(red)
    (series / "there" / "mine.csv").write_text(blue)
    (series / "there" / "only_there.csv").write_text(blue)
    picture = {name: bytes_of(aeolic.Renderer("run/sheet_0.vtp", color_by="q", colormap=str(series / name / "mine.csv"),
                                              **SMALL).render()) for name in ("here", "there")}
    assert picture["here"] != picture["there"]
    renderer = aeolic.Renderer("run/sheet_0.vtp", color_by="q", **SMALL)
    kept = aeolic.Renderer("run/sheet_0.vtp", color_by="q", colormap="mine.csv", **SMALL)
    os.chdir(series / "there")
    renderer.set(colormap="mine.csv")
    assert bytes_of(renderer.render()) == picture["there"]
    kept.set(colormap="only_there.csv")
    assert bytes_of(kept.render()) == picture["there"]
    kept.set(colormap="mine.csv")
    assert bytes_of(kept.render()) == picture["here"]


def test_a_surfaces_own_colour_map_is_read_with_the_scene(series):
    (series / "here" / "mine.csv").write_text("0,0,0,0\n1,255,0,0\n")
    surfaces = [{"surface": "run/sheet_0.vtp", "color_by": "q", "colormap": "mine.csv"}, "run/sheet_1.vtp"]
    first = aeolic.Renderer(surfaces, **SMALL).render()
    renderer = aeolic.Renderer(surfaces, **SMALL)
    os.chdir(series)
    assert bytes_of(renderer.render()) == bytes_of(first)
