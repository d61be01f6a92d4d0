#!/usr/bin/env python3
"""How many pairs a second does gjkstep query answer? Writes a table.

    python3 tests/bench/query_report.py build/gjkstep-query-bench > tests/bench/query.md
"""
import json, subprocess, sys

repeats = 7


def main(program):
    said = subprocess.run([program, f"--benchmark_repetitions={repeats}", "--benchmark_min_time=0.2", "--benchmark_format=json",
                           "--benchmark_enable_random_interleaving=true"], capture_output=True, text=True, check=True).stdout
    rows = sorted((each for each in json.loads(said)["benchmarks"] if each.get("aggregate_name") == "median"),
                  key=lambda each: each["family_index"])
    print("# Pairs a second\n\nMade again by `python3 tests/bench/query_report.py build/gjkstep-query-bench > tests/bench/query.md`.\n"
          f"One core, doubles; medians of {repeats} turns in one run. Lines are read from memory and answers written there.\n")
    print("| | pairs a second | ns a pair |\n|---|---:|---:|")
    for row in rows:
        rate = row["items_per_second"]
        print(f"| {row['run_name']} | {rate:,.0f} | {1e9 / rate:.0f} |")


main(sys.argv[1])
