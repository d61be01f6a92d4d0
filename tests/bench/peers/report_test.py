#!/usr/bin/env python3
"""The tables and sentences of numbers that were made up, with a family each for what can be said or not."""
import sys, unittest
sys.dont_write_bytecode = True
import report

columns = "part,family,pairs,timed,meet,lost,contender,is_peer,borrows,proves,ns,false_positives,false_negatives,undecided,failed,not_asked,first_failure"
contenders = [("gjkstep", 0, 0, ""), ("gjkstep eager", 0, 0, ""), ("certified", 0, 0, "gjkstep"), ("CGAL exact", 0, 0, ""), ("other", 1, 0, ""),
              ('"other, ours"', 1, 1, "")]
nanoseconds = {"triangles": (1000, 900, 1060, 1049, 1680, 1470), "tetrahedra": (100, 90, 107, 428, 162, 147), "hulls-8": (100, 90, 103, 0, 150, 135),
               "askew": (100, 90, 900, 0, 150, 135), "spheres": (100, 90, 0, 0, 85, 80)}


def line(family, time, name, is_peer, borrows, proves):
    wrong = (1, 2, 3, 4, 0, "pair 17: crashed") if family == "askew" and is_peer else (0, 0, 0, 0, 0 if time else 10, "")
    lost = 7 if family == "askew" else 0
    return ",".join(map(str, ("Part", family, 10, 9, 5, lost, name, is_peer, borrows, proves, time, *wrong))) + "\n"


made_up = ["# seed: 7\n", columns + "\n", *(line(family, time, *who) for family, row in nanoseconds.items() for time, who in zip(row, contenders))]
expected = """
## Part

| ns per query | pairs | timed | gjkstep | gjkstep eager | certified | CGAL exact | other | other, ours | fastest peer ÷ gjkstep | fastest peer ÷ gjkstep eager | fastest no worse ÷ gjkstep | fastest no worse ÷ gjkstep eager |
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|
| triangles | 10 | 9 | 1000 | 900 | 1060 | 1049 | 1680 | 1470 | 1.47 | 1.63 | 1.47 | 1.63 |
| tetrahedra | 10 | 9 | 100 | 90 | 107 | 428 | 162 | 147 | 1.47 | 1.63 | 1.47 | 1.63 |
| hulls-8 | 10 | 9 | 100 | 90 | 103 | – | 150 | 135 | 1.35 | 1.50 | 1.35 | 1.50 |
| askew | 10 | 9 | 100 | 90 | 900 | – | 150 | 135 | 1.35 | 1.50 | – | – |
| spheres | 10 | 9 | 100 | 90 | – | – | 85 | 80 | 0.80 | 0.89 | 0.80 | 0.89 |

| wrong answers | meet | gjkstep | gjkstep eager | certified | CGAL exact | other | other, ours | a peer right, gjkstep not |
|---|---:|---:|---:|---:|---:|---:|---:|---:|
| triangles | 5 | 0 | 0 | 0 | 0 | 0 | 0 | 0 |
| tetrahedra | 5 | 0 | 0 | 0 | 0 | 0 | 0 | 0 |
| hulls-8 | 5 | 0 | 0 | 0 | 10 not asked | 0 | 0 | 0 |
| askew | 5 | 0 | 0 | 0 | 10 not asked | 1+ 2− 3? 4! | 1+ 2− 3? 4! | 7 |
| spheres | 5 | 0 | 0 | 10 not asked | 10 not asked | 0 | 0 | 0 |

| what a proof costs | certified ÷ gjkstep | CGAL exact ÷ certified | fastest peer ÷ certified | fastest as it comes ÷ certified |
|---|---:|---:|---:|---:|
| triangles | 1.06 | 0.99 | 1.39 | 1.58 |
| tetrahedra | 1.07 | 4.00 | 1.37 | 1.51 |
| hulls-8 | 1.03 | – | 1.31 | 1.46 |
| askew | 9.00 | – | 0.15 | 0.17 |
| spheres | – | – | – | – |

* gjkstep is at least 1.5 times as fast as the fastest peer on: none. Less on: triangles (1.47), tetrahedra (1.47), hulls-8 (1.35)
* gjkstep eager is at least 1.5 times as fast as the fastest peer on: triangles (1.63), tetrahedra (1.63), hulls-8 (1.50), askew (1.50)
* certified is at least 1.5 times as fast as the fastest peer on: none. Less on: triangles (1.39), tetrahedra (1.37), hulls-8 (1.31)
* certified is at least 1.5 times as fast as the fastest peer as it comes on: triangles (1.58), tetrahedra (1.51). Less on: hulls-8 (1.46)
* certified ÷ gjkstep is within the aim on: triangles (1.060, aim 1.06), hulls-8 (1.030, aim 1.03). Above it on: tetrahedra (1.070, aim
  1.06)
* certified is at least as fast as CGAL exact on: tetrahedra (4.00, aim 5.0). Slower on: triangles (0.99)
* A peer is right and gjkstep is not, about pairs of: askew (7)
* other, askew, pair 17: crashed
* other, ours, askew, pair 17: crashed
"""


class OfMadeUpNumbers(unittest.TestCase):
    maxDiff = None

    def test_tables_and_aims(self):
        text = report.page(made_up)
        self.assertIn("* seed: 7\n", text)
        self.assertEqual(text[text.index("\n## "):], expected)

    def test_nothing_is_said_of_proofs_where_nobody_proves_anything(self):
        self.assertNotIn("proof", report.page([row for row in made_up if ",certified," not in row]))


if __name__ == "__main__":
    unittest.main()
