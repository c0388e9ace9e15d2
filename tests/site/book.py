"""The book holds every written page once, its links lead to places in it, its pictures are there, and a browser prints it.

book.py BOOK.html [BOOK.pdf]"""

import re
import subprocess
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path


class Book(HTMLParser):
    def __init__(self):
        super().__init__()
        self.ids, self.links, self.pictures, self.pages, self.folded = [], [], [], [], 0

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        for name in ("id", "name"):
            if name in of and not (name == "name" and tag == "meta"):
                self.ids.append(of[name])
        if tag == "a" and "href" in of:
            self.links.append(of["href"])
        if tag == "img":
            self.pictures.append(of["src"])
        if tag == "section":
            self.pages.append(of["id"])
        self.folded += tag == "details" and "open" not in of


def faults(file):
    book = Book()
    book.feed(file.read_text(encoding="utf-8"))
    written = {page.stem for page in (file.parent / "html").glob("*.html")
               if re.fullmatch(r"(chapter|more)_\d+|exercises(_\d+)?|which_method|glossary|methods|rigid_methods|in_your_engine|talks|promises|teaching", page.stem)}
    found = [f"{page} is in the book {count} times" for page, count in Counter(book.pages).items() if count != 1]
    found += [f"{page} is not in the book" for page in sorted(written - set(book.pages))]
    found += [f"{one} stands {count} times" for one, count in Counter(book.ids).items() if count != 1]
    found += [f"a link to {link} leads nowhere" for link in book.links
              if not link.startswith(("http:", "https:")) and link.removeprefix("#") not in book.ids]
    found += [f"the picture {name} is not there" for name in book.pictures if not (file.parent / name).exists()]
    if book.folded:
        found.append(f"{book.folded} parts are folded")
    if len(book.links) < 500 or len(book.pictures) < 50:
        found.append(f"{len(book.links)} links and {len(book.pictures)} pictures are too few")
    return found


def main():
    found = faults(Path(sys.argv[1]))
    if len(sys.argv) > 2:
        text = subprocess.run(["pdftotext", "-layout", sys.argv[2], "-"], check=True, capture_output=True, text=True).stdout
        for words in ("Timestep", "Beyond the talk", "For teachers"):
            if words not in text:
                found.append(f"what was printed lacks: {words}")
        has_katex = (Path(sys.argv[1]).parent / "html/katex").exists()  # without it formulas stand as source
        for source in (r"\(\omega", r"\frac{", "$\\omega"):
            if has_katex and source in text:
                found.append(f"a formula was printed as its source: {source}")
    print("\n".join(found) or "fine")
    sys.exit(bool(found))


main()
