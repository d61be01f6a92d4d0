#!/usr/bin/env python3
"""Runs gjkstep with little memory (ulimit -v) and few processes (ulimit -u): it ends well, with whole files, or says why not.

    python3 tests/disturbed/memory_test.py build/gjkstep             # some limits: what ctest runs
    python3 tests/disturbed/memory_test.py build/gjkstep --step 5    # every 5 MiB from 50 to 800, and a table: four minutes

Below some 200 MiB it is the system that cannot load the libraries, and says so (exit code 127).
"""
import argparse, collections, os, pathlib, resource, subprocess, sys, tempfile

parser = argparse.ArgumentParser()
parser.add_argument("program", type=pathlib.Path)
parser.add_argument("--step", type=int, default=50, help="MiB between two limits")
parser.add_argument("--backends", default="osmesa,egl", help="what to draw with")
arguments = parser.parse_args()

mebibyte = 1 << 20
scene = pathlib.Path(__file__).resolve().parents[1] / "fuzz/scenes/ok-cylinders.json"
pictures = pathlib.Path(__file__).resolve().parents[1] / "package/pictures/expected/box-and-can"
pair = b'{"a":{"points":[[0,0,0],[2,0,0],[0,2,0]]},"b":{"points":[[3,3,0],[1,1,1],[2,2,1]]}}\n'
endings = {0: "well", 1: "memory, a thread or a crash", 3: "fonts", 4: "no OpenGL", 127: "libraries"}


def files(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def run(words, out, limit=None, kind=resource.RLIMIT_AS, user=None):
    """The outcome of one run, and what it has written."""
    def lower():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if limit is not None:
            resource.setrlimit(kind, (limit, limit))
    ended = subprocess.run([arguments.program.resolve(), *words], cwd=out, input=pair, capture_output=True, timeout=1200,
                           check=False, preexec_fn=lower, user=user)
    return ended, files(out)


def problem_of(ended, written, expected, expected_out):
    """What is wrong with this outcome; empty where nothing is."""
    said = ended.stderr.decode(errors="replace").strip()
    if ended.returncode not in endings:
        return f"ends with {ended.returncode}: {said[:200]}"
    if ended.returncode == 0 and (written != expected or ended.stdout != expected_out):
        return "says that all is well and has written something else"
    if any(written[name] != expected.get(name) for name in written if not name.endswith(".gjkstep")):
        return "has left a file that is not whole"
    sentence = said.splitlines()[-1] if said else ""
    if ended.returncode not in (0, 127) and not (sentence.startswith("gjkstep: ") and "ulimit -v" in sentence):
        return f"ends with {ended.returncode} and says '{sentence}'"
    return ""


def commands():
    for backend in arguments.backends.split(","):
        yield ["render", "figure-4-left", "--strip", "--out", "out", "--gl", backend]
    yield ["list", "regions"]
    yield ["query", "--scalar", "exact"]
    yield ["trace", scene]
    yield ["compare", pictures / "000.png", pictures / "000.png", "--report", "out"]


def few_processes(words):
    """None but the one it is: no thread can be started. Root may always start more, so somebody else runs it."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o777)
        nobody = 65534 if os.geteuid() == 0 else None
        ended, written = run(words, pathlib.Path(folder), limit=1, kind=resource.RLIMIT_NPROC, user=nobody)
    said = ended.stderr.decode()
    if ended.returncode not in (1, 4) or "gjkstep: " not in said or "ulimit -u" not in said or written:
        return [f"{' '.join(map(str, words))}, without threads: {ended.returncode}: {said}"]
    return []


def main():
    problems, table = [], collections.Counter()
    for words in commands():
        name = " ".join([words[0], *words[-2:]] if words[0] == "render" else words[:1])
        with tempfile.TemporaryDirectory() as folder:
            whole, expected = run(words, pathlib.Path(folder))
        expected.pop("out/index.html", None)
        for limit in range(50, 801 if words[0] == "render" or arguments.step < 50 else 250, arguments.step):
            with tempfile.TemporaryDirectory() as folder:
                ended, written = run(words, pathlib.Path(folder), limit * mebibyte)
            table[name, ended.returncode] += 1
            written.pop("out/index.html", None)  # it names the folder where it was made
            if problem := problem_of(ended, written, expected, whole.stdout):
                problems.append(f"{name}, {limit} MiB: {problem}")
    for words in list(commands())[:arguments.backends.count(",") + 1]:
        problems += few_processes(words)
    for (name, code), count in sorted(table.items()):
        print(f"{count:5}  {name}: {code}, {endings.get(code, 'something else')}")
    print("\n".join(problems) if problems else "no crash, always a sentence, whole files")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
