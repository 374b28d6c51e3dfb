"""aeolic.info(): what a file holds, for people and for programs."""
import os
import pathlib
import shlex
import subprocess

import aeolic

AHMED = pathlib.Path(__file__).parents[2] / "examples" / "ahmed"


def test_the_text_is_that_of_the_program():
    file = str(AHMED / "ahmed.vtp")
    told = subprocess.run([os.environ["AEOLIC_PROGRAM"], "info", file], capture_output=True, text=True, check=True).stdout
    assert str(aeolic.info(file)) == told


def test_a_surface():
    info = aeolic.info(AHMED / "ahmed.vtp")
    assert info.kind == "polygons" and info.points > 0 and info.cells > 0
    arrays = {array.name: array for array in info.arrays}
    assert arrays["wallShearStress"].components == 3 and arrays["p"].components == 1
    low, high = arrays["p"].range
    assert low < high
    assert info.bounds[0] < info.bounds[1] and len(info.bounds) == 6
    assert info.times == () and info.parts == ()
    assert info.vectors == "wallShearStress"
    assert info.suggestions and all(line in info.text for line in info.suggestions)
    assert "ahmed.vtp" in info.text and "arrays: " in repr(info)


def test_suggestions_are_commands_that_the_program_takes():
    for line in aeolic.info(AHMED / "ahmed_wake.vti").suggestions:
        words = shlex.split(line)
        assert words[:2] == ["aeolic", "render"] and words[-2:] == ["-o", "out.png"]


def test_what_holds_nothing_to_draw_suggests_nothing(tmp_path):
    (tmp_path / "p.vtk").write_text("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\n"
                                    "LINES 1 3\n2 0 1\n")
    info = aeolic.info(tmp_path / "p.vtk")
    assert info.suggestions == () and "Nothing to draw" in info.text and info.vectors is None
