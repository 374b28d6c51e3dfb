"""examples/insitu: a solver that draws while it runs. Arguments: the program aeolic, the program insitu, mpirun (or empty)."""
import json
import os
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading
import unittest

AEOLIC, INSITU, MPIRUN = sys.argv[1:4]
del sys.argv[1:4]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "serve"))
os.environ.setdefault("AEOLIC_PROGRAM", AEOLIC)
os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"})
from viewer import Viewer  # noqa: E402

SMALL = ["--size", "8x24x48"]
LOOK = ["--vectors", "velocity", "--color-by", "velocity:mag", "--color-range", "0,0.128", "--size", "1200x500",
        "--camera", "azimuth=60,elevation=20,roll=90,zoom=1.9"]
CHANGE = 4


def words(ranks):
    return ([MPIRUN, "-n", str(ranks)] if ranks > 1 else []) + [INSITU, *SMALL]


class InSitu(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_pictures_are_those_of_files_written_at_that_step(self):
        for ranks in (1, 2, 3) if MPIRUN else (1,):
            subprocess.run([*words(ranks), "--steps", "4", "--every", "2", "-o", f"{self.folder}/{ranks}-%d.png", "--files",
                            str(self.folder)], check=True, timeout=120, capture_output=True)
            for step in (2, 4):
                picture = self.folder / "of-files.png"
                subprocess.run([AEOLIC, "render", "--surface", str(self.folder / f"step-{step}.pvtp"), *LOOK, "-o", str(picture)],
                               check=True, timeout=120)
                self.assertEqual(picture.read_bytes(), (self.folder / f"{ranks}-{step}.png").read_bytes(), (ranks, step))

    def test_viewers_watch_and_steer(self):
        for ranks in (1, 2) if MPIRUN else (1,):
            with subprocess.Popen([*words(ranks), "--steps", "1000000", "--every", "1", "--serve"], stdout=subprocess.PIPE,
                                  text=True) as solver:
                try:
                    self.watch(solver)
                finally:
                    solver.terminate()

    def watch(self, solver):
        said = queue.Queue()
        threading.Thread(target=lambda: said.put(solver.stdout.readline()), daemon=True).start()
        with Viewer(said.get(timeout=60).strip()) as viewer:
            controls = viewer.loaded().scene["program"]["controls"]
            self.assertEqual([one["name"] for one in controls], ["pause", "step", "inflow"])
            first, second = viewer.see().pixels(), viewer.picture().pixels()
            self.assertNotEqual(first, second, "the flow goes on by itself")
            viewer.send(CHANGE, {"steer": {"pause": 1}})
            viewer.until(lambda _: viewer.scene["program"]["controls"][0]["value"] == 1)
            still = viewer.see().pixels()
            self.assertEqual(viewer.see().pixels(), still)
            viewer.send(CHANGE, {"steer": {"step": 1, "inflow": 0.03}})
            viewer.until(lambda _: viewer.scene["program"]["controls"][1]["value"] == 1)
            self.assertNotEqual(viewer.see().pixels(), still)
            self.assertEqual(viewer.scene["program"]["controls"][2]["value"], 0.03)

    def test_wrong_words_end_in_one_line(self):
        for wrong, line in ((["--size", "1x2x3"], "--size: found '1x2x3'"), (["--stps", "3"], "--stps: unknown"), (["-o"], "-o: unknown")):
            done = subprocess.run([INSITU, *wrong], capture_output=True, text=True, timeout=60)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"insitu: {line}", done.stderr)


if __name__ == "__main__":
    unittest.main()
