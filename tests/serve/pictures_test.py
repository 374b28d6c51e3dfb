"""What viewers see: the bytes of `aeolic render`, their own cameras, each other's."""
import json
import os
import tempfile
import time
import unittest

import suite
from server import Server, gl_faults, has_gl, has_mpirun, run
from viewer import CHANGE, FOLLOW, JPEG, PNG, SHOWN, decode_png

WAKE = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "examples", "ahmed", "ahmed_wake.vti"))


def read(path):
    with open(path, "rb") as file:
        return file.read()


class PicksOfPixels(unittest.TestCase):
    """What a view shows at a pixel, between pictures of others."""

    def picks(self, ranks, *options):
        scene = ["--surface", "sphere:20000", "--field", "rotation:33,33,33", "--color-by", "rotation:mag", "--steps", "4"]
        with Server("--ranks", str(ranks), scene=[*scene, *options]) as server, server.viewer() as a, server.viewer() as b:
            a.until(lambda _: a.scene)
            view = {"camera": {"azimuth": 0, "elevation": 0}}
            place = a.pick(32, 24, **view)
            x, y, z = place["position"]
            self.assertAlmostEqual(x * x + y * y + z * z, 1, delta=0.01)
            self.assertLess(y, -0.9)
            turns = place["scalar"] / (x * x + y * y) ** 0.5
            self.assertAlmostEqual(place["vector"][0], -turns * y, delta=0.02)
            self.assertEqual((place["scalarName"], place["vectorName"], place["surface"]), ("|rotation|", "rotation", "sphere"))
            self.assertIsNone(a.pick(0, 0, **view))
            told = run("probe", "32,24", *scene, "--size", "64x48", "--camera", "azimuth=0,elevation=0").stdout
            self.assertEqual([float(number) for number in told.splitlines()[0].split()[1:]],
                             [float(f"{number:.9g}") for number in place["position"]])
            picture = b.see(width=64, height=48)
            for turn in range(5):  # Pictures of others, and of other sizes, do not change what is told.
                wanted = b.view(width=90 + turn, height=40)
                self.assertEqual(a.pick(32, 24, **view), place)
                b.picture(wanted)
            self.assertEqual(b.see(width=64, height=48).pixels(), picture.pixels())
            self.assertIn("azimuth", a.pick(1, 1, camera={"azimuth": "east"}))

    def test_one_rank(self):
        self.picks(1)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_two_ranks(self):
        self.picks(2)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_two_ranks_with_a_field_in_bricks(self):
        self.picks(2, "--bricks", "on")


class SameBytesAsRender(unittest.TestCase):
    """grab of a running server against render, file against file."""

    SCENES = [
        # size, options of render, the same as a view
        ("64x48", [], {}),
        ("97x61", ["--lic", "direct", "--integrator", "rk4", "--steps", "5"],
         {"lic": {"method": "direct", "integrator": "rk4", "steps": 5}}),
        ("131x257", ["--kernel", "hann", "--phase", "1.5", "--noise-scale", "2", "--seed", "9"],
         {"lic": {"kernel": "hann", "phase": 1.5, "noiseScale": 2, "seed": 9}}),
        ("1x1", [], {}),
        ("3x200", [], {}),
        ("90x70", ["--background", "transparent"], {"shading": {"background": "transparent"}}),
        ("120x90", ["--camera", "azimuth=75,elevation=-30,roll=10,zoom=1.5", "--blend", "0.4", "--lighting", "off"],
         {"camera": {"azimuth": 75, "elevation": -30, "roll": 10, "zoom": 1.5},
          "shading": {"blend": 0.4, "lighting": False}}),
    ]

    def compare(self, server, scene, size, render, view):
        rendered, grabbed = os.path.join(server.folder, "r.png"), os.path.join(server.folder, "g.png")
        result = run("render", *scene, *render, "--size", size, "-o", rendered)
        self.assertEqual(result.returncode, 0, result.stderr)
        result = run("grab", server.address, "--size", size, "--view", json.dumps(view), "-o", grabbed)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(read(grabbed), read(rendered), f"{size} {render}")

    def scenes(self, ranks):
        scene = ["--surface", "teapot:2000", "--field", "rotation:16,16,16"]
        with Server("--ranks", str(ranks), scene=scene + ["--steps", "8"]) as server:
            for size, render, view in self.SCENES:
                with self.subTest(size=size, render=render):
                    steps = [] if "--steps" in render else ["--steps", "8"]
                    self.compare(server, scene, size, render + steps, view)

    def test_one_rank(self):
        self.scenes(1)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_three_ranks(self):
        self.scenes(3)

    def gl(self, ranks):
        """The next frame is begun before the one before is there. Each viewer still sees its own frames."""
        scene = ["--surface", "teapot:2000", "--field", "rotation:16,16,16", "--steps", "8", "--backend", "gl"]
        mark = tempfile.mktemp(prefix="aeolic_overlapped_")
        environment = {"LD_PRELOAD": gl_faults, "AEOLIC_TEST_OVERLAP": mark}
        with Server("--ranks", str(ranks), scene=scene, environment=environment) as server, \
                server.viewer() as a, server.viewer() as b:
            size = {"width": 64, "height": 48}
            expected = {}
            for azimuth in (0, 40, 80):
                expected[azimuth] = a.see(camera={"azimuth": azimuth}, **size).pixels()
            self.assertFalse(os.path.exists(mark), "one frame after the other")
            for turn in range(60):  # On a busy machine a frame may be there before somebody asks for the next one.
                if turn >= 3 and os.path.exists(mark):
                    break
                for azimuth in (0, 40, 80):  # Both ask at once, so that there is always a next frame.
                    of_a = a.view(camera={"azimuth": azimuth}, **size)
                    of_b = b.view(camera={"azimuth": 80 - azimuth}, **size)
                    self.assertEqual(a.picture(of_a).pixels(), expected[azimuth])
                    self.assertEqual(b.picture(of_b).pixels(), expected[80 - azimuth])
            os.remove(mark)  # The file is there because two frames were in flight.
            self.compare(server, scene, "64x48", [], {})

    @unittest.skipUnless(has_gl(), "no OpenGL in this build or on this machine, or with sanitizers")
    def test_one_rank_on_a_gpu(self):
        self.gl(1)

    @unittest.skipUnless(has_mpirun and has_gl(), "no OpenGL here, no mpirun, or a build without MPI")
    def test_two_ranks_on_a_gpu(self):
        self.gl(2)

    def test_the_scene_s_view_as_the_page_sends_it(self):
        """Numbers of a place in the world, however far the scene zooms: it is the scene's own picture."""
        scene = ["--surface", "teapot:2000", "--field", "rotation:16,16,16", "--steps", "8"]
        for camera in ("azimuth=10", "azimuth=10,zoom=2", "azimuth=10,zoom=50", "zoom=300,focal=1,0.5,0.5", "fov=120,zoom=6"):
            with self.subTest(camera=camera), Server(scene=scene + ["--camera", camera]) as server, server.viewer() as viewer:
                size = {"width": 64, "height": 48}
                expected = viewer.see(**size).pixels()
                self.assertEqual(viewer.see(camera=viewer.scene["view"], **size).pixels(), expected)

    def test_scalar_bar_and_a_scene_file(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.json")
            with open(scene, "w") as file:
                json.dump({"version": 1, "surface": {"spec": "sphere"}, "field": {"spec": "rotation:16,16,16"},
                           "lic": {"steps": 6}, "shading": {"colorBy": "rotation:mag", "colormap": "turbo"}}, file)
            with Server(scene=[scene]) as server:
                self.compare(server, [scene], "300x200", [], {})
                self.compare(server, [scene], "300x200", ["--scalar-bar", "off", "--color-range", "0,2"],
                             {"shading": {"scalarBar": False, "colorRange": [0, 2]}})

    def test_a_view_of_an_animation_has_its_legend_as_a_still(self):
        """The square is in the upper right of this view, and elsewhere later in the orbit."""
        with tempfile.TemporaryDirectory() as folder:
            still, turning = os.path.join(folder, "still.json"), os.path.join(folder, "turning.json")
            for name, output in ((still, {}), (turning, {"frames": 36})):
                with open(name, "w") as file:
                    json.dump({"version": 1, "surface": {"spec": "plane"}, "field": {"spec": "uniform:2,2,2"}, "lic": {"steps": 6},
                               "shading": {"colorBy": "uniform:mag"}, "output": output,
                               "camera": {"position": [0, 0, 4], "focal": [-0.8, -0.8, 0], "up": [0, 1, 0]}}, file)
            with Server(scene=[turning]) as server:
                self.compare(server, [still], "300x300", [], {})

    def test_a_figure_with_a_colour_map_out_of_a_file(self):
        """The file belongs to the scene. A viewer may choose it or a built-in one, and no other file."""
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "mine.json"), "w") as file:
                json.dump([{"Name": "mine", "ColorSpace": "RGB", "NanColor": [1, 0, 1], "BelowRangeColor": [0, 1, 0],
                            "UseBelowRangeColor": 1, "AboveRangeColor": [1, 1, 1], "UseAboveRangeColor": 0,
                            "RGBPoints": [0, 0, 0, 64 / 255, 1, 1, 1, 0, 2, 120 / 255, 0, 0]}], file)
            with open(os.path.join(folder, "other.csv"), "w") as file:
                file.write("0,0,0\n1,1,1\n")
            scene = os.path.join(folder, "scene.json")
            with open(scene, "w") as file:
                json.dump({"version": 1, "surface": {"spec": "sphere"}, "field": {"spec": "gyre:9,9,9"}, "lic": {"steps": 6},
                           "shading": {"colorBy": "gyre:mag", "colormap": "mine.json", "title": "Größe", "axes": True}}, file)
            with Server("--ranks", "1", scene=[scene]) as server, server.viewer() as viewer:
                self.compare(server, [scene], "300x200", [], {})
                self.compare(server, [scene], "300x200",
                             ["--color-scale", "bands:4", "--legend", "|v| [m/s]", "--time-stamp", "on", "--mask-below", "0.1",
                              "--below-color", "0000ff", "--color-range", "0.05,0.2", "--text-scale", "1.3"],
                             {"shading": {"colorScale": "bands:4", "legend": "|v| [m/s]", "timeStamp": True,
                                          "belowColor": "0000ff", "colorRange": [0.05, 0.2], "textScale": 1.3}, "lic": {"maskBelow": 0.1}})
                told = viewer.loaded().scene
                name = told["scene"]["shading"]["colormap"]
                self.assertEqual(told["options"]["shading"]["colormap"]["names"][-1], name)
                self.assertEqual(told["choices"]["colorStops"][name][0], "000040")
                self.assertEqual(told["choices"]["colorsOutside"],
                                 {name: {"nanColor": "ff00ff", "belowColor": "00ff00"}})
                small = viewer.see(width=90, height=60)
                self.assertIn("no room for the title, the axes and the legend", small.stats["warnings"][0])
                self.assertEqual(viewer.see(width=300, height=200).stats["warnings"], [])
                of_file = small.pixels()
                self.assertNotEqual(viewer.see(width=90, height=60, shading={"colormap": "vik"}).pixels(), of_file)
                os.remove(os.path.join(folder, "mine.json"))  # It was read once.
                self.assertEqual(viewer.see(width=90, height=60, shading={"colormap": name}).pixels(), of_file)
                viewer.view(shading={"colormap": os.path.join(folder, "other.csv")})
                viewer.until(lambda _: viewer.notices)
                self.assertIn("shading.colormap", viewer.notices[0]["message"])

    def test_what_can_be_chosen_of_a_series(self):
        """Ranges of a field's arrays are those of its first step, whatever names the series."""
        with tempfile.TemporaryDirectory() as folder:
            for step in (0, 1):
                p, vectors = " ".join(str(i + step) for i in range(8)), "3 0 4 " * 8
                with open(os.path.join(folder, f"w_{step}.vti"), "w") as file:
                    file.write('<VTKFile type="ImageData"><ImageData WholeExtent="0 1 0 1 0 1" Spacing="1 1 1">'
                               '<Piece Extent="0 1 0 1 0 1"><PointData>'
                               f'<DataArray type="Float32" Name="p" format="ascii">{p}</DataArray>'
                               '<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">'
                               f"{vectors}</DataArray></PointData></Piece></ImageData></VTKFile>")
            with open(os.path.join(folder, "w.pvd"), "w") as file:
                file.write('<VTKFile type="Collection"><Collection><DataSet timestep="1" file="w_0.vti"/>'
                           '<DataSet timestep="2" file="w_1.vti"/></Collection></VTKFile>')
            for field in ("w_%d.vti", "w.pvd"):
                with self.subTest(field):
                    scene = ["--surface", "slice:0.5,0.5,0.5:0,0,1", "--field", os.path.join(folder, field)]
                    with Server("--ranks", "1", scene=scene) as server, server.viewer() as viewer:
                        self.assertEqual(viewer.loaded().scene["choices"]["isosurface"],
                                         [{"array": "p", "range": [0, 7]}, {"array": "U:mag", "range": [5, 5]}])
                        self.assertEqual(viewer.scene["choices"]["bounds"], [[0, 0, 0], [1, 1, 1]],
                                         "where the slice can be, which knows itself alone")


class Viewing(unittest.TestCase):
    def test_two_viewers_with_their_own_cameras(self):
        with Server() as server, server.viewer() as ann, server.viewer() as bob:
            self.assertNotEqual(ann.number, bob.number)
            ann.view(camera={"azimuth": 10})
            bob.view(camera={"azimuth": 100})
            of_ann, of_bob = ann.picture(), bob.picture()
            self.assertEqual((of_ann.viewer, of_bob.viewer), (ann.number, bob.number))
            self.assertNotEqual(of_ann.pixels(), of_bob.pixels())
            again = bob.see(camera={"azimuth": 10})
            self.assertEqual(again.pixels(), of_ann.pixels(), "the same view gives the same bytes to everyone")

    def test_following(self):
        with Server() as server, server.viewer(name="ann") as ann, server.viewer(name="bob") as bob:
            bob.loaded()
            bob.send(FOLLOW, ann.number)
            of_ann = ann.see(camera={"azimuth": 77})
            of_bob = bob.picture()
            self.assertEqual((of_bob.frame, of_bob.viewer), (of_ann.frame, ann.number))
            self.assertEqual(of_bob.pixels(), of_ann.pixels())
            own = bob.see(camera={"azimuth": 5})  # A view of its own ends the following.
            self.assertEqual(own.viewer, bob.number)
            self.assertEqual({viewer["name"] for viewer in bob.state["viewers"]}, {"ann", "bob"})

    def test_moving_is_lossy_and_rest_is_lossless(self):
        with Server() as server, server.viewer() as viewer:
            moving = viewer.see(moving=True, width=200, height=150)
            self.assertFalse(moving.lossless)
            self.assertEqual({tile[2] for tile in moving.tiles.values()}, {JPEG})
            rest = viewer.see(width=200, height=150)
            self.assertTrue(rest.lossless)
            self.assertEqual((rest.width, rest.height, rest.asked_width), (200, 150, 200))
            self.assertEqual({tile[2] for tile in rest.tiles.values()}, {PNG})
            for key in ("totalMs", "stagesMs", "encodeMs", "bytes", "ranks"):
                self.assertIn(key, rest.stats)

    def test_where_the_legend_stands_is_told(self):
        with Server("--color-by", "rotation:mag") as server, server.viewer() as viewer:
            for moving in (True, False):
                picture = viewer.see(moving=moving, width=300, height=200)
                x, y, width, height = picture.stats["legend"]
                self.assertTrue(0 <= x < x + width <= picture.width and 0 <= y < y + height <= picture.height)
                self.assertGreater(min(width, height), 10)
            self.assertIsNone(viewer.see(width=300, height=200, shading={"scalarBar": False}).stats["legend"])

    def test_a_view_from_home_goes_along_with_the_scene(self):
        with Server(scene=["--surface", "slice:1.1,0,0:1,0,0", "--field", WAKE, "--steps", "8"]) as server, server.viewer() as viewer:
            for home in (1, 1.5):
                viewer.send(CHANGE, {"surface": "original", "change": 1})
                viewer.see(width=120, height=120, home=home, camera={"azimuth": 77})
                viewer.send(CHANGE, {"surface": "slice:1.3,0,0:1,0,0", "change": 2})
                viewer.until(lambda _: viewer.answered == 2)
                along = viewer.picture()
                eye = viewer.scene["view"]
                position = [f + home * (p - f) for p, f in zip(eye["position"], eye["focal"])]
                there = viewer.see(width=120, height=120, camera={**eye, "position": position})
                self.assertEqual(along.pixels(), there.pixels())

    def test_what_a_viewer_cannot_decode_is_not_sent(self):
        with Server() as server, server.viewer(codecs=["png"]) as viewer:
            self.assertEqual({tile[2] for tile in viewer.see(moving=True).tiles.values()}, {PNG})

    def test_only_the_newest_view_counts(self):
        with Server() as server, server.viewer() as viewer:
            viewer.see()
            numbers = [viewer.view(moving=True, camera={"azimuth": i}) for i in range(100)]
            drawn = []
            viewer.until(lambda frame: frame and (drawn.append(frame.view) or frame.view == numbers[-1]))
            self.assertEqual(drawn, sorted(drawn))
            self.assertLess(len(drawn), 50, "most of them were never drawn")

    def test_credit_of_two_frames(self):
        with Server() as server, server.viewer() as viewer, server.viewer() as other:
            got = []
            for azimuth in range(4):
                viewer.view(camera={"azimuth": azimuth})
                other.see(camera={"azimuth": azimuth})  # Time enough to draw it, if it is drawn.
            while len(got) < 2:
                viewer.until(lambda frame: frame and (got.append(frame) or True), show=False)
            other.see()
            with self.assertRaises(TimeoutError):
                viewer.until(lambda frame: frame, seconds=1, show=False)
            viewer.send(SHOWN, got[-1].frame)
            self.assertEqual(viewer.picture().view, 4)

    def test_wrong_options_are_told_and_the_connection_stays(self):
        with Server() as server, server.viewer() as viewer:
            viewer.loaded()
            viewer.view(lic={"steps": 0})
            viewer.until(lambda _: viewer.notices)
            self.assertIn("lic.steps", viewer.notices[0]["message"])
            self.assertEqual(viewer.notices[0]["level"], "error")
            viewer.see()

    def test_sizes_over_the_limit_are_cut_down(self):
        with Server("--max-size", "100") as server, server.viewer() as viewer:
            self.assertEqual(viewer.welcome["limits"]["largestSide"], 100)
            frame = viewer.see(width=4000, height=1000)
            self.assertEqual((frame.width, frame.height), (100, 25))

    def test_changes_of_the_scene_are_everybodys(self):
        with Server() as server, server.viewer() as ann, server.viewer() as bob:
            before = ann.see().pixels()
            bob.see()
            ann.scene = bob.scene = None
            bob.send(CHANGE, {"colorBy": "rotation:mag"})
            bob.until(lambda _: bob.scene or bob.notices)
            if bob.notices:
                self.fail(bob.notices[0]["message"])
            ann.until(lambda _: ann.scene)
            self.assertEqual(ann.scene["scene"]["shading"]["colorBy"], "rotation:mag")
            self.assertNotEqual(ann.picture().pixels(), before, "drawn again without being asked")

    def test_a_viewer_names_no_file(self):
        with Server() as server, server.viewer() as viewer:
            before = viewer.see().pixels()
            secret = os.path.join(server.folder, "log")
            for surface in (secret, "/etc/passwd", "../log", "file://" + secret, "sphere"):
                viewer.notices.clear()
                viewer.send(CHANGE, {"surface": surface})
                viewer.until(lambda _: viewer.notices)
                self.assertTrue(viewer.notices[0]["change"])
                self.assertNotIn("cannot be", viewer.notices[0]["message"], "nor learns whether there is one")
            self.assertEqual(viewer.see().pixels(), before)

    def test_a_change_that_cannot_be_loaded_leaves_the_scene(self):
        with Server() as server, server.viewer() as viewer:
            before = viewer.see().pixels()
            viewer.send(CHANGE, {"colorBy": "no such array"})
            viewer.until(lambda _: viewer.notices)
            self.assertIn("no such array", viewer.notices[0]["message"])
            self.assertEqual(viewer.see().pixels(), before)

    def test_the_pictures_decoder_of_these_tests(self):
        with Server() as server:
            path = os.path.join(server.folder, "r.png")
            run("render", "--surface", "sphere", "--steps", "3", "--size", "40x30", "--background", "transparent", "-o", path)
            width, height, channels, pixels = decode_png(read(path))
            self.assertEqual((width, height, channels, len(pixels)), (40, 30, 4, 40 * 30 * 4))


if __name__ == "__main__":
    suite.main()
