#!/usr/bin/env python3
"""Does every link in the site lead somewhere, does the site need nothing from elsewhere, and do the
hidden tests stay hidden?

    links.py SITE      prints a line for each fault; exit status 0 when there is none, else 1

Reads the pages as files: every local href and src must name a file that exists, every anchor a
place in it, and what a file to take home includes lies beside it. Scripts, styles and images come from the site itself. The tree and the search, which
are made of scripts, are held to the same.
"""

import html.parser
import os
import re
import sys
import urllib.parse

# Bytes, with what belongs to none; and so many for each that is added.
CHAPTERS, A_CHAPTER = 8, 4_700_000
HIDDEN = ("tests/exercises/", "solutions/")  # folders whose sources no page may show


class Page(html.parser.HTMLParser):
    """What one page links to, and what can be linked to in it."""

    def __init__(self, text):
        super().__init__()
        self.anchors = set()
        self.links = []      # (address, needed to show the page)
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        for name in ("id", "name"):
            if given.get(name):
                self.anchors.add(given[name])
        if given.get("href"):
            self.links.append((given["href"], tag == "link"))
        if given.get("src"):
            self.links.append((given["src"], True))
        if given.get("srcset"):
            self.links += [(part.split()[0], True) for part in given["srcset"].split(",")]


def script_links(text):
    """The addresses in Doxygen's scripts of the tree and the search."""
    return re.findall(r"""["'](?:\.\./)?([^"'<>\s]+\.html(?:#[^"'<>\s]*)?)["']""", text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def find_faults(site):
    """A sentence for each fault of the site."""
    pages, faults, scripts = {}, [], {}
    size = 0
    for folder, _, files in os.walk(site):
        for name in files:
            path = os.path.join(folder, name)
            size += os.path.getsize(path)
            relative = os.path.relpath(path, site)
            if name.endswith(".html"):
                text = read(path)
                pages[relative] = Page(text)
                title = re.search("<title>(.*?)</title>", text)
                if title and any(folder in title.group(1) for folder in HIDDEN):
                    faults.append(f"{relative}: shows a hidden file, {title.group(1)}")
            elif name.endswith(".js") and not name.startswith("navtreeindex"):
                # What follows NAVTREEINDEX names the same entries again, every 250th of them.
                scripts[relative] = script_links(read(path).split("var NAVTREEINDEX")[0])
    chapters = sum(re.fullmatch(r"chapter_\d\d\.html", page) is not None for page in pages)
    largest = A_CHAPTER * max(CHAPTERS, chapters)
    if size > largest:
        faults.append(f"the site has {size / 1e6:.1f} MB, more than {largest / 1e6:.1f} MB")
    if "index.html" not in pages:
        faults.append("there is no index.html")

    def check(origin, address, base):
        parts = urllib.parse.urlsplit(address)
        target = os.path.normpath(os.path.join(base, urllib.parse.unquote(parts.path))) \
            if parts.path else origin
        if not os.path.exists(os.path.join(site, target)):
            faults.append(f"{origin}: {address} leads to no file")
        elif parts.fragment and target in pages and parts.fragment not in pages[target].anchors:
            faults.append(f"{origin}: {address} leads to no place in the page")

    # Each file to take home finds what it includes.
    for folder, _, files in os.walk(os.path.join(site, "take_home")):
        for name in (name for name in files if name.endswith((".h", ".hpp"))):
            path = os.path.join(folder, name)
            for opened, included in re.findall(r'^#include ([<"])([^>"\n]+)', read(path), re.M):
                if opened == '"' or included.startswith("timestep/"):
                    base = folder if opened == '"' else os.path.join(site, "take_home")
                    if not os.path.exists(os.path.join(base, included)):
                        faults.append(f"{os.path.relpath(path, site)}: {included} leads to no file")

    for origin, page in pages.items():
        for address, needed in page.links:
            scheme = urllib.parse.urlsplit(address).scheme
            if address.startswith("//") or scheme in ("http", "https"):
                if needed:
                    faults.append(f"{origin}: {address} is not part of the site")
            elif scheme not in ("javascript", "mailto", "data"):
                check(origin, address, os.path.dirname(origin))
    # Below a file, Doxygen's tree lists its members with places that the file's page does not have:
    # there the page is all that is asked for.
    for origin, addresses in scripts.items():
        for address in addresses:
            check(origin, address if origin in ("navtreedata.js", "search_places.js") else address.split("#")[0], "")
    return sorted(set(faults))


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: links.py SITE")
    faults = find_faults(sys.argv[1])
    print("\n".join(faults) or "every link leads somewhere")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
