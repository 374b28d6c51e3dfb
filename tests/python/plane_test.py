"""lic2d: what the module adds to aeolic/plane.h, which has tests of its own."""
import signal
import subprocess
import sys
import unittest

import numpy

import aeolic


class Plane(unittest.TestCase):
    def setUp(self):
        self.y, self.x = numpy.mgrid[0:40, 0:60].astype("f4")
        self.u, self.v = 20 - self.y, self.x - 30

    def test_arrays_in_arrays_out(self):
        value = aeolic.lic2d(self.u, self.v, steps=15)
        self.assertEqual((value.shape, value.dtype), ((40, 60), numpy.float32))
        self.assertLess(abs(value.mean()), 0.3)
        self.assertTrue(numpy.array_equal(value, aeolic.lic2d(self.u, self.v, steps=15)))
        self.assertFalse(numpy.array_equal(value, aeolic.lic2d(self.u, self.v, steps=15, seed=2)))
        self.assertFalse(numpy.array_equal(value, aeolic.lic2d(self.u, self.v, steps=15, lic="direct")))

    def test_u_goes_along_rows_and_v_across(self):
        texture = numpy.random.default_rng(1).normal(size=self.u.shape)
        along = aeolic.lic2d(numpy.ones_like(self.u), 0 * self.v, steps=20, texture=texture)
        across = aeolic.lic2d(0 * self.u, numpy.ones_like(self.v), steps=20, texture=texture)
        self.assertLess(numpy.abs(numpy.diff(along, axis=1)).mean(), 0.5 * numpy.abs(numpy.diff(along, axis=0)).mean())
        self.assertLess(numpy.abs(numpy.diff(across, axis=0)).mean(), 0.5 * numpy.abs(numpy.diff(across, axis=1)).mean())

    @staticmethod
    def slope(value):
        """By how many columns a row's streaks are shifted against those of the row before it."""
        def alike(shift):
            return numpy.mean([value[y, 40:-40] @ numpy.roll(value[y - 1], shift)[40:-40] for y in range(1, len(value))])
        return max(range(-12, 13), key=alike)

    def test_a_flow_runs_at_its_angle_whatever_the_spacing(self):
        flow, steep = numpy.ones((80, 320)), {"steps": 60, "lic": "direct"}
        for spacing, columns in ((1, 1), ((1, 1), 1), ((4, 1), 4), ((6, 2), 3), ((-4, 1), -4), ((4, -1), -4), ((1e-30, 1e-30), 1)):
            with self.subTest(spacing=spacing):
                self.assertEqual(self.slope(aeolic.lic2d(flow, flow, spacing=spacing, **steep)), columns)
        self.assertTrue(numpy.array_equal(aeolic.lic2d(self.u, self.v, spacing=(0.5, 0.5)), aeolic.lic2d(self.u, self.v)))
        for wrong, words in (((1, 2, 3), "found shape (3,); expected (dy, dx), or one number for both"), ((0, 1), "found 0.0"),
                             ((1, numpy.nan), "found nan"), (None, "found None"), ("x", "expected numbers")):
            with self.subTest(wrong=wrong), self.assertRaises(aeolic.InputError) as caught:
                aeolic.lic2d(self.u, self.v, spacing=wrong)
            self.assertIn("lic2d: spacing: ", str(caught.exception))
            self.assertIn(words, str(caught.exception))

    def test_polarization_has_no_signs(self):
        signs = numpy.random.default_rng(3).choice([-1, 1], self.u.shape)
        velocity = aeolic.lic2d(self.u, self.v, steps=15, lic="direct")
        value = aeolic.lic2d(signs * self.u, signs * self.v, steps=15, uv_mode="polarization")
        self.assertGreater((abs(value - velocity) < 1e-3).mean(), 0.95)
        self.assertLess((abs(aeolic.lic2d(signs * self.u, signs * self.v, steps=15) - velocity) < 1e-3).mean(), 0.3)
        for options, words in (({"uv_mode": "polarisation"}, "uv_mode: found 'polarisation'; expected one of velocity, polarization"),
                               ({"uv_mode": "polarization", "lic": "hierarchical"}, "expected lic=direct")):
            with self.assertRaisesRegex(aeolic.InputError, words):
                aeolic.lic2d(self.u, self.v, **options)

    def test_land_is_nan(self):
        self.u[10:20, 5:9] = numpy.nan
        masked = numpy.ma.masked_invalid(self.u)
        value = aeolic.lic2d(masked, self.v)
        self.assertTrue(numpy.array_equal(numpy.isnan(value), masked.mask))

    def test_periodic_planes_repeat(self):
        u, v = numpy.ones((16, 24)), numpy.full((16, 24), 0.5)
        texture = numpy.random.default_rng(2).normal(size=u.shape)
        once = aeolic.lic2d(u, v, texture=texture, boundary="periodic", steps=30, lic="direct")
        rolled = aeolic.lic2d(u, v, texture=numpy.roll(texture, (3, 5), (0, 1)), boundary="periodic", steps=30, lic="direct")
        numpy.testing.assert_allclose(numpy.roll(once, (3, 5), (0, 1)), rolled, atol=2e-3)

    def test_arrays_may_lie_as_they_like(self):
        expected = aeolic.lic2d(self.u, self.v)
        for name, change in {"Fortran order": numpy.asfortranarray, "float64": lambda a: a.astype("f8"),
                             "negative strides": lambda a: a[::-1].copy()[::-1], "lists": lambda a: a.tolist(),
                             "int": lambda a: a.astype("i2"), "big-endian": lambda a: a.astype(">f4")}.items():
            with self.subTest(name):
                self.assertTrue(numpy.array_equal(aeolic.lic2d(change(self.u), change(self.v)), expected))
        with numpy.errstate(all="raise"):
            self.assertTrue(numpy.isnan(aeolic.lic2d(numpy.full((3, 3), 1e300), numpy.zeros((3, 3)))).all())

    def test_wrong_input_is_named(self):
        for call, words in (
                (lambda: aeolic.lic2d(self.u, self.v[1:]), "v: found shape (39, 60); expected (40, 60)"),
                (lambda: aeolic.lic2d(self.u[0], self.v[0]), "u: found shape (60,); expected (ny, nx)"),
                (lambda: aeolic.lic2d(None, self.v), "u: found None"),
                (lambda: aeolic.lic2d(self.u, self.v, texture=self.u[:, 1:]), "texture: found shape (40, 59)"),
                (lambda: aeolic.lic2d(self.u[:0], self.v[:0]), "a plane of 60 x 0 pixels"),
                (lambda: aeolic.lic2d(self.u, self.v, boundary="perodic"), "did you mean periodic?"),
                (lambda: aeolic.lic2d(self.u, self.v, steps=65536, step=8, boundary="periodic"),
                 'steps=65536 of step=8 with boundary="periodic" need '),
                (lambda: aeolic.lic2d(self.u, self.v, steps=0), "steps: found 0")):
            with self.subTest(expected=words), self.assertRaises(aeolic.InputError) as caught:
                call()
            self.assertIn(words, str(caught.exception))
        for name in ("noise_scale", "mask_below"):  # They would do nothing.
            with self.assertRaisesRegex(TypeError, f"unexpected keyword argument '{name}'"):
                aeolic.lic2d(self.u, self.v, **{name: 2})

    def test_ctrl_c_ends_it(self):
        code = ("import aeolic, numpy, os, signal, threading\n"
                "flow = numpy.ones((1000, 1000), 'f4')\n"
                "threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
                "print('ready', flush=True)\n"
                "aeolic.lic2d(flow, flow, lic='direct', steps=65536)\n"  # Minutes.
                "print('drawn')\n")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout, "ready\n")
        self.assertIn("KeyboardInterrupt", done.stderr)
        self.assertEqual(done.returncode, -signal.SIGINT)
