#!/usr/bin/env python3
"""A sentence with "never", "cannot", "always" or the like is on the list absolutes.tsv, and what the list names exists.

    absolutes.py ROOT

reads the pages (chapters, docs), the words of `tools/advise`, and the comments that
document the library. A claim with such a word needs a proof: the list names an anchor (#ch5_passive), a study's check
(05_gyroscopic/example), or a test (test: words of its name) where it stands, and several with "; " between. Definitions and instructions need none.
Questions are no claims. A line of the list is: fragment of the sentence, tab, kind, tab, where the proof stands or "-".
"""
import pathlib
import re
import sys

ABSOLUTE = re.compile(
    r"\b(never|cannot|can't|can not|always|impossible|no matter|whatever|at any|ever)\b(?! (shorter|longer|nearer|smaller)\b)"
    r"|\bno\b[^.;:]{0,60}?\bmakes\b", re.IGNORECASE)
KINDS = ("proof", "definition", "instruction")


def sentences_of(text):
    """The sentences of a paragraph; blanks are one blank."""
    text = re.sub(r"\s+", " ", text).strip()
    return re.split(r"(?<=[.!?])[)*”\"]*\s+(?=[^a-z\s])", text)


def without_directives(text):
    """Captions, questions and what a colon leads to stay; numbers and marks go."""
    text = re.sub(r"\{\{(?:figure|live|ask|run)\b[^:{}]*:", " ", text)
    while (shorter := re.sub(r"\{\{[^{}]*\}\}", "", text)) != text:
        text = shorter
    return text.replace("}}", "").replace("**", "").replace("\\ref ", "").replace("`", "")


def page(lines):
    """(line, sentence) of a page: paragraphs, list items and rows of tables apart."""
    code, begin, paragraph = False, 1, ""
    for number, line in enumerate(lines + [""], 1):
        fence = line.lstrip(" >").startswith("```")
        code = code != fence
        block = line.strip()
        if code or fence or not block or re.match(r"[-*|#>]|\d+\.|\{\{", block):
            for sentence in sentences_of(without_directives(paragraph)):
                yield begin, sentence
            paragraph = ""
        if not code and not fence:
            begin = begin if paragraph else number
            paragraph += " " + block.lstrip("-*#> ")


def comments(lines):
    """(line, sentence) of the comments that document a header."""
    begin, paragraph = 1, ""
    for number, line in enumerate(lines + [""], 1):
        found = re.search(r"//[/!]<? ?(.*)", line)
        words = found[1].strip() if found else ""
        if not words or "//!<" in line or "///<" in line:
            for sentence in sentences_of(paragraph):
                yield begin, sentence.replace("`", "")
            paragraph = ""
        begin = begin if paragraph else number
        paragraph += " " + words


def texts(lines):
    """(line, sentence) of the adviser's words, "key: text"."""
    for number, line in enumerate(lines, 1):
        if re.match(r"[a-z0-9_]+: ", line):
            for sentence in re.split(r"; ", line.partition(": ")[2]):
                for part in sentences_of(sentence) if " " in sentence else []:
                    yield number, part.replace("`", "").replace("**", "")


def sources(root):
    for file in sorted([root / "README.md", *root.glob("chapters/*/*.md"), *root.glob("docs/*.md"), *root.glob("engines/*.md")]):
        if file.name != "promises.md":  # each of its rows names its own tests, which tests/grading/promises.sh looks up
            yield file, page
    for file in sorted([*root.glob("include/timestep/**/*.h*")]):
        yield file, comments
    yield root / "tools/advise/words.txt", texts


def claims(root):
    """(file, line, sentence) of what has an absolute word and is no question."""
    for file, read in sources(root):
        for line, sentence in read(file.read_text(encoding="utf-8").split("\n")):
            if ABSOLUTE.search(sentence) and not sentence.rstrip(" )*").endswith("?"):
                yield str(file.relative_to(root)), line, sentence


class Proofs:
    """Where a proof may stand: is it there?"""

    def __init__(self, root):
        self.root = root
        pages = [file.read_text(encoding="utf-8") for file in [*root.glob("chapters/*/*.md"), *root.glob("docs/**/*.md"), *root.glob("engines/*.md")]]
        self.anchors = set(re.findall(r"\{#(\w+)\}", "\n".join(pages)))
        self.tests = None

    def missing(self, where):
        """What is wrong with the place, or nothing."""
        if where.startswith("#"):
            return "" if where[1:] in self.anchors else f"no section has the anchor {{{where}}}"
        if where.startswith("test: "):
            if self.tests is None:
                files = [file for end in ("cpp", "hpp", "sh", "txt", "py", "cmake") for file in self.root.glob(f"tests/**/*.{end}")]
                text = "\n".join(file.read_text(encoding="utf-8", errors="replace") for file in files if file.name != "absolutes.py")
                self.tests = re.sub(r'"\s*\n\s*"', "", text)  # a long name goes on in the next line
            return "" if where[6:] in self.tests else f"no test has the words \"{where[6:]}\" in its name"
        chapter, _, check = where.partition("/")
        named = f'"{check}"'
        studies = [*self.root.glob(f"chapters/{chapter}/study/*.cpp"), *self.root.glob(f"chapters/{chapter}/study/*.hpp")]
        if chapter == "in_engines":
            studies = [self.root / "engines/measured/checks.tsv"]
            named = f"\n{check}\t"
        return "" if check and any(named in file.read_text(encoding="utf-8") for file in studies) \
            else f"no study has the check {where}"


def faults(root, table):
    entries, wrong = [], []
    proofs = Proofs(root)
    for number, line in enumerate(table.read_text(encoding="utf-8").split("\n"), 1):
        if not line or line.startswith("#"):
            continue
        place = f"{table.name}:{number}"
        cells = line.split("\t")
        if len(cells) != 3 or cells[1] not in KINDS or not ABSOLUTE.search(cells[0]):
            wrong.append(f"{place}: a line is a fragment with its absolute word, one of {', '.join(KINDS)}, and a place or \"-\", with tabs between")
            continue
        fragment, kind, where = cells
        if (where == "-") == (kind == "proof"):
            wrong.append(f"{place}: \"{fragment}\": a proof names its place, anything else has \"-\"")
        elif kind == "proof":
            for one in where.split("; "):
                if missing := proofs.missing(one):
                    wrong.append(f"{place}: \"{fragment}\": {missing}")
        entries.append([fragment, place, False])
    for file, line, sentence in claims(root):
        listed = False
        for entry in entries:
            if entry[0] in sentence:
                entry[2] = listed = True
        if not listed:
            wrong.append(f"{file}:{line}: \"{sentence.strip()}\": give it a proof and a line in tests/site/{table.name}, or do without \"{ABSOLUTE.search(sentence)[0]}\"")
    wrong += [f"{place}: \"{fragment}\" stands nowhere any more: take the line out" for fragment, place, used in entries if not used]
    return wrong


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    root = pathlib.Path(sys.argv[1])
    found = faults(root, root / "tests/site/absolutes.tsv")
    print("\n".join(found) or "every absolute sentence is on the list, and every line of the list holds")
    sys.exit(1 if found else 0)
