#!/usr/bin/env python3
"""Is the main line of every chapter short enough to be read in one sitting?

    words.py SITE      prints a line for each chapter; exit status 0 when all are short enough, else 1

Counts the words of the built page as a reader meets them: paragraphs, lists, tables and captions. What is folded
away is not counted, nor are listings, what programs print, and the table of contents. A formula is one word; a number is none.
"""

import html.parser
import pathlib
import re
import sys

MOST = 3500  # words
APART = {"details", "pre", "script", "style", "svg", "nav"}
APART_CLASSES = {"fragment", "toc", "facts", "claims", "panel", "header"}
EMPTY = {"area", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
FORMULA = re.compile(r"\\\((?:.|\n)*?\\\)|\\\[(?:.|\n)*?\\\]|\\begin\{(\w+\*?)\}(?:.|\n)*?\\end\{\1\}")


class MainLine(html.parser.HTMLParser):
    """The text of div.contents, without what stands apart."""

    def __init__(self, text):
        super().__init__()
        self.open = []   # of each open tag, whether what is in it counts
        self.text = []
        self.feed(text)

    def counts(self):
        return bool(self.open) and self.open[-1]

    def handle_starttag(self, tag, attributes):
        if tag in EMPTY:
            self.text.append(" ")
            return
        classes = set((dict(attributes).get("class") or "").split())
        counts = self.counts() or "contents" in classes
        self.open.append(counts and tag not in APART and not classes & APART_CLASSES)
        if tag not in {"a", "b", "code", "em", "i", "span", "strong", "sub", "sup"}:
            self.text.append(" ")

    def handle_endtag(self, tag):
        if tag not in EMPTY and self.open:
            self.open.pop()
            if tag not in {"a", "b", "code", "em", "i", "span", "strong", "sub", "sup"}:
                self.text.append(" ")

    def handle_data(self, data):
        if self.counts():
            self.text.append(data)


def words(page):
    """How many words the main line of a page has."""
    text = FORMULA.sub(" formula ", "".join(MainLine(page).text))
    return sum(1 for word in text.split() if re.search(r"[^\W\d_]", word))


def main():
    pages = sorted(pathlib.Path(sys.argv[1]).glob("chapter_[0-9][0-9].html"))
    if not pages:
        print(f"words.py: no chapter in {sys.argv[1]}", file=sys.stderr)
        return 2
    too_long = False
    for page in pages:
        count = words(page.read_text(encoding="utf-8"))
        if count < 1000:  # then this has not understood the page
            print(f"{page.name}: {count} words are too few to be a chapter")
            too_long = True
        elif count > MOST:
            print(f"{page.name}: {count} words outside folds, at most {MOST}: fold away what is not the main line")
            too_long = True
        else:
            print(f"{page.name}: {count} words")
    return 1 if too_long else 0


if __name__ == "__main__":
    sys.exit(main())
