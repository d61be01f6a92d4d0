"""Runs tests/run.sh on the other Debian, with the packages named: on 13 where this is 12, on 12 where this is 13.

    python3 other_debian.py "cmake g++ PACKAGES..." --sanitized      # takes the network

Where that cannot be it says "skipped: " and why, and ends with 77.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import root as roots

top = pathlib.Path(__file__).resolve().parents[2]


def copy_project(folder):
    """What is committed, and what is not yet."""
    files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=top, check=True,
                           stdout=subprocess.PIPE, text=True).stdout
    for file in filter(lambda name: (top / name).is_file(), files.split("\0")):
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(top / file, folder / file)


def main(packages, *tier):
    if reason := roots.why_not():
        roots.skip(reason)
    with tempfile.TemporaryDirectory(prefix="gjkstep-debian-") as folder:
        root = roots.make(pathlib.Path(folder), roots.other_release(), packages.split())
        copy_project(root / "project")
        code, said, _ = roots.shell(root, " ".join(["tests/run.sh", *tier]), "/project")
        print(said[-20000:] if code else said[said.rfind("\n\n"):], flush=True)
        sys.exit(code)


main(*sys.argv[1:])
