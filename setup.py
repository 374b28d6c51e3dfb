"""Makes a wheel of the Python module: CMake builds the library and the module, and the wheel holds both. The libraries
that they are built from stay those of the system. AEOLIC_BUILD_DIR names a build folder that is already there, where one
is; CMAKE_ARGS are given to CMake else."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parent
WORK = ROOT / "build" / "wheel"


def run(*words):
    subprocess.run([str(word) for word in words], check=True)


class Build(build_py):
    def run(self):
        build = pathlib.Path(os.environ.get("AEOLIC_BUILD_DIR") or WORK / "cmake").resolve()
        if "AEOLIC_BUILD_DIR" not in os.environ:
            run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DAEOLIC_TESTS=OFF",
                "-DAEOLIC_PYTHON=ON", f"-DAEOLIC_PYTHON_PROGRAM={sys.executable}",
                *shlex.split(os.environ.get("CMAKE_ARGS", "")))
            run("cmake", "--build", build, "--target", "aeolic_python", "aeolic_stub", "aeolic_reader")
        package = pathlib.Path(self.build_lib) / "aeolic"
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(build / "python" / "aeolic", package, ignore=shutil.ignore_patterns("__pycache__"))
        # The module looks for the library beside itself first, and the library for the program that reads files.
        library = next(path for path in build.glob("libaeolic.so.*.*") if not re.search(r"\d+\.\d+\.\d+$", path.name))
        shutil.copyfile(library.resolve(), package / library.name)
        readers = package / "libexec" / "aeolic"  # The program, and its modules.
        readers.mkdir(parents=True)
        for name in ("aeolic-reader", "aeolic-reader-hdf5.so", "aeolic-reader-vtk.so"):
            shutil.copy(build / "libexec" / "aeolic" / name, readers / name)


class Binary(Distribution):
    """What is built is for one kind of machine and one Python."""

    def has_ext_modules(self):
        return True


version = re.search(r"project\(Aeolic VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
WORK.mkdir(parents=True, exist_ok=True)
setup(version=version, packages=["aeolic"], package_dir={"": "python"}, cmdclass={"build_py": Build}, distclass=Binary,
      options={"build": {"build_base": str(WORK)}, "egg_info": {"egg_base": str(WORK)}})
