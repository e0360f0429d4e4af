"""Times programs of OSMesa's with this project's libOSMesa and with the reference's, in turns: MuJoCo's
sample program record (its start, and a frame of 800 by 800 pixels with shadows and four samples), and 5,000
small draws. Both draw in one thread. The reference's llvmpipe is not pinned: it uses the processor's own
vectors, and keeps its compiled shaders in a cache. Prints the least of the times and their ratios.
usage: bench.py BUILD RUNS    (from the root of the project; BUILD has osmesa)"""

import glob
import os
import subprocess
import sys
import tempfile
import time

SAMPLE = "/usr/share/doc/libmujoco-samples/examples/record.cc"
MODEL = "/usr/share/mujoco/model/humanoid/humanoid.xml"
FRAMES = 30


def reference(command):
    """The command with the loader and the libraries of the reference, and its environment."""
    root = os.environ.get("MESA", os.path.join(build, "mesa"))
    libraries = (glob.glob(root + "/usr/lib/*-linux-gnu") + [""])[0]
    loader = (glob.glob(root + "/usr/lib/*-linux-gnu/ld-linux*.so.*") + [""])[0]
    if loader:
        path = "%s:/usr/lib/%s" % (libraries, os.path.basename(libraries))
        command = [loader, "--library-path", path] + command
    return command, {"GALLIUM_DRIVER": "llvmpipe", "LP_NUM_THREADS": "0"}


def ours(command):
    return command, {"LD_LIBRARY_PATH": os.path.realpath(build + "/osmesa")}


def run(how, command):
    """Returns what the command prints, and its seconds. record returns 1 in the end."""
    command, environment = how(command)
    began = time.monotonic()
    done = subprocess.run(command, env=dict(os.environ, **environment), capture_output=True, text=True)
    return done.stdout, time.monotonic() - began


def record(how, frames):
    printed, seconds = run(how, [work + "/record", MODEL, str((frames - 0.5) / 60), "60", work + "/rgb"])
    if "." not in printed:
        sys.exit("bench-osmesa: record draws nothing: " + printed)
    return seconds


def draws(how):
    printed, _ = run(how, [work + "/draws", "5"])
    return float(printed) / 1000


def measure(how, had):
    one = record(how, 1) if had else None
    many = record(how, 1 + FRAMES) if had else None
    return {"MuJoCo's start and first frame": one, "a frame of MuJoCo's": had and (many - one) / FRAMES,
            "5,000 draws of 12 triangles": draws(how)}


def compile_with(*command):
    library = os.path.realpath(build + "/osmesa")
    subprocess.run([*command, "-L" + library, "-l:libOSMesa.so.8"], check=True)


build, runs = sys.argv[1], int(sys.argv[2])
with tempfile.TemporaryDirectory() as work:
    compile_with("cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O1", "-Itools/osmesa",
                 "tools/bench/osmesa/draws.c", "-o", work + "/draws")
    has_mujoco = os.path.exists(SAMPLE) and os.path.exists("/usr/include/mujoco/mujoco.h")
    if has_mujoco:
        compile_with("g++", "-O1", "-DMJ_OSMESA", "-Itools/osmesa", SAMPLE, "-o", work + "/record", "-lmujoco")
    else:
        print("MuJoCo is not timed: 'make setup-verify' installs libmujoco-dev and libmujoco-samples")
    least = {}
    for turn in range(runs):
        for how in (ours, reference):
            for what, seconds in measure(how, has_mujoco).items():
                if seconds is not None:
                    key = what, how
                    least[key] = min(seconds, least.get(key, seconds))
        print("bench-osmesa: run %d of %d" % (turn + 1, runs), file=sys.stderr)
    print("%-32s %12s %12s %8s" % ("", "Gnomon", "llvmpipe", "ratio"))
    for what in dict.fromkeys(key[0] for key in least):
        mine, theirs = least[what, ours], least[what, reference]
        print("%-32s %9.1f ms %9.1f ms %8.2f" % (what, mine * 1e3, theirs * 1e3, theirs / mine))
