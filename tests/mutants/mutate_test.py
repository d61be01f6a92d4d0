#!/usr/bin/env python3
"""mutate.py --check must name each mutant that cannot be made."""
import pathlib, subprocess, sys, tempfile

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
print("\n".join(failures))
sys.exit(1 if failures else 0)
