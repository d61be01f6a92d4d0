#!/usr/bin/env python3
"""Makes tables and pictures of the CSV files that gjkstep-study wrote.

    tests/study/report/report.py study                          # of `gjkstep-study run --out study`, of `claims --out study`, or of both
    tests/study/report/report.py out/shard-*-of-64 --out study  # the shards of one run, added up
"""
import argparse, pathlib, sys
sys.dont_write_bytecode = True
import claims, pictures, tables
from data import Refused, Study

texts = {"tables.md": tables.tables_md, "errors.md": tables.errors_md, "settings.md": tables.settings_md, "timings.md": tables.timings_md,
         "certified.md": tables.certified_md}
drawn = {"error-vs-time.png": pictures.error_vs_time, "heat-map.png": pictures.heat_map, "iterations.png": pictures.iterations}


def write(file, text):
    file.write_text(text)
    print(file)


def report_run(folders, out):
    study = Study(folders)
    for name, text_of in texts.items():
        if text := text_of(study):
            write(out / name, text)
    for name, script_of in drawn.items():
        if pictures.draw(out / name, script_of(study)):
            print(out / name)
        else:
            print(f"report.py: {name} is left out: gnuplot is not there or failed; apt-get install gnuplot-nox", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description="Makes tables and pictures of the CSV files that gjkstep-study wrote.")
    parser.add_argument("folders", metavar="FOLDER", nargs="+", type=pathlib.Path, help="of a run or of claims, or those of all shards of a run")
    parser.add_argument("--out", type=pathlib.Path, help="folder of tables and pictures; FOLDER, unless it is told")
    arguments = parser.parse_args()
    folders, out = arguments.folders, arguments.out or arguments.folders[0]
    if len(folders) > 1 and not arguments.out:
        parser.error("--out: name a folder for what the shards make together")
    has_claims = (folders[0] / "claims-mistakes.csv").exists()
    try:
        out.mkdir(parents=True, exist_ok=True)
        if has_claims:
            write(out / "claims.md", claims.claims_md(folders[0]))
        if not has_claims or (folders[0] / "counts.csv").exists():
            report_run(folders, out)
    except Refused as error:
        sys.exit(f"report.py: {error}")
    except OSError as error:
        sys.exit(f"report.py: {error.filename}: {error.strerror}; choose another folder with --out")


if __name__ == "__main__":
    main()
