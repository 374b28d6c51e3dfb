"""examples/notebooks: every cell runs, and the cells that end in a picture or a page show one."""
import ast
import json
import os
import pathlib
import unittest
import unittest.mock

import aeolic

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples" / "notebooks"


def cells(path):
    notebook = json.loads(path.read_text())
    for cell in notebook["cells"]:
        assert not cell.get("outputs"), f"{path}: a cell has outputs"
        if cell["cell_type"] == "code":
            yield "".join(cell["source"])


def run(source, names):
    """What the last line of a cell gives, as a kernel shows it."""
    tree = ast.parse(source)
    last = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(last, "cell", "eval"), names) if last else None


class Notebooks(unittest.TestCase):
    def run_all(self, name):
        before = os.getcwd()
        os.chdir(FOLDER)
        self.addCleanup(os.chdir, before)
        names = {}
        with unittest.mock.patch("webbrowser.open"):
            return [run(source, names) for source in cells(FOLDER / f"{name}.ipynb")], names

    def test_body(self):
        shown, names = self.run_all("body")
        self.assertEqual([type(one) for one in shown[1:3]], [aeolic.Picture, aeolic.Picture])
        self.assertTrue(shown[1]._repr_png_().startswith(b"\x89PNG"))
        self.assertEqual(shown[3][0], (500, 900, 3))
        self.assertEqual(repr(names["viewer"]), "<aeolic.Viewer, closed>")

    def test_time(self):
        shown, names = self.run_all("time")
        self.assertIsInstance(shown[1], aeolic.Picture)
        self.assertEqual(shown[2], (3 * 480, 900, 3))
        pictures = list(names["pictures"].values())
        self.assertTrue((pictures[0] != pictures[1]).any())
        self.assertAlmostEqual(names["t"], 5.0)

    def test_plane(self):
        shown, names = self.run_all("plane")
        self.assertEqual(shown[0][0], (400, 400))
        self.assertEqual(shown[2], (True, True))
        self.assertEqual(shown[3][0], (100, 400))
        self.assertAlmostEqual(shown[3][1], 4)
        self.assertTrue(0.5 < shown[4] < 2, shown[4])

    def test_all_are_run(self):
        self.assertEqual(sorted(path.stem for path in FOLDER.glob("*.ipynb")), ["body", "plane", "time"])
