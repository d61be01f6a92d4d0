#!/usr/bin/env python3
"""Changes one place of the project at a time, in ways that nobody chose (see made.py), and tells which test noticed.

    tests/mutants/mutate.py --made N [WORDS]   N mutants (20) of each folder; of files with one of WORDS alone
        --seed S        other mutants
        --in FOLDER     of this folder only (core, render, walkthroughs); may be named again
        --tier TIER     which tests are asked: quick, those of tests/run.sh, or full, the others, study and judge, too (full)
        --folder F      works in the copy F and keeps it: the next run builds what has changed, not all
    tests/mutants/mutate.py --check            whether each of equivalent.txt can be made

Works on a copy of the project, in a temporary folder unless told otherwise, built with little optimisation. Exit code 1
where fewer than 95 of 100 (by quick: 90) are noticed in a folder; those of equivalent.txt, which change nothing that can be
seen, count for neither. 2 where nothing could be tried.
"""
import argparse, os, pathlib, re, shutil, signal, subprocess, sys, tempfile, time

import made

here = pathlib.Path(__file__).resolve().parent
root = here.parents[1]
folders = {"core": "core-tests", "render": "render-tests", "walkthroughs": "walkthroughs-tests"}
transcripts = "gjkstep"  # the program whose answers they hold
quick, every = "~[full]", ""  # which tests
aim = {"quick": 90, "full": 95}  # of 100


def give_up(why):
    """Nothing can be said of mutants: unlike 1, this is not about tests."""
    print(why, file=sys.stderr)
    sys.exit(2)


def parts_of(line):
    return tuple(part.strip(" ") for part in line.split(" | "))


def problem_of(line):
    """Why this mutant cannot be made; empty where it can."""
    parts = parts_of(line)
    if len(parts) != 4:
        return f"has {len(parts)} parts instead of 4, divided by ' | '"
    file, old, new, _ = parts
    if not (root / file).is_file():
        return f"there is no file {file}"
    made_there = {(mutant.old_line, mutant.new_line) for mutant in made.mutants_of(file, (root / file).read_text())}
    return "" if (old, new) in made_there else "is not made of the text that stands there"


def equivalents():
    """The parts of all lines of equivalent.txt. Ends the program where one of them has a problem."""
    listed = here / "equivalent.txt"
    lines = [(i, l) for i, l in enumerate(listed.read_text().splitlines(), 1) if l.strip() and not l.startswith("#")]
    problems = [f"{listed}:{i}: {why}: bring it up to date\n    {l}" for i, l in lines if (why := problem_of(l))]
    if problems:
        sys.exit("\n".join(problems))
    return [parts_of(line) for _, line in lines]


def run(command, folder, patience=None):
    """Returns: exit code and output; 'does not end' where it takes longer."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               errors="replace", start_new_session=True)
    try:
        return process.communicate(timeout=patience)[0], process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return "does not end", 1


def build(folder, *targets):
    return run(["cmake", "--build", "build", "--parallel", "2", "--target", *targets], folder)[1] == 0


def files_of(folder):
    """All files of the project in that folder, by their path in it."""
    tops = [folder / top for top in (*folders, "tests")]
    found = {f.relative_to(folder) for top in tops for f in top.rglob("*") if f.is_file() and "__pycache__" not in f.parts}
    return found | {pathlib.Path("CMakeLists.txt"), pathlib.Path("README.md")}


def copy_to(folder):
    """Brings the copy up to date: what has not changed keeps its time, and is not built again."""
    for file in files_of(folder) - files_of(root):
        (folder / file).unlink(missing_ok=True)
    for file in files_of(root):
        if not (folder / file).is_file() or (folder / file).read_bytes() != (root / file).read_bytes():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / file, folder / file)
    options = ["-DGJKSTEP_TESTS=ON", "-DGJKSTEP_STUDY=ON", "-DGJKSTEP_UNITY=OFF", "-DCMAKE_BUILD_TYPE=None",
               "-DCMAKE_CXX_FLAGS=-O1 -D_GLIBCXX_ASSERTIONS"]
    run(["cmake", "-S", ".", "-B", "build", "-G", "Ninja", *options], folder)


def tests_called(pattern, file):
    """The files of the room's tests so called, without their endings."""
    tests = sorted(test.stem for test in (root / "tests" / pathlib.PurePath(file).parent).glob(pattern))
    return [test for test in tests if test != "no_heap_test"]


def stages(file, tier):
    """Programs, which of their tests, and the tier these are of: those first that most likely notice, and those of the quick tier
    before what --full runs besides. Each is built when its turn comes."""
    top, stem = file.split("/")[0], pathlib.PurePath(file).stem
    own = sorted(tests_called(f"{stem}*_test.cpp", file), key=len)  # the one that is called as the file is comes first
    program = folders[top]
    if top == "core":  # all of which is compiled into each test, and whose tests are built sooner than the pictures
        first, rest = [(test, quick) for test in own], [program, "golden-tests", transcripts]
    else:
        fitting = own or tests_called("*_test.cpp", file)
        first = [(program, ",".join(f"[#{test}]{quick}" for test in fitting))] if fitting else []
        rest = ["golden-tests", program, transcripts]
    turns = [(name, tests, "quick") for name, tests in first] + [(name, quick, "quick") for name in rest]
    return turns + [(name, every, "full") for name in [*rest, "study-tests"]] if tier == "full" else turns


def first_failure(out):
    """The case that failed: the last one named before it did. Those that warn are named, too."""
    names = re.findall(r"^-{20,}\n(.*?)\n-{20,}", out.partition(": FAILED:")[0], re.S | re.M)
    return out if out == "does not end" else names[-1].splitlines()[0] if names else "crashes"


def command_of(program, tests):
    if program == transcripts:
        leave_out = "| grep -v /others" if tests else ""  # which tests/CMakeLists.txt calls full, as cases tagged so
        return ["sh", "-c", f"python3 tests/console/run.py build/gjkstep $(ls tests/console/*.txt {leave_out})"]
    return [f"build/{program}", "--filenames-as-tags", "--abort", *filter(None, [tests])]


def patience_for(tests, seconds):
    """How long to wait for tests that take so many seconds together, unmutated. A few of them take far less than that."""
    return 60 + (2 if tests not in (quick, every) else 4) * seconds


def who_notices(turns, folder, seconds):
    """The first test that fails, and its tier; ("", "") where none does. None: this does not compile. `seconds`: of each program."""
    for program, tests, tier in turns:
        if not build(folder, program):
            return None
        out, code = run(command_of(program, tests), folder, patience_for(tests, seconds[program]))
        if code:
            return f"{program}: {'a transcript' if program == transcripts else first_failure(out)}", tier
    return "", ""


def keep_sound(folder):
    """Keeps what is built without any change beside it."""
    shutil.rmtree(folder / "sound", ignore_errors=True)
    shutil.copytree(folder / "build", folder / "sound", symlinks=True)


def bring_back_sound(folder):
    """Undoes what the build of a mutant did: without this, what depends on the file would be built again unchanged."""
    for file in (folder / "build").rglob("*"):
        sound = folder / "sound" / file.relative_to(folder / "build")
        if file.is_file() and not sound.is_file():
            file.unlink()
        elif file.is_file() and file.stat().st_mtime_ns != sound.stat().st_mtime_ns:
            shutil.copy2(sound, file)


def try_made(mutant, turns, folder, seconds):
    """Returns: the tier that notices, 'SURVIVED' or 'no mutant', which the compiler refuses; prints it."""
    path, start = folder / mutant.file, time.monotonic()
    sound, times = path.read_text(), path.stat()
    path.write_text(sound[:mutant.start] + mutant.new + sound[mutant.end:])
    try:
        by = who_notices(turns, folder, seconds)
    finally:
        path.write_text(sound)
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
        bring_back_sound(folder)
    by, tier = by if by else ("", "no mutant")
    verdict = tier or "SURVIVED"
    print(f"{verdict:9} {mutant.file}:{mutant.line}: {mutant.kind} ({time.monotonic() - start:.0f} s)"
          f"\n    {mutant.old_line}\n    {mutant.new_line}" + (f"\n    {by}" if by else ""), flush=True)
    return verdict


def seconds_of(folder, programs):
    """How many seconds each program takes without a mutant."""
    if not build(folder, *programs):
        give_up("without any change this does not compile: nothing can be said of mutants")
    seconds = {}
    for program in programs:
        start = time.monotonic()
        if run(command_of(program, every), folder)[1]:
            give_up(f"without any change {program} does not pass: nothing can be said of mutants")
        seconds[program] = time.monotonic() - start
    return seconds


def possible_mutants(top, words):
    files = sorted(str(f.relative_to(root)) for f in (root / top).rglob("*.[ch]pp"))
    mutants = [m for file in files for m in made.mutants_of(file, (root / file).read_text())]
    return [m for m in mutants if not words or any(word in f"{m.file}:{m.line}" for word in words)]


def try_all_made(arguments, folder):
    equivalent = {parts[:3] for parts in equivalents()}
    possible = {top: possible_mutants(top, arguments.words) for top in arguments.only or folders}
    samples = {top: made.sample(mutants, arguments.made, arguments.seed) for top, mutants in possible.items()}
    turns = {m.file: stages(m.file, arguments.tier) for sample in samples.values() for m in sample}
    seconds = seconds_of(folder, sorted({program for turn in turns.values() for program, *_ in turn}))
    keep_sound(folder)
    table, good = [], True
    for top, sample in samples.items():
        start = time.monotonic()
        counts = dict.fromkeys((*aim, "SURVIVED", "no mutant", "equivalent"), 0)
        for mutant in sample:
            known = (mutant.file, mutant.old_line, mutant.new_line) in equivalent
            counts["equivalent" if known else try_made(mutant, turns[mutant.file], folder, seconds)] += 1
        judged = counts["quick"] + counts["full"] + counts["SURVIVED"]
        shares = {"quick": counts["quick"], "full": counts["quick"] + counts["full"]}
        if arguments.tier == "quick":
            del shares["full"]  # was not asked
        good &= all(100 * noticed >= aim[tier] * judged for tier, noticed in shares.items())
        scores = [f"{100 * shares[tier] / judged:.0f} %" if judged and tier in shares else "-" for tier in aim]
        table.append(f"{top:13} {len(possible[top]):8} {judged:6} {scores[0]:>8} {scores[1]:>8} {counts['SURVIVED']:9} "
                     f"{counts['equivalent']:11} {counts['no mutant']:14} {(time.monotonic() - start) / 60:8.1f}")
    print(f"\nseed {arguments.seed}\n{'folder':13} {'possible':>8} {'judged':>6} {'by quick':>8} {'by full':>8} {'survived':>9} "
          f"{'equivalent':>11} {'not compiled':>14} {'minutes':>8}", *table, sep="\n")
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--made", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--in", dest="only", choices=folders, action="append")
    parser.add_argument("--tier", choices=aim, default="full")
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if arguments.check:
        return print(len(equivalents()), "mutants can be made")
    with tempfile.TemporaryDirectory(prefix="gjkstep-mutants-") as temporary:
        folder = (arguments.folder or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        copy_to(folder)
        good = try_all_made(arguments, folder)
    sys.exit(0 if good else 1)


main()
