#!/usr/bin/env python3
"""Kills commands of the project at random moments, and looks at what they leave.

    python3 tests/disturbed/kill_test.py --program build/gjkstep --study build/gjkstep-study --kills 1000    # by hand: half an hour

Each kill is by SIGKILL, SIGTERM, SIGINT or SIGHUP, the last two as from a terminal, to the children, too; half of them in an
empty folder, half where all files are there already. Then the command is run once more, to its end. Counted: files that
are there and not whole; files that nobody asked for, right after the kill or after that later run; later runs that end or write
otherwise. Exit code 1 where one of these is not 0.
"""
import argparse, os, pathlib, random, signal, sys, tempfile, time

sys.dont_write_bytecode = True
import disturbed

parser = argparse.ArgumentParser()
parser.add_argument("--program", type=pathlib.Path, required=True)
parser.add_argument("--study", type=pathlib.Path)
parser.add_argument("--kills", type=int, default=40, help="of all commands together")
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--only", help="the one command of this name")
arguments = parser.parse_args()

signals = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP]


def wait_for_group(group):
    """Waits until the children have ended, too: a plotting program may go on a little."""
    for _ in range(120000):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.005)
    disturbed.fail("a child of what was killed goes on for ten minutes")


def kill(case, dice, shortest):
    """Starts the command and kills it at a moment before it would end. Returns: whether it was hit."""
    process = case.start(start_new_session=True)
    time.sleep(dice.uniform(0, shortest))
    how = dice.choice(signals)
    try:
        (os.killpg if how in (signal.SIGINT, signal.SIGHUP) else os.kill)(process.pid, how)
    except ProcessLookupError:
        pass
    process.communicate()
    wait_for_group(process.pid)
    return process.returncode == -how


def kills_of(case, count, dice):
    row = {"command": case.name, "kills": 0, "hit": 0, "half": 0, "left over": 0, "disturbed": 0}
    begin = time.monotonic()
    case.run()
    shortest = time.monotonic() - begin  # of its runs so far: other work on the machine comes and goes
    for i in range(count):
        if i % 2 == 0:
            case.clear()
        row["kills"] += 1
        row["hit"] += kill(case, dice, shortest)
        half, left = case.half(), case.left_over()
        begin = time.monotonic()
        wrong = case.disturbed()
        shortest = min(shortest, time.monotonic() - begin)
        left += case.left_over()
        row["half"] += len(half)
        row["left over"] += len(left)
        row["disturbed"] += bool(wrong)
        for kind, found in (("half", half), ("left over", left), ("disturbed", wrong)):
            if found:
                print(f"{case.name}, kill {i}: {kind}: {', '.join(found)}", flush=True)
    return row


def main():
    with tempfile.TemporaryDirectory(prefix="gjkstep-kill-") as folder:
        study = arguments.study.resolve() if arguments.study else None
        found = [case for case in disturbed.cases(arguments.program.resolve(), study, pathlib.Path(folder))
                 if arguments.only in (None, case.name)]
        print(f"seed {arguments.seed}", flush=True)
        share = -(-arguments.kills // len(found))
        rows = [kills_of(case, share, random.Random(f"{arguments.seed} {case.name}")) for case in found]
    return not disturbed.table(rows, ("half", "left over", "disturbed"))


if __name__ == "__main__":
    sys.exit(main())
