#!/usr/bin/env python3
"""No sentence that people read is longer than 25 words, but for those listed here, each with its reason; and triple products carry
brackets wherever people read them.

    python3 words_test.py [FILE...]     FILE: count in these, and show every long sentence
"""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
most = 25

# What a long sentence begins with, and why it may be long.
may_be_long = {
    r"--from-trace --all": "a list of options",
    r"code \(its support function\)": "a list of files",
    r"\*\*(holds|fails)\*\*|\* None seen|Nothing was seen in": "a list of families of pairs",
    r"\* (gjkstep [a-z ]+ is at least|A peer is right)": "a list of families of pairs",
}


def texts(file):
    """What people read in a file, in pieces that no sentence goes beyond."""
    text = file.read_text()
    if file.suffix == ".md":
        text = re.sub(r"^```.*?^```$", "\n", text, flags=re.MULTILINE | re.DOTALL)
        text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
        return re.split(r"\n\s*\n|\n(?=\s*[-*|#0-9])|\|", text)
    if file.suffix == ".hpp":
        comments = re.sub(r"^(?!\s*///).*$", "", text, flags=re.MULTILINE)
        return re.split(r"\n\s*\n|\n\s*///\s*\n|\n\s*///\s+(?=[-*•]|[0-9]\. )|///<", comments)
    if file.name == "sentences.txt":
        return [re.sub(r"^\d+ × ", "", line.split("   | ")[0]) for line in text.splitlines()]
    return [part for line in text.splitlines() for part in re.split(r"(?<=[:;])\s", line)]  # of messages: what, where, what to do


def sentences(piece):
    piece = re.sub(r"\s*///<?", " ", piece)
    piece = re.sub(r"`[^`]*`", "code", piece)
    piece = re.sub(r"[(\[][^()\[\]]*\d[^()\[\]]*[)\]]", "(0)", piece)  # coordinates are no words
    return re.split(r"(?<=[.!?])\s+", " ".join(piece.split()))


def words_in(sentence):
    return sum(bool(re.search(r"\w", word)) for word in sentence.split())


def long_sentences(file):
    return [sentence for piece in texts(file) for sentence in sentences(piece)
            if words_in(sentence) > most and not any(re.match(begin, sentence) for begin in may_be_long)]


def read_by_people():
    for pattern in ("*.md", "core/**/*.md", "walkthroughs/**/*.md", "tests/**/*.md", "core/**/*.hpp", "tests/golden/sentences.txt",
                    "tests/golden/complaints.txt", "tests/console/*.txt"):
        yield from sorted(root.glob(pattern))


def without_brackets(file):
    return re.findall(r"(?<![(\w])([A-Z]{1,2})×[A-Z]O×\1", file.read_text())


if __name__ == "__main__":
    given = [pathlib.Path(name).resolve() for name in sys.argv[1:]] or list(read_by_people())
    found = [f"{file.relative_to(root)}: {words_in(each)} words: {each}" for file in given for each in long_sentences(file)]
    found += [f"{file.relative_to(root)}: a triple product without brackets" for file in given
              if file.suffix != ".hpp" and "golden" not in file.parts and without_brackets(file)]
    print("\n".join(found) or "no sentence is longer than 25 words")
    sys.exit(bool(found))
