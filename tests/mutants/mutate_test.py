#!/usr/bin/env python3
"""mutate.py --check names each mutant that cannot be made; made.py makes those of its kinds, and no others."""
import pathlib, subprocess, sys, tempfile

sys.dont_write_bytecode = True
import made

here = pathlib.Path(__file__).resolve().parent
sound = "core/rules.hpp | step.keep_all(AO) | step.keep_all(-AO) | it points away"
damaged = {
    'core/rules.hpp | step.skip_beyond_A("R2") | step.skip_beyond_A("R3") | once too often': "is 2 times in core/rules.hpp",
    "core/rules.hpp | nowhere to be found | x | gone": "'nowhere to be found' is 0 times",
    "core/no_rules.hpp | a | b | no file": "there is no file core/no_rules.hpp",
    "core/rules.hpp | step.keep_all(AO) | step.keep_all(AO) | the same": "changes nothing",
    "core/rules.hpp | X.cross(Y) | three parts": "has 3 parts instead of 4",
}


def check(lines):
    with tempfile.TemporaryDirectory(prefix="gjkstep-mutants-") as folder:
        listed = pathlib.Path(folder, "mutants.txt")
        listed.write_text("# a comment\n\n" + "\n".join(lines) + "\n")
        command = [sys.executable, here / "mutate.py", "--check", listed]
        return subprocess.run(command, capture_output=True, text=True, check=False)


failures = []
outcome = check([sound])
if outcome.returncode != 0 or outcome.stdout != "1 mutants can be made\n":
    failures.append(f"a sound mutant is refused: {outcome.stdout}{outcome.stderr}")
outcome = check([sound, *damaged])
for number, (line, reason) in enumerate(damaged.items(), 4):  # behind a comment, a blank line and the sound one
    said = [text for text in outcome.stderr.splitlines() if f"mutants.txt:{number}: " in text and reason in text]
    if outcome.returncode != 1 or not said or "    " + line not in outcome.stderr.splitlines():
        failures.append(f"not told: {line}\n{outcome.stderr}")
text = """#include "a < b.hpp"
/// if (a < b) && c
int f(const Box<int>& box, int n) {
  if (n < 3 && !box.empty()) return -1;
  std::string words = "a < b" + name(1.05, n);
  box.grow(n, 2);
  return x - 10;  // 3 < 4
}
"""
expected = {
    ("comparison", "if (n <= 3 && !box.empty()) return -1;"), ("comparison", "if (n >= 3 && !box.empty()) return -1;"),
    ("operator", "if (n < 3 || !box.empty()) return -1;"), ("negation", "if (n < 3 && box.empty()) return -1;"),
    ("constant", "if (n < 4 && !box.empty()) return -1;"), ("constant", "if (n < 2 && !box.empty()) return -1;"),
    ("guard", "if (false) return -1;"), ("guard", "if (!(n < 3 && !box.empty())) return -1;"),
    ("sign", "if (n < 3 && !box.empty()) return 1;"), ("constant", "if (n < 3 && !box.empty()) return -2;"),
    ("constant", "if (n < 3 && !box.empty()) return -0;"),
    ("arguments", 'std::string words = "a < b" + name(n, 1.05);'),
    ("constant", 'std::string words = "a < b" + name(1.06, n);'), ("constant", 'std::string words = "a < b" + name(1.04, n);'),
    ("arguments", "box.grow(2, n);"), ("constant", "box.grow(n, 3);"), ("constant", "box.grow(n, 1);"), ("statement", ";"),
    ("operator", "return x + 10; // 3 < 4"), ("constant", "return x - 11; // 3 < 4"), ("constant", "return x - 9; // 3 < 4"),
}
found = {(mutant.kind, mutant.new_line) for mutant in made.mutants_of("f.cpp", text)}
if found != expected:
    failures.append(f"made and should not be: {found - expected}\nnot made: {expected - found}")
for mutant in made.mutants_of("f.cpp", text):
    changed = text[:mutant.start] + mutant.new + text[mutant.end:]
    if " ".join(changed.splitlines()[mutant.line - 1].split()) != mutant.new_line:
        failures.append(f"told as another line than it makes: {mutant}")

many = made.mutants_of("f.cpp", text)
fewer = [mutant for mutant in many if mutant.line != 4]  # as where another line has changed
if not set(m.new_line for m in made.sample(fewer, 5, 7)) >= set(m.new_line for m in made.sample(many, 5, 7) if m.line != 4):
    failures.append("a change of one line draws other mutants of the others")
if made.sample(many, 5, 7) == made.sample(many, 5, 8):
    failures.append("another seed draws the same")

print("\n".join(failures))
sys.exit(1 if failures else 0)
