#!/usr/bin/env python3
"""Makes a page of what gjkstep-moving wrote.

    build/gjkstep-moving > moving.csv
    tests/bench/peers/moving_report.py moving.csv > tests/bench/peers/moving.md
"""
import csv, sys

import report

goal = 2  # times as long as the fastest peer is to take


def main(file):
    lines = open(file).readlines()
    head = [line[2:].rstrip("\n") for line in lines if line.startswith("# ")]
    races = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("# ")):
        races.setdefault((row["family"], row["pace"], row["step"]), []).append(row)
    names = [row["contender"] for row in next(iter(races.values()))]
    print("# Pairs that move\n\nOne object is turned, and carried to and fro through the other. All are asked in each frame, in one process and one thread.\n"
          "Processor time counts, and the median of turns. The answers are compared with the certified one before anything is timed.\n")
    print("\n".join(f"* {line}" for line in head) + "\n")
    print("A frame goes `step` radians, and `step` sizes of the object or a little more or less. *meet*: frames in which they do.\n")

    def times(key, rows):
        ns = [float(row["ns"]) for row in rows]
        fastest = min(each for each, row in zip(ns, rows) if row["is_peer"] == "1")
        ours = [row for row in rows if row["contender"].endswith("last found")]
        return [key[0], f"{key[1]}, {key[2]}", rows[0]["together"], *[f"{each:.0f}" for each in ns],
                *[report.number(fastest / float(row["ns"])) for row in ours]]

    fast = [f"fastest peer ÷ {name}" for name in names if name.endswith("last found")]
    rows = [times(key, rows) for key, rows in races.items()]
    print(report.table(["ns per query", "pace, step", "meet", *names, *fast], rows))
    print(report.table(["other answers than certified", "pace, step", *names],
                       [[key[0], f"{key[1]}, {key[2]}", *[row["otherwise"] for row in rows]] for key, rows in races.items()]))
    for place, name in enumerate(fast):
        below = [f"{row[0]}, {row[1]} ({row[len(row) - len(fast) + place]})" for row in rows if float(row[len(row) - len(fast) + place]) < goal]
        print(f"* {name} is at least {goal} on: all" + (f" but {'; '.join(below)}" if below else ""))


main(sys.argv[1])
