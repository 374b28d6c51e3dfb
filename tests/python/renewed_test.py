"""Renderers made and dropped, many times, with exceptions in between: nothing of them stays."""
import gc
import os
import pathlib

import pytest

import aeolic
from scenes import SMALL, Box, Sheet

HERE = pathlib.Path("/proc/self")


def tally():
    """Threads and open files, servers' sockets among them."""
    gc.collect()
    return {"threads": len(os.listdir(HERE / "task")), "files": len(os.listdir(HERE / "fd"))}


def resident_bytes():
    return int((HERE / "statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Stop(Exception):
    pass


def refuse(*_):
    raise Stop


def one_life(number, sheet, box):
    surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau, "q": sheet.q},
                             cell_data={"c": sheet.cell})
    grid = aeolic.Grid(box.origin, box.spacing, {"U": box.u, "p": box.p})
    with pytest.raises(Stop):
        aeolic.Renderer("boundary", field=grid, progress=refuse, **SMALL)
    with pytest.raises(aeolic.InputError):
        aeolic.Renderer(surface, vectors="nowhere", **SMALL)
    with pytest.raises(aeolic.InputError):
        aeolic.Renderer(aeolic.Surface(sheet.points, sheet.triangles + 1, point_data={"tau": sheet.tau}), **SMALL)
    renderer = aeolic.Renderer(surface, field=grid, color_by="p", **SMALL)
    renderer.render({"azimuth": number})
    with pytest.raises(aeolic.InputError):
        renderer.set(contrast=-1)
    renderer.set_data(surface, field=grid)
    with pytest.raises(aeolic.InputError):
        renderer.set_data(aeolic.Surface(sheet.points[:3], [[0, 1, 3]], point_data={"tau": sheet.tau[:3]}))
    renderer.render()
    if number % 5 == 0:
        with pytest.raises(aeolic.InputError):
            renderer.show(browser=False, controls={"": True})
        viewer = renderer.show(browser=False)
        if number % 10 == 0:
            viewer.close()
    cut = aeolic.Renderer("slice:0.5,0.5,0.3:0,0.2,1", field=grid, color_by="p", scalar_bar=True, **SMALL)
    next(cut.frames())._repr_png_()


@pytest.mark.parametrize("lives", [40, pytest.param(1000, marks=pytest.mark.long)])
def test_nothing_stays_of_renderers_that_are_gone(lives):
    sheet, box = Sheet(), Box()
    for number in range(20):  # What is made once in a process: threads, caches, the interpreter's own memory.
        one_life(number, sheet, box)
    before, memory = tally(), resident_bytes()
    for number in range(lives):
        one_life(number, sheet, box)
    assert tally() == before
    if "AEOLIC_SANITIZED" in os.environ:
        return  # Its runtime keeps freed memory for a while.
    grown = resident_bytes() / memory - 1
    assert grown < 0.02, f"memory has grown by {100 * grown:.1f} %"
