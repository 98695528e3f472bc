# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the Python package by CMake, as everything else. See pyproject.toml and docs/python.md."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
OPTIONS = {
    "CMAKE_BUILD_TYPE": "Release",
    "TOILE_GUI": "OFF",
    "BUILD_TESTING": "OFF",
    "TOILE_PYTHON": "ON",
    "Python_EXECUTABLE": sys.executable,
}


def version() -> str:
    found = re.search(r"project\(Toile VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert found
    return found.group(1)


class BuildByCMake(build_ext):
    """TOILE_BUILD names a build folder to use; else there is one for wheels, build/wheel. What is
    given in CMAKE_ARGS is added."""

    def build_extension(self, extension: Extension) -> None:
        build = Path(os.environ.get("TOILE_BUILD", ROOT / "build" / "wheel"))
        options = [f"-D{name}={value}" for name, value in OPTIONS.items()]
        if "TOILE_BUILD" not in os.environ:
            more = os.environ.get("CMAKE_ARGS", "").split()
            configure = ["cmake", "-S", ROOT, "-B", build, "-GNinja", *options, *more]
            subprocess.run(configure, check=True)
        subprocess.run(["cmake", "--build", build, "--target", "toile_python"], check=True)
        built = next((build / "app" / "python" / "toile").glob("_core.*.so"))
        self.copy_file(str(built), self.get_ext_fullpath(extension.name))


setup(
    version=version(),
    packages=["toile"],
    package_dir={"toile": "app/python/toile"},
    package_data={"toile": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("toile._core", [])],
    cmdclass={"build_ext": BuildByCMake},
)
