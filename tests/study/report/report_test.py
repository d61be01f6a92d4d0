#!/usr/bin/env python3
"""What gjkstep-study counts, and the tables and pictures that are made of it, held against ../golden; and shards against one run.

    python3 tests/study/report/report_test.py build/gjkstep-study
    python3 tests/study/report/report_test.py build/gjkstep-study --accept   # writes ../golden anew: look at the difference before you commit it
"""
import contextlib, io, pathlib, re, shutil, subprocess, sys, tempfile, unittest
from unittest import mock
sys.dont_write_bytecode = True
import claims, data, pictures, report, tables
from data import Rate, Refused, Study

here = pathlib.Path(__file__).resolve().parent


def run_study(*words):
    subprocess.run([program, *map(str, words)], check=True, capture_output=True)


class InFolder(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def report(self, *words):
        with mock.patch("sys.argv", ["report.py", *map(str, words)]), contextlib.redirect_stdout(io.StringIO()) as told:
            report.main()
        return told.getvalue().split()


class Goldens(InFolder):
    def check(self, name, text):
        golden = here.parent / "golden" / name
        if accept:
            golden.write_text(text)
        self.assertEqual(golden.read_text(), text, f"{name}: report_test.py with --accept makes it anew")

    def test_claims_of_few_pairs(self):
        run_study("claims", "--pairs", 6000, "--out", self.folder)
        self.assertEqual(self.report(self.folder), [str(self.folder / "claims.md")])
        self.assertNotIn("{{", (self.folder / "claims.md").read_text())
        for name in ("claims-effort.csv", "claims-moller.csv", "claims-mistakes.csv"):
            self.check(name, re.sub("# compiler: .*\n", "", (self.folder / name).read_text()))

    def test_the_text_that_is_kept_is_that_of_the_counts_that_are_kept(self):
        results = here.parent / "results"
        self.assertEqual(claims.claims_md(results), (results / "claims.md").read_text(), "tests/study/report/report.py tests/study/results makes it anew")

    def test_tables_and_pictures_of_few_pairs(self):
        """Some apart, some touching, some in doubt, and all that there are of a family; the times are made up: float is slower."""
        run_study("run", "--pairs", 100, "--seed", 3, "--families", "triangles,touching-face-askew,cylinders-gap-1e-12,cycles",
                  "--scalar", "float,double,exact", "--limit", "5,20", "--out", self.folder)
        for file in self.folder.iterdir():
            made = {"version": "gjkstep-study 9", "compiler": "GNU 12.2.0 -O3", "processor": "Abacus, 1 thread"}
            text = re.sub("# (version|compiler|processor): .*", lambda match: f"# {match[1]}: {made[match[1]]}", file.read_text())
            if file.name == "timings.csv":
                text = re.sub(r"(.*),(\d+),\d+\n", lambda row: f"{row[1]},{row[2]},{int(row[2]) * (len(row[1]) + 100 * ('float' in row[1]))}\n", text)
            if file.name == "alone.csv":
                text = re.sub(r"(.*exact),(\d+),\d+,(\d+),\d+,\d+,\d+\n", r"\1,\2,20000,\3,90000,4321,7\n", text)
            file.write_text(text)
        study = Study([self.folder])
        for name, text_of in report.texts.items():
            self.check(name, text_of(study))
        for name, script_of in report.drawn.items():
            self.check(name.replace(".png", ".gnuplot"), script_of(study))

    def test_a_study_of_certified_answers_alone_has_tables_of_these(self):
        run_study("run", "--pairs", 20, "--families", "triangles", "--rules", "certified,certified-eager", "--scalar", "double", "--out", self.folder)
        study = Study([self.folder])
        self.assertIn("says otherwise: double, rules certified.\nCertified answers", tables.tables_md(study))
        self.assertIn("Certified answers have no limit.", tables.settings_md(study))
        self.assertIn("title 'certified: 0 of 20 wrong or undecided'", pictures.error_vs_time(study))
        self.assertIn("\n$data << EOD\n", pictures.iterations(study))


class Shards(InFolder):
    def setUp(self):
        super().setUp()
        self.small = ["run", "--pairs", 40, "--families", "triangles,cycles,spheres", "--rules", "as-intended,certified", "--seed", 5, "--out"]
        for shard in ("0/2", "1/2"):
            run_study(*self.small, self.folder / "parts", "--shard", shard)
        self.shards = [self.folder / f"parts/shard-{i}-of-2" for i in (0, 1)]

    def refused(self, folders):
        with self.assertRaises(Refused) as raised:
            Study(folders)
        return str(raised.exception)

    def changed(self, old, new):
        """The second shard with other words in its files."""
        folder = self.folder / "changed"
        shutil.copytree(self.shards[1], folder, dirs_exist_ok=True)
        for file in folder.iterdir():
            file.write_text(re.sub(old, new, file.read_text()))
        return folder

    def test_they_are_one_run_byte_for_byte(self):
        run_study(*self.small, self.folder / "one")
        self.assertEqual(len(self.report(self.folder / "one")), 8)
        self.report(*self.shards, "--out", self.folder / "both")
        for name in ("tables.md", "errors.md", "settings.md", "heat-map.png", "iterations.png"):
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "both" / name).read_bytes(), name)

    def test_times_add_up_and_the_slowest_pair_is_that_of_the_larger_time(self):
        slow, quick = {"ns": 2, "slowest_nanoseconds": 9, "slowest_pair": 4}, {"ns": 3, "slowest_nanoseconds": 7, "slowest_pair": 8}
        for one, other in ((slow, quick), (quick, slow)):
            total = dict(one)
            data.add(total, other)
            self.assertEqual(total, {"ns": 5, "slowest_nanoseconds": 9, "slowest_pair": 4})

    def test_a_shard_may_have_no_pair_of_a_family(self):
        few = self.folder / "few"
        for shard in ("0/2", "1/2"):
            run_study("run", "--pairs", 1, "--families", "triangles", "--rules", "as-intended", "--out", few, "--shard", shard)
        shards = sorted(few.iterdir())
        for folders in (shards, shards[::-1]):
            study = Study(folders)
            self.assertGreater(study.nanoseconds("triangles", study.usual), 0)

    def test_what_does_not_go_together_is_told_by_name(self):
        first, second = self.shards
        self.assertRegex(self.refused([first]), "shard 1 of 2 is missing; make it with: gjkstep-study run --pairs 40 .* --shard 1/2")
        self.assertIn("shard 0 of 2 and shard 0 of 2, which is there twice", self.refused([first, first, second]))
        for what in ("seed", "version", "compiler", "command"):
            self.assertRegex(self.refused([first, self.changed(f"# {what}: .*", f"# {what}: other")]),
                             f"0-of-2/counts.csv and .*changed/counts.csv do not go together: {what} is '")
        self.assertIn("shard 0 of 2 and shard 1 of 3", self.refused([first, self.changed("1 of 2", "1 of 3")]))
        self.assertIn("their rows differ", self.refused([first, self.changed("certified,", "sure,")]))

    def test_what_is_missing_cut_off_or_no_csv_of_the_study_is_told_by_name(self):
        file = self.shards[1] / "timings.csv"
        whole = file.read_text()
        for text in ("", "nonsense\n", whole[:-9], re.sub(r"\d+\n$", "many\n", whole), whole + whole.splitlines()[-1] + "\n"):
            file.write_text(text)
            self.assertIn("timings.csv is damaged or none of gjkstep-study's", self.refused(self.shards))
        file.unlink()
        self.assertIn("timings.csv is missing: the run that writes it has not come to its end", self.refused(self.shards))


class Words(InFolder):
    def test_a_verdict_tells_at_how_many_places_a_claim_holds_and_names_the_fewer_ones(self):
        for strength, measured, expected in (
                ("always", {"boxes": (10000, 10000)}, "**holds** at 1 of 1"),
                ("always", {"boxes": (9999, 10000)}, "rare exceptions (under 1 %) at 1 of 1"),
                ("always", {"boxes": (9800, 10000)}, "**fails** at 1 of 1"),
                ("nearly always", {"boxes": (9999, 10000)}, "**holds** at 1 of 1"),
                ("usually", {"boxes": (4000, 10000)}, "**fails** at 1 of 1"),
                ("all but few", {"boxes": (999_997, 1_000_000), "cans": (999_900, 1_000_000)}, "**holds** at 1 of 2: boxes; **fails** at 1 of 2: cans"),
                ("always", {"boxes": (5000, 5000), "hulls": (5000, 5000), "needles": (4, 5), "spheres": (0, 0)},
                 "**holds** at 2 of 3; **fails** at 1 of 3: needles"),
                ("always", {"boxes": (0, 0)}, "nothing to look at"),
                # What few cases leave open is said with the reason.
                ("always", {"boxes": (380, 380), "hulls": (381, 381)}, "**holds** at 1 of 2: hulls; left open at 1 of 2: boxes (only 380 cases)"),
                ("always", {"boxes": (1, 1)}, "left open at 1 of 1: boxes (only 1 case)"),
                ("always", {"boxes": (3, 3, True)}, "**holds** at 1 of 1"),  # all that there are
                ("usually", {"boxes": (500, 1000)}, "left open at 1 of 1: boxes (50 % lies within the interval)")):
            self.assertEqual(claims.verdict(strength, {place: Rate(*rate) for place, rate in measured.items()}), expected)

    def test_a_picture_is_drawn_in_place_of_the_one_before_or_not_at_all(self):
        file = self.folder / "x.png"
        file.write_text("of other data")
        self.assertTrue(pictures.draw(file, "set terminal png\nplot x\n"))
        self.assertEqual(file.read_bytes()[:4], b"\x89PNG")
        self.assertFalse(pictures.draw(file, "set terminal png\nno such command\n"))
        self.assertFalse(file.exists())


if __name__ == "__main__":
    accept = "--accept" in sys.argv and not sys.argv.remove("--accept")
    program = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
