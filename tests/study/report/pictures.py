"""The three pictures of a study, drawn by gnuplot."""
import collections, math, shutil, subprocess
from data import Setting, all_but_scalar, all_pairs, failures, in_short, is_certified

# Colours that colour-blind readers tell apart as well (Okabe and Ito). They never stand alone.
blue, vermilion, orange, green, purple = "'#0072B2'", "'#D55E00'", "'#E69F00'", "'#009E73'", "'#CC79A7'"


def canvas(width, height, terminal="pngcairo"):
    return f"set terminal {terminal} size {width},{height} noenhanced background rgb 'white' font 'DejaVu Sans,11'\nset encoding utf8\n"


def in_quotes(text):
    """The text as gnuplot reads it. A line feed would end the text, and what follows would be a command."""
    return "'" + "".join(c if c >= " " else " " for c in text).replace("'", "''") + "'"


def small_print(study):
    return f"{study.head['command']}; {study.head['compiler']}"


def draw(file, script):
    """Returns whether gnuplot drew the picture; the file is there whole or not at all."""
    file.unlink(missing_ok=True)  # a picture of other data must not stay beside new tables
    drawn = shutil.which("gnuplot") and subprocess.run(["gnuplot"], input=script.encode(), capture_output=True)
    if not drawn or drawn.returncode or not drawn.stdout:
        return False
    file.write_bytes(drawn.stdout)
    return True


# -- Wrong or undecided against time ------------------------------------------------------------------------------------

def shared_families(study):
    """The families that every method was asked about, so that all points speak of the same. Left out are those that consist of pairs
    known to cycle, where no rules help, and those of which some scalar changes more than a tenth of the truths by writing the pairs:
    they are others in float (most sets at 1e12 are points there), and say nothing about float and double."""
    settings = [Setting(*setting, study.limits[-1] if study.limits else None) for setting in study.settings]
    def is_shared(family):
        rows = [study.row(family, setting) for setting in settings]
        return (all(row["pairs"] and study.nanoseconds(family, setting) is not None for row, setting in zip(rows, settings)) and
                not any(10 * row["truth_changed"] > all_pairs(row) for row in rows) and not family.startswith("cycles"))
    return [family for family in study.families if is_shared(family)]


class Labels:
    """Words beside points, where there is room. Places are shares of a panel's width and height; boxes are (left, right, low, high)."""

    def __init__(self, points):
        self.taken = [(x - 0.025, x + 0.025, y - 0.017, y + 0.017) for x, y in points]

    def place(self, words, x, y, sides):
        """The command that puts the words on the first side where there is room, "" where there is none."""
        width, height = 0.017 * len(words) + 0.006, 0.022
        for side in sides.split():
            at_x = x + {"right": 1, "left": -1}.get(side, 0) * (0.03 + width)
            at_y = y + {"above": 1, "below": -1}.get(side, 0) * 0.045
            left, right, low, high = box = at_x - width, at_x + width, at_y - height, at_y + height
            if left > 0 and right < 1 and low > 0 and high < 1 and not any(
                    left < r and l < right and low < h and b < high for l, r, b, h in self.taken):
                self.taken.append(box)
                return f"set label {in_quotes(words)} at graph {at_x:g},{at_y:g} center font ',10' front\n"
        return ""


def style(study, families, rules, zero_test):
    """Squares for the usual rules, triangles and diamonds for others; filled for the first zero test."""
    if is_certified(rules):
        asked = [study.row(family, Setting(*setting, None)) for setting in study.settings if setting[0] == rules for family in families]
        title = f"{rules}: {sum(map(failures, asked))} of {sum(counts['pairs'] for counts in asked)} wrong or undecided"
        return f"lc rgb {purple} ps 1.4 pt {7 if rules == 'certified' else 6} title {in_quotes(title)}"
    colour, dashes, mark = (blue, "1", 4) if rules == study.usual.rules else {
        "eager": (green, "'.'", 12), "as-printed": (vermilion, "'-'", 8), "complete": (orange, "'_'", 10)}[rules]
    return (f"lc rgb {colour} dt {dashes} lw 1.5 ps 1.4 pt {mark + (zero_test == study.zero_tests[0])} "
            f"title {in_quotes(f'rules {rules}, zero test {zero_test}')}")


class Panel:
    """All methods of one scalar, with a time axis of its own, which is logarithmic: a mean over families may be that of a few which
    take ten times as long. Points are (nanoseconds, share that went wrong), means of families, each counting alike."""

    def __init__(self, study, families, scalar):
        self.study, self.scalar, self.curves = study, scalar, []
        for rules in study.rules:
            for zero_test in study.zero_tests:
                if (rules, scalar, zero_test) in study.settings:
                    settings = [Setting(rules, scalar, zero_test, limit) for limit in ([None] if is_certified(rules) else study.limits)]
                    points = [tuple(sum(of(family, setting) for family in families) / len(families) for of in (study.nanoseconds, self.share))
                              for setting in settings]
                    self.curves.append((rules, points, style(study, families, rules, zero_test)))
        times = [max(nanoseconds, 1) for _, points, _ in self.curves for nanoseconds, _ in points]  # a clock may have seen no time pass
        self.begin, self.end = min(times) / 1.4, max(times) * 1.4
        self.worst = max(share for _, points, _ in self.curves for _, share in points)

    def share(self, family, setting):
        counts = self.study.row(family, setting)
        return failures(counts) / counts["pairs"]

    def labels(self, top):
        """The first limit of each curve has its number, and those that follow one number for all, as they lie near to each other. Curves
        fall, as more iterations leave less undecided: above their beginning and below their end no line is crossed."""
        place = lambda point: (math.log(point[0] / self.begin) / math.log(self.end / self.begin), (point[1] / top + 0.06) / 1.06)
        labels = Labels([place(point) for _, points, _ in self.curves for point in points])
        limits, text = self.study.limits, ""
        for rules, points, _ in self.curves:  # first, as they have no other number, and off the line of zero
            if is_certified(rules):
                text += labels.place(f"{in_short(points[0][1])} wrong", *place(points[0]), "above below")
        for rules, points, _ in self.curves:
            if not is_certified(rules):
                others = "–".join(dict.fromkeys(str(limit) for limit in limits[1:2] + limits[-1:]))
                text += labels.place(str(limits[0]), *place(points[0]), "above left right below")
                text += labels.place(others, *place(points[-1]), "below left right above") if limits[1:] else ""
        return text

    def text(self, top):
        """The commands that draw it, with rates up to `top`, the same in all panels."""
        per = 1000 if self.end > 1.4 * 20000 else 1
        low, high = self.begin / per, self.end / per
        tics = [first * 10 ** power for power in range(math.floor(math.log10(low)), 20) for first in (1, 2, 5)]
        text = (f"set title {in_quotes(self.scalar)} font ',13'\nset xlabel '{'micro' if per > 1 else 'nano'}seconds per query'\n"
                f"set xrange [{low:g}:{high:g}]\nset yrange [{-0.06 * top:g}:{top:g}]\n"
                f"set xtics ({', '.join(f'{tic:g}' for tic in tics if low <= tic <= high)})\n" + self.labels(top))
        for i, (_, points, _) in enumerate(self.curves):
            text += f"$curve{i} << EOD\n" + "".join(f"{time / per:g} {share:g}\n" for time, share in points) + "EOD\n"
        return text + "plot " + ", ".join(f"$curve{i} with linespoints {words}" for i, (_, _, words) in enumerate(self.curves)) + "\n"


def error_vs_time(study):
    families = shared_families(study)
    if not families:
        return canvas(1060, 570) + "set title 'no family was asked in every setting'\nplot [0:1] [0:1] NaN notitle\n"
    panels = [Panel(study, families, scalar) for scalar in study.scalars]
    top = 1.12 * max(panel.worst for panel in panels) or 1
    title = (f"Wrong or undecided against time, means of the {len(families)} of {len(study.families)} families that float can hold and every setting is "
             f"asked about; iteration limits {', '.join(map(str, study.limits))}")
    made = f"{small_print(study)}; CPU time on {study.processors}"
    return (canvas(1060, 570) + f"set logscale x\nset multiplot layout 1,{len(panels)} margins 0.06,0.985,0.135,0.705 spacing 0.045,0.1 "
            f"title {in_quotes(title)} font ',10'\nset label {in_quotes(made)} at screen 0.985,0.025 right font ',9'\nset grid\n"
            "set xzeroaxis lt 1 lc rgb 'black'\nset ylabel 'share wrong or undecided, mean of families'\n"
            "set key at screen 0.5,0.935 center top vertical maxrows 5 samplen 4\n" +
            "unset ylabel\nunset key\nunset label\n".join(panel.text(top) for panel in panels) + "unset multiplot\n")


# -- The heat map -------------------------------------------------------------------------------------------------------

def cell_words(study, family, counts):
    """Where nothing was seen they say how much that tells; where nothing was wrong, "in doubt"."""
    if not counts:
        return "not asked"
    rate = study.rate(family, counts, "failures")
    if not rate.count and not rate.census:
        high = rate.interval()[1]
        power = 10 ** math.floor(math.log10(high))
        return "<" + in_short(math.ceil(high / power) * power)  # one digit, and not below it
    if not rate.count or rate.count != counts["in_doubt"]:
        return in_short(rate.share)
    return ("all" if rate.count == rate.trials else in_short(rate.share)) + " in doubt"


def heat_map(study):
    """Rates from 1e-6 to 1 have a shade, and none at all is white; a number in each cell, so that the shade is not all that tells it."""
    columns, families = study.scalars_and_certified(), list(study.families)
    width, height = max(1000, 360 + 160 * len(columns)), 220 + 24 * len(families)
    cells = labels = ""
    for y, family in enumerate(families):
        for x, setting in enumerate(columns.values()):
            counts = study.counts(family, setting)
            share, words = failures(counts) / counts["pairs"] if counts else 0, cell_words(study, family, counts)
            colour = "#FFFFFF" if share > 0.005 else "#000000" if share or words == "0" else "#666666"
            labels += f"set label {in_quotes(words)} at {x},{y} center front textcolor rgb '{colour}'\n"
            cells += f"{x} {y} {math.log10(max(share, 1e-6)):g}\n" if share else ""
    tics = lambda axis, names: f"set {axis}tics ({', '.join(f'{in_quotes(name)} {i}' for i, name in enumerate(names))}) scale 0\n"
    note = lambda words, above: f"set label {in_quotes(words)} at screen 0.5,{above / height:g} center font ',9'\n"
    # Of at most 256 colours and without smooth lines: a quarter of the bytes, for areas and words.
    return (canvas(width, height, "png") + "$cells << EOD\n" + (cells or "0 0 NaN\n") + f"EOD\n{labels}"
            f"set title {in_quotes('Wrong or undecided, share of pairs: ' + all_but_scalar(study.usual))}\n" + tics("x", columns) + tics("y", families) +
            note("A number after <: none seen; if there are any they are fewer than this (upper end of the 95 % interval).", 54) +
            note("0: none of all the pairs that there are. Float is judged by the truth about the pair as float writes it.", 36) +
            note(small_print(study), 14) + f"set bmargin at screen {100 / height:g}\nset xrange [-0.5:{len(columns)} - 0.5]\n"
            f"set yrange [{len(families)} - 0.5:-0.5]\n"
            "set palette defined (0 '#FFF3B0', 1 '#F6C667', 2 '#E58F4B', 3 '#B8504A', 4 '#6F2C5B', 5 '#2A1145')\n"
            "set cbrange [-6:0]\nset cbtics ('1' 0, '0.1' -1, '0.01' -2, '1e-3' -3, '1e-4' -4, '1e-5' -5, '1e-6' -6)\n"
            "set style fill solid noborder\nunset key\nplot $cells using 1:2:(0.5):(0.5):3 with boxxyerror palette\n")


# -- Iterations ---------------------------------------------------------------------------------------------------------

def shares(study, families, of):
    """The share of queries that took k iterations, by k: the mean of the families that have any."""
    asked = [histogram for family in families if (histogram := study.iterations(family, study.usual, of))]
    mean = collections.Counter()
    for histogram in asked:
        for k, n in histogram.items():
            mean[k] += n / histogram.total() / len(asked)
    return mean


def iterations(study):
    families, text, last = [family for family in study.families if study.counts(family, study.usual)], "", 0
    for title, some in ((f"family {next(iter(study.families))}", families[:1]), ("all families, each counting alike", families)):
        hits, misses = shares(study, some, "hits"), shares(study, some, "misses")
        last = max(hits | misses, default=0)
        data = "".join(f"{k} {hits[k]:g} {misses[k]:g}\n" for k in range(1, last + 1)) or "0 NaN NaN\n"
        below = "" if some is not families else "set xlabel 'iterations; undecided queries count with those that they took'\n"
        text += (f"set title {in_quotes(title)}\n{below}$data << EOD\n{data}EOD\nplot $data using ($1-0.2):($2>0?$2:NaN) with boxes fs solid 1 lc rgb "
                 f"{blue} title 'hits', $data using ($1+0.2):($3>0?$3:NaN) with boxes fs pattern 2 lc rgb {vermilion} title 'misses'\n")
    return (canvas(1200, 820) + f"set multiplot layout 2,1 title {in_quotes(f'Iterations: {study.usual.scalar}, {all_but_scalar(study.usual)}')}\n"
            "set logscale y\nset yrange [1e-6:1]\nset ytics ('1' 1, '0.1' 0.1, '0.01' 0.01, '1e-3' 1e-3, '1e-4' 1e-4, '1e-5' 1e-5, '1e-6' 1e-6)\n"
            f"set ylabel 'share of hits, of misses'\nset xrange [0:{(last if is_certified(study.usual.rules) else study.usual.limit) + 1}]\n"
            "set xtics 1\nset boxwidth 0.4\nset grid y\nset key top right\n" + text + "unset multiplot\n")
