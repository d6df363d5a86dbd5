"""Builds the extension module with CMake, in build/release of the repository, and makes the wheel of it.

There scripts/run builds the program: what is built already is taken as it is. The environment variable PLANISH_BUILD
names another folder to build in.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

REPO = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(os.environ.get("PLANISH_BUILD", REPO / "build/release"))


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        configure = ["cmake", "-S", str(REPO), "-B", str(BUILD), "-DCMAKE_BUILD_TYPE=Release", "-DPLANISH_BUILD_PYTHON=ON"]
        if shutil.which("ninja") and not (BUILD / "CMakeCache.txt").exists():
            configure += ["-G", "Ninja"]
        subprocess.run([*configure, f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", str(BUILD), "-j", jobs, "--target", "planish_python"], check=True)
        built = BUILD / "python" / pathlib.Path(*ext.name.split(".")).parent
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built / target.name, target)


def version():
    return re.search(r"project\([^)]*VERSION ([\d.]+)", (REPO / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


(REPO / "build/wheel").mkdir(parents=True, exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("planish._core", [])],
    cmdclass={"build_ext": BuildWithCMake},
    options={
        "build": {"build_base": str(REPO / "build/wheel")},
        "egg_info": {"egg_base": str(REPO / "build/wheel")},
    },
)
