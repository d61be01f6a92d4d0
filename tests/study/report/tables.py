"""Tables of a study in Markdown; each varies one thing."""
import collections
from data import add, all_but_scalar, in_short, in_words, is_certified, mean, percentile_99, row

of_round_shapes = ("Certified answers about sets of points, and about balls, are never undecided; about cylinders, whose points are computed, they "
                   "are where these are known too badly. Balls and cylinders take no second search and have no certificate. ")


def head(study, title):
    return (f"# {title}\n\nMade by `{study.head['command']}` and `report.py`, with seed {study.head['seed']}, {study.head['version']}, "
            f"compiled by {study.head['compiler']}.\n\n")


def how_to_read(study):
    return ("Rates are shares of the pairs asked where a table names no others, with the ends of their 95 % score intervals (Wilson 1927); where "
            "nothing was seen, only the upper end. Families that were listed to the last pair are a census, \"of all\", and have none. Unless a "
            f"table says otherwise: {study.usual.scalar}, {all_but_scalar(study.usual)}. {of_round_shapes if study.certified() else ''}"
            "Every combination is in counts.csv, which the command writes.\n\n")


def heading(columns):
    return row("family", *columns) + row(*["---"] * (len(columns) + 1))


def table(study, columns):
    """`columns`: by heading, what says the cell of a family; empty where there is nothing to say."""
    return heading(columns) + "".join(row(family, *(cell(family) or "" for cell in columns.values())) for family in study.families)


def rate_table(study, columns):
    """As table(); families in which nothing was seen in any column are named below it."""
    seen, nothing = "", []
    for family in study.families:
        cells = [cell(family) or "" for cell in columns.values()]
        if all(cell in ("", "no pairs") or cell.startswith("0 ") for cell in cells):
            nothing.append(family)
        else:
            seen += row(family, *cells)
    below = f"Nothing was seen in: {', '.join(nothing)}.\n" if nothing else ""
    return heading(columns) + seen + ("\n" + below if below else "") if seen else below


def column(study, setting, words):
    """The cells of one setting: words(family, counts)."""
    return lambda family: (counts := study.counts(family, setting)) and words(family, counts)


def rates(study, setting, of):
    return column(study, setting, lambda family, counts: in_words(study.rate(family, counts, of)))


def undecided(study, setting):
    kinds = (("cycles", "in circles"), ("unusable", "without a direction"), ("in_doubt", "in doubt"))
    return column(study, setting, lambda family, counts: in_words(study.rate(family, counts, "undecided")) +
                  "".join(f"; {counts[of]} {what}" for of, what in kinds if counts[of]))


# -- Counts -----------------------------------------------------------------------------------------------------------

def proofs(counts):
    """"predicates", or with the counts "predicates 498, certificates 2" where there were several."""
    names = [name for name in ("predicates", "formulas", "certificates") if counts[f"by_{name}"]]
    return ", ".join(name + (f" {counts[f'by_{name}']}" if len(names) > 1 else "") for name in names)


def families(study):
    in_float, notes = study.usual._replace(scalar="float"), study.families
    told = lambda of: lambda family: (row := study.row(family, in_float)) and row[of] and str(row[of])
    return table(study, {
        "what": lambda family: notes[family]["what"],
        "pairs": lambda family: f"{notes[family]['pairs']}{', all' if str(notes[family]['pairs']) == notes[family]['size'] else ''}",
        "of these exact": lambda family: str(notes[family]["slow_pairs"]),
        "hits": column(study, study.usual, lambda family, counts: in_short(counts["hits"] / counts["pairs"])),
        "truth by": lambda family: (row := study.row(family, study.usual)) and proofs(row),
        "changed by float": told("truth_changed"),
        "beyond float's range": told("out_of_range")})


def iterations(study):
    """Of support calls a search makes two in each iteration, one of each set."""
    histogram = lambda family, of: study.iterations(family, study.usual, of)
    spread = lambda histogram: f"{mean(histogram):.2f}, {percentile_99(histogram)}, {max(histogram)}" if histogram else ""
    cell = lambda words: column(study, study.usual, lambda family, _: words(family))
    return table(study, {
        "hits: mean, 99 %, max": cell(lambda family: spread(histogram(family, "hits"))),
        "misses: mean, 99 %, max": cell(lambda family: spread(histogram(family, "misses"))),
        "support calls a query": cell(lambda family: f"{2 * mean(histogram(family, 'hits') + histogram(family, 'misses')):.1f}")})


def tables_md(study):
    return (head(study, "Accuracy") + how_to_read(study) +
            "## Families\n\nOf each pair it is known exactly whether the sets have a point in common; touching counts: by CGAL's exact predicates; by "
            "CGAL's exact linear program, with a certificate that is multiplied out in fractions; or by formulas in fractions. Float is asked about the "
            "pair as float writes it, and its answer held against the truth about that pair; how often writing it in float changed the truth is told "
            "beside it.\n\n" + families(study) + "\n## Wrong or undecided, by scalar\n\n" +
            rate_table(study, {title: rates(study, setting, "failures") for title, setting in study.scalars_and_certified().items()}) +
            "\n## Iterations\n\nHits and misses by truth; an undecided query counts with the iterations that it took." +
            (" A certified answer about points takes the same search first; how often a second follows, and its iterations, is in certified.md."
             if study.certified() else "") + "\n\n" + iterations(study))


def errors_md(study):
    kinds = {"false positives, of pairs apart": "false_positives", "false negatives, of pairs that meet": "false_negatives",
             "undecided, of all pairs": "undecided"}
    settings = {f"In {scalar}": study.usual._replace(scalar=scalar) for scalar in ("double", "float") if scalar in study.scalars}
    settings |= {title: setting for title, setting in study.certified().items() if setting.rules != study.usual.rules}
    return (head(study, "Errors of each kind") + how_to_read(study) +
            "A false positive can only happen to a pair that is apart, a false negative only to one that meets: each is told as a share of these. A "
            "family without such pairs says so.\n" +
            "".join(f"\n## {title}\n\n" + rate_table(study, {words: rates(study, setting, of) for words, of in kinds.items()})
                    for title, setting in settings.items()) +
            "\n## Undecided, by scalar\n\nIn circles: a simplex and a direction came back, so no limit would have helped.\n\n" +
            rate_table(study, {title: undecided(study, setting) for title, setting in study.scalars_and_certified().items()}))


def scalars_and_zero_tests(study):
    """The usual setting with every scalar and zero test. What does not round has only the usual zero test."""
    return {f"{scalar}, {zero_test}": study.usual._replace(scalar=scalar, zero_test=zero_test)
            for scalar in study.scalars for zero_test in study.zero_tests if scalar != "exact" or zero_test == study.usual.zero_test}


def settings_md(study):
    zero_tests = {title: setting for title, setting in scalars_and_zero_tests(study).items() if setting.scalar != "exact"}
    limits = {f"at most {limit}": rates(study, study.usual._replace(limit=limit), "undecided") for limit in study.limits}
    return (head(study, "What the other settings change") + how_to_read(study) + "## Wrong or undecided, by rules\n\n" +
            rate_table(study, {rules: rates(study, study.usual._replace(rules=rules), "failures") for rules in study.rules}) +
            "\n## Wrong or undecided, by zero test\n\n" +
            rate_table(study, {title: rates(study, setting, "failures") for title, setting in zero_tests.items()}) +
            "\n## Undecided, by iteration limit\n\n" +
            ("Certified answers have no limit.\n" if is_certified(study.usual.rules) else rate_table(study, limits)))


# -- Times ------------------------------------------------------------------------------------------------------------

def timings_md(study):
    settings = ({} if is_certified(study.usual.rules) else scalars_and_zero_tests(study)) | study.certified()
    cell = lambda setting: lambda family: (time := study.nanoseconds(family, setting)) is not None and f"{time:.0f}"
    return (head(study, "Speed") + f"Measured on {study.processors}, by the CPU clock of the thread that asks (CLOCK_THREAD_CPUTIME_ID), which stands "
            f"still while the processor serves others. Nanoseconds per query: {study.usual.scalar}, {all_but_scalar(study.usual)}; columns vary scalar "
            "and zero test. Shapes are made before the clock starts. The methods take turns with the same batch of up to 256 pairs, each limit after a "
            "pass with which the caches warm up, and another limit first in each turn; of five turns, of exact numbers three and 16 pairs, the median "
            "counts. One reading of the clock in each batch is part of it. Balls and cylinders pay for the choice of the form at each support call. " +
            (of_round_shapes if study.certified() else "") + "\n\n" +
            table(study, {title: cell(setting) for title, setting in settings.items()}) + float_and_double(study))


def float_and_double(study):
    """Why float is not the faster one, where this run shows that it is not, with the compiler that this was measured with."""
    family, both = next(iter(study.families)), [study.usual._replace(scalar=scalar) for scalar in ("float", "double")]
    times = [study.nanoseconds(family, setting) for setting in both]
    if not study.head["compiler"].startswith("GNU 12.") or None in times or times[0] < times[1]:
        return ""
    took = [mean(study.iterations(family, setting, "hits") + study.iterations(family, setting, "misses")) for setting in both]
    return (f"\nFloat is not the faster one, and not for more iterations ({family}: {took[0]:.2f} in float, {took[1]:.2f} in double) but for how GCC 12 "
            "packs the three numbers of a point into vector registers: compiled with -fno-tree-slp-vectorize, which forbids that, float takes no longer "
            "than double.\n")


def certified_md(study):
    """Counts and times of what is proven; nothing where nothing is."""
    if not study.certified():
        return ""
    return (head(study, "Certified answers") + of_round_shapes +
            "Where the first search proves nothing a second one follows. Each pair is timed alone by the CPU clock of the thread that asks, on "
            f"{study.processors}; reading the clock once is part of it, caches and branches have just seen other pairs, and of the slowest pair the least "
            "of five askings counts.\n" + "".join(f"\n## {title}\n\n{certified_summary(study, setting)}\n{certified_table(study, setting)}"
                                                   for title, setting in study.certified().items()))


def per_query(alone, how):
    return f"{alone[f'nanoseconds_{how}'] / alone[f'{how}_second_search']:.0f}" if alone[f"{how}_second_search"] else ""


def second(study, family, setting):
    """Queries by iterations of their second search, those that needed none left out; and the share that needed one."""
    histogram = study.iterations(family, setting, "second searches")
    some = collections.Counter({k: n for k, n in histogram.items() if k})
    return some, some.total() / histogram.total() if histogram else 0


def certified_table(study, setting):
    told = lambda words: column(study, setting, lambda family, _: words(*second(study, family, setting)))
    alone = lambda words: column(study, setting, lambda family, _: words(study.alone(family, setting)))
    count = lambda of: column(study, setting, lambda _, counts: str(of(counts)))
    return table(study, {
        "pairs": count(lambda counts: counts["pairs"]),
        "wrong": count(lambda counts: counts["false_positives"] + counts["false_negatives"]),
        "undecided": count(lambda counts: counts["undecided"]),
        "second searches: share": told(lambda some, share: in_short(share)),
        "iterations of these: mean, max": told(lambda some, _: f"{mean(some):.2f}, {max(some)}" if some else ""),
        "ns without": alone(lambda times: per_query(times, "without")),
        "ns with": alone(lambda times: per_query(times, "with")),
        "slowest, µs: pair": alone(lambda times: times["slowest_nanoseconds"] and
                                   f"{times['slowest_nanoseconds'] / 1000:.1f}: {times['slowest_pair']}")})


def certified_summary(study, setting):
    """All families in a few sentences."""
    alone = {family: study.alone(family, setting) for family in study.families if study.counts(family, setting)}
    if not alone:
        return "No pair was asked.\n"
    slowest = max(alone, key=lambda family: alone[family]["slowest_nanoseconds"])
    counts, searches, times = collections.Counter(), collections.Counter(), dict.fromkeys(alone[slowest], 0)
    for family in alone:
        counts.update(study.counts(family, setting))
        searches += second(study, family, setting)[0]
        add(times, alone[family])
    holds = f"{counts['false_certificates']} do not hold" if counts["false_certificates"] else "all hold"
    return (f"{counts['pairs']} pairs: {counts['false_positives'] + counts['false_negatives']} wrong, {counts['undecided']} undecided. "
            f"{counts['certificates']} certificates, those of the first pairs of each family, were multiplied out in fractions: {holds}. "
            f"{in_short(searches.total() / counts['pairs'])} of the pairs took a second search" +
            (f", of {mean(searches):.2f} iterations in the mean and {max(searches)} at most" if searches else "") + "." +
            "".join(f" {words} it a query took {per_query(times, how)} ns." for how, words in (("without", "Without"), ("with", "With"))
                    if times[f"{how}_second_search"]) +
            f" The slowest, pair {times['slowest_pair']} of {slowest}, took {times['slowest_nanoseconds'] / 1000:.1f} µs.\n")
