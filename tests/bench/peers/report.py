#!/usr/bin/env python3
"""Makes a page of what gjkstep-peers wrote.

    build/gjkstep-peers > peers.csv
    tests/bench/peers/report.py peers.csv > tests/bench/peers/results.md
"""
import csv, sys, textwrap

exact = "CGAL exact"  # a peer that is always right about what it can be asked
speed_aim = 1.5       # how many times as long the fastest peer is to take
exact_aim = 5         # and the exact one, about random tetrahedra
compared = 2          # contenders that have columns of their own: the plain call and the eager one, which stand first


def proof_aim(family):
    """How many times as long as its guess a proven answer may take; None where nothing is aimed at."""
    return 1.06 if family in ("triangles", "tetrahedra", "boxes") else 1.03 if family.startswith("hulls-") else None


def read(lines):
    """The lines of the head, and by title and family what each contender did."""
    head = [line[2:].rstrip("\n") for line in lines if line.startswith("# ")]
    parts = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("# ")):
        words = ("part", "family", "contender", "proves", "first_failure")
        numbers = {name: float(value) if name == "ns" else int(value) for name, value in row.items() if name not in words}
        parts.setdefault(row["part"], {}).setdefault(row["family"], {})[row["contender"]] = row | numbers
    return head, parts


# -- One family, by contender -----------------------------------------------------------------------------------------

def time(match, contender):
    """Nanoseconds a query; None where it was not timed, or is not there."""
    return match[contender]["ns"] or None if contender in match else None


def not_right(row):
    return sum(row[kind] for kind in ("false_positives", "false_negatives", "undecided", "failed", "not_asked"))


def fastest(rows, most_not_right=float("inf")):
    """The time of the fastest of those that have at most so many pairs not right."""
    return min((row["ns"] for row in rows if row["ns"] and not_right(row) <= most_not_right), default=None)


def fastest_peer(match, most_not_right=float("inf")):
    return fastest([row for row in match.values() if row["is_peer"]], most_not_right)


def fastest_as_it_comes(match):
    """The same of peers that have only what is their own."""
    return fastest([row for row in match.values() if row["is_peer"] and not row["borrows"]])


def quotient(one, other):
    return one / other if one and other else None


def mistakes(row):
    """"0", or what went wrong."""
    signs = {"false_positives": "+", "false_negatives": "−", "undecided": "?", "failed": "!", "not_asked": " not asked"}
    return " ".join(f"{row[kind]}{sign}" for kind, sign in signs.items() if row[kind]) or "0"


# -- Tables -----------------------------------------------------------------------------------------------------------

def number(value, digits=2):
    return "–" if value is None else f"{value:.{digits}f}"


def table(columns, rows):
    line = lambda cells: "".join(f"| {cell} " for cell in cells) + "|\n"
    return line(columns) + "|---" + "|---:" * (len(columns) - 1) + "|\n" + "".join(map(line, rows)) + "\n"


def times(matches, names):
    def row(family, match):
        ours = [match[name] for name in names[:compared]]
        return [family, ours[0]["pairs"], ours[0]["timed"], *(number(time(match, name), 0) for name in names),
                *(number(quotient(fastest_peer(match), row["ns"])) for row in ours),
                *(number(quotient(fastest_peer(match, not_right(row)), row["ns"])) for row in ours)]
    ratios = [f"{peer} ÷ {name}" for peer in ("fastest peer", "fastest no worse") for name in names[:compared]]
    return table(["ns per query", "pairs", "timed", *names, *ratios], [row(*each) for each in matches.items()])


def wrong_answers(matches, names):
    return table(["wrong answers", "meet", *names, "a peer right, gjkstep not"],
                 [[family, match[names[0]]["meet"], *(mistakes(match[name]) for name in names), match[names[0]]["lost"]]
                  for family, match in matches.items()])


def proofs(matches, provers):
    """Each prover beside what it proves, the exact peer and the fastest one."""
    def row(match):
        for name, guesser in provers.items():
            ours = time(match, name)
            yield from (quotient(ours, time(match, guesser)), quotient(time(match, exact), ours), quotient(fastest_peer(match), ours),
                        quotient(fastest_as_it_comes(match), ours))
    columns = [words for name, guesser in provers.items() for words in (f"{name} ÷ {guesser}", f"{exact} ÷ {name}", f"fastest peer ÷ {name}", f"fastest as it comes ÷ {name}")]
    return table(["what a proof costs", *columns], [[family, *map(number, row(match))] for family, match in matches.items()]) if provers else ""


# -- Aims -------------------------------------------------------------------------------------------------------------

def bullet(words):
    return textwrap.fill(f"* {words}", 140, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False) + "\n"


def parted(beginning, otherwise, judged):
    """`judged`: a family, what stands in brackets behind it, and whether it is as it should be; or None where nothing can be said."""
    lists = {holds: ", ".join(f"{family} ({words})" for family, words, met in filter(None, judged) if met == holds) for holds in (True, False)}
    if not any(lists.values()):
        return ""
    return bullet(f"{beginning} on: {lists[True] or 'none'}" + (f". {otherwise} on: {lists[False]}" if lists[False] else ""))


def beside_the_fastest(family, match, name, fastest=fastest_peer):
    """Families that nothing is aimed at are named where they reach it all the same."""
    ratio = quotient(fastest(match), time(match, name))
    return ratio and (ratio >= speed_aim or proof_aim(family)) and (family, number(ratio), ratio >= speed_aim)


def beside_the_guess(family, match, name, guesser):
    cost, most = quotient(time(match, name), time(match, guesser)), proof_aim(family)
    return cost and most and (family, f"{number(cost, 3)}, aim {number(most)}", cost <= most)


def beside_the_exact(family, match, name):
    ratio = quotient(time(match, exact), time(match, name))
    return ratio and (family, number(ratio) + (f", aim {exact_aim:.1f}" if family == "tetrahedra" else ""), ratio >= 1)


def aims(matches, names, provers):
    ours = [name for name in names if name != exact and not next(iter(matches.values()))[name]["is_peer"]]
    of_each = lambda judge, *of: [judge(family, match, *of) for family, match in matches.items()]
    lost = ", ".join(f"{family} ({match[names[0]]['lost']})" for family, match in matches.items() if match[names[0]]["lost"])
    return ("".join(parted(f"{name} is at least {speed_aim} times as fast as the fastest peer", "Less", of_each(beside_the_fastest, name))
                    for name in ours) +
            "".join(parted(f"{name} is at least {speed_aim} times as fast as the fastest peer as it comes", "Less",
                           of_each(beside_the_fastest, name, fastest_as_it_comes)) for name in provers) +
            "".join(parted(f"{name} ÷ {guesser} is within the aim", "Above it", of_each(beside_the_guess, name, guesser))
                    for name, guesser in provers.items()) +
            "".join(parted(f"{name} is at least as fast as {exact}", "Slower", of_each(beside_the_exact, name)) for name in provers) +
            bullet(f"A peer is right and {names[0]} is not, about pairs of: {lost}" if lost else f"{names[0]} is right wherever a peer is") +
            "".join(f"* {name}, {family}, {row['first_failure']}\n"
                    for family, match in matches.items() for name, row in match.items() if row["first_failure"]))


def page(lines):
    head, parts = read(lines)
    text = f"""# The plain call beside other libraries

All are asked about the same pairs, in one process and one thread. Processor time counts.
The contenders take turns, and the median of their turns counts.
Shapes are made beforehand. Truth is exact: `tests/study/truth/oracle.hpp`.

{"".join(map(bullet, head))}
Signs of wrong answers:

* `+` false positives, `−` false negatives, `?` undecided or an exception, `!` crashed or out of time
* After three that crashed or were out of time, the rest is not asked. Nor is what a contender has no call for.
* Sets are closed: touching is intersecting.
* "Fastest no worse": the fastest of the peers that are not right on at most as many pairs.
* "Fastest as it comes": the fastest of the peers that are not given our support function.

Times:

* The first pairs are timed, as many as stay in the cache.
* A contender that has no answer to some pair is not timed.
* "–": not timed, or no such peer.
* The fastest peer may be wrong about most pairs, as the table of wrong answers shows.
"""
    for title, matches in parts.items():
        first = next(iter(matches.values()))
        names, provers = list(first), {name: row["proves"] for name, row in first.items() if row["proves"]}
        text += (f"\n## {title}\n\n" + times(matches, names) + wrong_answers(matches, names) + proofs(matches, provers) +
                 aims(matches, names, provers))
    return text


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(f"use: {sys.argv[0]} peers.csv")
    with open(sys.argv[1]) as file:
        print(page(file.readlines()), end="")
