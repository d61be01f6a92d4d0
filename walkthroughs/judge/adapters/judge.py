"""Lets `gjkstep judge` ask a collision test that is written in Python. Write it in a file of yours, such as mine.py:

    def collide(a, b): ...

It gets the points [x, y, z] of two convex hulls. It returns True where the hulls have a point in common, else False.
It returns None where it cannot tell. It may return the distance instead, as a float: 0.0 where they meet. Then:

    gjkstep judge -- python3 judge.py mine

If your search calls step(searched_along, simplex) at the end of each iteration, its steps are judged, too: write
`from judge import step`. The simplex is the reduced one, points a - b, the newest last (or always first).
"""
import importlib
import json
import numbers
import os
import sys


def step(searched_along, simplex):
    if "JUDGE_STEPS" in os.environ:
        numbers_of = [[float(x) for x in point] for point in [searched_along, *simplex]]
        print(json.dumps({"direction": numbers_of[0], "simplex": numbers_of[1:]}), flush=True)


def points_of(shape):
    if "points" not in shape:
        print("judge.py: a line is no pair of sets of points", file=sys.stderr)
        sys.exit(2)
    return [[*point, 0.0][:3] for point in shape["points"]]  # a point [x, y] means [x, y, 0]


def in_words(answer):
    if answer is None:
        return "undecided"
    if isinstance(answer, numbers.Integral):  # a bool is one
        return "yes" if answer else "no"
    return f"distance {float(answer)!r}" if isinstance(answer, numbers.Real) else str(answer)  # shown as it is


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: python3 judge.py MODULE")
    sys.path.insert(0, os.getcwd())
    collide = importlib.import_module(sys.argv[1].removesuffix(".py")).collide
    for line in sys.stdin:
        pair = json.loads(line)
        print(in_words(collide(points_of(pair["a"]), points_of(pair["b"]))), flush=True)


if __name__ == "__main__":
    main()
