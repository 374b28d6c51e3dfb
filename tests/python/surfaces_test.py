"""Several surfaces in one picture: the command line's bytes, a scene file's, and what is refused."""
import json
import os
import pathlib
import subprocess

import numpy
import pytest

import aeolic
from scenes import Sheet

PROGRAM = os.environ["AEOLIC_PROGRAM"]
VIEW = {"size": (120, 90), "steps": 9, "backend": "cpu", "field": "tornado:9,9,9"}
WORDS = ["--size", "120x90", "--steps", "9", "--backend", "cpu", "--field", "tornado:9,9,9"]


def by_program(folder, *words):
    subprocess.run([PROGRAM, "render", *words, "-o", str(folder / "program.png")], check=True, capture_output=True)
    return (folder / "program.png").read_bytes()


def test_lists_are_the_command_lines_repeated_options(tmp_path):
    picture = aeolic.render(["sphere:400", "torus:400"], context=["plane", pathlib.Path("wave")], **VIEW)
    assert picture._repr_png_() == by_program(tmp_path, *WORDS, "--surface", "sphere:400", "--surface", "torus:400",
                                              "--context", "plane", "--context", "wave")
    assert aeolic.render("sphere:400", context="plane", **VIEW)._repr_png_() == by_program(
        tmp_path, *WORDS, "--surface", "sphere:400", "--context", "plane")


def test_dicts_are_a_scene_files_items(tmp_path):
    sheet = Sheet(bend=3)
    sheet.write(tmp_path / "sheet.vtp", swirl=sheet.tau[:, ::-1])
    items = [{"surface": tmp_path / "sheet.vtp", "vectors": "swirl", "color_by": "c", "colormap": "turbo", "legend": "c [K]",
              "color_range": numpy.array([0, 2])},
             {"surface": "sphere:400", "color_by": None}, {"surface": "torus:400", "streaks": False, "shown": numpy.False_}]
    renderer = aeolic.Renderer(items, **VIEW)
    listed = renderer.scene["surfaces"]
    assert [item["spec"] for item in listed] == [str(tmp_path / "sheet.vtp"), "sphere:400", "torus:400"]
    assert listed[0]["colorRange"] == [0, 2] and listed[0]["colormap"] == "turbo" and not listed[2]["shown"]
    (tmp_path / "scene.json").write_text(json.dumps(renderer.scene))
    assert renderer.render()._repr_png_() == by_program(tmp_path, str(tmp_path / "scene.json"))


def test_surfaces_are_switched_off_and_on():
    renderer = aeolic.Renderer(["sphere:400", "torus:400"], context="plane", **VIEW)
    whole = renderer.render()._repr_png_()
    renderer.set_shown([True, False, numpy.True_])
    assert renderer.render()._repr_png_() != whole
    assert [item["shown"] for item in renderer.scene["surfaces"]] == [True, False, True]
    renderer.set_shown((True, True, True))
    assert renderer.render()._repr_png_() == whole
    with pytest.raises(aeolic.InputError, match="^surfaces: found 2 switches; expected 3, one for each of several surfaces$"):
        renderer.set_shown([True, False])
    assert renderer.render()._repr_png_() == whole


@pytest.mark.parametrize("options, message", [
    ({"surface": []}, "surface: found an empty list; expected at least one surface"),
    ({"surface": ["sphere", 5]}, r"surface\[1\]: found int; expected a file's name or another text that names a surface"),
    ({"surface": ["sphere", {"colorby": "p"}]}, r"surface\[1\]: 'colorby': unknown key; .*; did you mean color_by\?"),
    ({"surface": ["sphere", {"surface": "torus", "color_by": object()}]}, r"surface\[1\]: color_by: found object; expected a "),
    ({"surface": ["sphere", {"surface": "torus", "color_range": [2, 1]}]}, r"surface\[1\]: color_range: found 2,1; expected the low"),
    ({"surface": ["sphere", {"surface": "torus", "color_range": [float("nan"), 1]}]}, r"surface\[1\]: color_range: found nan; expected finite numbers"),
    ({"surface": ["sphere", {"surface": "torus", "streaks": "no"}]}, r"surface\[1\]: streaks: found the text 'no'; expected true"),
    ({"surface": ["sphere", {}]}, r"surface\[1\]: surface: found ''"),
    ({"surface": ["sphere"] * 201}, "surfaces: found a list of 201; expected at most 200 surfaces"),
    ({"surface": ["sphere", "image"]}, r"surface\[1\]: surface: found 'image' among several; expected it alone"),
    ({"surface": ["sphere", aeolic.Surface([[0, 0, 0]], [])]}, r"surface\[1\]: found Surface; expected a file's name"),
    ({"surface": ["sphere", {"surface": "torus", "color_range": [10**400, 1]}]},
     r"surface\[1\]: color_range: found 10*; expected finite numbers"),
    ({"surface": ["sphere", "\udcff.vtp"]}, r"surface\[1\]: found '.udcff.vtp'; expected a text in UTF-8"),
    ({"context": 7}, r"context\[0\]: found int; expected a file's name"),
    ({"context": b"plane"}, r"context\[0\]: found bytes; expected a file's name"),
    ({"surface": "image", "context": "plane"}, "expected it alone"),
])
def test_nonsense_is_refused_in_one_line(options, message):
    with pytest.raises(aeolic.InputError, match=message) as caught:
        aeolic.Renderer(**{**VIEW, **options})
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("shown", [None, 3, "ab"])
def test_what_is_no_row_of_switches_is_refused(shown):
    renderer = aeolic.Renderer(["sphere:400", "torus:400"], **VIEW)
    with pytest.raises(TypeError, match=f"set_shown: found {type(shown).__name__}; expected a row of True and False"):
        renderer.set_shown(shown)


def test_one_surface_has_no_switch():
    with pytest.raises(aeolic.InputError, match="found 1 switches; expected none: there is one surface"):
        aeolic.Renderer("sphere:400", **VIEW).set_shown([True])


def test_a_surface_in_memory_overrides_those_of_a_scene_file(tmp_path):
    (tmp_path / "scene.json").write_text(json.dumps(aeolic.Renderer(["sphere:400", "torus:400"], **VIEW).scene))
    sheet = Sheet()
    surface = aeolic.Surface(sheet.points, sheet.triangles)
    assert aeolic.Renderer(surface, scene=tmp_path / "scene.json").info["triangles"] < 400


def test_misspelt_arguments_are_answered_with_the_right_one():
    for misspelt, meant in (("feild", "field"), ("porgress", "progress"), ("contextt", "context")):
        for function in (aeolic.render, aeolic.Renderer):
            with pytest.raises(TypeError, match=f"'{misspelt}'; did you mean {meant}?"):
                function("sphere", **{misspelt: 1})


def test_a_surface_in_memory_stands_alone():
    sheet = Sheet()
    surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau})
    with pytest.raises(aeolic.InputError, match="^context: found together with a surface in memory; expected a surface from"):
        aeolic.Renderer(surface, context="plane", size=(60, 40))
