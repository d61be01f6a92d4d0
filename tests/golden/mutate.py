#!/usr/bin/env python3
"""Changes one line of the project at a time and tells which golden noticed.

Usage: tests/golden/mutate.py [WORD]   (only mutants with WORD in their line)

Works on a copy in a temporary folder, without optimisation. Each line of mutants.txt is one mutant. Exit code 1 where one
of them passes all golden tests, or does not compile.
"""
import pathlib, shutil, subprocess, sys, tempfile, time

root = pathlib.Path(__file__).resolve().parents[2]


def mutants(word):
    for line in (root / "tests/golden/mutants.txt").read_text().splitlines():
        if line.strip() and not line.startswith("#") and word in line:
            file, old, new, wrong = (part.strip(" ") for part in line.split(" | "))
            yield file, old, new, wrong


def run(command, folder):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def build(folder):
    return run(["cmake", "--build", "build", "--parallel", "2", "--target", "golden-tests"], folder).returncode == 0


def noticed(folder):
    """The traces and the pictures that differ, by name."""
    says = {}
    for kind, test, marks in (("traces", "traces of all*", [": the traces part"]),
                              ("images", "images of*", ["-report: ", "-dark: ", "-slides: ", "-no-captions: "])):
        try:
            out = subprocess.run(["build/golden-tests", test], cwd=folder, capture_output=True, text=True, timeout=120)
        except subprocess.TimeoutExpired:
            says[kind] = ["does not end"]
            continue
        names = [l.strip() for l in out.stdout.splitlines() if any(m in l for m in marks)]
        if out.returncode and not names:
            names = ["crashes"]
        says[kind] = [n.split(": ")[0] for n in names]
    return says


def main():
    word = sys.argv[1] if len(sys.argv) > 1 else ""
    with tempfile.TemporaryDirectory(prefix="gjkstep-mutants-") as name:
        folder = pathlib.Path(name)
        for part in ("core", "render", "walkthroughs", "tests"):
            shutil.copytree(root / part, folder / part)
        for part in ("CMakeLists.txt", "README.md"):
            shutil.copy(root / part, folder / part)
        ccache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        run(["cmake", "-S", ".", "-B", "build", "-DGJKSTEP_TESTS=ON", "-DCMAKE_BUILD_TYPE=None"] + ccache, folder)
        if not build(folder) or any(noticed(folder).values()):
            sys.exit("without any change the golden tests do not pass: nothing can be said of mutants")
        survivors = 0
        for file, old, new, wrong in mutants(word):
            path = folder / file
            sound = path.read_text()
            if old not in sound:
                sys.exit(f"{file} has no '{old}': bring mutants.txt up to date")
            path.write_text(sound.replace(old, new, 1))
            if build(folder):
                says = noticed(folder)
                verdict = "; ".join(f"{len(found)} {kind}, first {found[0]}" for kind, found in says.items() if found)
            else:
                verdict = ""
                wrong += " (does not compile)"
            survivors += not verdict
            print(f"{'noticed' if verdict else 'SURVIVED'}  {file}: {wrong}\n    {verdict}", flush=True)
            path.write_text(sound)
        print(f"{survivors} survived")
        sys.exit(1 if survivors else 0)


main()
