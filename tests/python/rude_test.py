"""Callers who do what one does not do."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy

import aeolic
from scenes import SMALL, Box, Sheet, same


class Rude(unittest.TestCase):
    def setUp(self):
        self.sheet, self.box = Sheet(), Box()
        self.expected = self.draw()

    def draw(self, **changes):
        parts = {"points": self.sheet.points, "triangles": self.sheet.triangles, "point_data": {"tau": self.sheet.tau},
                 **changes}
        return aeolic.render(aeolic.Surface(**parts), **SMALL)

    def complaint(self, **changes):
        with self.assertRaises(aeolic.InputError) as caught:
            self.draw(**changes)
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception)

    def test_arrays_may_lie_in_memory_as_they_like(self):
        points = self.sheet.points
        padded = numpy.full((len(points), 5), numpy.nan, "f4")
        padded[:, 1:4] = points
        unaligned = numpy.frombuffer(b"x" + points.tobytes(), "u1")[1:].view("f4").reshape(-1, 3)
        for name, array in {
                "columns of a wider array": padded[:, 1:4], "Fortran order": numpy.asfortranarray(points),
                "negative strides": points[::-1].copy()[::-1], "turned rows": points[:, ::-1].copy()[:, ::-1],
                "every second": numpy.repeat(points, 2, 0)[::2], "float64": points.astype("f8"),
                "big-endian": points.astype(">f4"), "long double": points.astype("g"), "unaligned": unaligned,
                "a list": points.tolist(), "read-only": numpy.frombuffer(points.tobytes(), "f4").reshape(-1, 3),
                "masked, but nowhere": numpy.ma.array(points)}.items():
            with self.subTest(name):
                self.assertTrue(same(self.draw(points=array), self.expected))
        for kind in ("i2", "u2", "i4", "u4", "i8", "u8", ">i8"):
            with self.subTest(kind):
                self.assertTrue(same(self.draw(triangles=self.sheet.triangles.astype(kind)), self.expected))
        grid = {"U": self.box.u}
        expected = aeolic.render("sphere", field=aeolic.Grid(self.box.origin, self.box.spacing, grid), **SMALL)
        for name, array in {"Fortran order": numpy.asfortranarray(self.box.u), "float64": self.box.u.astype("f8"),
                            "negative strides": self.box.u[:, ::-1].copy()[:, ::-1]}.items():
            with self.subTest(name):
                field = aeolic.Grid(self.box.origin, self.box.spacing, {"U": array})
                self.assertTrue(same(aeolic.render("sphere", field=field, **SMALL), expected))

    def test_wrong_arrays_are_named(self):
        sheet = self.sheet
        here = "surface in memory: "
        for changes, words in (
                (dict(points=sheet.points[:, :2]), here + "points: found shape (25, 2); expected (points, 3)"),
                (dict(points=sheet.points.reshape(-1)), here + "points: found shape (75,); expected (points, 3)"),
                (dict(points=None), here + "points: found None; expected numbers"),
                (dict(points=sheet.points.astype(complex)), here + "points: found values of type complex128"),
                (dict(points=[[1, 2, 3], [4, 5]]), here + "points: "),
                (dict(points="body.vtp"), here + "points: found values of type <U8; expected numbers"),
                (dict(points=numpy.empty((0, 3))), "polygon 0 refers to point 0, which does not exist; expected at least one point"),
                (dict(triangles=None), here + "triangles: found None"),
                (dict(triangles=sheet.triangles.astype(float)), here + "triangles: found values of type float64"),
                (dict(triangles=numpy.ma.masked_less(sheet.triangles, 5)), here + "triangles: found masked values"),
                (dict(triangles=sheet.triangles + 1), "refers to point 25, which does not exist; expected points from 0 to 24"),
                (dict(triangles=-sheet.triangles), "polygon 0 refers to point -"),
                (dict(triangles=numpy.full((1, 3), 2**64 - 1, "u8")), "polygon 0 refers to point -1, which"),
                (dict(triangles=[]), "no polygons"),
                (dict(triangles=None, polygons=([0, 3], [0, 1])), "offsets: they do not rise from 0"),
                (dict(triangles=None, polygons=([0, 9, 3], [0, 1, 2])), "offsets: they do not rise from 0"),
                (dict(triangles=None, polygons=7), "polygons: expected a pair"),
                (dict(polygons=([0, 3], [0, 1, 2])), "triangles and polygons; expected one or the other"),
                (dict(point_data={"tau": sheet.tau[:3]}), "array 'tau' has 3 values; expected 25, one for each of the"),
                (dict(point_data={"tau": sheet.tau[:, :2]}), "array 'tau' has 2 components; expected 3"),
                (dict(point_data={"tau": sheet.tau[None]}), "array 'tau': found shape (1, 25, 3)"),
                (dict(point_data={7: sheet.tau}), "found 7 as a name; expected a text"),
                (dict(point_data={"": sheet.tau}), "an array without a name"),
                (dict(point_data=[sheet.tau]), "point_data: found list; expected a dict"),
                (dict(point_data={"tau": None}), "array 'tau': found None"),
                (dict(points=numpy.full_like(sheet.points, numpy.nan)), "have a corner that is not finite")):
            with self.subTest(expected=words):
                self.assertIn(words, self.complaint(**changes))

    def test_wrong_grids_are_named(self):
        box = self.box
        for given, words in (
                (((0, 0), box.spacing, {"U": box.u}), "origin: found shape (2,); expected 3 numbers"),
                ((box.origin, None, {"U": box.u}), "spacing: found None"),
                ((box.origin, (1, 0, 1), {"U": box.u}), "its spacing is 1,0,1; expected positive numbers"),
                ((box.origin, box.spacing, {}), "0 points and 0 cells"),
                ((box.origin, box.spacing, {"U": box.u[0, 0]}), "array 'U': found shape (9, 3)"),
                ((box.origin, box.spacing, {"U": box.u, "p": box.p[1:]}), "expected (5, 8, 9) beside the other arrays"),
                ((box.origin, box.spacing, {"p": box.p}), "no array of vectors")):
            with self.subTest(expected=words), self.assertRaises(aeolic.InputError) as caught:
                aeolic.render("sphere", field=aeolic.Grid(*given), **SMALL)
            self.assertIn(words, str(caught.exception))

    def test_sources_of_other_kinds_are_refused(self):
        for surface, field in ((7, None), (self.sheet.points, None), (aeolic.Grid((0, 0, 0), 1, {"U": self.box.u}), None),
                               ("sphere", 7), ("sphere", aeolic.Surface(self.sheet.points, self.sheet.triangles))):
            with self.assertRaises(TypeError):
                aeolic.render(surface, field=field)

    def test_masked_values_are_left_out(self):
        tau = numpy.ma.array(self.sheet.tau, mask=numpy.zeros_like(self.sheet.tau, bool))
        tau[3] = numpy.ma.masked
        renderer = aeolic.Renderer(aeolic.Surface(self.sheet.points, self.sheet.triangles, point_data={"tau": tau}), **SMALL)
        self.assertEqual(len(renderer.info["warnings"]), 1)

    def test_a_surface_changed_later_does_not_show(self):
        renderer = aeolic.Renderer(aeolic.Surface(self.sheet.points, self.sheet.triangles,
                                                  point_data={"tau": self.sheet.tau}), **SMALL)
        self.sheet.points[:] = numpy.nan
        self.sheet.tau[:] = 0
        self.sheet.triangles[:] = 10**6
        self.assertTrue(same(renderer.render(), self.expected))

    def test_a_grid_changed_later_does_no_harm(self):
        renderer = aeolic.Renderer("sphere", field=aeolic.Grid(self.box.origin, self.box.spacing, {"U": self.box.u}),
                                   normalize=False, **SMALL)
        for value in (numpy.nan, numpy.inf, 3e38, -3e38):
            self.box.u[1:3] = value
            self.assertEqual(numpy.asarray(renderer.render()).shape, (36, 48, 3))

    def test_threads_share_a_renderer(self):
        renderer = aeolic.Renderer("torus", **SMALL)
        expected = [numpy.array(renderer.render({"azimuth": 10 * i})) for i in range(8)]
        wrong = []

        def work(i):
            for _ in range(5):
                if not same(renderer.render({"azimuth": 10 * i}), expected[i]):
                    wrong.append(i)
        threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_others_run_while_it_draws(self):
        ticks = []
        stop = threading.Event()

        def tick():
            while not stop.wait(0.005):
                ticks.append(1)
        thread = threading.Thread(target=tick)
        thread.start()
        try:
            renderer = aeolic.Renderer("teapot:20000", size=(600, 600), lic="direct", integrator="rk4", steps=200,
                                       backend="cpu", threads=1)
            before = len(ticks)
            renderer.render()
            self.assertGreater(len(ticks) - before, 2)
        finally:
            stop.set()
            thread.join()

    def test_progress_may_raise(self):
        class Enough(Exception):
            pass

        def progress(what, fraction):
            self.assertIsInstance(what, str)
            raise Enough("no more")
        with self.assertRaisesRegex(Enough, "no more"):
            aeolic.Renderer("sphere", progress=progress, **SMALL)
        renderer = aeolic.Renderer("slice:0.5,0.5,0.3:0,0,1", field=aeolic.Grid(
            self.box.origin, self.box.spacing, {"U": self.box.u}), **SMALL)
        before = renderer.render()
        with self.assertRaises(Enough):
            renderer.set_data(field=aeolic.Grid(self.box.origin, self.box.spacing, {"U": 2 * self.box.u}),
                              progress=progress)
        self.assertTrue(same(renderer.render(), before), "what failed changes nothing")
        with self.assertRaises(TypeError):
            aeolic.Renderer("sphere", progress=3)

    def test_progress_cannot_use_the_renderer(self):
        heard = []
        grid = aeolic.Grid(self.box.origin, self.box.spacing, {"U": self.box.u})
        renderer = aeolic.Renderer("boundary", field=grid, **SMALL)

        def progress(what, fraction):
            heard.append(what)
            renderer.render()
        with self.assertRaisesRegex(RuntimeError, "its progress function cannot use it"):
            renderer.set_data(field=grid, progress=progress)
        self.assertTrue(heard)

    def test_ctrl_c_ends_loading(self):
        with self.assertRaises(KeyboardInterrupt):
            aeolic.Renderer("sphere", progress=lambda *_: os.kill(os.getpid(), signal.SIGINT), **SMALL)

    def test_ctrl_c_ends_an_animation(self):
        code = ("import aeolic\nprint('ready', flush=True)\n"
                "for frame in aeolic.Renderer('sphere', size=(64, 64), frames=100000, backend='cpu').frames(): pass")
        program = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(program.stdout.readline(), "ready\n")
        threading.Event().wait(1)
        program.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", program.communicate(timeout=30)[1])

    def test_a_renderer_stays_in_its_process(self):
        renderer = aeolic.Renderer("sphere", **SMALL)
        renderer.render()
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                renderer.render()
                said = "drawn"
            except RuntimeError as error:
                said = str(error)
            del renderer
            os.write(write, said.encode())
            os._exit(0)
        os.waitpid(child, 0)
        self.assertIn("before the process was forked", os.read(read, 1000).decode())
        os.close(read)
        os.close(write)
        self.assertTrue(same(renderer.render(), renderer.render()))

    def test_a_renderer_that_failed_is_no_trap(self):
        renderer = aeolic.Renderer.__new__(aeolic.Renderer)
        with self.assertRaises(aeolic.InputError):
            renderer.__init__("none.vtp")
        self.assertEqual(repr(renderer), "<aeolic.Renderer of nothing>")

    def test_pictures_are_saved_by_the_end_of_their_name(self):
        picture = aeolic.render("sphere", **SMALL)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.gif", "a.mp4", "a", ".png"):
                with self.assertRaises(aeolic.InputError):
                    picture.save(pathlib.Path(folder) / name)
            with self.assertRaises(OSError):
                picture.save(pathlib.Path(folder) / "none" / "a.png")
            self.assertEqual(os.listdir(folder), [])
            for name, begin in (("a.png", b"\x89PNG"), ("a.jpg", b"\xff\xd8\xff"), ("a.webp", b"RIFF")):
                picture.save(pathlib.Path(folder) / name)
                self.assertEqual((pathlib.Path(folder) / name).read_bytes()[:len(begin)], begin)
