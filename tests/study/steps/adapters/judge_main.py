"""Makes a program that `gjkstep-study judge` can ask out of a function of yours; the standard library is enough.

    gjkstep-study judge -- python3 judge_main.py your_module

Its function collide(a, b) gets two lists of points [x, y, z] and returns True where their convex hulls have a point in
common, False where they have none, None where it cannot tell. It may tell its steps: `from judge_main import step`.
"""
import importlib
import json
import os
import sys


def step(searched_along, reduced_simplex):
    """Call it at the end of each iteration, if you like: where JUDGE_STEPS is set, it tells `gjkstep-study check-steps`
    of the direction and of the simplex, its newest vertex last (or always first)."""
    if "JUDGE_STEPS" in os.environ:
        simplex = [[float(x) for x in p] for p in reduced_simplex]
        print(json.dumps({"direction": [float(x) for x in searched_along], "simplex": simplex}), flush=True)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: python3 judge_main.py MODULE")
    sys.path.insert(0, os.getcwd())
    collide = importlib.import_module(sys.argv[1]).collide
    for line in sys.stdin:
        pair = json.loads(line)
        if "points" not in pair["a"] or "points" not in pair["b"]:
            sys.exit("judge_main.py asks about points, and this pair has a round shape")
        answer = collide(pair["a"]["points"], pair["b"]["points"])
        print(json.dumps("undecided" if answer is None else bool(answer)), flush=True)


if __name__ == "__main__":
    main()
