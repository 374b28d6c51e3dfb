"""The reader is killed, wherever it may be: one line says so, nothing waits for it, and nothing is left of it."""
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import uuid

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, os.pardir, "serve"))
from server import LAUNCHING, PROGRAM, SLOW, Server, has_mpirun, open_files, within  # noqa: E402
from viewer import CHANGE  # noqa: E402

READER = os.path.join(os.path.dirname(os.path.abspath(PROGRAM)), "libexec", "aeolic", "aeolic-reader")
MOST_SECONDS = 5 * SLOW  # From the kill to the end.
SIDE = 120  # Points along a side of the surfaces: their arrays are large enough to travel as memory.


def write_surface(path, height):
    """A square with vectors, as legacy VTK."""
    points = SIDE * SIDE
    with open(path, "wb") as file:
        file.write(f"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS {points} float\n".encode())
        for y in range(SIDE):
            for x in range(SIDE):
                file.write(struct.pack(">3f", x, y, height))
        cells = (SIDE - 1) ** 2
        file.write(f"\nPOLYGONS {cells} {5 * cells}\n".encode())
        for y in range(SIDE - 1):
            for x in range(SIDE - 1):
                first = y * SIDE + x
                file.write(struct.pack(">5i", 4, first, first + 1, first + SIDE + 1, first + SIDE))
        file.write(f"\nPOINT_DATA {points}\nVECTORS v float\n".encode())
        file.write(struct.pack(">3f", 1, 0.5, 0) * points)


def write_case(folder):
    """A channel of one cell as an OpenFOAM case, with a wall."""
    def write(name, kind, text):
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(f"FoamFile\n{{\n version 2.0;\n format ascii;\n class {kind};\n object x;\n}}\n{text}\n")
    mesh = "constant/polyMesh/"
    write(mesh + "points", "vectorField", "8\n((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1))")
    write(mesh + "faces", "faceList", "6\n(4(0 3 2 1) 4(4 5 6 7) 4(0 1 5 4) 4(1 2 6 5) 4(2 3 7 6) 4(3 0 4 7))")
    write(mesh + "owner", "labelList", "6\n(0 0 0 0 0 0)")
    write(mesh + "neighbour", "labelList", "0\n()")
    write(mesh + "boundary", "polyBoundaryMesh",
          "2\n(floor { type wall; nFaces 1; startFace 0; } rest { type patch; nFaces 5; startFace 1; })")
    for moment in ("1", "2"):
        write(f"{moment}/U", "volVectorField",
              "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (1 0 0);\nboundaryField\n{\n"
              "floor { type fixedValue; value uniform (1 0 0); }\nrest { type zeroGradient; }\n}")
    open(os.path.join(folder, "case.foam"), "w").close()


class Kills(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="aeolic_kills_")
        cls.file = os.path.join(cls.folder, "s_0.vtk")
        for step in range(4):
            write_surface(os.path.join(cls.folder, f"s_{step}.vtk"), step)
        cls.case = os.path.join(cls.folder, "case")
        write_case(cls.case)
        cls.series = os.path.join(cls.folder, "s.pvd")
        with open(cls.series, "w") as file:
            sets = "".join(f'<DataSet timestep="{step}" file="s_{step}.vtk"/>' for step in range(4))
            file.write(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)

    def setUp(self):
        self.mark = uuid.uuid4().hex
        self.killed = os.path.join(self.folder, self.mark)

    def environment(self, place):
        return {**LAUNCHING, "AEOLIC_READER": os.path.join(HERE, "killed_reader.py"), "AEOLIC_TEST_READER": READER,
                "AEOLIC_TEST_KILL": place, "AEOLIC_TEST_KILLED": self.killed, "AEOLIC_TEST_MARK": self.mark}

    def kills(self):
        """When readers were killed."""
        if not os.path.exists(self.killed):
            return []
        with open(self.killed) as file:
            return [float(line) for line in file]

    def readers(self):
        """Processes that are left of those that were started with this test's mark."""
        found = []
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{pid}/environ", "rb") as environ, open(f"/proc/{pid}/cmdline", "rb") as words:
                    if self.mark.encode() in environ.read() and b"reader" in words.read():
                        found.append(pid)
            except OSError:
                pass
        return found

    def run_killed(self, place, *words):
        """Runs the words to their end, with a reader that is killed there."""
        ended = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=60 * SLOW, stdin=subprocess.DEVNULL,
                               cwd=self.folder, env={**os.environ, **self.environment(place)})
        end = time.time()
        self.assertTrue(self.kills(), f"nothing was killed: {ended.stderr}")
        self.assertLess(end - self.kills()[0], MOST_SECONDS)
        within(2, lambda: not self.readers(), "the end of the readers")
        return ended

    def one_line(self, text, path):
        lines = [line for line in text.splitlines() if "the reader" in line]
        self.assertEqual(len(lines), 1, text)
        self.assertRegex(lines[0], re.escape(path) + r".*: the reader ended \(SIGKILL\) while [a-z ]+; expected ")
        return lines[0]

    def render(self, surface, *words):
        return [PROGRAM, "render", "--surface", surface, "--size", "64x48", "--steps", "8", "-o", os.path.join(self.folder, "a.png"),
                *words]

    def test_render(self):
        for place in ("start", "open", "read", "memory"):
            with self.subTest(place=place):
                self.setUp()
                ended = self.run_killed(place, *self.render(self.file))
                self.assertEqual(ended.returncode, 2, ended.stderr)
                self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
                self.one_line(ended.stderr, self.file)

    def test_render_case(self):
        for place in ("start", "look", "look:2", "open", "arrays", "read"):
            with self.subTest(place=place):
                self.setUp()
                ended = self.run_killed(place, *self.render(self.case + ":floor"))
                self.assertEqual(ended.returncode, 2, ended.stderr)
                self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
                self.one_line(ended.stderr, self.case)

    def test_info(self):
        for path in (self.file, self.case, self.series):
            for place in ("start", "look"):
                with self.subTest(place=place, path=path):
                    self.setUp()
                    ended = self.run_killed(place, PROGRAM, "info", path)
                    self.assertEqual(ended.returncode, 2, ended.stderr)
                    self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
                    self.one_line(ended.stderr, path)

    def test_between_steps(self):
        """Nobody asks anything of a reader that ended, or hangs, when it closed its file: another one reads the next."""
        words = self.render(self.series, "--frames", "4", "--time-range", "0,3")
        whole = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(whole.returncode, 0, whole.stderr)

        def pictures():
            names = [name for name in sorted(os.listdir(self.folder)) if name.startswith("a") and name.endswith(".png")]
            return [open(os.path.join(self.folder, name), "rb").read() for name in names]
        before = pictures()
        for place in ("close", "hang"):
            with self.subTest(place=place):
                self.setUp()
                ended = self.run_killed(place, *words)
                self.assertEqual(ended.returncode, 0, ended.stderr)
                self.assertEqual(pictures(), before)

    def test_serve_that_cannot_start(self):
        for place in ("start", "open", "read", "memory"):
            with self.subTest(place=place):
                self.setUp()
                with tempfile.TemporaryFile("w+") as said:
                    server = subprocess.Popen([PROGRAM, "serve", "--surface", self.file, "--port", "0"], stdout=subprocess.DEVNULL,
                                              stderr=said, stdin=subprocess.DEVNULL, env={**os.environ, **self.environment(place)})
                    try:
                        within(20, self.kills, "the kill")

                        def told():
                            said.seek(0)
                            return "the reader ended" in said.read()
                        within(5, told, "the line")
                        within(2, lambda: not self.readers(), "the end of the readers")
                    finally:
                        server.terminate()
                        server.wait(15 * SLOW)

    def test_serve_between_moments(self):
        """A moment that cannot be read leaves the server as it was, and others can."""
        with Server(scene=["--surface", self.series, "--steps", "8", "--time", "0"], environment=self.environment("read:2")) as server:
            with server.viewer() as viewer:
                viewer.see(width=64, height=48)
                pid = server.ranks(1)[0]
                files = open_files(pid)
                for change, moment in enumerate((2, 3), 1):
                    viewer.send(CHANGE, {"change": change, "time": moment})
                    viewer.until(lambda _, change=change: viewer.answered == change, 30)
                    viewer.see(width=64, height=48)
                self.assertTrue(self.kills())
                self.assertEqual(server.ranks(1), [pid])
                within(5, lambda: open_files(pid) <= files, "the end of the descriptors")
                within(2, lambda: len(self.readers()) <= 2, "the end of the readers")  # Of which one waits, by its stand-in.
        within(2, lambda: not self.readers(), "the end of the readers")

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_four_ranks(self):
        for surface in (self.file, self.case + ":floor"):
            for place in ("start", "open", "read") + (("memory",) if surface == self.file else ("look",)):
                with self.subTest(place=place, surface=surface):
                    self.setUp()
                    ended = self.run_killed(place, "mpirun", "-n", "4", *self.render(surface))
                    self.assertNotEqual(ended.returncode, 0)
                    self.one_line(ended.stderr, surface.split(":")[0])

    @unittest.skipUnless(os.environ.get("AEOLIC_TESTED_PYTHON"), "no Python module")
    def test_python(self):
        """The process goes on, and has what it had."""
        program = """
import os, sys, time
import aeolic
def files(): return len(os.listdir("/proc/self/fd"))
def maps(): return open("/proc/self/maps").read().count("aeolic-")
start = os.environ["AEOLIC_TEST_KILL"]
def attempt(**words):
    try:
        return aeolic.Renderer(size=(64, 48), steps=8, **words)
    except aeolic.InputError as error:
        print(error)
        assert len(str(error).splitlines()) == 1 and "(SIGKILL)" in str(error), error
aeolic.Renderer(surface="teapot:2000", field="rotation", size=(64, 48)).render()
before, mapped = files(), maps()
assert attempt(surface=sys.argv[1]) is None
assert (files(), maps()) == (before, mapped), "something is left"
try:
    os.waitpid(-1, os.WNOHANG)
    raise AssertionError("a process is left")
except ChildProcessError:
    pass
os.environ["AEOLIC_TEST_KILL"] = "never"
attempt(surface=sys.argv[1]).render()
"""
        for place in ("start", "open", "read", "memory"):
            with self.subTest(place=place):
                self.setUp()
                ended = self.run_killed(place, os.environ["AEOLIC_TESTED_PYTHON"], "-c", program, self.file)
                self.assertEqual(ended.returncode, 0, ended.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
