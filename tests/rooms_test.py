#!/usr/bin/env python3
"""The README names every room; includes run one way: no folder knows one above it, no unit (foo.hpp with foo.cpp) includes itself in
a circle; a room opens its own namespace; and no code reads in a sentence what an event knows as a value.

    python3 tests/rooms_test.py
"""
import pathlib, re, sys

root = pathlib.Path(__file__).resolve().parents[1]

# The rooms of the walkthroughs in their order, as namespaces see each other.
rooms = re.findall(r"^namespace walkthroughs::(\w+)", (root / "walkthroughs/rooms.hpp").read_text(), re.MULTILINE)

# The floors, lowest first. A file may include what stands on its own line or above it in this list; folders on one line
# do not know each other. Whatever is in a folder named here belongs to its line.
floors = [
    ["core", "render"],
    ["core/certified"],
    ["walkthroughs/rooms.hpp"],
    *[[f"walkthroughs/{room}"] for room in rooms],
    ["tests/kit"],
    ["tests/core", "tests/render"],
    ["tests/walkthroughs"],  # what its tests share
    ["tests/study/pairs"],
    ["tests/study/truth"],
    ["tests/study/methods"],
    ["tests/study/sweep"],
    ["tests/study/claims"],
    ["tests/study/corpus"],
    ["tests/study/program"],
    ["tests/study"],
    ["tests/golden", "tests/bench", "tests/fuzz", "tests"],
]


# Headers that need Boost, too; who includes others of the core needs Eigen only.
proving = [f"core/certified/{name}.hpp" for name in ("certified", "moving", "exact_fallback", "telling", "grown", "check", "check_grown", "dyadic",
                                                      "fraction", "boost_whole_numbers")]


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
    """Folders of the project that the map does not name."""
    readme = (root / "walkthroughs/README.md").read_text()
    rooms = [folder.relative_to(root).as_posix() for folder in sorted((root / "walkthroughs").glob("*/"))]
    return [f"walkthroughs/README.md: the map does not name {room}" for room in ["core", "render", *rooms, "tests", "tests/study"]
            if not re.search(rf"^\| (\[{room}\]|`{room}`)", readme, re.MULTILINE)]


def boost_elsewhere(root):
    """Headers of the core that need Boost, and should not."""
    for file in sorted((root / "core").rglob("*.hpp")):
        name, text = file.relative_to(root).as_posix(), file.read_text()
        needed = re.findall(r'^\s*#\s*include\s*[<"](boost/[^>"]+|(?:certified|exact_fallback|balls|check|fraction|boost_whole_numbers)\.hpp)', text, re.MULTILINE)
        if needed and name not in proving:
            yield f"{name} includes {needed[0]}: Boost is for {' and '.join(proving)} alone"


# Looks for an equation, the beginning of a line of code or a region in a text.
reads_sentence = re.compile(
    r'\b(?:text|caption|headline)\.(?:starts_with|contains)\(story|(find|find_first_of|substr|starts_with|ends_with)\("[^"]*( = |: |·|×|←|\bif\b|\belse\b|\bR[1-7])')


def sentences_read(root):
    """Lines that learn a fact from a sentence: from words that were made of values."""
    for room in ("core", "core/certified", "walkthroughs/model", "walkthroughs/story", "walkthroughs/picture", "walkthroughs/page"):
        for file in sorted((root / room).glob("*.?pp")):
            for number, line in enumerate(file.read_text().splitlines(), 1):
                if reads_sentence.search(line):
                    yield f"{file.relative_to(root).as_posix()}:{number} reads a sentence: {line.strip()}"


def told_again(root):
    """Lines that make a caption or run a search where a story has these already."""
    for file in sorted((root / "walkthroughs").rglob("*.cpp")):
        name, text = file.relative_to(root).as_posix(), file.read_text()
        made = len(re.findall(r"(?<![\w.>])caption\(", text))
        if name != "walkthroughs/story/captions.cpp" and made > (name == "walkthroughs/story/storyboard.cpp"):
            yield f"{name} makes a caption: what is said of each event is in Telling::said"
        if name.startswith("walkthroughs/page/") and re.search(r"(?<![\w.>])(tell|run)\(", text):
            yield f"{name} runs a search: its story has done that"


def elsewhere(root):
    """Files of a room that do not open its namespace."""
    for room in rooms:
        for file in sorted((root / "walkthroughs" / room).glob("*.?pp")):
            if not re.search(rf"^namespace walkthroughs::{room}\b", file.read_text(), re.MULTILINE) and file.name != "main.cpp":
                yield f"{file.relative_to(root).as_posix()} opens another namespace than walkthroughs::{room}"


def problems(root):
    edges, found = [], [*missing_in_map(root), *boost_elsewhere(root), *sentences_read(root), *told_again(root), *elsewhere(root)]
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


if __name__ == "__main__":
    found = problems(root)
    print("\n".join(found) if found else "includes run one way")
    sys.exit(bool(found))
