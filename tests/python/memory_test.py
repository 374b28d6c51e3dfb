"""Arrays in memory draw what files with the same contents draw."""
import gc
import pathlib
import tempfile
import unittest
import weakref

import numpy

import aeolic
from scenes import SMALL, Box, Sheet, same


class Memory(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.sheet, self.box = Sheet(), Box()

    def surface(self, **changes):
        parts = {"points": self.sheet.points, "triangles": self.sheet.triangles,
                 "point_data": {"tau": self.sheet.tau, "q": self.sheet.q}, "cell_data": {"c": self.sheet.cell}, **changes}
        return aeolic.Surface(**parts)

    def grid(self):
        return aeolic.Grid(self.box.origin, self.box.spacing, {"U": self.box.u, "p": self.box.p})

    def test_a_surface_draws_what_its_file_draws(self):
        file = self.sheet.write(self.path / "sheet.vtp")
        for color_by in (None, "q", "c", "tau:mag"):
            self.assertTrue(same(aeolic.render(self.surface(), color_by=color_by, **SMALL),
                                 aeolic.render(file, color_by=color_by, **SMALL)), color_by)

    def test_a_grid_draws_what_its_file_draws(self):
        file = self.box.write(self.path / "box.vti")
        for surface in ("slice:0.5,0.5,0.3:0,0.2,1", "isosurface:p=0.5", "boundary", "sphere"):
            for precision in ("float", "half"):
                options = {"color_by": "p", "field_precision": precision, **SMALL}
                self.assertTrue(same(aeolic.render(surface, field=self.grid(), **options),
                                     aeolic.render(surface, field=file, **options)), surface)

    def test_surface_and_grid_go_together(self):
        expected = aeolic.render(self.sheet.write(self.path / "s.vtp"), field=self.box.write(self.path / "b.vti"), **SMALL)
        self.assertTrue(same(aeolic.render(self.surface(), field=self.grid(), **SMALL), expected))

    def test_polygons_are_offsets_and_connectivity(self):
        triangles = self.sheet.triangles
        polygons = (numpy.arange(0, 3 * len(triangles) + 1, 3, dtype="i4"), triangles.reshape(-1).astype("u4"))
        self.assertTrue(same(aeolic.render(self.surface(triangles=None, polygons=polygons), **SMALL),
                             aeolic.render(self.surface(), **SMALL)))

    def test_contiguous_arrays_are_not_copied(self):
        memory = self.surface()._memory
        self.assertIs(memory["points"], self.sheet.points)
        self.assertIs(memory["triangles"], self.sheet.triangles)
        self.assertTrue(numpy.shares_memory(self.grid()._memory["point_data"][0][1], self.box.u))

    def test_arrays_live_as_long_as_they_are_needed(self):
        points, u = self.sheet.points, self.box.u
        gone = weakref.ref(points), weakref.ref(u)
        renderer = aeolic.Renderer(self.surface(points=points),
                                   field=aeolic.Grid(self.box.origin, self.box.spacing, {"U": u}), **SMALL)
        before = renderer.render()
        del points, u
        self.sheet.points = self.box.u = None
        gc.collect()
        self.assertTrue(same(renderer.render(), before))
        self.assertIsNone(gone[0](), "a surface is copied by the renderer")
        self.assertIsNotNone(gone[1](), "a grid is sampled where it is")
        del renderer
        gc.collect()
        self.assertIsNone(gone[1]())

    def test_pictures_share_their_memory_with_numpy(self):
        picture = aeolic.render("sphere", background="transparent", **SMALL)
        pixels = numpy.asarray(picture)
        self.assertEqual((pixels.shape, pixels.dtype), ((36, 48, 4), numpy.uint8))
        self.assertEqual(pixels.__array_interface__["data"][0], picture.__array_interface__["data"][0])
        png = picture._repr_png_()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        pixels[:] = 7
        self.assertNotEqual(picture._repr_png_(), png)
        del picture
        self.assertTrue((pixels == 7).all())

    def test_new_data_are_drawn_as_a_series_is(self):
        other = Sheet(bend=-0.2)
        self.sheet.write(self.path / "s_0.vtp")
        other.write(self.path / "s_1.vtp")
        series = aeolic.Renderer(self.path / "s_%d.vtp", color_by="q", **SMALL)
        renderer = aeolic.Renderer(self.surface(), color_by="q", **SMALL)
        self.assertTrue(same(renderer.render(), series.render()))
        series.time = 1
        renderer.set_data(self.surface(points=other.points, point_data={"tau": other.tau, "q": other.q}))
        self.assertTrue(same(renderer.render(), series.render()))
        self.assertEqual(series.times, (0.0, 1.0))
        with self.assertRaises(aeolic.InputError):
            renderer.set_data(field=self.grid())
        with self.assertRaises(TypeError):
            renderer.set_data("file.vtp")

    def test_info_and_stats_tell_what_was_drawn(self):
        renderer = aeolic.Renderer(self.surface(), **SMALL)
        renderer.render()
        self.assertEqual(renderer.info["triangles"], 32)
        self.assertEqual(renderer.info["backend"], "cpu")
        self.assertEqual(renderer.stats["lic"]["steps"], 9)
        self.assertGreater(renderer.stats["image"]["covered_pixels"], 100)
        self.assertIn("tau", aeolic.info(self.sheet.write(self.path / "s.vtp")).text)
        with self.assertRaises(aeolic.InputError):
            aeolic.info(self.path / "none.vtp")
