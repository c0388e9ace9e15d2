#!/usr/bin/env python3
"""Does a learner's edition hold anything of the tests or the solutions?

    leaks.py SOURCE KIT    prints a line for each file that does; exit status 0 when there is none, else 1

Looks for every line of the tests and of the solutions' answers that has 20 characters or more, and is not also in a file
that is handed out on purpose, in every file of KIT: sources, programs, pages without their tags. Blanks do not count.
"""
import html
import pathlib
import re
import sys

SHORTEST = 20
OPEN = ("chapters", "docs", "engines", "include", "tools", "CMakeLists.txt", "CMakePresets.json", "README.md", "course", "LICENSE")


def files(*places):
    return [file for place in places for file in ([place] if place.is_file() else sorted(place.rglob("*")))
            if file.is_file() and not file.is_symlink()]


def plain(text):
    return text.translate(None, b" \t\r\n\v\f")


def lines_of(code):
    """The lines of code and comments. What stands between the brackets of a check is what Catch2 would leave in a program."""
    for line in map(plain, code.split(b"\n")):
        yield line
        if found := re.match(rb"(?:REQUIRE|CHECK)\w*\((.*)\)", line):
            yield found[1]


def secret_lines(source):
    for file in files(source / "tests"):
        code = file.read_bytes()
        if file.suffix == ".diff":  # what is said of a mistake is told to learners
            code = b"\n".join(re.findall(rb"^[-+=](.*)", code, re.M))
        if file.name != "about.json":
            yield from lines_of(code)
    for file in files(source / "solutions"):
        answers = re.split(rb"// \[answer\]", file.read_bytes())[1::2]
        for answer in answers:
            yield from lines_of(answer)
        yield plain(b"".join(answers))  # in one piece, too, since its lines may be short


def open_text(source):
    """All that is handed out, the exercises' stubs among it."""
    for file in files(*(source / name for name in OPEN), *source.glob("tests/**/about.json")):
        yield file.read_bytes()
    for file in files(source / "solutions"):
        yield from re.split(rb"// \[answer\]", file.read_bytes())[::2]


def found_in(text, secrets):
    """The secrets in a text without blanks. `secrets` has them by their beginnings."""
    ends = range(len(text) - SHORTEST + 1)
    return {line for at in ends if (some := secrets.get(text[at:at + SHORTEST])) for line in some if text.startswith(line, at)}


def secrets_of(source):
    secrets = {}
    for line in set(secret_lines(source)):
        if len(line) >= SHORTEST and not line.startswith(b"#include<timestep/"):
            secrets.setdefault(line[:SHORTEST], set()).add(line)
    for line in found_in(plain(b"".join(open_text(source))), secrets):
        secrets[line[:SHORTEST]].discard(line)
    return secrets


def faults(kit, secrets):
    for file in files(kit):
        text = file.read_bytes()
        if file.suffix in (".gz", ".tar", ".zip", ".xz"):
            yield f"{file}: is packed, so that nobody can look into it"
        found = found_in(plain(text), secrets)
        if file.suffix in (".html", ".js"):
            words = html.unescape(re.sub(r"<[^>]*>", "", text.decode(errors="replace"))).replace("\u00a0", " ")
            found |= found_in(plain(words.encode()), secrets)
        if found:
            yield f"{file}: {len(found)} lines: {min(found).decode(errors='replace')}"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    secrets, kit = secrets_of(pathlib.Path(sys.argv[1])), pathlib.Path(sys.argv[2])
    found, count = [*faults(kit, secrets)], sum(map(len, secrets.values()))
    if count == 0 or not files(kit):
        found.append(f"{kit}: nothing to look for, or nowhere to look")
    print("\n".join([*found, f"{count} lines looked for in {len(files(kit))} files: {len(found)} files leak"]))
    sys.exit(1 if found else 0)
