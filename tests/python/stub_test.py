"""What the module says about itself: type stubs and help()."""
import ast
import inspect
import pathlib
import pydoc
import unittest

import aeolic
from aeolic import _options

STUB = ast.parse((pathlib.Path(aeolic.__file__).parent / "__init__.pyi").read_text())


def names_of(function):
    arguments = function.args
    several = [arguments.vararg] if arguments.vararg else []
    return [a.arg for a in arguments.args + several + arguments.kwonlyargs]


class Stub(unittest.TestCase):
    def test_names_are_those_of_the_module(self):
        stubbed = {node.name for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(stubbed, set(aeolic.__all__))

    def test_signatures_are_those_of_the_module(self):
        checked = 0
        for node in STUB.body:
            if isinstance(node, ast.FunctionDef):
                self.assertEqual(names_of(node), list(inspect.signature(getattr(aeolic, node.name)).parameters))
                checked += 1
            if not isinstance(node, ast.ClassDef):
                continue
            for member in node.body:
                if not isinstance(member, ast.FunctionDef):
                    continue
                found = inspect.getattr_static(getattr(aeolic, node.name), member.name)
                if inspect.isfunction(found):
                    self.assertEqual(names_of(member), list(inspect.signature(found).parameters), member.name)
                    checked += 1
        self.assertGreater(checked, 8)

    def test_members_are_those_of_the_classes(self):
        for node in STUB.body:
            if isinstance(node, ast.ClassDef) and node.name != "InputError":
                stubbed = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
                fields = {member.target.id for member in node.body if isinstance(member, ast.AnnAssign)}
                public = {name for name in vars(getattr(aeolic, node.name)) if not name.startswith("_")}
                self.assertEqual({name for name in stubbed if not name.startswith("_")} | fields & public, public, node.name)

    def test_help_names_every_option_with_its_range(self):
        text = pydoc.plain(pydoc.render_doc(aeolic))
        for name in _options.KEYWORDS:
            self.assertIn(f"{name}: ", text)
        for words in ("integration steps in each direction; from 1 to 65536 [128]", "world units", "Raises InputError"):
            self.assertIn(words, text)
        self.assertIn("save(self, path)", text)
        self.assertNotIn("_save", text)

    def test_everything_public_is_described(self):
        for name in aeolic.__all__:
            thing = getattr(aeolic, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing) and name != "InputError":
                for key, member in vars(thing).items():
                    if not key.startswith("_"):
                        self.assertTrue(inspect.getdoc(member), f"{name}.{key}")
