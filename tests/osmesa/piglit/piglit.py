#!/usr/bin/env python3
"""Runs piglit's tests of OpenGL 1 with the reference's libOSMesa and with this project's.

usage: piglit.py BUILD [--only REGEX] [--again] [--jobs N]

The programs are those of Debian's package piglit. waffle.c beside this file takes the place of
libwaffle, so that they draw in OSMesa's windows. The tests are those of piglit's own list whose
names match TESTS.

Of the tests of extensions, those that this library skips are left out: they need a shading language
or a later version of OpenGL.

Prints each test that passes with the reference alone, with the reason that differing.txt has; for
a test that passes with both, how many pixels of its window differ at the end, if any do; and last
"N passed, N failed". A test fails if it passes with the reference, not with this library, and
differing.txt does not name it; or if differing.txt names it and it passes.

What the reference did is kept in BUILD/osmesa-piglit and used again; --again runs it anew.
"""
import argparse
import ast
import collections
import concurrent.futures
import gzip
import json
import os
import re
import signal
import subprocess
import sys
import xml.etree.ElementTree

PIGLIT = "/usr/lib/x86_64-linux-gnu/piglit"
HERE = os.path.dirname(os.path.abspath(__file__))
SECONDS = 60  # of one test; the longest that ends takes half of it on a machine that does nothing else

# OpenGL 1.0 to 1.5, and the extensions of which the library has the functions.
TESTS = re.compile(
    r"(hiz|object namespace pollution|spec@(!opengl 1\.[0-5]|arb_(clip_control|depth_buffer_float|depth_texture|framebuffer_object|framebuffer_srgb"
    r"|half_float_pixel|multisample|multitexture|occlusion_query|pixel_buffer_object|point_parameters"
    r"|seamless_cube_map|shadow|texture_(border_clamp|cube_map|env_combine|env_crossbar|non_power_of_two)"
    r"|vertex_buffer_object|window_pos)|ati_texture_env_combine3|ext_(fog_coord|framebuffer_blit"
    r"|framebuffer_multisample|framebuffer_object|packed_depth_stencil|secondary_color|stencil_wrap|texture_env_combine"
    r"|texture_lod_bias|texture_srgb)|khr_debug|nv_texture_env_combine4|sgis_generate_mipmap))@")

# Windows of OSMesa have no samples; the programs of others fill all memory, or end after minutes only.
LEFT_OUT = re.compile(r"samples=|max-texture-size$|tex3d-maxsize$|streaming-texture-leak$|windowoverlap$")


def read_tests(only):
    """Returns the names of the tests and their commands."""
    tests = {}
    for test in xml.etree.ElementTree.parse(gzip.open(f"{PIGLIT}/tests/opengl.xml.gz")).iter("Test"):
        name = test.get("name")
        options = {option.get("name"): option.get("value") for option in test.iter("option")}
        if TESTS.match(name) and not LEFT_OUT.search(name) and "command" in options and re.search(only, name):
            tests[name] = ast.literal_eval(options["command"])
    return tests


def run_test(runner, build, folder, name, command):
    """Runs a test by a function of reference.sh. Returns its result: what the program says of itself, "crash",
    "timeout" or "none"."""
    environment = dict(os.environ, PIGLIT_PLATFORM="gbm", LD_PRELOAD=os.path.abspath(f"{folder}/waffle.so"),
                       PICTURE=picture_of(folder, runner, name))
    script = 'library=$1; runner=$2; shift 2; . tests/osmesa/reference.sh; "$runner" "$@"'
    program = ["sh", "-c", script, "sh", f"{build}/osmesa", runner, f"{PIGLIT}/bin/{command[0]}"] + command[1:]
    # A session of its own, so that a test that takes too long is ended together with its shell.
    with subprocess.Popen(program + ["-auto"], env=environment, text=True, errors="replace", stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True) as process:
        try:
            said, _ = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return "timeout"
    results = re.findall(r'PIGLIT: \{"result": "(\w+)"', said)
    return "crash" if process.returncode > 128 else results[-1] if results else "none"


def picture_of(folder, runner, name):
    return os.path.abspath(os.path.join(folder, runner, re.sub(r"[^A-Za-z0-9_.-]", "_", name)))


def run_tests(runner, build, folder, tests, jobs):
    os.makedirs(os.path.join(folder, runner), exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(jobs) as executor:
        results = executor.map(lambda test: run_test(runner, build, folder, *test), tests.items())
        return dict(zip(tests, results))


def reference_results(build, folder, tests, jobs, again):
    """Returns the reference's results, of which those of earlier runs are kept in a file."""
    kept = os.path.join(folder, "reference.json")
    results = {}
    if os.path.exists(kept) and not again:
        with open(kept, encoding="utf-8") as file:
            results = json.load(file)
    results.update(run_tests("reference", build, folder, {n: c for n, c in tests.items() if n not in results}, jobs))
    with open(kept, "w", encoding="utf-8") as file:
        json.dump(results, file, indent=0)
    return results


def read_differing(tests):
    """Returns the reason of each test that is known to pass with the reference alone."""
    reasons = {}
    with open(os.path.join(HERE, "differing.txt"), encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                names, reason = line.rstrip("\n").split(": ", 1)
                reasons.update({name: reason for name in tests if re.fullmatch(names, name.partition("@")[2])})
    return reasons


def differing_pixels(folder, name):
    """Returns how many pixels of the windows differ, and how many there are."""
    pictures = []
    for runner in ("reference", "ours"):
        try:
            with open(picture_of(folder, runner, name), "rb") as file:
                pictures.append(file.read().partition(b"ENDHDR\n")[2])
        except OSError:
            return 0, 0
    theirs, ours = pictures
    count = min(len(theirs), len(ours)) // 4
    return sum(theirs[4 * i:4 * i + 4] != ours[4 * i:4 * i + 4] for i in range(count)), count


def main():
    parser = argparse.ArgumentParser(usage="piglit.py BUILD [--only REGEX] [--again] [--jobs N]")
    parser.add_argument("build")
    parser.add_argument("--only", default="")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    if not os.path.exists(PIGLIT) or not os.path.exists("/usr/include/waffle-1/waffle.h"):
        print("piglit: needs Debian's packages piglit and libwaffle-dev: 'make setup-piglit' installs them")
        sys.exit(2)
    folder = os.path.join(options.build, "osmesa-piglit")
    os.makedirs(folder, exist_ok=True)
    subprocess.run(["cc", "-shared", "-fPIC", "-Itools/osmesa", f"{HERE}/waffle.c", "-o", f"{folder}/waffle.so",
                    "-Wl,-soname,libwaffle-1.so.0", "-ldl"], check=True)

    tests = read_tests(options.only)
    ours = run_tests("ours", options.build, folder, tests, options.jobs)
    tests = {name: tests[name] for name in tests if ours[name] != "skip" or "!opengl" in name}
    theirs = reference_results(options.build, folder, tests, options.jobs, options.again)
    differing = read_differing(tests)
    failed = []
    equal_windows = windows = 0
    print(f"{'reference':10} {'ours':8} test")
    for name in tests:
        passes = [results[name] == "pass" for results in (theirs, ours)]
        if passes[0] != passes[1] and passes[0]:
            print(f"{theirs[name]:10} {ours[name]:8} {name}: {differing.get(name, 'not known')}")
        if passes[0] and passes[1] == (name in differing):
            failed.append(name)
        if passes[0] and passes[1]:
            pixels, count = differing_pixels(folder, name)
            windows += count > 0
            equal_windows += count > 0 and pixels == 0
            if pixels:
                print(f"{'pass':10} {'pass':8} {name}: {pixels} of {count} pixels differ at the end")
    for name in failed:
        print(f"FAILED: {name}: {'differing.txt names it, but it passes' if name in differing else ours[name]}")
    for runner, results in (("reference", theirs), ("ours", ours)):
        counts = collections.Counter(results[name] for name in tests)
        print(f"{runner}: " + ", ".join(f"{count} {result}" for result, count in counts.most_common()))
    print(f"windows of tests that pass with both: {equal_windows} of {windows} have equal pixels")
    passing = [name for name in tests if theirs[name] == "pass"]
    known = [name for name in passing if name in differing and name not in failed]
    print(f"known to pass with the reference alone: {len(known)}")
    print(f"piglit: {len(passing) - len(known) - len(failed)} passed, {len(failed)} failed")
    sys.exit(bool(failed))


main()
