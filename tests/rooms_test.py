#!/usr/bin/env python3
"""The README names every room, and includes run one way: no folder knows one above it, no unit (foo.hpp with foo.cpp) includes itself in a circle.

    python3 tests/rooms_test.py        # looks at this project, and first at small made-up ones with one mistake each
"""
import pathlib, re, sys, tempfile, unittest

# The floors, lowest first. A file may include what stands on its own line or above it in this list; folders on one line
# do not know each other. Whatever is in a folder named here belongs to its line.
floors = [
    ["core", "render"],
    ["walkthroughs/wrong_on_purpose"],
    ["walkthroughs/model"],
    ["walkthroughs/text"],
    ["walkthroughs/query"],
    ["walkthroughs/story"],
    ["walkthroughs/picture"],
    ["walkthroughs/trace"],
    ["walkthroughs/catalogue"],
    ["walkthroughs/page"],
    ["walkthroughs/output"],
    ["walkthroughs/program"],
    ["tests/kit"],
    ["tests/core", "tests/render"],
    ["tests/walkthroughs"],  # what its tests share
    ["tests/study/pairs"],
    ["tests/study/truth"],
    ["tests/study/methods"],
    ["tests/study/sweep"],
    ["tests/study/claims"],
    ["tests/study/corpus"],
    ["tests/study/judge"],
    ["tests/study/steps"],
    ["tests/study/program"],
    ["tests/study"],
    ["tests/golden", "tests/bench", "tests/fuzz", "tests"],
]


# Headers of the core that need Boost, too; who includes others of the core needs Eigen only.
proving = ["core/certified.hpp", "core/certified_search.hpp", "core/certified_telling.hpp",
           "core/certified_balls.hpp", "core/certificate_check.hpp"]


def floor_of(path):
    """The line in `floors` of the longest name that `path` lies in, and that name. Tests stand on the roof."""
    if path.endswith("_test.cpp"):
        return len(floors) - 1, "tests"
    fitting = [(len(name), level, name) for level, names in enumerate(floors) for name in names
               if path == name or path.startswith(name + "/")]
    if not fitting:
        return None
    return max(fitting)[1:]


def includes(root):
    """All includes between files of the project: (file, file included), by their paths from its top."""
    for folder in ("core", "render", "walkthroughs", "tests"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".hpp", ".cpp"):
                continue
            for quote, name in re.findall(r'^\s*#\s*include\s*(["<])([^">]+)[">]', file.read_text(), re.MULTILINE):
                beside, below_top = file.parent / name, root / name
                if quote == "<" and not below_top.is_file():
                    continue
                found = beside if beside.is_file() else below_top
                yield file.relative_to(root).as_posix(), found.relative_to(root).as_posix(), found.is_file()


def unit(path):
    return path.rsplit(".", 1)[0]


def circle(edges):
    """The files along one circle of units, or an empty list."""
    names, done, way = {}, set(), []
    for a, b in edges:
        if unit(a) != unit(b):
            names.setdefault(unit(a), {}).setdefault(unit(b), (a, b))

    def visit(at):
        if at in way:
            return way[way.index(at):]
        if at in done:
            return []
        way.append(at)
        for after in names.get(at, {}):
            if found := visit(after):
                return found
        way.pop()
        done.add(at)
        return []

    for start in sorted(names):
        if found := visit(start):
            return [names[a][b] for a, b in zip(found, found[1:] + found[:1])]
    return []


def missing_in_map(root):
    """Folders of the project that the README's map does not name."""
    readme = (root / "README.md").read_text() if (root / "README.md").is_file() else None
    rooms = [folder.relative_to(root).as_posix() for folder in sorted((root / "walkthroughs").glob("*/"))]
    if readme is None:
        return []
    return [f"README.md: the map does not name {room}" for room in ["core", "render", *rooms, "tests", "tests/study"]
            if not re.search(rf"^\| (\[{room}\]|`{room}`)", readme, re.MULTILINE)]


def boost_elsewhere(root):
    """Headers of the core that need Boost, and should not."""
    for file in sorted((root / "core").glob("*.hpp")):
        name, text = file.relative_to(root).as_posix(), file.read_text()
        needed = re.findall(r'^\s*#\s*include\s*[<"](boost/[^>"]+|certified\w*\.hpp|certificate_check\.hpp)', text, re.MULTILINE)
        if needed and name not in proving:
            yield f"{name} includes {needed[0]}: Boost is for {' and '.join(proving)} alone"


def problems(root):
    edges, found = [], missing_in_map(root) + list(boost_elsewhere(root))
    for file, included, is_there in includes(root):
        if not is_there:
            found.append(f"{file} includes {included}, which is not there")
            continue
        edges.append((file, included))
        low, high = floor_of(included), floor_of(file)
        if not low or not high:
            found.append(f"{file} includes {included}: name the folder of both in {pathlib.Path(__file__).name}")
        elif low[0] > high[0]:
            found.append(f"{file} includes {included}, which lies above it")
        elif low[0] == high[0] and low[1] != high[1] and not high[1].startswith("tests"):
            found.append(f"{file} includes {included}, and {high[1]} must not know {low[1]}")
    if ring := circle(edges):
        found.append("a circle: " + ", ".join(f"{a} includes {b}" for a, b in ring))
    return found


class OneMistakeEach(unittest.TestCase):
    def told(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return problems(root)

    def test_down_is_fine(self):
        self.assertEqual(self.told({"core/a.hpp": "", "walkthroughs/text/b.cpp": '#include "core/a.hpp"\n',
                                    "core/c.hpp": '#include "a.hpp"\n'}), [])

    def test_up(self):
        said = self.told({"walkthroughs/model/a.cpp": '#include "walkthroughs/text/b.hpp"\n',
                          "walkthroughs/text/b.hpp": ""})
        self.assertEqual(said, ["walkthroughs/model/a.cpp includes walkthroughs/text/b.hpp, which lies above it"])

    def test_every_spelling(self):
        for line in ('#include <walkthroughs/text/b.hpp>', '# include "walkthroughs/text/b.hpp"'):
            said = self.told({"core/a.hpp": "#include <vector>\n" + line + "\n", "walkthroughs/text/b.hpp": ""})
            self.assertEqual(said, ["core/a.hpp includes walkthroughs/text/b.hpp, which lies above it"])

    def test_boost_in_the_core(self):
        certified = {"core/certified.hpp": "#include <boost/multiprecision/cpp_int.hpp>\n"}
        self.assertEqual(self.told(certified), [])
        for line in ("#include <boost/rational.hpp>", '#include "certified.hpp"'):
            said = self.told({**certified, "core/gjk.hpp": f"#pragma once\n{line}\n"})
            self.assertEqual(len(said), 1)
            self.assertIn("Boost is for core/certified.hpp and", said[0])

    def test_core_and_render(self):
        for one, other in (("core", "render"), ("render", "core")):
            said = self.told({f"{one}/a.hpp": f'#include "{other}/b.hpp"\n', f"{other}/b.hpp": ""})
            self.assertEqual(said, [f"{one}/a.hpp includes {other}/b.hpp, and {one} must not know {other}"])

    def test_circle(self):
        said = self.told({"core/a.hpp": "", "core/a.cpp": '#include "b.hpp"\n', "core/b.hpp": "",
                          "core/b.cpp": '#include "c.hpp"\n', "core/c.hpp": '#include "a.hpp"\n'})
        self.assertEqual(said, ["a circle: core/a.cpp includes core/b.hpp, core/b.cpp includes core/c.hpp, "
                                "core/c.hpp includes core/a.hpp"])

    def test_room_that_the_map_lacks(self):
        said = self.told({"README.md": "| `core` | x |\n| `render` | x |\n| [tests](t) | x |\n| [tests/study](t) | x |\n",
                          "walkthroughs/model/a.hpp": ""})
        self.assertEqual(said, ["README.md: the map does not name walkthroughs/model"])

    def test_missing_and_unknown(self):
        self.assertIn("which is not there", self.told({"core/a.hpp": '#include "core/b.hpp"\n'})[0])
        said = self.told({"walkthroughs/new/a.hpp": '#include "core/b.hpp"\n', "core/b.hpp": ""})
        self.assertIn("name the folder of both", said[0])


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=0)
    found = problems(pathlib.Path(__file__).resolve().parents[1])
    print("\n".join(found) if found else "includes run one way")
    sys.exit(bool(found) or not outcome.result.wasSuccessful())
