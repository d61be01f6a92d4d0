#!/usr/bin/env python3
"""What does work cost as there is more of it: points, frames, pairs? Writes a table and growth.svg beside this file.

    python3 tests/bench/growth.py build/gjkstep build/gjkstep-growth > tests/bench/growth.md

Needs gnuplot. Times are of the processor, each the median of three; slopes are of the last three sizes, on logarithmic scales: 1 is
linear.
"""
import json, math, os, pathlib, random, resource, statistics, subprocess, sys, tempfile

here = pathlib.Path(__file__).parent
repeats = 3


def spent(command, **options):
    """Seconds of processor and the largest memory in MB of a command."""
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **options)
    _, status, usage = os.wait4(child.pid, 0)
    assert status == 0, command
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measured(run):
    runs = [run() for _ in range(repeats)]
    return statistics.median(seconds for seconds, _ in runs), max(memory for _, memory in runs)


def triangle(dice):
    return [[round(dice.uniform(-1, 1), 6) for _ in range(3)] for _ in range(3)]


def pairs(program, folder, count):
    file, dice = folder / f"{count}.jsonl", random.Random(7474)
    with open(file, "w") as out:
        for _ in range(count):
            out.write(json.dumps({"a": {"points": triangle(dice)}, "b": {"points": triangle(dice)}}) + "\n")
    return measured(lambda: spent([program, "query", "--certified"], stdin=open(file)))


def frames(program, folder, count):
    """Scenes of one search over and over, drawn small; each has `of_one` frames."""
    of_one = 10
    scene = {"a": {"points": [[-1.25, 1.25], [0.5, 2.25], [2.25, 1.75]]}, "b": {"points": [[-1.5, -1.5], [-1.25, 2.25], [1, 0], [1.25, -1.75]]}}
    names = []
    for i in range(math.ceil(count / of_one)):
        names.append(folder / f"scene-{i}.json")
        names[-1].write_text(json.dumps(scene))
    out = folder / f"frames-{count}"
    return measured(lambda: spent([program, "render", *names, "--frames", f"1-{of_one}", "--size", "160x90", "--out", out]))


def slope(rows):
    """Of the logarithms of the last three."""
    xs, ys = [[math.log(value) for value in column] for column in zip(*[(n, cost) for n, cost in rows[-3:]])]
    x, y = statistics.mean(xs), statistics.mean(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


colors = ["#0072b2", "#009e73", "#d55e00", "#222222", "#cc79a7", "#767676"]


def plot(curves):
    lines = ["set terminal svg size 760,560 font 'sans,13' background '#ffffff'", f"set output '{here / 'growth.svg'}'", "set logscale xy",
             "set key outside below center samplen 3", "set xlabel 'points, frames or pairs'", "set ylabel 'time of processor'",
             "set format x '%.0s%c'", "set format y '%.0s %cs'", "set grid lw 0.5"]
    for place, rows in enumerate(curves.values()):
        lines += [f"$c{place} << END", *[f"{n} {cost}" for n, cost in rows], "END"]
    lines.append("plot " + ", ".join(
        f"$c{place} with linespoints lw 2 pt {5 + 2 * place} ps 0.7 lc rgb '{color}' title '{name} (slope {slope(rows):.2f})'"
        for place, ((name, rows), color) in enumerate(zip(curves.items(), colors))))
    subprocess.run(["gnuplot"], input="\n".join(lines), text=True, check=True)


def main(program, of_points):
    curves, memory = {}, {}
    for line in subprocess.run([of_points], capture_output=True, text=True, check=True).stdout.splitlines():
        name, n, seconds = line.rsplit(",", 2)
        curves.setdefault(name, []).append((int(n), float(seconds)))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, sizes, run in (("frames, drawn at 160x90", [10, 100, 1000, 10000], frames),
                                 ("pairs, certified query", [1, 100, 10000, 100000, 1000000], pairs)):
            for n in sizes:
                seconds, most = run(program, folder, n)
                curves.setdefault(name, []).append((n, seconds))
                memory.setdefault(name, []).append((n, most))
    plot(curves)
    print("# What work costs as there is more of it\n\nMade again by `python3 tests/bench/growth.py build/gjkstep build/gjkstep-growth > tests/bench/growth.md`.\n"
          "Seconds of processor, medians; slopes of the last three sizes on logarithmic scales: 1 is linear.\n\n![growth](growth.svg)\n")
    print("| | slope | " + "seconds, by size |\n|---|---:|---|")
    for name, rows in curves.items():
        print(f"| {name} | {slope(rows):.2f} | " + "; ".join(f"{n:,}: {cost:.3g}" for n, cost in rows) + " |")
    print("\n| most memory, MB | by size |\n|---|---|")
    for name, rows in memory.items():
        print(f"| {name} | " + "; ".join(f"{n:,}: {most:.0f}" for n, most in rows) + " |")


main(*sys.argv[1:])
