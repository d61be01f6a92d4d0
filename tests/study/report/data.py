"""CSV files of gjkstep-study, added up where they are shards of one run, and what is read from them."""
import collections, csv, math

# How many of its columns, from the first, name what a row is about. The others are counted, and add up.
keys = {"families": 5, "counts": 5, "iterations": 5, "timings": 5, "alone": 4,
        "claims-effort": 5, "claims-moller": 3, "claims-mistakes": 4}
histograms = ("iterations", "claims-effort")  # whose counts are "4:1000 5:20" where 1000 took 4 and 20 took 5


class Refused(Exception):
    """Files that do not go together or are none of the study's; its text says which and why."""


def number(text, name):
    if name not in histograms:
        return int(text)
    return collections.Counter({int(k): int(n) for k, n in (pair.split(":") for pair in text.split())})


def read(file, name):
    """The head of a CSV file, and its rows: what each is about, and its counts by column."""
    try:
        lines = file.read_text().splitlines()
        head = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
        columns, *rows = csv.reader(line for line in lines if not line.startswith("# "))
        n = keys[name]
        found = {tuple(row[:n]): {column: number(text, name) for column, text in zip(columns[n:], row[n:], strict=True)} for row in rows}
    except FileNotFoundError:
        raise Refused(f"{file} is missing: the run that writes it has not come to its end") from None
    except ValueError as error:
        raise Refused(f"{file} is damaged or none of gjkstep-study's: {error}") from None
    if "command" not in head or len(found) != len(rows):
        raise Refused(f"{file} is damaged or none of gjkstep-study's")
    return head, found


def add(total, more):
    """Adds the counts of one row to those of the same in another shard. The slowest pair is that of the larger time."""
    slowest = max(total, more, key=lambda row: row.get("slowest_nanoseconds", 0))
    for column, value in more.items():
        total[column] = slowest[column] if column.startswith("slowest") else total[column] + value


def expect_shards(files, heads):
    """That these are all shards of one run, each once."""
    shards = [head.get("shard", "0 of 1") for head in heads]
    count = shards[0].split(" of ")[1]
    missing = [f"{i} of {count}" for i in range(int(count))]
    for file, head, shard in zip(files, heads, shards):
        for name, value in heads[0].items():
            if name not in ("shard", "processor") and head.get(name) != value:
                raise Refused(f"{files[0]} and {file} do not go together: {name} is '{value}' and '{head.get(name)}'")
        if shard not in missing:
            raise Refused(f"{files[0]} and {file} do not go together: shard {shards[0]} and shard {shard}, which is there twice or of another number")
        missing.remove(shard)
    if missing:
        raise Refused(f"shard {missing[0]} is missing; make it with: {heads[0]['command']} --shard {missing[0].replace(' of ', '/')}")


def read_all(folders, name):
    """The head and the rows of all of them together."""
    files = [folder / f"{name}.csv" for folder in folders]
    heads, parts = zip(*(read(file, name) for file in files))
    expect_shards(files, heads)
    total = parts[0]
    for file, part in zip(files[1:], parts[1:]):
        if name != "timings" and part.keys() != total.keys():  # where a shard has no pair of a family it times nothing
            raise Refused(f"{files[0]} and {file} do not go together: their rows differ")
        for key, row in part.items():
            if key in total:
                add(total[key], row)
            else:
                total[key] = row
    processors = dict.fromkeys(head["processor"] for head in heads if "processor" in head)
    return {**heads[0], "processors": " and ".join(processors)}, total


# -- Rates ------------------------------------------------------------------------------------------------------------

class Rate(collections.namedtuple("Rate", "count trials census", defaults=(False,))):
    """`count` of `trials`, which are a sample of many that could be made, or a census: then there is no interval."""

    @property
    def share(self):
        return self.count / self.trials if self.trials else 0

    def opposite(self):
        return Rate(self.trials - self.count, self.trials, self.census)

    def interval(self):
        """The 95 % score interval (E. B. Wilson 1927), from 0 to 1 where there are no trials."""
        if not self.trials:
            return 0, 1
        z, n, p = 1.959963984540054, self.trials, self.share
        middle, half, scale = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)), 1 + z * z / n
        return 0 if self.count == 0 else (middle - half) / scale, 1 if self.count == n else (middle + half) / scale


def in_short(value):
    """"0.0031", "3.1e-5", "0"."""
    return "0" if value == 0 else f"{value:.2g}".replace("e-0", "e-")


def in_words(rate):
    """"0 (< 3.7e-6)", "0.0031 (0.0029 – 0.0033)" with the ends of the interval; "0.0031 of all"; "no pairs"."""
    low, high = map(in_short, rate.interval())
    if not rate.trials:
        return "no pairs"
    if rate.census:
        return f"{in_short(rate.share)} of all"
    return f"{in_short(rate.share)} ({low} – {high})" if rate.count else f"0 (< {high})"


def row(*cells):
    """Of a table in Markdown."""
    return "".join(f"| {cell} " for cell in cells) + "|\n"


# -- Histograms -------------------------------------------------------------------------------------------------------

def between(histogram, least, most):
    return Rate(sum(n for k, n in histogram.items() if least <= k <= most), histogram.total())


def mean(histogram):
    return sum(k * n for k, n in histogram.items()) / histogram.total()


def percentile_99(histogram):
    """The least k such that at least 99 % took k or fewer."""
    return next(k for k in sorted(histogram) if 100 * between(histogram, 0, k).count >= 99 * histogram.total())


# -- A study ----------------------------------------------------------------------------------------------------------

Setting = collections.namedtuple("Setting", "rules scalar zero_test limit")


def is_certified(rules):
    """Answers that are proven: no rules and no limit of the search that begins change them."""
    return rules.startswith("certified")


def all_but_scalar(setting):
    """"rules as-intended, zero test exact, at most 20 iterations"; "rules certified", which say it all."""
    if is_certified(setting.rules):
        return f"rules {setting.rules}"
    return f"rules {setting.rules}, zero test {setting.zero_test}, at most {setting.limit} iterations"


def failures(counts):
    return counts["false_positives"] + counts["false_negatives"] + counts["undecided"]


def all_pairs(counts):
    """Asked or not."""
    return sum(counts[column] for column in ("pairs", "out_of_range", "not_askable", "exceptions"))


class Study:
    """A whole run. `usual`: the setting that tables vary one thing of: the rules as intended, in double, with the exact zero test
    and the report's limit; where the run has no such, the first, or last limit, that it has."""

    def __init__(self, folders):
        self.head, self._counts = read_all(folders, "counts")
        self.families = {name: {"pairs": int(pairs), "slow_pairs": int(slow_pairs), "size": size, "what": what}
                         for name, pairs, slow_pairs, size, what in read_all(folders, "families")[1]}
        self._iterations = read_all(folders, "iterations")[1]
        timed, self._timings = read_all(folders, "timings")
        self._alone = read_all(folders, "alone")[1]
        self.processors = timed["processors"]
        self.settings = list(dict.fromkeys(key[1:4] for key in self._counts))  # rules, scalar and zero test
        self.rules, self.scalars, self.zero_tests = (list(dict.fromkeys(names)) for names in zip(*self.settings))
        self.limits = [int(limit) for limit in dict.fromkeys(key[4] for key in self._counts) if limit != "none"]
        usual = [wanted if wanted in names else names[0] for names, wanted in (
            (self.rules, "as-intended"), (self.scalars, "double"), (self.zero_tests, "exact"))]
        self.usual = Setting(*usual, 20 if 20 in self.limits or not self.limits else self.limits[-1])

    def row(self, family, setting):
        """The counts of one setting, asked or not; None where there is no such setting. Certified answers have no limit."""
        return self._counts.get((family, *setting[:3], "none" if is_certified(setting.rules) else str(setting.limit)))

    def counts(self, family, setting):
        """As row(); None where no pair was asked."""
        row = self.row(family, setting)
        return row if row and row["pairs"] else None

    def rate(self, family, counts, of):
        """How often something happens, of the pairs with which it can. A family that was listed to its end is a census."""
        trials = {"false_positives": counts["pairs"] - counts["hits"], "false_negatives": counts["hits"]}.get(of, counts["pairs"])
        return Rate(failures(counts) if of == "failures" else counts[of], trials, self.families[family]["size"] == str(all_pairs(counts)))

    def iterations(self, family, setting, of):
        """Queries by iterations; those that took more than the limit count with the limit."""
        histogram = collections.Counter()
        for k, n in self._iterations[(family, *setting[:3], of)]["queries_by_iterations"].items():
            histogram[k if is_certified(setting.rules) else min(k, setting.limit)] += n
        return histogram

    def nanoseconds(self, family, setting):
        """Of a query; None where nothing was timed."""
        timed = self._timings.get((family, *setting[:3], "none" if is_certified(setting.rules) else str(setting.limit)))
        return timed and timed["nanoseconds"] / timed["queries"]

    def alone(self, family, setting):
        return self._alone[(family, *setting[:3])]

    def certified(self):
        """The certified settings, by what tables call them: "certified double"."""
        return {f"{rules} {scalar}": Setting(rules, scalar, "exact", None) for rules in self.rules if is_certified(rules)
                for scalar in self.scalars if (rules, scalar, "exact") in self.settings}

    def scalars_and_certified(self):
        """The usual setting in each scalar, and certified answers whose search begins by the usual rules."""
        usual = {} if is_certified(self.usual.rules) else {scalar: self.usual._replace(scalar=scalar) for scalar in self.scalars}
        first_search = {"certified": "as-intended", "certified-eager": "eager"}
        return usual | {title: setting for title, setting in self.certified().items()
                        if self.usual.rules in (setting.rules, first_search[setting.rules])}
