"""Mutants that nobody chose: every small change of a kind that programmers make by mistake, found in the text of the
project. Not compiled here: what the compiler refuses is no mutant.
"""
import bisect, collections, hashlib, re

Mutant = collections.namedtuple("Mutant", "file line kind start end new old_line new_line")

comment_or_text = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*', re.S | re.M)

comparisons = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="]}
swapped = {"&&": "||", "||": "&&", "+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
           "true": "false", "false": "true", "min": "max", "max": "min", "front": "back", "back": "front",
           "floor": "ceil", "ceil": "floor", "sin": "cos", "cos": "sin"}
# In min and max the order of arguments does not matter.
no_call = "min max if while for switch return sizeof decltype catch operator constexpr requires noexcept assert".split()
no_statement = ("return throw using case default static const auto template struct class enum public private protected "
                "typedef if for while else do switch friend explicit virtual constexpr namespace static_assert goto "
                "inline extern concept requires").split()


def code_of(text):
    """The text with spaces for comments and directives, quotes for what is quoted: every character stays where it is."""
    def blank(match):
        return re.sub(r"[^\n]", " " if match.group().lstrip()[0] in "/#" else '"', match.group())
    return comment_or_text.sub(blank, text)


def closing(code, start):
    """Where the bracket that opens at `start` closes; None where it does not."""
    depth = 0
    for i in range(start, len(code)):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if depth == 0:
            return i
    return None


def arguments_of(code, start, end):
    """The ranges of what stands between commas at the top level of code[start:end]."""
    depth, ranges, begin = 0, [], start
    for i in range(start, end):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if code[i] == "," and depth == 0:
            ranges.append((begin, i))
            begin = i + 1
    ranges.append((begin, end))
    return [(b + len(code[b:e]) - len(code[b:e].lstrip()), e - len(code[b:e]) + len(code[b:e].rstrip())) for b, e in ranges]


def comparison_changes(code):
    for m in re.finditer(r"(?<= )(<=|>=|==|!=|<|>)(?=\s)", code):
        for new in comparisons[m.group()]:
            yield "comparison", m.start(), m.end(), new


def operator_changes(code):
    for m in re.finditer(r"(?<!\"\s)(?<=\s)(&&|\|\||[-+*/]=?)(?= [^\"])", code):  # not between texts, which only + joins
        yield "operator", m.start(), m.end(), swapped[m.group()]
    for m in re.finditer(r"\b(true|false)\b|\b(min|max|floor|ceil|sin|cos)(?=\()|(?<=[.])(front|back)(?=\(\))", code):
        yield "word", m.start(), m.end(), swapped[m.group()]


def sign_changes(code):
    for m in re.finditer(r"(?:(?<=[(\[{<=>?:,*/+] )|(?<=[(\[{])|(?<=return ))-(?=[\w(])", code):
        yield "sign", m.start(), m.end(), ""
    for m in re.finditer(r"(?:(?<=[(\[{])|(?<=\s))!(?=[\w(])", code):
        yield "negation", m.start(), m.end(), ""


def constant_changes(code):
    for m in re.finditer(r"(?<![\w.])(\d+)(?![\w.'])", code):
        yield "constant", m.start(), m.end(), str(int(m.group()) + 1)
        if int(m.group()) > 0:
            yield "constant", m.start(), m.end(), str(int(m.group()) - 1)
    for m in re.finditer(r"(?<![\w.])(\d+)\.(\d*)(?![\w'.])", code):
        digits = len(m.group(2))
        for step in (1, -1):
            value = int(m.group(1) + m.group(2)) + step
            if value > 0:
                text = str(value).rjust(digits + 1, "0")
                yield "constant", m.start(), m.end(), text[:len(text) - digits] + "." + text[len(text) - digits:]


def argument_swaps(code):
    for m in re.finditer(r"\b([A-Za-z_]\w*)\(", code):
        end = closing(code, m.end() - 1)
        if m.group(1) in no_call or end is None:
            continue
        args = arguments_of(code, m.end(), end)
        if any(re.fullmatch(r"(?:const )?[\w:<>, ]+?[&*]* \w+(?: = .*)?|\[.*", code[b:e], re.S) for b, e in args):
            continue  # a declaration, or a lambda
        for (b1, e1), (b2, e2) in zip(args, args[1:]):
            if code[b1:e1] != code[b2:e2]:
                yield "arguments", b1, e2, (slice(b2, e2), slice(e1, b2), slice(b1, e1))


def statements(code):
    """Where each statement that is an expression begins and ends."""
    for m in re.finditer(r"(?<=[;{}:)])\s*\n\s*(?=[A-Za-z_+*(-])", code):
        begin = m.end()
        word = re.match(r"\w*", code[begin:]).group()
        if word in no_statement or not re.match(
                r"(?:\+\+|--|\*)?[A-Za-z_][\w:]*(?:\.|->|\[|\(| [-+*/|&%]?= | << |\+\+|--|;)", code[begin:]):
            continue
        depth = 0
        for i in range(begin, len(code)):
            depth += (code[i] in "([{") - (code[i] in ")]}")
            if depth < 0 or (depth == 0 and code[i] == "}"):
                break
            if depth == 0 and code[i] == ";":
                yield begin, i + 1
                break


def removals(code):
    for begin, end in statements(code):
        yield "statement", begin, end, ";"
    for m in re.finditer(r"\bif \(", code):
        end = closing(code, m.end() - 1)
        if end is None or ";" in code[m.end():end]:
            continue
        yield "guard", m.end(), end, "false"
        yield "guard", m.end(), end, ("!(", slice(m.end(), end), ")")


def mutants_of(file, text):
    """All mutants of a file, in the order of its text."""
    code = code_of(text)
    starts = [0] + [m.end() for m in re.finditer("\n", text)]
    found = []
    for changes in (comparison_changes, operator_changes, sign_changes, constant_changes, argument_swaps, removals):
        for kind, start, end, new in changes(code):
            if not isinstance(new, str):
                new = "".join(part if isinstance(part, str) else text[part] for part in new)
            line = bisect.bisect(starts, start)
            first, last = starts[line - 1], text.find("\n", end)
            whole = " ".join(text[first:last].split())
            changed = " ".join((text[first:start] + new + text[end:last]).split())
            if whole != changed:
                found.append(Mutant(file, line, kind, start, end, new, whole, changed))
    return sorted(found, key=lambda mutant: (mutant.start, mutant.end, mutant.new))


def sample(mutants, count, seed):
    """Of these so many. A mutant is drawn by its own words: a change elsewhere does not draw others."""
    def lot(mutant):
        return hashlib.sha256(f"{seed}|{mutant.file}|{mutant.old_line}|{mutant.new_line}".encode()).digest()
    return sorted(sorted(mutants, key=lot)[:count], key=lambda mutant: (mutant.file, mutant.start, mutant.new))
