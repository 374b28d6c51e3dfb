"""Threads that share a Renderer, draw while the interpreter ends, and meet in progress functions."""
import subprocess
import sys
import threading

import pytest

import aeolic
from scenes import SMALL, Box, same

ENDING = """
import threading, time
import numpy
import aeolic
def work():
    {before}
    while True:
        begun.set()
        {work}
begun = threading.Event()
threading.Thread(target=work, daemon=True).start()
begun.wait()
time.sleep(0.1)
"""


@pytest.mark.parametrize("before, work", [
    ("renderer = aeolic.Renderer('teapot:2000', size=(300, 300), backend='cpu', threads=1)", "renderer.render()"),
    ("", "aeolic.Renderer('teapot:50000', size=(9, 9), backend='cpu', threads=1, progress=lambda *_: None)"),
    ("flow = numpy.random.rand(500, 500).astype('f4')", "aeolic.lic2d(flow, flow)"),
], ids=["drawing", "loading", "lic2d"])
def test_a_program_may_end_while_a_thread_is_at_work(before, work):
    ended = subprocess.run([sys.executable, "-c", ENDING.format(before=before, work=work)], capture_output=True,
                           text=True, timeout=120)
    assert (ended.returncode, ended.stderr) == (0, "")


def together(*calls):
    """Runs the calls at once, and gives what they raise; None for one that never ended."""
    barrier, raised = threading.Barrier(len(calls)), {}

    def run(number, call):
        barrier.wait()
        try:
            raised[number] = call()
        except Exception as error:
            raised[number] = error
    threads = [threading.Thread(target=run, args=pair, daemon=True) for pair in enumerate(calls)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
        assert not thread.is_alive(), "a thread waits for ever"
    return [raised[number] for number in range(len(calls))]


def of_grid():
    box = Box()
    grid = aeolic.Grid(box.origin, box.spacing, {"U": box.u})
    return aeolic.Renderer("boundary", field=grid, **SMALL), grid


@pytest.mark.parametrize("depth", [1, 2])
def test_progress_may_use_other_renderers_but_not_its_own(depth):
    renderer, grid = of_grid()
    other, _ = of_grid()

    def use_both(what, fraction):
        aeolic.render("sphere", progress=lambda *_: None, **SMALL)
        renderer.render()

    def within(what, fraction):
        other.set_data(field=grid, progress=use_both)
    progress = use_both if depth == 1 else within
    said, = together(lambda: renderer.set_data(field=grid, progress=progress))
    assert isinstance(said, RuntimeError) and "its progress function cannot use it" in str(said)


def test_progress_may_close_the_viewer():
    renderer, grid = of_grid()
    viewer = renderer.show(browser=False)
    assert together(lambda: renderer.set_data(field=grid, progress=lambda *_: viewer.close())) == [None]
    assert not viewer.is_open


def test_progress_cannot_show_its_renderer():
    renderer, grid = of_grid()
    viewers = []
    thread = threading.Thread(target=lambda: viewers.append(renderer.show(browser=False)), daemon=True)

    def progress(what, fraction):
        thread.start()
        thread.join(0.1)  # It waits for the renderer.
        renderer.show(browser=False)
    said, = together(lambda: renderer.set_data(field=grid, progress=progress))
    thread.join(60)
    assert isinstance(said, RuntimeError) and viewers[0].is_open


def test_threads_that_show_get_the_same_viewer():
    for _ in range(5):
        renderer = aeolic.Renderer("sphere", **SMALL)
        one, other = together(*[lambda: renderer.show(browser=False)] * 2)
        assert one is other
        one.close()


def test_no_change_of_a_thread_is_lost():
    renderer = aeolic.Renderer("wave", field="gyre", color_by="gyre:mag", **SMALL)
    for number in range(30):
        steps, contrast, moment = 10 + number, 1 + number / 64, number / 8

        def set_time():
            renderer.time = moment
        together(renderer.render, lambda: renderer.set(steps=steps), lambda: renderer.set(contrast=contrast),
                 set_time, lambda: (renderer.scene, renderer.stats))
        scene = renderer.scene
        found = scene["lic"]["steps"], scene["shading"]["contrast"], scene["time"]["moment"]
        assert found == (steps, contrast, moment)


def test_what_set_refuses_changes_nothing():
    renderer = aeolic.Renderer("sphere", **SMALL)
    before, scene = renderer.render(), renderer.scene
    for wrong in ({"size": (20, 20), "steps": 60, "colormap": "none.json"}, {"steps": 60, "contrast": -1}):
        with pytest.raises(aeolic.InputError):
            renderer.set(**wrong)
        assert renderer.scene == scene and same(renderer.render(), before)
