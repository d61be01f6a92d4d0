"""Tables of a study in Markdown; each varies one thing."""
import collections, textwrap
from data import add, all_but_scalar, in_short, in_words, is_certified, mean, percentile_99, row

of_round_shapes = ("Certified answers about sets of points, and about balls, are never undecided.\n"
                   "The points of cylinders are computed. Where they are not known well enough, the answer is undecided.\n"
                   "Balls and cylinders need no exact fallback. Certificates about balls are not multiplied out here.\n")


def head(study, title):
    return (f"# {title}\n\nMade by `{study.head['command']}` and `report.py`.\n"
            f"Seed: {study.head['seed']}. Version: {study.head['version']}. Compiler: {study.head['compiler']}.\n\n")


def how_to_read(study):
    return ("Rates are shares of the pairs asked, where a table names no others.\n"
            "Behind a rate are the ends of its 95 % score interval (Wilson 1927). Where nothing was seen, only the upper end is there.\n"
            "A family that was listed to the last pair is a census, \"of all\", and has no interval.\n"
            f"Unless a table says otherwise: {study.usual.scalar}, {all_but_scalar(study.usual)}.\n"
            f"{of_round_shapes if study.certified() else ''}Every combination is in counts.csv, which the command writes.\n\n")


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
    below = textwrap.fill(f"Nothing was seen in: {', '.join(nothing)}.", 140, break_on_hyphens=False) + "\n" if nothing else ""
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
            "## Families\n\nIt is known exactly of each pair whether the sets have a point in common. Touching counts.\n"
            "The truth comes from CGAL's exact predicates, from CGAL's exact linear program, or from formulas in fractions.\n"
            "Each answer of the linear program has a certificate, which is multiplied out in fractions.\n"
            "Float is asked about the pair as float writes it. Its answer is held against the truth about that pair.\n"
            "*Changed by float* tells how often writing the pair in float changed the truth.\n\n" + families(study) +
            "\n## Wrong or undecided, by scalar\n\n" +
            rate_table(study, {title: rates(study, setting, "failures") for title, setting in study.scalars_and_certified().items()}) +
            "\n## Iterations\n\nHits and misses are told apart by the truth. An undecided query counts with the iterations that it took.\n" +
            ("A certified answer about points takes the same search first.\n"
             "How often the exact fallback follows, and its iterations, is in certified.md.\n" if study.certified() else "") +
            "\n" + iterations(study))


def errors_md(study):
    kinds = {"false positives, of pairs apart": "false_positives", "false negatives, of pairs that meet": "false_negatives",
             "undecided, of all pairs": "undecided"}
    settings = {f"In {scalar}": study.usual._replace(scalar=scalar) for scalar in ("double", "float") if scalar in study.scalars}
    settings |= {title: setting for title, setting in study.certified().items() if setting.rules != study.usual.rules}
    return (head(study, "Errors of each kind") + how_to_read(study) +
            "A false positive can only happen to a pair that is apart, and is told as a share of these.\n"
            "A false negative can only happen to a pair that meets, and is told as a share of those.\n"
            "A family without such pairs says so.\n" +
            "".join(f"\n## {title}\n\n" + rate_table(study, {words: rates(study, setting, of) for words, of in kinds.items()})
                    for title, setting in settings.items()) +
            "\n## Undecided, by scalar\n\n*In circles*: a simplex and a direction came back, so no limit would have helped.\n\n" +
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
    return (head(study, "Speed") +
            f"Measured on {study.processors}, by the CPU clock of the thread that asks (CLOCK_THREAD_CPUTIME_ID).\n"
            "That clock stands still while the processor serves others. One reading of it in each batch is part of the time.\n"
            f"Numbers are nanoseconds per query: {study.usual.scalar}, {all_but_scalar(study.usual)}.\n"
            "Columns vary scalar and zero test. Shapes are made before the clock starts.\n"
            "The methods take turns with the same batch of up to 256 pairs, and the median of five turns counts.\n"
            "With exact numbers there are three turns, of up to 16 pairs.\n"
            "Each limit is measured after a pass with which the caches warm up. Each turn begins with another limit.\n"
            "Balls and cylinders pay for the choice of the form at each support call.\n" +
            (of_round_shapes if study.certified() else "") + "\n" +
            table(study, {title: cell(setting) for title, setting in settings.items()}) + float_and_double(study))


def float_and_double(study):
    """Why float is not the faster one, where this run shows that it is not, with the compiler that this was measured with."""
    family, both = next(iter(study.families)), [study.usual._replace(scalar=scalar) for scalar in ("float", "double")]
    times = [study.nanoseconds(family, setting) for setting in both]
    if not study.head["compiler"].startswith("GNU 12.") or None in times or times[0] < times[1]:
        return ""
    took = [mean(study.iterations(family, setting, "hits") + study.iterations(family, setting, "misses")) for setting in both]
    return (f"\nFloat is not the faster one. It does not take more iterations ({family}: {took[0]:.2f} in float, {took[1]:.2f} in double).\n"
            "The reason is how GCC 12 packs the three numbers of a point into vector registers.\n"
            "Compiled with -fno-tree-slp-vectorize, which forbids that, float takes no longer than double.\n")


def certified_md(study):
    """Counts and times of what is proven; nothing where nothing is."""
    if not study.certified():
        return ""
    return (head(study, "Certified answers") + of_round_shapes +
            "A filter follows the plain search. Where it proves nothing, the exact fallback follows.\n"
            f"Each pair is timed alone, by the CPU clock of the thread that asks, on {study.processors}.\n"
            "Reading the clock once is part of the time. Caches and branches have just seen other pairs.\n"
            "Of the slowest pair the least of five askings counts.\n" +
            "".join(f"\n## {title}\n\n{certified_summary(study, setting)}\n{certified_table(study, setting)}"
                    for title, setting in study.certified().items()))


def per_query(alone, how):
    return f"{alone[f'nanoseconds_{how}'] / alone[f'{how}_second_search']:.0f}" if alone[f"{how}_second_search"] else ""


def second(study, family, setting):
    """Queries by iterations of their exact fallback, those that needed none left out; and the share that needed one."""
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
        "exact fallbacks: share": told(lambda some, share: in_short(share)),
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
    return (f"{counts['pairs']} pairs: {counts['false_positives'] + counts['false_negatives']} wrong, {counts['undecided']} undecided.\n"
            f"{counts['certificates']} certificates, those of the first pairs of each family, were multiplied out in fractions: {holds}.\n"
            f"{in_short(searches.total() / counts['pairs'])} of the pairs took the exact fallback" +
            (f", of {mean(searches):.2f} iterations in the mean and {max(searches)} at most" if searches else "") + "." +
            "".join(f" {words} it a query took {per_query(times, how)} ns." for how, words in (("without", "Without"), ("with", "With"))
                    if times[f"{how}_second_search"]) +
            f"\nThe slowest, pair {times['slowest_pair']} of {slowest}, took {times['slowest_nanoseconds'] / 1000:.1f} µs.\n")
