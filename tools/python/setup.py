"""Builds the wheel: `make` builds the library and the contract's program, cffi the module."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))


def version() -> str:
    """Returns the library's version."""
    header = (ROOT / "include/gnomon/version.h").read_text()
    parts = (re.search(rf"GN_VERSION_{part} (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    return ".".join(part.group(1) for part in parts if part)


class BuildExtension(build_ext):
    """Builds the library first, and puts its files beside the module."""

    def run(self) -> None:
        # GNOMON_BUILD names a directory of make, whose compiled objects are used. It is an absolute
        # path, since the working directory is the one of this file.
        given = os.environ.get("GNOMON_BUILD")
        build = Path(given or Path(self.build_temp) / "library").resolve()
        jobs = os.cpu_count() or 1
        make = ["make", "-s", f"-j{jobs}", "-C", str(ROOT), f"BUILD={build}", "python-parts"]
        subprocess.run(make, check=True, env={**os.environ, "MAKEFLAGS": ""})
        package = (HERE / "src" if self.inplace else Path(self.build_lib).resolve()) / "gnomon"
        package.mkdir(parents=True, exist_ok=True)
        libraries = list((build / "python").glob("libgnomon.so.*"))
        for file in [*libraries, build / "python/contract-check", build / "python/contract.txt"]:
            shutil.copy2(file, package)
        for extension in self.extensions:
            extension.library_dirs += [str(build / "python")]
            extension.extra_link_args += [f"-l:{libraries[0].name}", "-Wl,-rpath,$ORIGIN"]
        super().run()


class BuildModules(build_py):
    """Builds the extension first, so that the library's files are there when data is listed."""

    def run(self) -> None:
        self.run_command("build_ext")
        super().run()


class BinaryDistribution(Distribution):
    """A wheel that holds programs is for one platform."""

    def has_ext_modules(self) -> bool:
        return True


setup(
    version=version(),
    distclass=BinaryDistribution,
    cmdclass={"build_ext": BuildExtension, "build_py": BuildModules},
    cffi_modules=["build_native.py:ffibuilder"],
)
