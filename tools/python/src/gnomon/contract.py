"""The contract: the pixels of this machine compared with the reference's."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .arrays import integer

_HERE = Path(__file__).resolve().parent


@dataclass(frozen=True)
class Contract:
    """What `contract` found. `digest` identifies the contract: the hash of its file."""

    scenes: int
    classes: int
    differing: int
    backends: str
    digest: str

    def __bool__(self) -> bool:
        return self.differing == 0


def contract(every: int = 10) -> Contract:
    """Draws every `every`th scene of the contract and compares the pixels with the reference's.

    The contract lists hashes of 5,000 random scenes, which the reference rasterizer drew; it is
    the same file on every machine. The scenes are drawn by the very library that this package
    draws with. The result is true if all pixels are equal.
    """
    import hashlib

    every = integer(every, "every", 1, 2**31 - 1)
    file = _HERE / "contract.txt"
    done = subprocess.run(
        [str(_HERE / "contract-check"), "--every", str(every), str(file)],
        capture_output=True,
        text=True,
        check=False,
    )
    last = (done.stdout.strip().splitlines() or [""])[-1]
    found = re.match(
        r"contract: (\d+) scenes, (\d+) classes, \d+ equal, (\d+) differ \((.*)\)", last
    )
    if not found:
        raise OSError(f"contract-check failed: {done.stderr.strip() or last}")
    scenes, classes, differing = (int(found.group(i)) for i in (1, 2, 3))
    digest = hashlib.sha256(file.read_bytes()).hexdigest()
    return Contract(scenes, classes, differing, found.group(4), digest)
