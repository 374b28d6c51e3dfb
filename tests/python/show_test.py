"""Renderer.show(): a server for one scene."""
import gc
import unittest
import urllib.error
import urllib.request

import aeolic
from scenes import SMALL, Sheet


class Show(unittest.TestCase):
    def test_it_serves_the_scene_until_it_is_closed(self):
        renderer = aeolic.Renderer("sphere", **SMALL)
        renderer.set(contrast=1.5, phase=-1)
        with renderer.show(browser=False) as viewer:
            self.assertRegex(viewer.address, r"^http://127\.0\.0\.1:\d+/\?token=.{16,}")
            self.assertIn(viewer.address, viewer._repr_html_())
            browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
            self.assertIn(b"<html", browser.open(viewer.address, timeout=20).read())
            with self.assertRaises(urllib.error.HTTPError):
                urllib.request.urlopen(viewer.address.split("?")[0] + "status", timeout=20)
        self.assertEqual(repr(viewer), "<aeolic.Viewer, closed>")
        with self.assertRaises(urllib.error.URLError):
            urllib.request.urlopen(viewer.address, timeout=20)
        viewer.close()

    def test_it_ends_with_the_last_who_holds_it(self):
        viewer = aeolic.Renderer("sphere", **SMALL).show(browser=False)
        address = viewer.address
        del viewer
        gc.collect()
        with self.assertRaises(urllib.error.URLError):
            urllib.request.urlopen(address, timeout=20)

    def test_memory_and_wrong_servers_are_refused(self):
        sheet = Sheet()
        surface = aeolic.Surface(sheet.points, sheet.triangles, point_data={"tau": sheet.tau})
        with self.assertRaisesRegex(aeolic.InputError, "show: the scene is in memory"):
            aeolic.Renderer(surface, **SMALL).show()
        with self.assertRaisesRegex(aeolic.InputError, "--prot=3: unknown option; did you mean --port"):
            aeolic.Viewer(["--surface=sphere", "--prot=3"])


if __name__ == "__main__":
    unittest.main()
