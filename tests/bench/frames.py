#!/usr/bin/env python3
"""How long do frames take, beside what zlib alone would take to compress them? Writes a table.

    python3 tests/bench/frames.py build/gjkstep > tests/bench/frames.md

The program lays out, draws, compresses and writes with all processors; zlib compresses the same rows at level 6 in one thread.
"""
import os, pathlib, statistics, subprocess, sys, tempfile, time, zlib

repeats = 5
of_what = {"in the plane": ["figure-4-left", "figure-4-right", "figure-4-right-no-crossing-test", "figure-5"],
           "in space": ["regions/3-simplex-face-adb-edge-ad", "vehicle-and-threat/counter-munition-hit", "regions/2-simplex-r1-below"],
           "all of the catalogue": ["--all"]}


def rows_of(png):
    """What is compressed in a PNG, unpacked."""
    data, at, packed = png.read_bytes(), 8, b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return zlib.decompress(packed)


def seconds(run):
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def zlib_alone(folder):
    total = 0
    for png in sorted(folder.rglob("*.png")):
        rows = rows_of(png)
        total += seconds(lambda: zlib.compress(rows, 6))
    return total


def main(program):
    print(f"# Frames beside zlib alone\n\nMade again by `python3 tests/bench/frames.py build/gjkstep > tests/bench/frames.md`, on {os.cpu_count()} processors.\n"
          "Frames of 1280x720; seconds, medians. The program's time is all of it, from its start to the last file.\n")
    print("| | frames | the program | zlib, level 6, one thread | program ÷ zlib | MB | MB by zlib |\n|---|---:|---:|---:|---:|---:|---:|")
    for what, names in of_what.items():
        times, others = [], []
        for _ in range(1 if names == ["--all"] else repeats):
            with tempfile.TemporaryDirectory() as out:
                out = pathlib.Path(out)
                times.append(seconds(lambda: subprocess.run([program, "render", *names, "--out", out], stdout=subprocess.DEVNULL,
                                                            stderr=subprocess.DEVNULL, check=True)))
                others.append(zlib_alone(out))
                pngs = list(out.rglob("*.png"))
                size = sum(png.stat().st_size for png in pngs) / 1e6
                by_zlib = sum(len(zlib.compress(rows_of(png), 6)) for png in pngs) / 1e6
        ours, theirs = statistics.median(times), statistics.median(others)
        print(f"| {what} | {len(pngs)} | {ours:.2f} | {theirs:.2f} | {ours / theirs:.2f} | {size:.1f} | {by_zlib:.1f} |", flush=True)


main(sys.argv[1])
