#!/usr/bin/env python3
"""Small CSV files in, tables and pictures out; and what gjkstep-study writes in shards and at once.

    python3 tests/study/report/report_test.py build/gjkstep-study
"""
import collections, contextlib, io, pathlib, subprocess, sys, tempfile, unittest
from unittest import mock
sys.dont_write_bytecode = True
import claims, pictures, report, tables
from data import Rate, Refused, Study, percentile_99

head = "# command: gjkstep-study run --pairs 10\n# seed: 1\n# version: gjkstep-study 9\n# compiler: GNU 12.2.0 -O3\n# shard: 0 of 1\n"
columns = {
    "families": "family,pairs,slow_pairs,size,what",
    "counts": "family,rules,scalar,zero_test,limit,pairs,hits,false_positives,false_negatives,undecided,cycles,unusable,in_doubt,out_of_range,"
              "not_askable,truth_changed,exceptions,by_predicates,by_formulas,by_certificates,certificates,false_certificates",
    "iterations": "family,rules,scalar,zero_test,of,queries_by_iterations",
    "timings": "family,rules,scalar,zero_test,limit,queries,nanoseconds",
    "alone": "family,rules,scalar,zero_test,without_second_search,nanoseconds_without,with_second_search,nanoseconds_with,slowest_nanoseconds,"
             "slowest_pair",
}
# Ten pairs of one family, four of which meet; in double, and proven, where one took a second search of four iterations and one of eight.
rows = {
    "families": ['family,10,2,,"made up, by hand"'],
    "counts": ["family,as-intended,double,exact,5,10,4,1,1,6,1,1,0,0,0,0,0,7,0,3,0,0",
               "family,as-intended,double,exact,20,10,4,2,1,1,1,1,0,0,0,0,0,7,0,3,0,0",
               "family,certified,double,exact,none,10,4,0,0,0,0,0,0,0,0,0,0,10,0,0,7,0"],
    "iterations": ["family,as-intended,double,exact,hits,2:3 30:1", "family,as-intended,double,exact,misses,3:6",
                   "family,certified,double,exact,hits,25:4", "family,certified,double,exact,misses,25:6",
                   "family,certified,double,exact,second searches,0:8 4:1 8:1"],
    "timings": ["family,as-intended,double,exact,5,10,900", "family,as-intended,double,exact,20,10,1000",
                "family,certified,double,exact,none,10,1230"],
    "alone": ["family,certified,double,exact,8,1600,2,6002,4321,7"],
}


def replaced(name, line, **fields):
    """The rows of one file with fields of one of them, by name, replaced."""
    cells = dict(zip(columns[name].split(","), rows[name][line].split(","))) | fields
    return {name: [*rows[name][:line], ",".join(map(str, cells.values())), *rows[name][line + 1:]]}


class InFolder(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def written(self, name, change=lambda text: text, **changed):
        """A folder with the rows above in it but for those that are told."""
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        for file, lines in (rows | changed).items():
            made = head + ("# processor: Abacus, 1 thread\n" if file in ("timings", "alone") else "")
            (folder / f"{file}.csv").write_text(change("\n".join([made + columns[file], *lines, ""])))
        return folder

    def study(self, **changed):
        return Study([self.written("run", **changed)])

    def refused(self, folders):
        with self.assertRaises(Refused) as raised:
            Study(folders)
        return str(raised.exception)


class Tables(InFolder):
    def test_rates_have_their_interval_a_census_has_none(self):
        self.assertIn("\n| family | 0.4 (0.17 – 0.69) | 0 (< 0.28) |\n", tables.tables_md(self.study()))
        census = tables.tables_md(self.study(families=['family,10,2,10,"made up"']))
        self.assertIn("\n| family | 0.4 of all | 0 of all |\n", census)
        self.assertIn("| family | made up | 10, all | 2 | 0.4 | predicates 7, certificates 3 |", census)

    def test_iterations_are_those_within_the_limit(self):
        self.assertIn("\n| family | 6.50, 20, 20 | 3.00, 3, 3 | 8.8 |\n", tables.tables_md(self.study()))
        self.assertEqual([percentile_99(collections.Counter({2: 100 - n, 5: n})) for n in (1, 2)], [2, 5])

    def test_errors_are_shares_of_the_pairs_with_which_they_can_happen(self):
        text = tables.errors_md(self.study())
        self.assertIn("\n| family | 0.33 (0.097 – 0.7) | 0.25 (0.046 – 0.7) | 0.1 (0.018 – 0.4) |\n", text)
        self.assertIn("| 0.1 (0.018 – 0.4); 1 in circles; 1 without a direction | 0 (< 0.28) |", text)
        self.assertIn("\n## certified double\n\nNothing was seen in: family.\n", text)
        self.assertIn("\n| family | 0.2 (0.057 – 0.51) | no pairs | 0.1 (0.018 – 0.4) |\n",
                      tables.errors_md(self.study(**replaced("counts", 1, hits=0, false_negatives=0))))
        self.assertIn("\n## In double\n\nNothing was seen in: family.\n",
                      tables.errors_md(self.study(**replaced("counts", 1, hits=0, false_positives=0, false_negatives=0, undecided=0))))

    def test_settings_vary_rules_zero_tests_and_limits(self):
        text = tables.settings_md(self.study())
        self.assertIn("| family | as-intended | certified |\n| --- | --- | --- |\n| family | 0.4 (0.17 – 0.69) | 0 (< 0.28) |", text)
        self.assertIn("| family | double, exact |\n", text)
        self.assertIn("| family | at most 5 | at most 20 |\n| --- | --- | --- |\n| family | 0.6 (0.31 – 0.83) | 0.1 (0.018 – 0.4) |", text)

    def test_times_are_told_with_what_they_were_taken_on_and_why_float_is_not_faster_where_it_is_not(self):
        text = tables.timings_md(self.study())
        self.assertIn("Measured on Abacus, 1 thread, by", text)
        self.assertIn("| family | double, exact | certified double |\n| --- | --- | --- |\n| family | 100 | 123 |\n", text)
        both = {name: rows[name] + [line.replace("double", "float") for line in rows[name] if "intended" in line]
                for name in ("counts", "iterations", "timings")}
        self.assertIn("(family: 4.40 in float, 4.40 in double)", tables.timings_md(self.study(**both)))
        both["timings"][-1] = "family,as-intended,float,exact,20,10,999"
        self.assertNotIn("Float is not", tables.timings_md(self.study(**both)))
        both["timings"][-1] = "family,as-intended,float,exact,20,10,1000"
        study = Study([self.written("other", lambda text: text.replace("GNU 12", "Clang 17"), **both)])  # of which nothing was measured
        self.assertNotIn("Float is not", tables.timings_md(study))

    def test_certified_answers_tell_what_they_are_worth_and_what_they_take(self):
        text = tables.certified_md(self.study())
        self.assertIn("\n10 pairs: 0 wrong, 0 undecided. 7 certificates, those of the first pairs of each family, were multiplied out in fractions: all "
                      "hold. 0.2 of the pairs took a second search, of 6.00 iterations in the mean and 8 at most. Without it a query took 200 ns. With it a "
                      "query took 3001 ns. The slowest, pair 7 of family, took 4.3 µs.\n", text)
        self.assertIn("\n| family | 10 | 0 | 0 | 0.2 | 6.00, 8 | 200 | 3001 | 4.3: 7 |\n", text)
        wrong = tables.certified_md(self.study(**replaced("counts", 2, false_positives=1, undecided=2, false_certificates=2)))
        self.assertRegex(wrong, "\n10 pairs: 1 wrong, 2 undecided. 7 certificates, .* in fractions: 2 do not hold. ")
        self.assertIn("No pair was asked.", tables.certified_md(self.study(**replaced("counts", 2, pairs=0))))

    def test_a_study_of_certified_answers_alone_has_tables_of_these(self):
        study = self.study(**{name: [line for line in lines if "intended" not in line] for name, lines in rows.items()})
        self.assertIn("says otherwise: double, rules certified. Certified answers", tables.tables_md(study))
        self.assertIn("Certified answers have no limit.", tables.settings_md(study))
        self.assertIn("set xrange [0:26]", pictures.iterations(study))


class Pictures(InFolder):
    def test_the_heat_map_tells_where_nothing_was_seen_how_much_that_says(self):
        text = pictures.heat_map(self.study())
        self.assertIn("set label '0.4' at 0,0 center front textcolor rgb '#FFFFFF'", text)
        self.assertIn("set label '<0.3' at 1,0 center front textcolor rgb '#666666'", text)  # the interval ends at 0.28
        for fields, words in (({"pairs": 0, "not_askable": 10}, "not asked"), ({"undecided": 5, "in_doubt": 5}, "0.5 in doubt"),
                              ({"undecided": 10, "in_doubt": 10}, "all in doubt"), ({"undecided": 5, "in_doubt": 5, "false_positives": 1}, "0.6")):
            self.assertIn(f"set label '{words}' at 1,0", pictures.heat_map(self.study(**replaced("counts", 2, **fields))))

    def test_points_are_means_of_families_and_certified_ones_stand_on_zero_with_their_number(self):
        text = pictures.error_vs_time(self.study())
        curves = "$curve0 << EOD\n90 0.8\n100 0.4\nEOD\n$curve1 << EOD\n123 0\nEOD\n"
        self.assertIn(curves, text)
        two = {name: lines + [line.replace("family,", "other,") for line in lines] for name, lines in rows.items()}
        self.assertIn(curves, pictures.error_vs_time(self.study(**two)))
        self.assertIn("title 'certified: 0 of 10 wrong or undecided'", text)
        self.assertEqual([line.split("'")[1] for line in text.splitlines() if line.startswith("set label") and "graph" in line], ["0 wrong", "5", "20"])

    def test_families_that_say_nothing_about_all_settings_are_left_out(self):
        for fields in ({"pairs": 0}, {"truth_changed": 2}):
            self.assertIn("no family was asked in every setting", pictures.error_vs_time(self.study(**replaced("counts", 1, **fields))))

    def test_iterations_are_shares_of_hits_and_of_misses(self):
        self.assertIn("\n1 0 0\n2 0.75 0\n3 0 1\n4 0 0\n", pictures.iterations(self.study()))

    def test_labels_keep_clear_of_each_other(self):
        labels = pictures.Labels([(0.5, 0.5)])
        self.assertIn("at graph 0.5,0.545 ", labels.place("5", 0.5, 0.5, "above left"))
        self.assertIn("at graph 0.447,0.5 ", labels.place("5", 0.5, 0.5, "above left"))
        self.assertEqual(labels.place("5", 0.5, 0.5, "above left"), "")

    def test_a_picture_is_drawn_in_place_of_the_one_before_or_not_at_all(self):
        file = self.folder / "x.png"
        file.write_text("of other data")
        self.assertTrue(pictures.draw(file, "set terminal png\nplot x\n"))
        self.assertEqual(file.read_bytes()[:4], b"\x89PNG")
        self.assertFalse(pictures.draw(file, "set terminal png\nno such command\n"))
        self.assertFalse(file.exists())


class Shards(InFolder):
    def shards(self, change=lambda text: text):
        """Two, the second of which is changed."""
        return [self.written("s0", lambda text: text.replace("0 of 1", "0 of 2")),
                self.written("s1", lambda text: change(text.replace("0 of 1", "1 of 2")))]

    def test_counts_add_up_and_the_slowest_pair_is_that_of_the_larger_time(self):
        study = Study(self.shards(lambda text: text.replace("4321,7", "5000,9")))
        setting = study.certified()["certified double"]
        self.assertEqual(study.counts("family", study.usual)["pairs"], 20)
        self.assertEqual(study.iterations("family", setting, "second searches"), {0: 16, 4: 2, 8: 2})
        self.assertEqual(study.nanoseconds("family", study.usual), 100)
        self.assertEqual(list(study.alone("family", setting).values()), [16, 3200, 4, 12004, 5000, 9])
        untimed = self.shards(lambda text: text.replace("family,as-intended,double,exact,20,10,1000\n", ""))  # a shard may have no pair of a family
        for folders in (untimed, untimed[::-1]):
            self.assertEqual(Study(folders).nanoseconds("family", study.usual), 100)

    def test_what_does_not_go_together_is_told_by_name(self):
        first, second = self.shards()
        self.assertIn("shard 1 of 2 is missing; make it with: gjkstep-study run --pairs 10 --shard 1/2", self.refused([first]))
        self.assertIn("counts.csv do not go together: both are shard 0 of 2", self.refused([first, first, second]))
        for what, old, new in (("seed", "seed: 1", "seed: 4"), ("version", "study 9", "study 8"), ("compiler", "12.2", "13"), ("command", "10\n", "11\n")):
            self.assertRegex(self.refused(self.shards(lambda text: text.replace(old, new))),
                             f"s0/counts.csv and .*s1/counts.csv do not go together: {what} is '")
        self.assertIn("shard 0 of 2 and shard 1 of 3", self.refused(self.shards(lambda text: text.replace("1 of 2", "1 of 3"))))
        self.assertIn("their rows differ", self.refused(self.shards(lambda text: text.replace("certified,", "sure,"))))

    def test_what_is_missing_cut_off_or_no_csv_of_the_study_is_told_by_name(self):
        folder = self.written("run")
        file = folder / "timings.csv"
        for text in ("", "nonsense\n", file.read_text()[:-9], file.read_text().replace("1000", "many"), file.read_text() + rows["timings"][0] + "\n"):
            file.write_text(text)
            self.assertIn("timings.csv is damaged or none of gjkstep-study's", self.refused([folder]))
        file.unlink()
        self.assertIn("timings.csv is missing: the run that writes it has not come to its end", self.refused([folder]))


class Claims(unittest.TestCase):
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

    def test_the_text_that_is_kept_is_that_of_the_counts_that_are_kept(self):
        results = pathlib.Path(__file__).resolve().parents[1] / "results"
        self.assertEqual(claims.claims_md(results), (results / "claims.md").read_text(), "tests/study/report/report.py tests/study/results makes it anew")

    def test_rates_are_told_with_as_many_digits_as_say_something(self):
        for rate, text in (((123, 1000), "12.3 % (10.4–14.5)"), ((0, 1000000), "0 (at most 3.84 per million)"), ((0, 0), "–"),
                           ((2, 1000000), "2 (0.548–7.29) per million"), ((999, 1000), "99.90 % (99.44–99.982)"), ((5, 5), "100 % (at least 56.6 %)")):
            self.assertEqual(claims.rate_text(Rate(*rate)), text)
        self.assertEqual(claims.joined(["a", "b", "c"]), "a, b and c")

    def test_of_a_mistake_it_is_told_how_many_pairs_show_it(self):
        self.assertEqual(claims.passes_text(Rate(1, 50), 100), "13.3 %")
        self.assertEqual(claims.passes_text(Rate(0, 1000), 100), "≥ 68.2 %")
        self.assertEqual(claims.needed_between(Rate(12, 1_000_000)), "250,000 (140,000–440,000)")
        self.assertEqual(claims.needed(Rate(0, 1_000_000)), "more than 780,000")


class WithTheProgram(InFolder):
    def run_study(self, *words):
        subprocess.run([program, *words], check=True, capture_output=True)

    def report(self, *words):
        with mock.patch("sys.argv", ["report.py", *map(str, words)]), contextlib.redirect_stdout(io.StringIO()) as told:
            report.main()
        return told.getvalue().split()

    def test_shards_are_one_run_byte_for_byte(self):
        small = ["run", "--pairs", "40", "--families", "triangles,cycles,spheres", "--scalar", "float,double", "--seed", "5", "--out"]
        self.run_study(*small, self.folder / "one")
        for shard in ("0/2", "1/2"):
            self.run_study(*small, self.folder / "parts", "--shard", shard)
        self.assertEqual(len(self.report(self.folder / "one")), 8)
        self.report(*(self.folder / "parts").iterdir(), "--out", self.folder / "both")
        for name in ("tables.md", "errors.md", "settings.md", "heat-map.png", "iterations.png"):
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "both" / name).read_bytes(), name)

    def test_claims_of_few_pairs_have_all_their_tables(self):
        self.run_study("claims", "--pairs", "500", "--out", self.folder)
        self.assertEqual(self.report(self.folder), [str(self.folder / "claims.md")])
        text = (self.folder / "claims.md").read_text()
        self.assertNotIn("{{", text)
        self.assertRegex(text, r"\| GJK “rarely needs more than 10” .* \| cycles: 0 % of all 48 \|")
        self.assertRegex(text, r"(?m)^\| M1 \| [0-9].* \|$")
        self.assertIn("\n| M21 | the origin in a face of the tetrahedron counts as outside | 3.2.4 | 0 | 0 |", text)


if __name__ == "__main__":
    program = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
    if not program:
        del WithTheProgram
    unittest.main()
