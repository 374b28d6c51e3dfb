"""Renderer.show(): a scene in a browser, live."""
import gc
import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request
import weakref
import webbrowser

import aeolic
import numpy
from scenes import SMALL, Box, Sheet, same

PROGRAM = os.environ["AEOLIC_PROGRAM"]


def picture_at(viewer, size=SMALL["size"]):
    """What a viewer sees at rest."""
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "a.png")
        subprocess.run([PROGRAM, "grab", viewer.address, "-o", name, "--size", "x".join(map(str, size))], check=True, timeout=60)
        with open(name, "rb") as file:
            return file.read()


def of_memory(**options):
    sheet, box = Sheet(), Box()
    surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau, "q": sheet.q})
    grid = aeolic.Grid(origin=box.origin, spacing=box.spacing, point_data={"U": box.u})
    return aeolic.Renderer(surface, field=grid, **SMALL, **options)


def is_gone(address):
    try:
        urllib.request.urlopen(address, timeout=20)
    except urllib.error.HTTPError:
        return False
    except urllib.error.URLError:
        return True
    return False


class Show(unittest.TestCase):
    def test_viewers_see_the_renderers_pictures(self):
        for renderer in (aeolic.Renderer("sphere", **SMALL), of_memory()):
            with renderer.show(browser=False) as viewer:
                self.assertEqual(picture_at(viewer), renderer.render()._repr_png_())
                renderer.set(contrast=1.5, phase=-1)
                time.sleep(0.2)
                self.assertEqual(picture_at(viewer), renderer.render()._repr_png_())
                self.assertEqual(numpy.asarray(renderer.render()).shape[:2], SMALL["size"][::-1])

    def test_viewers_of_other_sizes_change_nothing_here(self):
        renderer = of_memory()
        before = renderer.render()
        with renderer.show(browser=False) as viewer:
            picture_at(viewer, (30, 20))
            self.assertTrue(same(before, renderer.render()))
            self.assertEqual(renderer.scene["output"]["width"], SMALL["size"][0])
        self.assertTrue(same(before, renderer.render()))

    def test_other_data_are_shown(self):
        sheet = Sheet(bend=0.6)
        renderer = of_memory()
        with renderer.show(browser=False) as viewer:
            first = picture_at(viewer)
            renderer.set_data(aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau, "q": sheet.q}))
            second = picture_at(viewer)
            self.assertNotEqual(first, second)
            self.assertEqual(second, renderer.render()._repr_png_())

    def test_it_draws_while_python_does(self):
        renderer = of_memory()
        expected = renderer.render()
        with renderer.show(browser=False) as viewer:
            grabbed = []
            threads = [threading.Thread(target=lambda: grabbed.append(picture_at(viewer, (33, 21)))) for _ in range(3)]
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                self.assertTrue(same(renderer.render(), expected))
            self.assertEqual(len(set(grabbed)), 1)

    def test_controls(self):
        renderer = of_memory()
        with renderer.show(browser=False, controls={"speed": (0, 2, 0.5), "pause": True, "step": "button"}) as viewer:
            self.assertEqual([viewer.value(name) for name in ("speed", "pause", "step")], [0.5, 1, 0])
            viewer.set_value("speed", 7)
            self.assertEqual(viewer.value("speed"), 2)
            words = "control: found 'sped'; expected one of speed, pause, step; did you mean speed"
            for asked in (lambda: viewer.value("sped"), lambda: viewer.set_value("sped", 1)):
                with self.assertRaisesRegex(aeolic.InputError, words):
                    asked()
            with self.assertRaisesRegex(aeolic.InputError, "value: found nan; expected a number"):
                viewer.set_value("speed", float("nan"))
            self.assertEqual(viewer.value("speed"), 2)
            viewer.set_value("speed", float("-inf"))
            self.assertEqual(viewer.value("speed"), 0)
        with self.assertRaisesRegex(RuntimeError, "closed"):
            viewer.value("speed")
        for wrong, error in (({"a": (1, 0)}, "a range of finite numbers"), ({"a": (0, 1, 3)}, "found 3"), ({"": True}, "a name")):
            with self.assertRaisesRegex(aeolic.InputError, error):
                renderer.show(browser=False, controls=wrong)
        for wrong in ({"a": 1}, {"a": "slider"}, {"a": (1,)}, {"a": None}):
            with self.assertRaises(TypeError):
                renderer.show(browser=False, controls=wrong)

    def test_one_scene_has_one_server(self):
        renderer = of_memory()
        viewer = renderer.show(browser=False)
        self.assertIs(renderer.show(browser=False), viewer)
        other = of_memory().show(browser=False)
        self.assertNotEqual(other.address, viewer.address)
        viewer.close()
        viewer.close()
        self.assertEqual(repr(viewer), "<aeolic.Viewer, closed>")
        self.assertTrue(is_gone(viewer.address))
        self.assertFalse(is_gone(other.address))
        again = renderer.show(browser=False)
        self.assertFalse(is_gone(again.address))

    def test_it_ends_with_the_last_who_holds_it(self):
        viewer = of_memory().show(browser=False)
        address = viewer.address
        self.assertFalse(is_gone(address))
        del viewer
        gc.collect()
        self.assertTrue(is_gone(address))

    def test_it_goes_on_while_somebody_holds_the_renderer(self):
        renderer = of_memory()
        address = renderer.show(browser=False).address
        gc.collect()
        self.assertFalse(is_gone(address), "nobody holds the viewer")
        again = renderer.show(browser=False)
        self.assertEqual(again.address, address)
        kept = weakref.ref(renderer)
        del renderer
        self.assertFalse(is_gone(address), "the viewer holds the renderer")
        gc.disable()
        try:
            del again
            self.assertIsNone(kept(), "nothing has to look for them")
            self.assertTrue(is_gone(address))
        finally:
            gc.enable()

    def test_a_browser_finds_the_page_of_who_keeps_no_viewer(self):
        opened, given = [], webbrowser.open
        webbrowser.open = opened.append
        try:
            renderer = of_memory()
            renderer.show()
        finally:
            webbrowser.open = given
        self.assertFalse(is_gone(opened[0]))
        renderer.show(browser=False).close()
        self.assertTrue(is_gone(opened[0]))

    def test_a_process_ends_while_it_is_shown(self):
        code = "import aeolic; r = aeolic.Renderer('sphere', size=(9, 9), backend='cpu'); r.show(browser=False); r.me = r"
        ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_only_who_knows_the_address_may_look(self):
        with of_memory().show(browser=False) as viewer:
            self.assertRegex(viewer.address, r"^http://127\.0\.0\.1:\d+/\?token=.{16,}")
            with self.assertRaises(urllib.error.HTTPError):
                urllib.request.urlopen(viewer.address.split("?")[0] + "status", timeout=20)

    def test_ports(self):
        with of_memory().show(browser=False) as viewer:
            port = int(viewer.address.split(":")[2].split("/")[0])
            with self.assertRaisesRegex(aeolic.InputError, "in use"):
                of_memory().show(browser=False, port=port)
        with self.assertRaisesRegex(aeolic.InputError, "found 70000"):
            of_memory().show(browser=False, port=70000)

    def test_nothing_is_left_of_many(self):
        def tally():
            return len(os.listdir("/proc/self/fd")), len(os.listdir("/proc/self/task"))
        renderer = of_memory()
        renderer.show(browser=False).close()
        before = tally()
        for _ in range(20):
            renderer.show(browser=False).close()
        self.assertEqual(tally(), before)

    def test_a_notebook_gets_the_page_in_a_frame(self):
        renderer = of_memory()
        with renderer.show(browser=False, height=321, proxy="/user/me/proxy/{port}/") as viewer:
            told = viewer._repr_html_()
            port = viewer.address.split(":")[2].split("/")[0]
            self.assertIn("height:321px", told)
            self.assertIn(f'path = "/user/me/proxy/{port}/"', told)
            self.assertIn(viewer.address, told)
        self.assertEqual(viewer._repr_html_(), "closed")
        renderer.show(browser=False, height=200)
        self.assertEqual(renderer.show(browser=False, height=300).height, 300, "the page of a viewer that nobody held")

    def test_a_forked_process_does_not_end_it(self):
        viewer = of_memory().show(browser=False)
        child = os.fork()
        if child == 0:
            del viewer
            gc.collect()
            os._exit(0)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        self.assertFalse(is_gone(viewer.address))
        viewer.close()

    def test_a_closed_port_is_free_although_a_forked_process_has_it(self):
        viewer = of_memory().show(browser=False)
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(write)
            os.read(read, 1)
            os._exit(0)
        try:
            viewer.close()
            self.assertTrue(is_gone(viewer.address))
            of_memory().show(browser=False, port=int(viewer.address.split(":")[2].split("/")[0])).close()
        finally:
            os.close(write)
            os.close(read)
            os.waitpid(child, 0)
