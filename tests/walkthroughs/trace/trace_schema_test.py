"""The schema that gjkstep prints is one, its traces keep to it, and damaged ones do not.

    python3 trace_schema_test.py GJKSTEP FOLDER_OF_TRACES
"""
import copy
import json
import pathlib
import subprocess
import sys

import jsonschema

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def output(*arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def lines_of(text):
    return [json.loads(line) for line in text.splitlines()]


def damaged(line):
    """Each object in the line without one of its keys, with a key more, and each of its values of another type."""
    yield from ({**line, "more": 1}, [line], None)
    for key, value in line.items():
        if key not in may_be_missing:
            yield {k: v for k, v in line.items() if k != key}
        yield {**line, key: {"of": "another type"}}
        if isinstance(value, str) and key not in free_words:
            yield {**line, key: value + "?"}
        if isinstance(value, list) and len(value) == 3 and isinstance(value[0], float):
            yield {**line, key: value[:2]}
            yield {**line, key: ["a number", *value[1:]]}
        if isinstance(value, dict):
            yield from ({**line, key: inner} for inner in damaged(value))


free_words = {"scene", "region", "dropped", "why", "reason", "name", "title", "source", "summary", "text", "support", "crossing", "direction"}
may_be_missing = {"region", "face", "formula", "normal", "value", "relation", "index", "pose", "remarks", "close_up", "separation", "nearest", "gap", "of_decimals", "by_rounded_turn", "exchanged"}

schema = json.loads(output("trace", "--schema"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

valid = refused = 0
names = [line.split()[0] for line in output("list").splitlines() if line.strip()]
texts = {name: subprocess.run([program, "trace", name], capture_output=True, text=True) for name in names}
for name, result in texts.items():
    if result.returncode != 0:
        assert "diagram" in result.stderr, (name, result.stderr)
        continue
    for number, line in enumerate(lines_of(result.stdout), 1):
        errors = [error.message[:200] for error in validator.iter_errors(line)]
        assert not errors, (name, number, errors)
        valid += 1
for file in sorted(folder.glob("ok-*.jsonl")):
    for number, line in enumerate(lines_of(file.read_text()), 1):
        assert validator.is_valid(line), (file.name, number)
        valid += 1

for name in ("as-printed-spheres", "regions/2-simplex-r3", "failures/coplanar-askew"):
    for number, line in enumerate(lines_of(texts[name].stdout), 1):
        for wrong in damaged(line):
            assert not validator.is_valid(wrong), (name, number, wrong)
            refused += 1
header = lines_of((folder / "ok-sums.jsonl").read_text())[0]
for damage in (lambda o: o.pop("name"), lambda o: o.update(more=1), lambda o: o.update(points=[[0, 0, 0]]),
               lambda o: o["sum"].pop(), lambda o: o["sum"].append(o["sum"][0]), lambda o: o["sum"][0].clear(),
               lambda o: o["sum"][0].update(name="a summand has none"), lambda o: o["sum"][0].update(pose={}),
               lambda o: o["sum"][1]["sphere"].pop("radius"), lambda o: o["sum"][1]["sphere"].update(radius=-1)):
    wrong = copy.deepcopy(header)
    damage(wrong["scenes"][0]["a"])
    assert not validator.is_valid(wrong), wrong["scenes"][0]["a"]
    refused += 1
for file in ("bad-sum-of-one", "bad-version-1", "bad-version-4", "bad-name-elsewhere", "bad-unknown-key", "bad-infinite-scene"):
    lines = lines_of((folder / (file + ".jsonl")).read_text())
    assert not all(validator.is_valid(line) for line in lines), file

assert valid > 1500 and refused > 300, (valid, refused)
print(f"{valid} lines are valid, {refused} damaged ones are not")
