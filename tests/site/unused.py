#!/usr/bin/env python3
"""Does a study write a number that no page and no plot names, or a source have a snippet mark that no page quotes?

    unused.py ROOT RUNS    prints a line for each line of code that does; exit status 1 when there is one

A number counts as named where a page puts it in ({{name}}, {{03_euler_variants/name}}, {{where name}}) or a plot
reads it by its name. A line in a loop writes several numbers: one of them must be named. A mark is a pair of lines `/// [tag]`, quoted by {{code file tag}}.
"""
import pathlib
import re
import sys


def pages(root):
    """(run of the page or nothing, text) of every page's source."""
    for file in sorted([*root.glob("chapters/*/*.md"), *root.glob("docs/**/*.md"), *root.glob("engines/*.md"), *root.glob("docs/**/*.dox"),
                        root / "docs/talks.tsv"]):
        yield file.parent.name if file.parent.parent.name == "chapters" else "", file.read_text(encoding="utf-8")


def used_numbers(root):
    """(run, number) of all that pages put in, and the words of all plots."""
    used = set()
    for own_run, text in pages(root):
        for name in re.findall(r"\{\{(?:where )?((?:\w+/)?\w+?)(?:\.value)?\}\}", text):
            run, _, number = name.rpartition("/")
            used.add((run or own_run, number))
    plots = {word for file in [*root.glob("chapters/**/*.gp"), *root.glob("engines/**/*.gp")]
             for word in re.findall(r"\w+", file.read_text(encoding="utf-8"))}
    return used, plots


def cells(file):
    return [line.split("\t") for line in file.read_text(encoding="utf-8").splitlines()[1:]]


def unused_numbers(root, runs):
    used, plots = used_numbers(root)
    for file in sorted(runs.glob("*/run/numbers.tsv")):
        run = file.parent.parent.name
        places = file.parent / "places.tsv"
        if not places.exists():  # a record of runs elsewhere
            continue
        written_at = {name: place for name, kind, place in cells(places) if kind == "number"}
        unused, needed = {}, set()
        for name, *_ in cells(file):
            place = written_at.get(name, name)
            if (run, name) in used or name in plots:
                needed.add(place)
            else:
                unused.setdefault(place, name)
        for place, name in unused.items():
            if place not in needed:
                yield f"{place}: no page and no plot names the number {name}"


def unused_marks(root):
    quoted = {(file, tag.strip()) for _, text in pages(root)
              for file, tag in re.findall(r"\{\{code\s+(\S+)\s+([^:}]+)", text)}
    for folder in ("include", "chapters", "docs", "engines"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".hpp", ".cpp", ".h", ".txt", ".cmake", ".gp", ".cs"):
                continue
            name = str(file.relative_to(root))
            lines = file.read_text(encoding="utf-8").splitlines()
            tags = {found[1] for line in lines if (found := re.fullmatch(r"\s*(?:///|//!|//|#) \[([\w -]+)\]\s*", line))}
            for tag in sorted(tags):
                if (name, tag) not in quoted:
                    yield f"{name}: no page quotes the mark [{tag}]"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    root, runs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    if not [*runs.glob("*/run/numbers.tsv")]:
        sys.exit(f"{runs}: holds no run")
    found = [*unused_numbers(root, runs), *unused_marks(root)]
    print("\n".join(found) or "a page or a plot names every number, and a page quotes every mark")
    sys.exit(1 if found else 0)
