#!/usr/bin/env python3
"""Judges libraries of Debian, and writes a table of how wrong they are and why.

    apt-get install libccd-dev libfcl-dev libbullet-dev
    tests/study/judged/judged.py build/gjkstep > tests/study/results/judged.md

Each is asked as its users ask it, see the file of its name beside this one. What works in floats is asked about pairs that were
rounded to floats. The right half of the table lets contact be either, and counts no answer that is within a millionth of right (of
floats: a thousandth).
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
COUNT = "400"
# What it is called, its file, what it is built with, in which numbers, and what else is in its environment.
PROGRAMS = [
    ("libccd, ccdGJKIntersect", "libccd", "ccd", "double", {}),
    ("FCL, distance", "fcl", "fcl", "double", {"FCL_WAY": "distance"}),
    ("FCL, collide with its own GJK", "fcl", "fcl", "double", {"FCL_WAY": "collide-indep"}),
    ("FCL, collide (portal refinement of libccd)", "fcl", "fcl", "double", {}),
    ("Bullet in doubles, btGjkPairDetector", "bullet", "bullet-float64", "double", {}),
    ("Bullet in floats, btGjkPairDetector", "bullet", "bullet", "float", {}),
]


def version_of(package):
    return subprocess.run(["pkg-config", "--modversion", package], check=True, capture_output=True, text=True).stdout.strip()


def built(gjkstep, file, package, folder):
    main = folder / "judge.cpp"
    main.write_text(subprocess.run([gjkstep, "judge", "--adapter", "cpp"], check=True, capture_output=True, text=True).stdout)
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", package], check=True, capture_output=True, text=True).stdout.split()
    program = folder / f"{file}-{package}"
    subprocess.run(["c++", "-std=c++17", "-O2", main, HERE / f"{file}.cpp", "-o", program, "-I/usr/include/eigen3", *flags, "-lccd"], check=True)
    return program


def judged(gjkstep, program, environment, *options):
    command = [gjkstep, "judge", "--json", "--count", COUNT, *options, "--", program]
    run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment})
    if run.returncode > 1:
        sys.exit(run.stderr)
    return json.loads(run.stdout)


def counts(found):
    everything = found["all"]
    none = sum(everything.get(key, 0) for key in ("not a number", "no answer", "ended", "too late"))
    return [f"{everything.get('wrong yes', 0):,}", f"{everything.get('wrong no', 0):,}", f"{none:,}"]


def row(gjkstep, name, file, package, numbers, environment, folder):
    program = built(gjkstep, file, package, folder)
    strict = judged(gjkstep, program, environment, "--numbers", numbers)
    tolerant = judged(gjkstep, program, environment, "--numbers", numbers, "--touching", "either", "--tolerance", "1e-3" if numbers == "float" else "1e-6")
    cause = next((each["cause"] for each in tolerant["causes"] or strict["causes"]), "no cause found")
    worst = next((f"{each['relative']:.2g}, {each['name']}" for each in tolerant["worst"]), "")
    return [f"{name} ({version_of(package)})", numbers, f"{strict['all']['pairs']:,}", *counts(strict), *counts(tolerant), worst, cause]


def main():
    gjkstep = str(pathlib.Path(sys.argv[1]).resolve())
    head = ["program", "numbers", "pairs", "wrong yes", "wrong no", "no answer", "… fairly: wrong yes", "wrong no", "no answer",
            "the worst of these, relative to its size", "probable cause"]
    print("# Libraries, judged\n\nMade by `tests/study/judged/judged.py build/gjkstep`, which says what each column means.\n")
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    with tempfile.TemporaryDirectory() as folder:
        for each in PROGRAMS:
            print("| " + " | ".join(row(gjkstep, *each, pathlib.Path(folder))) + " |", flush=True)


if __name__ == "__main__":
    main()
