#!/usr/bin/env python3
"""Shows what the golden tests find changed, and accepts it.

    tests/golden/accept.py                    what changed: texts here, pictures of before and now side by side in a page
    tests/golden/accept.py --accept           and all of it is accepted
    tests/golden/accept.py --accept traces    of one kind alone: images, traces, frames, sentences, answers, complaints, pages

Pictures that are kept have a page of their own, build/golden/index.html. Of frames only checksums are kept (frames.txt): those of
before are drawn by the program as it was when frames.txt was accepted last, built in build/golden/before.
"""
import argparse, os, pathlib, shutil, subprocess, sys

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("kind", nargs="?", default="", help="of which kind; all where it is left out")
parser.add_argument("--build", type=pathlib.Path, default="build", help="folder that was built into, with GJKSTEP_TESTS=ON")
parser.add_argument("--accept", action="store_true", help="accept what is drawn and written now")
parser.add_argument("--most", type=int, default=60, help="so many frames are shown at most, those of each walkthrough in turn")
arguments = parser.parse_args()

root = pathlib.Path(__file__).resolve().parents[2]
build = arguments.build if arguments.build.is_absolute() else root / arguments.build
golden = build / "golden"


def run(*command, **options):
    return subprocess.run([str(word) for word in command], cwd=root, **options)


def program_of_before():
    """Built from the commit in which frames.txt is the one that is compared with."""
    commit = run("git", "log", "-1", "--format=%h", "--", "tests/golden/frames.txt", capture_output=True, text=True,
                 check=True).stdout.strip()
    source = golden / "before" / commit
    program = source / "build/gjkstep"
    if not program.exists():
        print(f"building the program of {commit}, by which frames.txt was accepted, in {source}", flush=True)
        source.mkdir(parents=True, exist_ok=True)
        archive = run("git", "archive", commit, capture_output=True, check=True).stdout
        subprocess.run(["tar", "-x", "-C", source], input=archive, check=True)
        run("cmake", "-S", source, "-B", source / "build", "-G", "Ninja", check=True, stdout=subprocess.DEVNULL)
        run("cmake", "--build", source / "build", "--target", "gjkstep", check=True, stdout=subprocess.DEVNULL)
    return program


def frames_to_draw(lines):
    """Of each walkthrough its name, steps ("1,4"; empty: all) and options, as long as there are not too many."""
    left = arguments.most
    each = max(1, left // len(lines))
    for line in lines:
        name, frames, options = line.split("\t")
        chosen = frames.split(",")[:each]
        if left <= 0:
            return
        left -= len(chosen)
        yield name, ",".join(chosen), options.split()


def show_frames():
    lines = (golden / "changed-frames.txt").read_text().splitlines()
    if not lines:
        return print("no frame changed")
    before, shown = program_of_before(), golden / "frames"
    shutil.rmtree(shown, ignore_errors=True)
    for name, frames, options in frames_to_draw(lines):
        source = golden / (name + ".json") if name.startswith("random/") else name
        choice = ["--frames", frames] if frames else []
        for program, side in ((before, "before"), (build / "gjkstep", "now")):
            run(program, "render", source, *choice, *options, "--size", "640x360", "--out", shown / side,
                stdout=subprocess.DEVNULL)
    print(f"{len(lines)} walkthroughs and searches at random have other frames")
    run(build / "gjkstep", "compare", shown / "before", shown / "now", "--report", shown / "report")


def main():
    run("cmake", "--build", build, "--target", "golden-tests", "gjkstep", check=True, stdout=subprocess.DEVNULL)
    tests = [build / "golden-tests", arguments.kind + "*"]
    code = run(*tests).returncode
    if arguments.kind in ("", "frames"):
        show_frames()
    if code and arguments.accept:
        code = run(*tests, env=os.environ | {"GJKSTEP_UPDATE_GOLDENS": "1"}).returncode
    return code


sys.exit(main())
