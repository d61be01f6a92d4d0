"""claims.md: the report's claims against what was counted."""
import collections, math, pathlib, re
from data import Rate, Refused, between, mean, percentile_99, read_all, row

iterations_allowed = 20


def read_claims(folder):
    tables = {name: read_all([folder], f"claims-{name}") for name in ("effort", "moller", "mistakes")}
    heads = [head for head, _ in tables.values()]
    if any(head != heads[0] for head in heads):
        raise Refused(f"the claims in {folder} are not all of one run: {' and '.join(head['command'] for head in heads)}")
    return heads[0], {name: rows for name, (_, rows) in tables.items()}


# -- Words and numbers ------------------------------------------------------------------------------------------------

def percent(share):
    """Two or three digits of what differs from nothing or from everything: 12.3, 0.012, 99.983."""
    rare = 100 * min(share, 1 - share)
    digits = 0 if rare <= 0 else 1 if rare >= 10 else 2 if rare >= 1 else 1 - math.floor(math.log10(rare))
    return f"{100 * share:.{min(digits, 7)}f}"


def share_text(share):
    """12.3 %, 99.983 %, or 1.7 per million."""
    return f"{1e6 * share:.3g} per million" if 0 < share < 1e-4 else f"{percent(share)} %"


def rate_text(rate):
    """With its interval."""
    low, high = rate.interval()
    if not rate.trials:
        return "–"
    if not rate.count:
        return f"0 (at most {share_text(high)})"
    if rate.count == rate.trials:
        return f"100 % (at least {percent(low)} %)"
    if rate.share < 1e-4:
        return f"{1e6 * rate.share:.3g} ({1e6 * low:.3g}–{1e6 * high:.3g}) per million"
    return f"{percent(rate.share)} % ({percent(low)}–{percent(high)})"


def joined(words):
    """"a, b and c"."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def heading(left, *cells):
    """`left`: how many columns, from the first, hold words; the others hold numbers."""
    return row(*cells) + "".join("|---" if i < left else "|--:" for i in range(len(cells))) + "|\n"


# -- Verdicts ---------------------------------------------------------------------------------------------------------

# How strong the report's words are: the share of cases from which on they hold.
thresholds = {"always": 0.99, "nearly always": 0.99, "usually": 0.5, "all but few": 1 - 10e-6}  # 2 of a million may be 7 as well


def standing(strength, rate):
    """How a claim stands at one place. An *always* that exceptions refute, which are fewer than 1 % all the same, holds "nearly"."""
    low, high = (rate.share, rate.share) if rate.census else rate.interval()
    if strength == "always" and rate.count < rate.trials:
        return "nearly" if low >= thresholds[strength] else "fails"
    return "holds" if low >= thresholds[strength] else "fails" if high < thresholds[strength] else "open"


def why_open(strength, rate):
    """Without an exception only their small number can leave an *always* open."""
    if rate.count == rate.trials:
        return f"only {rate.trials:,} case{'s' if rate.trials > 1 else ''}"
    return f"{100 * thresholds[strength]:.5g} % lies within the interval"


def verdict(strength, measured):
    """At how many of the places that were looked at a claim holds, fails, or does neither, from how often it was true there, {place: Rate}.
    Those are named that are no more than half."""
    looked_at = {place: rate for place, rate in measured.items() if rate.trials}
    places = collections.defaultdict(list)
    for place, rate in looked_at.items():
        kind = standing(strength, rate)
        places[kind].append(f"{place} ({why_open(strength, rate)})" if kind == "open" else place)
    words = {"holds": "**holds**", "nearly": "rare exceptions (under 1 %)", "fails": "**fails**", "open": "left open"}
    named = lambda kind: f": {joined(places[kind])}" if 2 * len(places[kind]) <= len(looked_at) or kind == "open" else ""
    return "; ".join(f"{words[kind]} at {len(places[kind])} of {len(looked_at)}{named(kind)}"
                     for kind in words if places[kind]) or "nothing to look at"


# -- Effort: Sections 3.2 and 3.3 ---------------------------------------------------------------------------------------

# Regions that the report skips when it looks for the origin: its words and section, the vertices, the features.
skipped_regions = [
    ("1-simplex: “the origin cannot be in region R1”, beyond B", "3.2.2", 2, "B"),
    ("1-simplex: “The origin also cannot be in R2”, beyond A", "3.2.2", 2, "A"),
    ("2-simplex: “R4, R5 and R6, so the origin cannot be in those regions” (B, BC, C)", "3.2.3", 3, "B BC C"),
    ("2-simplex: “We can also eliminate region R2”, beyond A", "3.2.3", 3, "A"),
    ("3-simplex: “the points B, C, and D, the line segments BC, CD and DB”", "3.2.4", 4, "B C D BC CD BD"),
    ("3-simplex: “… and the triangle BCD”", "3.2.4", 4, "BCD"),
    ("3-simplex: “we can eliminate the region beyond A”", "3.2.4", 4, "A"),
]


def not_nearest(counts, size, features):
    """How often the nearest feature was none of these; flat simplices, of which it cannot be told, are under 0 and left out."""
    nearest = counts[f"nearest_of_{size}"]
    bits = [sum(1 << "ABCD".index(letter) for letter in feature) for feature in features.split()]
    return Rate(sum(nearest[feature] for feature in bits), nearest.total() - nearest[0]).opposite()


def queries(counts):
    return sum(counts[of].total() for of in ("hits", "misses", "wrong", "undecided"))


def answered_within(counts, least, most):
    return Rate(between(counts["hits"] + counts["misses"] + counts["wrong"], least, most).count, queries(counts))


def extra_checks(counts, simplices, *false):
    edges = sum(counts[f"{simplex}_edges"].total() for simplex in simplices)
    return Rate(edges - sum(counts[f"{simplex}_{kind}_false"].total() for simplex in simplices for kind in false), edges)


# Claim by claim: the report's words, their section, what is counted as true, their strength, and how often it was.
claims_of_effort = [
    ("GJK “rarely needs more than 10”", "3.1.4", "answers within 10 iterations", "nearly always", lambda c: answered_within(c, 0, 10)),
    ("“usually around 5–10” iterations", "3.3", "answers after 5 to 10 iterations", "usually", lambda c: answered_within(c, 5, 10)),
    ("“If the objects intersect, GJK generally requires at least 4 iterations”", "3.3", "hits of 4 or more iterations", "usually",
     lambda c: between(c["hits"], 4, iterations_allowed)),
    ("“If the objects do not intersect, then GJK is usually able to determine that within 2–3”", "3.3", "misses of at most 3 iterations", "usually",
     lambda c: between(c["misses"], 0, 3)),
    ("“we never found GJK to require 20 iterations”", "3.3", "answers within 19 iterations", "always",
     lambda c: answered_within(c, 0, iterations_allowed - 1)),
    ("“Processing a 3-simplex requires, at most, 7 cross products”", "3.3", "queries without a 3-simplex that took more", "always",
     lambda c: between(c["most_in_a_3simplex"], 0, 7)),
    ("the simplex needs “at most, four 3-D points”", "3.3", "simplices of at most 4 vertices", "always",
     lambda c: Rate(*[between(c["simplices"], 2, most).count for most in (4, 1000)])),
    *[(words, section, "the origin lies elsewhere, exactly", "always", lambda c, size=size, features=features: not_nearest(c, size, features))
      for words, section, size, features in skipped_regions],
    ("“That guarantees that AB·AO > 0”, said of A exactly in the direction searched", "3.2.3", "AB·AO > 0 where Eq. 12 is true, of any A", "always",
     lambda c: extra_checks(c, ["triangle"], "newest")),
    ("BA·BO > 0 is among the checks that “are almost always satisfied”", "3.2.3", "BA·BO > 0 where Eq. 12 is true", "nearly always",
     lambda c: extra_checks(c, ["triangle"], "older")),
    ("“some peculiar cases that require these extra checks, though we never encountered any”", "3.2.3",
     "both checks are true, of edges kept by Algorithms 4 and 5", "always", lambda c: extra_checks(c, ["triangle", "tetrahedron"], "newest", "older")),
    ("the new simplex is “the triangle face itself, or an edge, whichever feature is closer”", "3.2.4",
     "what Algorithm 5 keeps is the feature nearest to the origin", "always",
     lambda c: Rate(c["kept_the_nearest"][1], c["kept_the_nearest"].total())),
]


def claims_table(shapes):
    text = heading(6, "The report says", "Section", "Counted as true", "Random triangles", "Where it is true least often", "Verdict")
    for words, section, what, strength, how_often in claims_of_effort:
        measured = {key[0]: how_often(counts)._replace(census=key[3] == "yes") for key, counts in shapes.items()}
        first = next(iter(measured.values()))
        place, least = min(measured.items(), key=lambda item: item[1].share if item[1].trials else 2)
        where = f"{place}: {share_text(least.share)} of all {least.trials:,}" if least.census else f"{place}: {rate_text(least)}"
        text += row(words, section, what, rate_text(first), "–" if least.share >= first.share else where, verdict(strength, measured))
    return text


def costs(histogram):
    return f"{mean(histogram):.2f} / {percentile_99(histogram)} / {max(histogram)}" if histogram else "–"


def iterations_table(shapes):
    text = heading(2, "Shape", "Pairs", "Asked", "Hits", "Wrong", "Undecided", "Iterations: hits", "misses", "Cross products: hits", "misses")
    for (shape, _, kind, _, what), counts in shapes.items():
        share = lambda of: share_text(counts[of].total() / queries(counts))
        text += row(shape, what, f"{queries(counts):,}", share("hits"), share("wrong") if kind == "hard" else "–", share("undecided"),
                    *[costs(counts[of]) for of in ("hits", "misses", "hit_cross_products", "miss_cross_products")])
    return text


def skipped_table(effort):
    text = heading(1, "Shape", *[f"{size - 1}-simplex: {features}" for _, _, size, features in skipped_regions])
    for (shape, computed, *_), counts in effort.items():
        exceptions = [not_nearest(counts, size, features).opposite() for _, _, size, features in skipped_regions]
        text += row(shape + (", in fractions" if computed == "fractions" else ""), *[f"{rate.count:,} of {rate.trials:,}" for rate in exceptions])
    return text


def extra_checks_table(shapes):
    text = heading(2, "Shape", "Simplex", "Iteration 3", "4", "5 and later", "All")
    for (shape, *_), counts in shapes.items():
        for simplex in ("triangle", "tetrahedron"):
            of = lambda what, when: between(counts[f"{simplex}_{what}"], *when).count
            text += row(shape, simplex, *[f"{of('newest_false', when):,} + {of('older_false', when):,} of {of('edges', when):,}" if of("edges", when) else "–"
                                          for when in ((3, 3), (4, 4), (5, 1000), (0, 1000))])
    return text


# -- Möller's test: Section 4 -------------------------------------------------------------------------------------------

random_ones, ten, hundred = "random triangles", "whole numbers 0 … 10", "whole numbers 0 … 100"
common_vertex = "a common vertex, whole numbers 0 … 100"
ways = ("double", "float", "double, snapped", "float, snapped")


def with_right(counts, of):
    return f"{counts[of]:,} (right: {counts[f'{of}_right']:,})" if counts[of] else "0"


def comparison_table(moller):
    text = heading(2, "GJK's rules", "Both compute in", "Both: they meet", "Both: they do not", "Only GJK: they meet", "Only Möller: they meet",
                   "… beyond the plane", "Undecided")
    for (kind, rules, way), c in moller.items():
        if kind == random_ones:
            text += row(rules, way, f"{c['both_yes']:,}", f"{c['both_no']:,}", with_right(c, "only_gjk"), with_right(c, "only_moller"),
                        f"{c['only_moller_beyond_plane']:,}", f"{c['undecided']:,}")
    return text


def agreement(c):
    return Rate(c["both_yes"] + c["both_no"], c["pairs"])


def gjk_right(c):
    return Rate(c["only_gjk_right"] + c["only_moller"] - c["only_moller_right"], c["only_gjk"] + c["only_moller"])


# As claims_of_effort, and in which kinds of triangles it is counted.
claims_of_moller = [
    ("“agreed with TriTri for all but 2 pairs of triangles” of a million", "4", "both say the same", "all but few", agreement,
     (random_ones, hundred, ten)),
    ("“In both cases, our GJK implementation reported that the triangles intersected whereas TriTri reported they did not”", "4",
     "disagreements in which only GJK says that they meet", "always", lambda c: Rate(c["only_gjk"], gjk_right(c).trials), (random_ones, hundred, ten)),
    ("where GJK and TriTri disagree, “our implementation was determined to operate correctly”", "5", "disagreements in which GJK is right", "always",
     gjk_right, (random_ones, hundred, ten, common_vertex)),
    ("“TriTri reports that a pair of triangles intersect if they share a common vertex”", "4",
     "pairs that share a vertex, of which Möller's test says that they meet", "always",
     lambda c: Rate(c["share_seen_by_moller"], c["share_a_vertex"]), (random_ones, hundred, ten, common_vertex)),
]


def claims_by_way(moller):
    text = heading(9, "The report says", "Section", "Counted as true", "Both compute in", "Random triangles", "Whole numbers 0 … 100",
                   "Whole numbers 0 … 10", "Made to share a vertex, 0 … 100", "Verdict")
    for words, section, what, strength, how_often, kinds in claims_of_moller:
        for way in ways:
            measured = {"pairs made to share a vertex" if kind == common_vertex else kind:
                        how_often(moller[(kind, "as intended", way)]) if kind in kinds else Rate(0, 0)
                        for kind in (random_ones, hundred, ten, common_vertex)}
            first = (words, section, what) if way == ways[0] else ("", "", "")  # the words stand in the first row alone
            text += row(*first, way, *map(rate_text, measured.values()), verdict(strength, measured))
    return text


def touches_table(moller):
    text = heading(1, "Coordinates", "Pairs that touch so", "Pairs that share a vertex", "Both compute in", "Only GJK: they meet", "… and touch so",
                   "… and share a vertex", "Only Möller: they meet")
    for (kind, rules, way), c in moller.items():
        if rules == "as intended":
            text += row(kind, f"{c['touch_so']:,}", f"{c['share_a_vertex']:,}", way, with_right(c, "only_gjk"), f"{c['only_gjk_touch_so']:,}",
                        f"{c['only_gjk_share_a_vertex']:,}", with_right(c, "only_moller"))
    return text


def explanations(moller):
    """What a count of the report's kind says about its two of a million: kinds of coordinates, by whether they have as many."""
    few, most = Rate(2, 1_000_000).interval()
    kinds = {"too many": [], "too few": [], "fit": [], "unseen": []}
    for (kind, rules, way), c in moller.items():
        if rules == "as intended" and way == "float, snapped" and kind != common_vertex:
            rate = Rate(c["only_gjk_touch_so"], c["pairs"])
            low, high = rate.interval()
            found = "too many" if low > most else "too few" if high < few else "fit" if rate.count else "unseen"
            kinds[found].append(f"{kind} ({rate_text(rate)})" if rate.count else kind)
    return {name: joined(some) or "none" for name, some in kinds.items()}


# -- Mistakes: Section 1 ------------------------------------------------------------------------------------------------

def passes(p, pairs):
    """The probability that so many random pairs show nothing, where each fails with probability `p`."""
    return 0 if p >= 1 else math.exp(pairs * math.log1p(-p))


def about(pairs):
    """Two digits say all that is known."""
    unit = 10 ** max(0, math.floor(math.log10(pairs)) - 1)
    return f"{math.floor(pairs / unit + 0.5) * unit:,}"


def pairs_to_see(p):
    """Of how many pairs at least one fails in 95 of 100 test runs."""
    return 1 if p >= 1 else math.ceil(math.log(0.05) / math.log1p(-p))


def needed(fails):
    return about(pairs_to_see(fails.share)) if fails.count else "more than " + about(pairs_to_see(fails.interval()[1]))


def needed_between(fails):
    low, high = fails.interval()
    return needed(fails) + (f" ({about(pairs_to_see(high))}–{about(pairs_to_see(low))})" if fails.count else "")


def passes_text(fails, pairs):
    """Where no failure was seen, what is sure at least."""
    p = passes(fails.share if fails.count else fails.interval()[1], pairs)
    if p > 0.999:
        return "> 99.9 %"
    return "< 0.1 %" if fails.count and p < 0.001 else f"{'' if fails.count else '≥ '}{100 * p:.1f} %"


def fails_of(counts):
    return Rate(counts["fails"], counts["asked"])


def mostly_heals(counts):
    """Whether most changed runs end in the right answer, be it yes or no."""
    kinds = [Rate(counts[f"healed_{kind}"], counts[f"changed_{kind}"]) for kind in ("meeting", "apart")]
    return counts["changed"] > 0 and all(not rate.trials or rate.interval()[0] > 0.5 for rate in kinds)


def mistakes_claims(triangles):
    """What *can* be is shown by a single mistake; none of these few leaves it open."""
    seldom = lambda pairs: lambda c: c["fails"] and passes(fails_of(c).interval()[1], pairs) > 0.5  # whatever the rate is within its interval
    acting = sum(counts["changed"] > 0 for counts in triangles.values())
    can_pass = "“an implementation can have a bug, but still pass many test cases”"
    text = heading(6, "The report says", "Section", "True of a mistake where …", "Mistakes", "Which", "Verdict")
    for words, what, is_so, among in (
            (can_pass, "it fails, and yet more likely than not passes 100 random triangle pairs", seldom(100), len(triangles)),
            (can_pass, "… passes 10,000 random triangle pairs", seldom(10_000), len(triangles)),
            ("“the implementation can self-correct in later iterations”",
             "most runs that it changes end rightly, of pairs that meet and of pairs that do not", mostly_heals, acting)):
        which = [mistake for mistake, counts in triangles.items() if is_so(counts)]
        text += row(words, "1", what, f"{len(which)} of {among}", joined(which) or "–", "**holds** for these" if which else "left open")
    return text + f"\nThe last line is about the {acting} mistakes that change any run.\n"


def what_happens(mistakes):
    text = heading(3, "", "Mistake", "Section", "Wrong yes", "Wrong no", "Undecided", "Changed", "Healed: pairs that meet", "Healed: pairs that do not",
                   "More iterations")
    for (pairs, mistake, name, section), c in mistakes.items():
        if pairs == "triangles":
            healed = c["healed_meeting"] + c["healed_apart"]
            extra = c["extra_iterations"] / healed if healed else 0
            share = lambda kind: share_text(c[f"healed_{kind}"] / c[f"changed_{kind}"]) if c[f"changed_{kind}"] else "–"
            text += row(mistake, name, section, f"{c['wrong_yes']:,}", f"{c['wrong_no']:,}", f"{c['undecided']:,}", share_text(c["changed"] / c["asked"]),
                        share("meeting"), share("apart"), f"{'−' if extra < 0 else '+'}{abs(extra):.2f}" if healed else "–")
    return text


def how_many_tests(triangles, tetrahedra, grid):
    """The program (CMakeLists.txt) reads these lines when it is built."""
    text = heading(1, "", "Fails", "Passes 100", "Passes 10,000", "Passes 1,000,000", "Needed: random triangles", "Random tetrahedra",
                   "Triangles on a grid of 6 × 6 × 6")
    for mistake, counts in triangles.items():
        fails = fails_of(counts)
        text += row(mistake, rate_text(fails), *[passes_text(fails, pairs) for pairs in (1e2, 1e4, 1e6)], needed_between(fails),
                    needed(fails_of(tetrahedra[mistake])), needed(fails_of(grid[mistake])))
    return text


def what_it_means(triangles, tetrahedra, grid):
    by_random = [mistake for mistake in triangles if not triangles[mistake]["fails"] and not tetrahedra[mistake]["fails"]]
    lists = {"Never seen by any of the random triangles and tetrahedra, but by the grid, where sets touch:": [m for m in by_random if grid[m]["fails"]],
             "Never seen to fail at all, at most to take longer:": [m for m in by_random if not grid[m]["fails"]],
             "Seen by the iteration limit more often than by a wrong answer:": [m for m, c in triangles.items() if c["undecided"] > c["fails"] > 0]}
    return "".join(f"* {words} {joined(which) or 'none'}.\n" for words, which in lists.items())


# -- The text -----------------------------------------------------------------------------------------------------------

def claims_md(folder):
    """claims.md.in, with what stands in its {{braces}} filled in."""
    head, tables = read_claims(folder)
    effort, moller, mistakes = tables["effort"], tables["moller"], tables["mistakes"]
    shapes = {key: counts for key, counts in effort.items() if key[1] == "double"}
    by_pairs = [{key[1]: counts for key, counts in mistakes.items() if key[0] == pairs} for pairs in ("triangles", "tetrahedra", "grid")]
    random, printed = (moller[(random_ones, rules, "float, snapped")] for rules in ("as intended", "as printed"))
    filled = {
        "command": head["command"], "compiler": head["compiler"], "pairs": f"{int(head['pairs']):,}",
        "hard pairs": f"{max(queries(counts) for key, counts in shapes.items() if key[2] == 'hard'):,}",
        "claims": claims_table(shapes), "iterations": iterations_table(shapes), "skipped": skipped_table(effort),
        "extra checks": extra_checks_table(shapes), "meet": f"{random['meet']:,}", "comparison": comparison_table(moller),
        "2 of a million": rate_text(Rate(2, 1_000_000)), "claims by way": claims_by_way(moller), "touches": touches_table(moller),
        "printed disagrees": rate_text(agreement(printed).opposite()), **explanations(moller),
        "mistakes claims": mistakes_claims(by_pairs[0]), "what happens": what_happens(mistakes), "how many tests": how_many_tests(*by_pairs),
        "what it means": what_it_means(*by_pairs)}
    template = pathlib.Path(__file__).with_name("claims.md.in").read_text()
    return re.sub(r"\{\{(.*?)\}\}", lambda match: filled[match[1]].rstrip("\n"), template)
