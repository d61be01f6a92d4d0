#!/usr/bin/env python3
"""Lets each write of a run fail as on a full disk, one run for each, and looks at what it leaves.

    python3 tests/disturbed/full_disk_test.py --program build/gjkstep              # some of them
    python3 tests/disturbed/full_disk_test.py --program build/gjkstep --study build/gjkstep-study --all    # by hand: ten minutes

strace lets the n-th call fail, in each thread, of what writes, names, closes (by a duplicate), makes a folder or opens a
file: in an empty folder, and where all files are there already. Then the run ends with exit code 5 and a sentence, leaves no
half file and nothing else, and the next run is whole. Where a file cannot be opened in one way there may be another, and one
that cannot be looked into may be of others: exit code 2.
Exit code 1 where something is otherwise.
"""
import argparse, pathlib, re, shutil, subprocess, sys, tempfile

sys.dont_write_bytecode = True
import disturbed

parser = argparse.ArgumentParser()
parser.add_argument("--program", type=pathlib.Path, required=True)
parser.add_argument("--study", type=pathlib.Path)
parser.add_argument("--all", action="store_true", help="each call, and not some of them")
parser.add_argument("--only", help="the one command of this name")
arguments = parser.parse_args()

calls = ["write", "linkat", "rename", "mkdir", "dup", "openat", "pwrite64", "ftruncate", "fsync"]  # some not used now


def strace(case, call, n, log):
    """The command in front of the one that is to fail, without programs that it starts. Of what opens files, only what opens those of the case counts."""
    paths = {pathlib.Path(name) for name in case.whole}  # as the command spells them
    paths |= {folder for path in paths for folder in path.parents}
    only = [word for path in sorted(paths) for word in ("-P", path)] if call == "openat" else []
    return ["strace", "-f", "--seccomp-bpf", "--detach-on=execve", "-y", "-qq", "-o", log, "-e", f"trace={call}", *only,
            "-e", f"inject={call}:error=ENOSPC:when={n}"]


def tells_of_errors(line):
    return re.match(r"\d+ +\w+\(2<", line) is not None


def problems_of(case, call, failed, code, said):
    found = [f"{name} is half" for name in case.half()] + [f"{name} is left over" for name in case.left_over()]
    sentence = said.strip().splitlines()[-1] if said.strip() else ""
    if code == case.code and call == "openat":
        found += [f"{name} is not there, exit code {code}" for name in case.whole if name not in case.files()]
    elif code not in ((2, 5) if call == "openat" else (5,)) or not (re.search(r"gjkstep(-study)?: .*(;|\. )", sentence) or any(map(tells_of_errors, failed))):
        found.append(f"exit code {code} and not 5, '{sentence}'")
    return found + [f"the next run: {wrong}" for wrong in case.disturbed()]


def runs_of(case, call, log):
    """One run for each call of that kind. Returns: how many failed, and the problems of each."""
    problems, tried = [], 0
    for is_there in (False, True):
        n, failed = 1, [""]
        while failed:  # until no thread has n of them
            if not is_there:
                case.clear()
            log.write_text("")
            code, said = case.run(before=strace(case, call, n, log))
            failed = [line for line in log.read_text(errors="replace").splitlines() if "(INJECTED)" in line]
            if not all(map(tells_of_errors, failed)):
                tried += 1
                problems += [f"{case.name}, {failed[0]}: {problem}" for problem in problems_of(case, call, failed, code, said)]
            n += 1 if arguments.all else n
    return tried, problems


def main():
    if shutil.which("strace") is None or subprocess.run(["strace", "-f", "-o", "/dev/null", "true"], check=False,
                                                        capture_output=True).returncode != 0:
        print("skipped: strace is not there (apt-get install strace), or may not trace here")
        return 77
    rows, all_problems = [], []
    with tempfile.TemporaryDirectory(prefix="gjkstep-full-disk-") as folder:
        study = arguments.study.resolve() if arguments.study else None
        for case in disturbed.cases(arguments.program.resolve(), study, pathlib.Path(folder)):
            if arguments.only not in (None, case.name):
                continue
            row = {"command": case.name}
            problems = []
            for call in calls:
                row[call], found = runs_of(case, call, pathlib.Path(folder) / "log")
                problems += found
            print("\n".join(problems), end="\n" if problems else "", flush=True)
            rows.append(row | {"problems": len(problems)})
            all_problems += problems
    return not disturbed.table(rows, ["problems"])


if __name__ == "__main__":
    sys.exit(main())
