"""The manual pages and completions that the build makes of the options: manual_test.py PROGRAM FOLDER."""
import os
import re
import shutil
import subprocess
import sys
import unittest

PROGRAM, FOLDER = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
COMMANDS = ["render", "extract", "probe", "info", "serve", "grab"]


def read(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return file.read()


def options_of(command):
    """Those that the help shows at the beginning of its lines."""
    text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
    return {name for line in text.splitlines() if re.match(r"  -", line) for name in re.findall(r"--[a-z][a-z-]*", line[:34])}


def completed(*words):
    """What bash offers for the last of these words."""
    script = ('compopt() { echo "($2)"; }; complete() { :; }; source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
              '_aeolic; printf "%s\\n" "${COMPREPLY[@]}"')
    out = subprocess.run(["bash", "-c", script, "bash", os.path.join(FOLDER, "aeolic.bash"), "aeolic", *words], capture_output=True,
                         text=True, check=True)
    assert not out.stderr, out.stderr
    return [line for line in out.stdout.splitlines() if line]


class Pages(unittest.TestCase):
    def test_every_option_stands_on_its_page(self):
        for command in COMMANDS:
            page = read("aeolic-%s.1" % command).replace("\\-", "-")
            shown = set(re.findall(r"\\fB(--[a-z-]+)\\fR", page))
            self.assertGreater(len(options_of(command)), 0)
            self.assertEqual(options_of(command), shown)

    def test_what_is_required_and_what_holds_without_an_option(self):
        grab = read("aeolic-grab.1").replace("\\-", "-")
        self.assertIn("\n\\fIADDRESS\\fR\n", grab)
        self.assertIn("[800x800]", grab)
        self.assertIn("\n[\\fISCENE.json\\fR]\n", read("aeolic-render.1"))
        self.assertIn("[8080]", read("aeolic-serve.1"))

    def test_the_programs_page_names_all_commands(self):
        page = read("aeolic.1").replace("\\-", "-")
        for command in COMMANDS:
            self.assertIn("\\fBaeolic-%s\\fR(1)" % command, page)
        self.assertNotIn("render-job", page)

    def test_man_shows_them_without_a_warning(self):
        if not shutil.which("man"):
            self.skipTest("no man (Debian: apt-get install man-db)")
        for name in ["aeolic"] + ["aeolic-" + command for command in COMMANDS]:
            said = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", os.path.join(FOLDER, name + ".1")],
                                  env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "100"}, capture_output=True, text=True)
            self.assertEqual((said.returncode, said.stderr), (0, ""), name)


class Bash(unittest.TestCase):
    def test_commands(self):
        self.assertEqual(completed("gr"), ["grab"])
        self.assertEqual(sorted(c for c in completed("") if not c.startswith("-")), sorted(COMMANDS))

    def test_options(self):
        self.assertEqual(completed("render", "--inte"), ["--integrator"])
        for command in COMMANDS:
            self.assertTrue(options_of(command) <= set(completed(command, "--")), command)
        self.assertEqual(completed("grab", "--surf"), [], "another command's")

    def test_values(self):
        self.assertEqual(completed("render", "--integrator", ""), ["euler", "rk2", "rk4"])
        self.assertEqual(completed("render", "--integrator", "r"), ["rk2", "rk4"])
        self.assertEqual(completed("serve", "--occlusion", ""), ["on", "off"])
        self.assertEqual(completed("render", "--color-scale", ""), ["linear", "log"])
        self.assertEqual(completed("render", "--steps", ""), [], "a number")

    def test_names_beside_files(self):
        found = completed("render", "--colormap", "v")
        self.assertEqual(found, ["(default)", "viridis", "vik"])
        self.assertEqual(completed("render", "--colormap", "Rd"), ["(default)", "RdBu"])

    def test_items_of_the_camera(self):
        self.assertEqual(completed("render", "--camera", "z"), ["(nospace)", "zoom="])
        self.assertIn("azimuth=", completed("serve", "--camera", ""))
        self.assertEqual(completed("render", "--size", ""), [], "no items")

    def test_files(self):
        for words in (["--surface", "t"], ["-o", ""], ["--output", "x"], ["scene"]):
            self.assertIn("(default)", completed("render", *words), words)


class Zsh(unittest.TestCase):
    def test_every_option_is_there(self):
        text = read("_aeolic")
        for command in COMMANDS:
            part = text[text.index("        %s)\n" % command):]
            part = part[:part.index(";;")]
            self.assertEqual(options_of(command), set(re.findall(r"'(--[a-z-]+)\[", part)))

    def test_zsh_reads_it(self):
        if not shutil.which("zsh"):
            self.skipTest("no zsh")
        said = subprocess.run(["zsh", "-n", os.path.join(FOLDER, "_aeolic")], capture_output=True, text=True)
        self.assertEqual((said.returncode, said.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + ["-v"])
