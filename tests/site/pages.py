#!/usr/bin/env python3
"""Are the chapters' main lines short enough, and is the glossary in order?

    pages.py ROOT    prints a line for each fault; exit status 1 when there is one

A main line is what a chapter does not fold away, without listings; a formula is one word of it. The glossary is in
alphabetical order and has nothing twice. Each of its words stands in the section to which its link leads, or leads to
another word. What a chapter prints bold, with a small first letter and three words at most, is in the glossary.
"""
import pathlib
import re
import sys

MOST = 3600  # words: one sitting
APART = re.compile(r"\{\{ask:.*?\{\{answered\}\}|```.*?```", re.DOTALL)
FORMULA = re.compile(r"\$\$.*?\$\$|\$[^$]*\$", re.DOTALL)
# - **term** (*plainer*): what it is. [Chapter 3](@ref ch3_order), or - **term**: see *other*.
ENTRY = re.compile(r"- \*\*([^*]+)\*\*(?: \(\*([^*]+)\*\))?[:,] (?:see \*([^*]+)\*\.|.*\(@ref ((?:ch|more)\d_\w+)\))")


def plain(text):
    """Small letters; a dash, an underscore or the end of a line is a blank."""
    return re.sub(r"[\s–_-]+", " ", text).replace("ö", "o").lower()


def too_long(root):
    for file in sorted(root.glob("chapters/*/chapter.md")):
        text = FORMULA.sub(" formula ", APART.sub(" ", file.read_text(encoding="utf-8")))
        count = sum(1 for word in text.split() if re.search(r"[^\W\d_]", word))
        if count > MOST:
            yield f"{file}: {count} words outside folds, must be at most {MOST}: fold away what is not the main line"
        if count == 0:  # then this has not understood the page
            yield f"{file}: has no words"


def glossary_faults(root):
    pages = [file.read_text(encoding="utf-8") for file in root.glob("chapters/*/*.md")]
    sections = {}
    for page in pages:
        for part in re.split(r"^(?=##)", page, flags=re.MULTILINE):
            if found := re.match(r".*\{#(\w+)\}\n", part):
                sections[found[1]] = plain(part)
    lines = [line for line in (root / "docs/glossary.md").read_text(encoding="utf-8").split("\n") if line.startswith("- ")]
    entries = [ENTRY.fullmatch(line) for line in lines]
    yield from (f"glossary: is no entry: {line}" for line, entry in zip(lines, entries) if not entry)
    entries = [entry.groups() for entry in entries if entry]
    terms, known = [entry[0] for entry in entries], set()
    explained = {term for term, _, other, _ in entries if not other}
    yield from (f"glossary: {after} does not come after {before}" for before, after in zip(terms, terms[1:])
                if plain(before) >= plain(after))
    for term, plainer, other, section in entries:
        words = [plain(word) for word in (re.sub(r" \(.*\)", "", term), plainer) if word]
        known.update(words)
        if other and other not in explained:
            yield f"glossary: {term} leads to {other}, which is not explained"
        if section and not any(word in sections.get(section, "") for word in words):
            yield f"glossary: {term} does not stand in the section {section}"
    for word in sorted({plain(word) for page in pages for word in re.findall(r"\*\*([a-z][^*.,;:]*)\*\*", page)} - known):
        if len(word.split()) <= 3:
            yield f"glossary: lacks {word}, which a chapter prints bold"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    found = [*too_long(root), *glossary_faults(root)]
    print("\n".join(found) or "the chapters are short enough, and the glossary is in order")
    sys.exit(1 if found else 0)
