"""What the tests of disturbed runs share: commands of the project, and what they write when nothing disturbs them."""
import dataclasses, json, pathlib, shutil, subprocess, sys

root = pathlib.Path(__file__).resolve().parents[2]
unfinished = ".unfinished"  # how a file is called while it replaces another (render/file.cpp)
manifest = ".gjkstep"       # the lines in it grow while other files are written (walkthroughs/output/manifest.cpp)


def is_of_stage(name):
    """Whether a run that makes pages has written it where the next run looks for it, to remove it (manifest.cpp)."""
    return f"/{unfinished}/" in name


def fail(why):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {why}")


@dataclasses.dataclass
class Case:
    """One command, run in a folder of its own. Its standard output goes to the file `stream` there."""
    name: str
    words: list
    stream: str = "printed"
    input: pathlib.Path = pathlib.Path("/dev/null")
    code: int = 0           # where nothing disturbs it
    timed: tuple = ()       # files that hold times, which are others in each run
    folder: pathlib.Path = None
    whole: dict = None      # what it writes when nothing disturbs it

    def start(self, before=(), **options):
        """The process, with `before` in front of its command."""
        with open(self.folder / self.stream, "wb") as out, open(self.input, "rb") as given:
            return subprocess.Popen([*before, *self.words], cwd=self.folder, stdin=given, stdout=out, stderr=subprocess.PIPE,
                                    **options)

    def run(self, before=(), **options):
        """Its exit code, and what it said on standard error."""
        process = self.start(before, **options)
        said = process.communicate(timeout=3000)[1].decode(errors="replace")
        return process.returncode, said

    def clear(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def files(self):
        return {file.relative_to(self.folder).as_posix(): file.read_bytes() for file in sorted(self.folder.rglob("*"))
                if file.is_file()}

    def is_whole(self, name, found):
        """Whether these are the bytes that the file of that name has when nothing disturbs the command."""
        expected = self.whole.get(name)
        if expected is None or pathlib.Path(name).name not in self.timed:
            return found == expected
        if name.endswith(".png"):
            return found.startswith(b"\x89PNG") and found.endswith(expected[-12:])
        if name.endswith(".json"):
            try:
                return json.loads(found).keys() == json.loads(expected).keys()
            except ValueError:
                return False
        return found.splitlines()[:1] == expected.splitlines()[:1] and found.endswith(b"\n")

    def half(self):
        """The files that are there and not whole. What is printed may end early, as it is read while it is written."""
        return [name for name, found in self.files().items() if not is_of_stage(name) and not name.endswith((unfinished, manifest)) and not (
            self.whole[self.stream].startswith(found) if name == self.stream else name not in self.whole or
            self.is_whole(name, found))]

    def left_over(self):
        """The files that no undisturbed run leaves, but for one whole one that was about to replace another."""
        others = [name for name in self.files() if name not in self.whole and not is_of_stage(name)]
        replacing = [name for name in others if self.is_whole(name.removesuffix(unfinished), (self.folder / name).read_bytes())
                     and name.endswith(unfinished)]
        return [name for name in others if name not in replacing[:1]]

    def disturbed(self):
        """What is other than usual when it is run once more; empty where nothing is."""
        code, said = self.run()
        found = self.files()
        wrong = [name for name in sorted(found.keys() | self.whole.keys())
                 if name not in found or not self.is_whole(name, found[name])]
        return ([f"exit code {code}: {said}"] if code != self.code else []) + wrong


def cases(program, study, folder):
    """All commands, their folders below `folder`, each run once: so what they write is known."""
    pictures = root / "tests/package/pictures/expected/box-and-can"
    for side in ("expected", "actual"):
        shutil.copytree(pictures, folder / side)
    for picture in sorted((folder / "actual").glob("*.png"))[:2]:
        shutil.copy(pictures / "005.png", picture)
    pairs = folder / "pairs.jsonl"
    pairs.write_text("".join(f'{{"a":{{"points":[[0,0,0],[2,0,{i}],[0,2,0]]}},"b":{{"sphere":{{"center":[3,{i % 7},0],"radius":1}}}}}}\n'
                             for i in range(10000)))
    found = [
        Case("render", [program, "render", "figure-4-left", "failures/vanished-product", "--detail", "iteration", "--size", "640x360",
                        "--strip", "--sheet", "--apng", "--turn", "1", "--rendered-by", "--captions", "captions.json",
                        "--page=single"]),
        Case("compare", [program, "compare", folder / "expected", folder / "actual", "--report", "report"], code=1),
        Case("query", [program, "query"], input=pairs),
        Case("trace", [program, "trace", "figure-4-left"]),
    ]
    if study:
        times = ("timings.csv", "alone.csv")
        small = ["--pairs", "20", "--families", "triangles,touching-vertex"]
        # Of pages and sheets so many writes could fail that full_disk_test.py tries them only beside the study, by hand.
        pages = ["figure-1", "figure-4-left", "--size", "320x180", "--page", "--sheet=a4"]
        found += [Case("pages", [program, "render", *pages]),
                  Case("study run", [study, "run", *small], timed=times)]
    for case in found:
        case.folder = folder / "runs" / case.name
        case.clear()
        code, said = case.run()
        case.whole = case.files()
        if code != case.code or len(case.whole) < 1:
            fail(f"{case.name} ends with {code} where nothing disturbs it: {said}")
    return found


def table(rows, columns):
    """Prints one line for each row, a dictionary. Returns: whether all numbers of `columns` are 0."""
    print("".join(f"{name:>14}" for name in rows[0]))
    for row in rows:
        print("".join(f"{value:>14}" for value in row.values()))
    return all(row[name] == 0 for row in rows for name in columns)
