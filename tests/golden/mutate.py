#!/usr/bin/env python3
"""Changes one line of the project at a time and tells which golden noticed.

Usage: tests/golden/mutate.py [WORDS]            (only mutants with one of WORDS in their line)
       tests/golden/mutate.py --check [MUTANTS]  (only whether each of mutants.txt, or of that file, can be made)

Works on a copy in a temporary folder, without optimisation. Each line of mutants.txt is one mutant. Exit code 1 where one
of them passes all golden tests, does not compile, or cannot be made: its text must be in its file exactly once, or another
line than the one meant could be the one that is changed.
"""
import pathlib, shutil, subprocess, sys, tempfile, time

root = pathlib.Path(__file__).resolve().parents[2]


def problem_of(line):
    """Why this mutant cannot be made; empty where it can."""
    parts = line.split(" | ")
    if len(parts) != 4:
        return f"has {len(parts)} parts instead of 4, divided by ' | '"
    file, old, new, _ = (part.strip(" ") for part in parts)
    if not (root / file).is_file():
        return f"there is no file {file}"
    if not old or old == new:
        return "changes nothing"
    times = (root / file).read_text().count(old)
    return "" if times == 1 else f"'{old}' is {times} times in {file}, and must be there exactly once"


def mutants(listed):
    """All mutants of that file. Ends the program where one of them cannot be made."""
    lines = [(i, l) for i, l in enumerate(listed.read_text().splitlines(), 1) if l.strip() and not l.startswith("#")]
    problems = [f"{listed}:{i}: {problem_of(l)}: bring it up to date\n    {l}" for i, l in lines if problem_of(l)]
    if problems:
        sys.exit("\n".join(problems))
    return [tuple(part.strip(" ") for part in line.split(" | ")) for _, line in lines]


def run(command, folder):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def build(folder):
    return run(["cmake", "--build", "build", "--parallel", "2", "--target", "golden-tests"], folder).returncode == 0


def noticed(folder, patience):
    """The traces and the pictures that differ, by name; each test may take so many seconds."""
    says = {}
    for kind, test, marks in (("traces", "traces of all*", [": the traces part"]),
                              ("images", "images of*", ["-report: ", "-dark: ", "-slides: ", "-no-captions: "])):
        try:
            out = subprocess.run(["build/golden-tests", test], cwd=folder, capture_output=True, text=True, timeout=patience)
        except subprocess.TimeoutExpired:
            says[kind] = ["does not end"]
            continue
        names = [l.strip() for l in out.stdout.splitlines() if any(m in l for m in marks)]
        if out.returncode and not names:
            names = ["crashes"]
        says[kind] = [n.split(": ")[0] for n in names]
    return says


def try_out(file, old, new, wrong, folder, patience):
    """Whether a golden noticed that mutant; prints which."""
    path = folder / file
    sound = path.read_text()
    path.write_text(sound.replace(old, new))
    verdict = ""
    if build(folder):
        says = noticed(folder, patience)
        verdict = "; ".join(f"{len(found)} {kind}, first {found[0]}" for kind, found in says.items() if found)
    else:
        wrong += " (does not compile)"
    print(f"{'noticed' if verdict else 'SURVIVED'}  {file}: {wrong}\n    {verdict}", flush=True)
    path.write_text(sound)
    return bool(verdict)


def copy_to(folder):
    for part in ("core", "render", "walkthroughs", "tests"):
        shutil.copytree(root / part, folder / part)
    for part in ("CMakeLists.txt", "README.md"):
        shutil.copy(root / part, folder / part)
    ccache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    run(["cmake", "-S", ".", "-B", "build", "-DGJKSTEP_TESTS=ON", "-DCMAKE_BUILD_TYPE=None"] + ccache, folder)


def main():
    words = sys.argv[1:] or [""]
    listed = root / "tests/golden/mutants.txt"
    if words[0] == "--check":
        return print(len(mutants(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else listed)), "mutants can be made")
    chosen = [mutant for mutant in mutants(listed) if any(word in " | ".join(mutant) for word in words)]
    if not chosen:
        sys.exit(f"no mutant has {' or '.join(words)} in its line")
    with tempfile.TemporaryDirectory(prefix="gjkstep-mutants-") as name:
        folder = pathlib.Path(name)
        copy_to(folder)
        built, start = build(folder), time.monotonic()
        if not built or any(noticed(folder, 1800).values()):
            sys.exit("without any change the golden tests do not pass: nothing can be said of mutants")
        patience = 60 + 10 * (time.monotonic() - start)  # a mutant that ends must not be taken for one that does not
        survivors = sum(not try_out(*mutant, folder, patience) for mutant in chosen)
    print(f"{survivors} survived")
    sys.exit(1 if survivors else 0)


main()
