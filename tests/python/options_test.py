"""Every option of the command line is a keyword of the module, and gives the command line's bytes."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import warnings

import numpy
import pytest

import aeolic
from aeolic import _options
from scenes import SMALL, Box, Sheet, same

PROGRAM = os.environ["AEOLIC_PROGRAM"]
PLAIN = {"surface": "wave", "field": "gyre:9,9,9", "size": (96, 72), "steps": 9, "backend": "cpu"}
COLORED = {"color_by": "gyre:mag"}
LARGE = {"size": (320, 240)}
SLICE = {"surface": "slice:0.4,0.5,0.3:0,0.2,1", "color_by": "p"}
SHEET = {"surface": "FOLDER/sheet.vtp", "field": None}

# Options whose values do not follow from their type. A new option that is a text needs a line here.
VALUES = {
    "surface": "torus:800", "field": "tornado:8,8,8", "vectors": "swirl", "backend": "auto", "color_by": "gyre:mag",
    "background": "transparent", "colormap": "turbo", "size": (50, 41), "camera": {"azimuth": 50, "zoom": 1.5},
    "title": "Flügel <b>", "legend": "|v| [m s⁻¹]", "color_scale": "bands:5", "nan_color": "102030", "below_color": "0000ff",
    "above_color": "ff0000", "context": "sphere:400", "mask_below": 0.15, "feature_angle": 5, "resample_spacing": 0.7,
    "time": 2.5, "time_range": (1, 4), "color_range": [0.1, 0.2], "offset": -0.05, "device": 0, "threads": 2, "frames": 2,
    "overlay": "streamlines:12,outline",
}
NUMBERS = {"float": 0.7, "int": 3}
# What else a scene needs, so that the option shows. A new option whose effect does not show in PLAIN needs a line here …
BESIDE = {
    "vectors": SHEET, "cells": {**SHEET, "color_by": "c"}, "faces": {**SHEET, "camera": {"azimuth": 200, "elevation": -30}},
    "feature_angle": SHEET, "nan_color": {**SHEET, "color_by": "gaps"},
    "field_precision": {"surface": "sphere", "field": "tornado:9,9,9"},
    "resample_spacing": {**SLICE, "field": "FOLDER/box.vtr"}, "axes": LARGE, "legend": {**LARGE, **COLORED},
    "integrator": {"lic": "direct"}, "phase": {"kernel": "hann"}, "time_range": {"frames": 2}, "orbit": {"frames": 2},
    "color_range": COLORED, "colormap": COLORED, "color_scale": COLORED, "scalar_bar": {**LARGE, **COLORED}, "text_scale": {**LARGE, **COLORED},
    "persistence": {"overlay": "topology", "surface": "torus:4000", "field": "abc:16,16,16"},
    "below_color": {**COLORED, "color_range": (0.1, 0.2)}, "above_color": {**COLORED, "color_range": (0.1, 0.2)},
}
# … or here, where it never changes a picture.
UNSEEN = {"threads", "device", "balance", "bricks", "guard", "guard_rows", "fps"}


def value_of(name, row):
    if name in VALUES:
        return VALUES[name]
    if row["type"] in NUMBERS:
        return NUMBERS[row["type"]]
    if row["type"] == "bool":
        return row["default"] != "on"
    if row["type"].startswith("Literal["):
        return next(name for name in row["type"].split('"')[1::2] if name != row["default"])
    raise AssertionError(f"give the option {name} ({row['type']}) a value in this test")


def typed(name, value):
    """What one types for the value, written down a second time."""
    if value is True or value is False:
        return "on" if value else "off"
    if isinstance(value, dict):
        return ",".join(f"{key}={item}" for key, item in value.items())
    if isinstance(value, (tuple, list)):
        return ("x" if name == "size" else ",").join(str(item) for item in value)
    return str(value)


def by_program(folder, options):
    words = [PROGRAM, "render"]
    for name, value in options.items():
        words += ["--" + name.replace("_", "-"), typed(name, value)]
    subprocess.run([*words, "-o", str(folder / "program.png")], check=True, capture_output=True)
    return [frame.read_bytes() for frame in sorted(folder.glob("program*.png"))]


def pictures(renderer):
    return [frame._repr_png_() for frame in renderer.frames()]


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files")
    sheet = Sheet(bend=3)
    gaps = sheet.q.copy()
    gaps[5:15] = numpy.nan
    sheet.write(folder / "sheet.vtp", swirl=sheet.tau[:, ::-1], gaps=gaps)
    Box().write(folder / "box.vti")
    Box().write(folder / "box.vtr")
    return folder


@pytest.mark.parametrize("name", _options.TABLE)
def test_each_option_gives_the_command_lines_bytes(name, files, tmp_path):
    scene = {**PLAIN, **BESIDE.get(name, {})}
    scene = {key: value.replace("FOLDER", str(files)) if isinstance(value, str) else value
             for key, value in scene.items() if value is not None}
    options = {**scene, name: value_of(name, _options.TABLE[name])}
    with_it, without = aeolic.Renderer(**options), aeolic.Renderer(**scene)
    assert with_it.scene != without.scene
    drawn = pictures(with_it)
    assert drawn == by_program(tmp_path, options)
    if name != "backend":  # A GPU's bytes may be others.
        assert (drawn == pictures(without)) == (name in UNSEEN), "whether the option shows in the picture"


OWN = {"surface": "surface.spec", "field": "field.spec", "lic": "lic.method", "time": "time.moment"}  # Groups' own options.


@pytest.mark.parametrize("name", _options.TABLE)
def test_each_option_has_one_name(name):
    """The command line's, a scene file's and Python's are the same words; a test in C++ checks the struct's member."""
    row = _options.TABLE[name]
    assert row["option"] == "--" + name.replace("_", "-")
    group, _, key = row["key"].partition(".")
    if name in OWN:
        assert row["key"] == OWN[name]
    elif name in ("size", "camera", "context"):
        assert row["key"] == ""
    else:
        first, *others = (name[len(group) + 1:] if name.startswith(group + "_") else name).split("_")
        assert key == first + "".join(word.capitalize() for word in others)
        kept = aeolic.Renderer("sphere:400", field="gyre:9,9,9", **{**SMALL, name: value_of(name, row)}).scene if name not in (
            "vectors", "resample_spacing", "colormap") else {group: {key: None}}
        assert key in kept[group]
    assert not re.search(r"--[a-z]", row["help"]), row["help"]


@pytest.mark.parametrize("name", _options.TABLE)
def test_messages_call_an_option_by_its_keyword(name):
    with pytest.raises(aeolic.InputError) as caught:
        aeolic.Renderer(**{"surface": "sphere", name: "\x01"})
    told = str(caught.value)
    assert told.startswith(("surface[1]: surface: " if name == "context" else name) + (": " if name != "context" else "")), told
    assert "--" not in told and not re.search(r"\w+\.[a-z]+[A-Z]", told), told


def test_a_renderers_scene_makes_another_one():
    options = {"camera": {"position": (3, 2, 1), "focal": (0, 0, 0)}, "color_by": "tornado:mag", "noise_scale": 2, **SMALL}
    first = aeolic.Renderer(["sphere:400", {"surface": "torus:400", "color_by": None}], field="tornado:8,8,8", **options)
    again = aeolic.Renderer(scene=first.scene)
    assert again.scene == first.scene and same(again.render(), first.render())
    assert same(again.render(camera=first.scene["camera"]), first.render()), "its camera is one for render(), too"
    assert aeolic.Renderer(scene=first.scene, noise_scale=3).scene["lic"]["noiseScale"] == 3
    for wrong, words in (({"lic": {"noise_scale": 2}}, "scene: lic: 'noise_scale': unknown key.*did you mean noiseScale"),
                         ({"lic": {"steps": object()}}, "scene: .*expected what a scene file holds"),
                         ({"lic": {"step": float("nan")}}, "scene: .*expected what a scene file holds"),
                         ({"lic": {"steps": -1}}, "scene: lic.steps: found -1; expected")):
        with pytest.raises(aeolic.InputError, match=words):
            aeolic.Renderer(scene=wrong)


def test_the_table_has_every_option_of_the_command_line():
    told = subprocess.run([PROGRAM, "render", "--help"], check=True, capture_output=True, text=True).stdout
    named = set(re.findall(r"^ +(?:-\w, ?)?--([a-z-]+)", told, re.MULTILINE))
    for_files = {"help", "output", "stats", "verbose", "list-colormaps"}
    assert {name.replace("-", "_") for name in named - for_files} == set(_options.TABLE)
    assert set(BESIDE) | set(VALUES) | UNSEEN <= set(_options.TABLE), "lines of options that there are no more"


def test_what_a_picture_cannot_give_is_told_and_follows_the_options():
    values = -1 - Sheet().q
    surface = aeolic.Surface(Sheet().points, Sheet().triangles, point_data={"tau": Sheet().tau, "q": values})
    renderer = aeolic.Renderer(surface, vectors="tau", color_by="q", color_scale="log", **{**SMALL, **LARGE})
    assert len(renderer.info["warnings"]) == 1 and "'q' is nowhere above 0" in renderer.info["warnings"][0]
    renderer.set(color_scale="linear", text_scale=4)
    assert len(renderer.info["warnings"]) == 1 and "no room for the legend" in renderer.info["warnings"][0]
    renderer.set(text_scale=1)
    assert renderer.info["warnings"] == []


def warned(*arguments, **options):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        aeolic.render(*arguments, **options)
    assert all(one.category is UserWarning and one.filename == __file__ for one in caught), "who called is told"
    return [str(one.message) for one in caught]


def test_render_warns_of_what_the_program_warns_of(tmp_path):
    sheet = Sheet()
    gaps = sheet.q.copy()
    gaps[5:15] = numpy.nan
    file = sheet.write(tmp_path / "sheet.vtp", gaps=gaps, none=sheet.tau * numpy.float32(numpy.nan))
    for options in ({"color_by": "gaps"}, {"vectors": "none"}, {"camera": {"position": (5, 5, 5), "focal": (9, 9, 9)}},
                    {"legend": "p [Pa]"}, {}):
        words = [PROGRAM, "render", "--surface", str(file), "--size", "48x36", "--steps", "9", "--backend", "cpu", "--threads", "1"]
        for name, value in options.items():
            words += ["--" + name.replace("_", "-"),
                      ";".join(f"{key}={typed(key, item)}" for key, item in value.items()) if name == "camera" else typed(name, value)]
        told = subprocess.run([*words, "-o", str(tmp_path / "a.png")], check=True, capture_output=True, text=True).stderr
        expected = [re.sub("--([a-z-]+)", lambda name: name[1].replace("-", "_"), line.removeprefix("aeolic: warning: "))
                    for line in told.splitlines() if line.startswith("aeolic: warning")]
        assert warned(file, **SMALL, **options) == expected
        assert bool(expected) == bool(options)


def test_warnings_are_those_of_the_data_that_are_shown():
    sheet = Sheet()
    good = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau})
    none = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": numpy.full_like(sheet.tau, numpy.nan)})
    renderer = aeolic.Renderer(good, **SMALL)
    for surface, count in ((none, 2), (good, 0), (none, 2)):
        renderer.set_data(surface)
        assert len(renderer.info["warnings"]) == count
        assert renderer.info["warnings"] == aeolic.Renderer(surface, **SMALL).info["warnings"]
    assert len(warned(none, **SMALL)) == 2


def test_none_brings_back_what_holds_without_the_option(tmp_path):
    plain = {"field": "gyre:9,9,9", "color_by": "gyre:mag", "backend": "cpu"}
    small = tmp_path / "small.json"
    small.write_text('{"version": 1, "surface": {"spec": "wave"}, "output": {"width": 48, "height": 36},'
                     '"shading": {"title": "T", "contrast": 1.5, "colorRange": [0, 9]}}')
    for start in ({"surface": "wave"}, {"scene": small}):
        bare = aeolic.Renderer(**start, **plain).scene
        for name in _options.CHANGEABLE:
            value = value_of(name, _options.TABLE[name])
            renderer = aeolic.Renderer(**start, **plain, **{name: value})
            assert renderer.scene != bare, name
            renderer.set(**{name: None})
            assert renderer.scene == bare, name
    renderer = aeolic.Renderer("wave", title="A", color_range=(0, 1), size=(48, 36), **plain)
    automatic = aeolic.Renderer("wave", size=(48, 36), **plain).render()._repr_png_()
    assert renderer.render()._repr_png_() != automatic
    renderer.set(title=None, color_range=None, contrast=1.25)
    renderer.set(contrast=None)
    assert renderer.render()._repr_png_() == automatic


def test_a_plane_has_its_own_size_again():
    u = numpy.ones((1, 20, 30, 3), "f4")
    renderer = aeolic.Renderer("image", field=aeolic.Grid((0, 0, 0), 1, {"U": u}), size=(40, 44), backend="cpu")
    renderer.set(size=None)
    assert renderer.render().shape[:2] == (20, 30)


def test_options_without_effect_are_told_of_until_they_have_one():
    renderer = aeolic.Renderer("sphere", field="uniform", phase=1, legend="p [Pa]", **SMALL)
    assert renderer.info["warnings"] == ["phase has no effect without kernel hann",
                                         "legend has no effect without color_by"]
    renderer.set(kernel="hann")
    assert renderer.info["warnings"] == ["legend has no effect without color_by"]


def test_a_field_of_the_users_needs_a_surface():
    grid = aeolic.Grid(Box().origin, Box().spacing, {"U": Box().u})
    for field in (grid, "wind.vti"):
        with pytest.raises(aeolic.InputError, match="^surface: found none; expected a file, boundary"):
            aeolic.Renderer(field=field, **SMALL)
    assert aeolic.Renderer("teapot", field=grid, **SMALL).info["triangles"] > 0
    assert aeolic.Renderer(field="uniform", **SMALL).info["triangles"] > 0


class Options(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_render_is_the_command_line_in_one_call(self):
        options = {"surface": "sphere", "size": (40, 30), "backend": "cpu", "camera": {"elevation": 70}}
        aeolic.render(**options).save(self.path / "module.png")
        self.assertEqual([(self.path / "module.png").read_bytes()], by_program(self.path, options))

    def test_a_scene_file_is_overridden(self):
        scene = self.path / "scene.json"
        scene.write_text('{"version": 1, "surface": {"spec": "torus"}, "lic": {"steps": 5}, "output": {"width": 30}}')
        renderer = aeolic.Renderer(scene=scene, steps=6, backend="cpu")
        self.assertEqual((renderer.scene["lic"]["steps"], renderer.scene["output"]["width"]), (6, 30))
        self.assertEqual(renderer.scene["surface"]["spec"], "torus")

    def test_numpy_numbers_and_texts_are_values_too(self):
        plain = aeolic.render("sphere", size=(40, 30), steps=7, step=0.5, lighting=False, backend="cpu")
        other = aeolic.render("sphere", size="40x30", steps=numpy.int16(7), step=numpy.float32(0.5),
                              lighting=numpy.bool_(False), backend="cpu", seed=numpy.array(1), blend=None)
        self.assertEqual(plain._repr_png_(), other._repr_png_())

    def test_wrong_values_get_the_command_lines_words(self):
        for options, words in ((dict(steps=0), "steps: found 0; expected a whole number from 1 to 65536"),
                               (dict(steps=True), "steps: found 'True'; expected a whole number from 1 to 65536"),
                               (dict(camera={"azimuth": True}), "camera azimuth: found 'True'; expected a number"),
                               (dict(scene=""), ": cannot be opened"),
                               (dict(context="sphere", surface=aeolic.Surface(numpy.eye(3), [[0, 1, 2]])),
                                "context: found together with a surface in memory"),
                               (dict(kernel="bax"), "kernel: found 'bax'; expected one of box, hann; did you mean box?"),
                               (dict(size=(0, 10)), "size width: found 0; expected a whole number from 1 to 32768"),
                               (dict(step=float("nan")), "step: found 'nan'; expected a number above 0, up to 8"),
                               (dict(camera={"azimut": 3}), "did you mean azimuth?"),
                               (dict(camera={"azimuth": 3, "position": (1, 2, 3)}), "angles and a position")):
            with self.subTest(**options), self.assertRaises(aeolic.InputError) as caught:
                aeolic.render(**{"surface": "sphere", **options})
            self.assertIn(words, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_unknown_keywords_name_the_nearest(self):
        with self.assertRaisesRegex(TypeError, r"unexpected keyword argument 'stepz'; did you mean steps\?"):
            aeolic.render("sphere", stepz=3)
        with self.assertRaisesRegex(TypeError, r"set\(\) .*'contrst'; did you mean contrast\?"):
            aeolic.Renderer("sphere", size=(20, 20), backend="cpu").set(contrst=1)
        sheet, plane = Sheet(), numpy.ones((4, 4))
        surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau})
        renderer = aeolic.Renderer(surface, **SMALL)
        for call, words in ((lambda: aeolic.lic2d(plane, plane, boundry="closed"), r"lic2d\(\) .*'boundry'; did you mean boundary"),
                            (lambda: aeolic.Surface(sheet.points, triangels=[]), r"Surface\(\) .*did you mean triangles"),
                            (lambda: aeolic.Grid((0, 0, 0), spacin=1, point_data={}), r"Grid\(\) .*did you mean spacing"),
                            (lambda: aeolic.Volume(sheet.points, [], type=1), r"Volume\(\) .*did you mean types"),
                            (lambda: renderer.render(camra={}), r"render\(\) .*did you mean camera"),
                            (lambda: renderer.set_data(surfce=surface), r"set_data\(\) .*did you mean surface"),
                            (lambda: renderer.show(browse=False), r"show\(\) .*did you mean browser")):
            with self.assertRaisesRegex(TypeError, words):
                call()
        with self.assertRaisesRegex(TypeError, "steps: found object; expected"):
            aeolic.render("sphere", steps=object())

    def test_set_draws_what_a_new_renderer_draws(self):
        plain = {"field": "gyre:9,9,9", "color_by": "gyre:mag", "size": (48, 36), "backend": "cpu"}
        renderer = aeolic.Renderer("wave", **plain)
        renderer.render()
        for name in _options.CHANGEABLE:
            with self.subTest(option=name):
                value = value_of(name, _options.TABLE[name])
                fresh = aeolic.Renderer("wave", **{**plain, name: value}).render()
                renderer.set(**{name: value})
                self.assertEqual(renderer.render()._repr_png_(), fresh._repr_png_())
                renderer = aeolic.Renderer("wave", **plain)
        with self.assertRaisesRegex(aeolic.InputError, "^color_by: it belongs to the loaded scene"):
            renderer.set(color_by="p")
        for wrong, instead in (({"camera": {}}, r"camera: .*expected render\(camera=…\)"),
                               ({"time": 2}, "time: .*expected renderer.time = …")):
            with self.assertRaisesRegex(aeolic.InputError, instead):
                renderer.set(**wrong)
        before = renderer.render()._repr_png_()
        with self.assertRaises(aeolic.InputError):
            renderer.set(contrast=-1)
        self.assertEqual(renderer.render()._repr_png_(), before)
