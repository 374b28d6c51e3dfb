"""Texts, names and numbers that nobody expects get one line that says what was."""
import enum
import os
import subprocess
import sys

import numpy
import pytest

import aeolic
from scenes import SMALL, Box, Sheet, same


def surface(**changes):
    sheet = Sheet()
    parts = {"points": sheet.points, "triangles": sheet.triangles, "point_data": {"tau": sheet.tau}, **changes}
    return aeolic.Surface(**parts)


def grid(origin=Box.origin, spacing=Box.spacing):
    return aeolic.render("sphere", field=aeolic.Grid(origin, spacing, {"U": Box().u}), **SMALL)


def volume(types):
    return aeolic.Volume(Sheet().points, ([0, 4], [0, 1, 5, 6]), types)


def assigned(moment):
    aeolic.Renderer("sphere", **SMALL).time = moment


def shown(**options):
    return aeolic.Renderer("sphere", **SMALL).show(browser=False, **options)


def asked(name):
    with shown(controls={"a": True}) as viewer:
        viewer.value(name)


TAU = Sheet().tau
OTHER = "\udcff"  # What os.listdir() gives for the byte 255.
WRONG = [
    (lambda: aeolic.render("a\0b", **SMALL), r"surface: found 'a\\x00b'; expected a text without NUL"),
    (lambda: aeolic.render(scene="a\0b"), "scene: found .*NUL"),
    (lambda: aeolic.info("a\0b"), "path: found .*NUL"),
    (lambda: aeolic.render("sphere", **SMALL).save("a\0.png"), "path: found .*NUL"),
    (lambda: aeolic.render("sphere", **SMALL).save("a.apng"), "'a.apng'; expected a name ending in .png, .jpg or .webp$"),
    (lambda: shown(port=1.5), "port: found 1.5; expected 0 to 65535"),
    (lambda: shown(port=float("nan")), "port: found nan; expected 0 to 65535"),
    (lambda: aeolic.render("sphere", title=OTHER), r"title: found '.udcff'; expected a text in UTF-8"),
    (lambda: aeolic.render(OTHER), "UTF-8"),
    (lambda: aeolic.render(scene=OTHER), "\ufffd: cannot be opened"),
    (lambda: aeolic.info(OTHER), "\ufffd: no such file"),
    (lambda: aeolic.render("sphere", camera=OTHER), r"camera: found '.udcff'; expected a text in UTF-8"),
    (lambda: aeolic.render("sphere", camera={OTHER: 1}), "camera: .*UTF-8"),
    (lambda: surface(point_data={OTHER: TAU}), "surface in memory: point_data: name of an array: found .*UTF-8"),
    (lambda: surface(point_data={"a\nb": TAU[None]}), r"array 'a\\nb': found shape"),
    (lambda: aeolic.render(surface(point_data={"a\nb": TAU[:3]})), "array 'a b' has 3 values"),
    (lambda: aeolic.info("a\nb.vtp"), "a b.vtp: no such file"),
    (lambda: aeolic.render([{"surface": "sphere", "legend": OTHER}]), "legend: found .*UTF-8"),
    (lambda: surface(point_data={"tau": numpy.ma.array(TAU * 1j)}), "found values of type complex64; expected numbers"),
    (lambda: surface(point_data={"tau": numpy.ma.array(TAU.astype(str))}), "found values of type <U32"),
    (lambda: surface(point_data={"tau": numpy.ma.array(TAU.astype("M8[s]"))}), "found values of type datetime64"),
    (lambda: grid(spacing=[1, [2, 3]]), "grid in memory: spacing: "),
    (lambda: grid(origin=(0, 0, float("nan"))), "its origin is 0,0,nan; expected finite numbers"),
    (lambda: volume([[10], [10, 10]]), "volume in memory: types: "),
    (lambda: assigned("x"), "time: found 'x'; expected a number"),
    (lambda: aeolic.Renderer(["sphere", "torus"], **SMALL).set_shown(numpy.zeros((2, 2))), "set_shown: found rows"),
    (lambda: shown(port="x"), "port: found 'x'; expected 0 to 65535"),
    (lambda: shown(port=10**20), "port: found 1000.*; expected 0 to 65535"),
    (lambda: shown(title=OTHER), "title: .*UTF-8"),
    (lambda: shown(height="x"), "height: found 'x'"),
    (lambda: shown(controls={OTHER: True}), "controls: name: .*UTF-8"),
    (lambda: shown(controls={"a": ("x", 1)}), "controls: 'a': found 'x'; expected a number"),
    (lambda: asked(OTHER), "control: .*UTF-8"),
]
WRONG_TYPES = [
    (lambda: aeolic.render("sphere", **SMALL).save(None), "path: found NoneType; expected a file's name"),
    (lambda: aeolic.lic2d(TAU, TAU, boundary=numpy.array(["closed", "x"])), "lic2d: boundary: found ndarray; expected a text"),
    (lambda: assigned(None), "time: found NoneType; expected a number"),
    (lambda: shown(title=None), "title: found NoneType; expected a text"),
    (lambda: shown(controls=["a"]), "controls: found list; expected a dict"),
    (lambda: shown(controls={1: True}), "controls: name: found int; expected a text"),
    (lambda: shown(proxy=7), "proxy: found int; expected a text"),
    (lambda: asked(7), "control: found int; expected a text"),
    (lambda: aeolic.render("sphere", **{OTHER: 1}), r"unexpected keyword argument '.udcff'"),
    (lambda: aeolic.Picture.__new__(aeolic.Picture), "Picture"),
    (aeolic.Picture, "Picture: found none drawn; expected what render"),
]


@pytest.mark.parametrize("kind, wrong, words", [(kind, *case) for kind, cases in (
    (aeolic.InputError, WRONG), (TypeError, WRONG_TYPES)) for case in cases])
def test_it_is_one_line(kind, wrong, words):
    with pytest.raises(kind, match=words) as caught:
        wrong()
    assert "\n" not in str(caught.value)


def test_files_may_have_names_of_other_bytes(tmp_path):
    name = tmp_path / os.fsdecode(b"t\xff.png")
    aeolic.render("sphere", **SMALL).save(name)
    assert os.listdir(os.fsencode(tmp_path)) == [b"t\xff.png"]
    with pytest.raises(OSError, match="none/t\ufffd.png: cannot be written"):
        aeolic.render("sphere", **SMALL).save(tmp_path / "none" / name.name)
    file = Sheet().write(tmp_path / os.fsdecode(b"t\xff.vtp"))
    assert "tau" in str(aeolic.info(file)) and "tau" in aeolic.info(str(file)).text


def test_names_of_arrays_may_be_of_other_bytes(tmp_path):
    sheet = Sheet()
    lines = ["# vtk DataFile Version 3.0", "x", "ASCII", "DATASET POLYDATA", f"POINTS {len(sheet.points)} float",
             *(" ".join(map(str, row)) for row in sheet.points.tolist()),
             f"POLYGONS {len(sheet.triangles)} {4 * len(sheet.triangles)}",
             *("3 " + " ".join(map(str, row)) for row in sheet.triangles.tolist()), f"POINT_DATA {len(sheet.points)}",
             "VECTORS Gr\u00f6\u00dfe float", *(" ".join(map(str, row)) for row in sheet.tau.tolist())]
    (tmp_path / "a.vtk").write_text("\n".join(lines), encoding="latin-1")
    assert "Gr\ufffd\ufffde" in str(aeolic.info(tmp_path / "a.vtk"))
    with pytest.raises(aeolic.InputError, match="no array 'x'.*Gr\ufffd\ufffde"):
        aeolic.render(tmp_path / "a.vtk", vectors="x", **SMALL)


def test_a_camera_that_says_nothing_is_the_scenes_own():
    renderer = aeolic.Renderer("sphere", camera={"azimuth": None}, **SMALL)
    for camera in ({}, {"azimuth": None}):
        assert same(renderer.render(camera), renderer.render())


def test_enums_of_texts_are_their_values():
    class Method(str, enum.Enum):
        DIRECT = "direct"
    assert aeolic.Renderer("sphere", lic=Method.DIRECT, **SMALL).scene["lic"]["method"] == "direct"


def test_numbers_of_numpy_are_numbers_in_lists_too():
    box = Box()
    scene = {"field": aeolic.Grid(box.origin, box.spacing, {"U": box.u, "p": box.p}), "color_by": "p", **SMALL}
    one, other = (aeolic.render([{"surface": "sphere", "color_range": limits}], **scene)
                  for limits in ((box.p.min(), box.p.max()), [float(box.p.min()), float(box.p.max())]))
    assert same(one, other)


def test_what_is_shown_cannot_be_shown_otherwise():
    renderer = aeolic.Renderer("sphere", **SMALL)
    with renderer.show(browser=False, controls={"a": numpy.True_}, proxy="{x}/{port}/") as viewer:
        port = int(viewer.address.split(":")[2].split("/")[0])
        assert f'path = "{{x}}/{port}/"' in viewer._repr_html_()
        assert renderer.show(browser=False, controls={"a": True}, port=port) is viewer is renderer.show(browser=False)
        for other in ({"controls": {"b": True}}, {"port": port % 65535 + 1}, {"title": "Other"}):
            with pytest.raises(aeolic.InputError, match=f"^{next(iter(other))}: found others than the open viewer has"):
                renderer.show(browser=False, **other)


@pytest.mark.parametrize("flags, code", [
    (["-OO"], "import aeolic; aeolic.render('sphere', size=(9, 9), backend='cpu')"),
    ([], "import aeolic, importlib; importlib.reload(aeolic)")])
def test_it_is_imported_without_texts_and_again(flags, code):
    ended = subprocess.run([sys.executable, *flags, "-c", code], capture_output=True, text=True, timeout=60)
    assert (ended.returncode, ended.stderr) == (0, "")
