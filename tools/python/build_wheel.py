"""Builds the wheel: `make` builds the library, cffi writes the module's C, the compiler makes it.

    python3 build_wheel.py DIRECTORY

prints the wheel's path. pip calls the functions of PEP 517 below. All that is needed is cffi, a C
compiler, make and Python's headers; a wheel is a zip file with a list of its files (PEP 427). The
module keeps to Python's stable interface, so one wheel is for every CPython from 3.9 on.

GNOMON_BUILD names make's build directory; without it, it is `build` in the root of the project.
"""

from __future__ import annotations

import base64
import hashlib
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Dict, List, Optional

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PACKAGE = HERE / "src/gnomon"
INTERFACE = "cp39-abi3"
FLAGS = ["-std=c11", "-O3", "-fno-math-errno", "-fPIC", "-pthread", "-D_POSIX_C_SOURCE=200809L"]
FLAGS += ["-ffp-contract=off", "-fno-fast-math"]
# A zip file holds times. With one for all files, equal files make equal wheels.
TIME = (1980, 1, 1, 0, 0, 0)

METADATA = """\
Metadata-Version: 2.1
Name: gnomon
Version: {version}
Summary: Software rendering to numpy arrays, with the same pixels on every machine
License: MIT
Requires-Python: >=3.9
Requires-Dist: cffi>=1.15
Requires-Dist: numpy>=1.21
Provides-Extra: images
Requires-Dist: Pillow>=8.1; extra == "images"
Classifier: Programming Language :: C
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Multimedia :: Graphics :: 3D Rendering
Classifier: Typing :: Typed
Description-Content-Type: text/markdown

{readme}"""

WHEEL = """\
Wheel-Version: 1.0
Generator: gnomon
Root-Is-Purelib: false
Tag: {tag}
"""


def _version() -> str:
    """Returns the library's version."""
    header = (ROOT / "include/gnomon/version.h").read_text()
    parts = (re.search(rf"GN_VERSION_{part} (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    return ".".join(part.group(1) for part in parts if part)


def _tag() -> str:
    return f"{INTERFACE}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def _information() -> Dict[str, bytes]:
    """Returns the files of the wheel's folder .dist-info, apart from the list of all files."""
    metadata = METADATA.format(version=_version(), readme=(HERE / "README.md").read_text("utf-8"))
    texts = {"METADATA": metadata, "WHEEL": WHEEL.format(tag=_tag())}
    files = {name: text.encode() for name, text in texts.items()}
    files["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    return files


def _run(command: List[str]) -> None:
    done = subprocess.run(command, check=False, cwd=ROOT)
    if done.returncode:
        raise SystemExit(f"build_wheel.py: failed: {shlex.join(command)}")


def _check_python() -> None:
    """Ends with words if this Python cannot build the module."""
    if sys.implementation.name != "cpython" or sysconfig.get_config_var("Py_GIL_DISABLED"):
        raise SystemExit("build_wheel.py: the module needs CPython with its stable interface")
    header = Path(sysconfig.get_path("include"), "Python.h")
    if not header.exists():
        raise SystemExit(f"build_wheel.py: {header} is missing; Debian has it in python3-dev")
    try:
        import cffi  # noqa: F401
    except ImportError:
        words = f"{sys.executable} has no cffi; install it, or name another: make wheel PYTHON=..."
        raise SystemExit(f"build_wheel.py: {words}") from None


def _make(build: Path, jobs: int) -> None:
    """Builds the library and the contract's program. make prints each file that it compiles."""
    environment = {**os.environ, "MAKEFLAGS": ""}
    command = ["make", f"-j{jobs}", "-C", str(ROOT), f"BUILD={build}", "python-parts"]
    if subprocess.run(command, check=False, env=environment).returncode:
        raise SystemExit("build_wheel.py: make python-parts failed")


def _module(build: Path, jobs: int) -> Path:
    """Returns the compiled module. Prints each file that is compiled, as make does."""
    sys.path.insert(0, str(HERE))
    import build_native

    work = build / "python/module"
    work.mkdir(parents=True, exist_ok=True)
    written = work / "_native.c"
    build_native.ffibuilder.emit_c_code(str(written))
    sources = [written, *build_native.SOURCES]
    compiler = shlex.split(os.environ.get("CC", "cc"))
    includes = [*build_native.INCLUDED, Path(sysconfig.get_path("include"))]
    flags = [*FLAGS, *(f"-I{directory}" for directory in includes)]

    def compile_one(source: Path) -> str:
        result = str(work / f"{source.stem}.o")
        print(f"  CC {source.name}", flush=True)
        _run([*compiler, *flags, "-c", str(source), "-o", result])
        return result

    with ThreadPoolExecutor(jobs) as pool:
        objects = list(pool.map(compile_one, sources))
    module = work / "_native.abi3.so"
    library = next((build / "python").glob("libgnomon.so.*"))
    linked = [f"-L{library.parent}", f"-l:{library.name}", "-Wl,-rpath,$ORIGIN"]
    print(f"  LD {module.name}", flush=True)
    _run([*compiler, "-shared", "-pthread", "-s", "-o", str(module), *objects, *linked, "-lm"])
    return module


def _contents() -> Dict[str, Path]:
    """Builds what is compiled; returns all files of the package by their names in the wheel."""
    _check_python()
    build = Path(os.environ.get("GNOMON_BUILD") or ROOT / "build").resolve()
    jobs = len(os.sched_getaffinity(0))
    _make(build, jobs)
    module = _module(build, jobs)
    parts = build / "python"
    built = [module, *parts.glob("libgnomon.so.*"), parts / "contract-check", parts / "contract.txt"]
    sources = [file for kind in ("*.py", "*.pyi", "py.typed") for file in PACKAGE.glob(kind)]
    return {f"gnomon/{file.name}": file for file in sorted([*sources, *built])}


def _record(name: str, contents: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(contents).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(contents)}\n"


def build_wheel(
    wheel_directory: str,
    config_settings: Optional[Dict[str, Any]] = None,
    metadata_directory: Optional[str] = None,
) -> str:
    """Writes the wheel to a directory and returns its name. (PEP 517)"""
    files = {name: (file.read_bytes(), file.stat().st_mode) for name, file in _contents().items()}
    folder = f"gnomon-{_version()}.dist-info"
    for name, contents in _information().items():
        files[f"{folder}/{name}"] = contents, 0o644
    record = "".join(_record(name, contents) for name, (contents, _) in files.items())
    files[f"{folder}/RECORD"] = f"{record}{folder}/RECORD,,\n".encode(), 0o644
    wheel = f"gnomon-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(Path(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, (contents, mode) in files.items():
            entry = zipfile.ZipInfo(name, TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if mode & 0o100 else 0o100644) << 16
            archive.writestr(entry, contents)
    return wheel


def prepare_metadata_for_build_wheel(
    metadata_directory: str, config_settings: Optional[Dict[str, Any]] = None
) -> str:
    """Writes what pip asks for before it builds. (PEP 517)"""
    folder = Path(metadata_directory, f"gnomon-{_version()}.dist-info")
    folder.mkdir()
    for name, contents in _information().items():
        (folder / name).write_bytes(contents)
    return folder.name


def build_sdist(sdist_directory: str, config_settings: Optional[Dict[str, Any]] = None) -> str:
    """Refuses: the package is built from the library's sources, which are beside it. (PEP 517)"""
    raise SystemExit("build_wheel.py: the source archive is the library's: make dist")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit("usage: build_wheel.py DIRECTORY")
    Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    print(Path(sys.argv[1], build_wheel(sys.argv[1])))
