"""It compiles on the other Debian, but for the study, and unit tests and transcripts pass there: 13 where this is 12, 12 where this is 13.

    GJKSTEP_OTHER_DEBIAN=1 python3 other_debian.py        # ten minutes and the network
    GJKSTEP_OTHER_DEBIAN=live python3 other_debian.py     # and the program in pages, by its Clang: five more

Says "skipped: " and why where that cannot be.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import root as roots

top = pathlib.Path(__file__).resolve().parents[2]


def program_packages(release):
    setup = (top / "walkthroughs/setup.sh").read_text()
    names = re.search(r'^program_packages="(.*?)"', setup, re.MULTILINE | re.DOTALL)[1]
    return names.replace("\\", " ").replace("$llvm", "16" if release == "bookworm" else "19").split()


def copy_project(folder):
    """What is committed, and what is not yet."""
    files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=top, check=True,
                           stdout=subprocess.PIPE, text=True).stdout
    for file in filter(lambda name: (top / name).is_file(), files.split("\0")):
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(top / file, folder / file)


def why_not():
    if os.environ.get("GJKSTEP_OTHER_DEBIAN", "0") not in ("1", "live"):
        return "takes ten minutes and the network; GJKSTEP_OTHER_DEBIAN=1 asks for it"
    return roots.why_not()


def main():
    if reason := why_not():
        return print(f"skipped: {reason}")
    with tempfile.TemporaryDirectory(prefix="gjkstep-debian-") as folder:
        live = "ON" if os.environ["GJKSTEP_OTHER_DEBIAN"] == "live" else "OFF"
        release = roots.other_release()
        root = roots.make(pathlib.Path(folder), release,
                          [*program_packages(release), "nodejs", "catch2", "python3", "python3-jsonschema"])
        copy_project(root / "project")
        for what, commands in (
                # -O1: it is asked whether it compiles and answers the same, not how soon.
                ("configured", f"cmake -S . -B build -G Ninja -DGJKSTEP_TESTS=ON -DGJKSTEP_LIVE={live} "
                               "-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1"),
                ("compiled", "cmake --build build --target quick-tests"),
                ("tested", "ctest --test-dir build --output-on-failure --parallel 2 --label-exclude 'full|long'")):
            code, said, seconds = roots.shell(root, commands, "/project")
            print(f"{what}: {seconds:.0f} s", flush=True)
            if code != 0:
                sys.exit(f"{what} ended with {code}:\n{said[-20000:]}")
        print(said[said.rfind("\n\n"):])


main()
