#!/usr/bin/env python3
"""Do the checks of the site find what they are there to find?

Each test makes a small site that is in order, plants one fault in it, and asks for its sentence.
Exit status 77 (skipped) when a browser is needed and not there.
"""

import os
import sys
import tempfile
import unittest

import browser
import links

PIXEL = b"GIF89a\x01\x00\x01\x00\x80\x00\x00\x00\x00\x00\xff\xff\xff!\xf9\x04\x00\x00\x00\x00\x00," \
        b"\x00\x00\x00\x00\x01\x00\x01\x00\x00\x02\x02D\x01\x00;"
GOOD = """<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>A page</title>
<style>@media (prefers-color-scheme: dark) { body { background: #111; color: #eee; } a { color: #9cf; } }</style>
</head><body><h1 id="top">A page</h1><img src="pixel.gif"><a href="other.html#there">there</a>
<pre>a \\(formula\\) in a listing</pre>%s</body></html>"""


class SiteCase(unittest.TestCase):
    """A site that is in order, but for what a test plants."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("pixel.gif", PIXEL)
        self.write("other.html", b'<p id="there">There</p>')
        self.plant("")

    def write(self, name, content):
        with open(os.path.join(self.folder.name, name), "wb") as file:
            file.write(content)

    def plant(self, fault):
        self.write("index.html", (GOOD % fault).encode())


class Links(SiteCase):
    """links.py"""

    def faults(self):
        return links.find_faults(self.folder.name)

    def test_planted_faults(self):
        for fault, sentence in (("", None),
                                ('<a href="none.html">', "none.html leads to no file"),
                                ('<img src="none.html">', "none.html leads to no file"),
                                ('<source srcset="none.html">', "none.html leads to no file"),
                                ('<link href="none.html">', "none.html leads to no file"),
                                ('<script src="none.html">', "none.html leads to no file"),
                                ('<a href="other.html#here">', "other.html#here leads to no place in the page"),
                                ('<a href="#here">', "#here leads to no place in the page"),
                                ('<script src="https://a.org/a.js"></script><a href="https://a.org/">',
                                 "https://a.org/a.js is not part of the site")):
            self.plant(fault)
            self.assertEqual(self.faults(), [f"index.html: {sentence}"] if sentence else [], fault)

    def test_the_tree(self):
        self.write("navtreedata.js", b'[ "A", "none.html", null ], [ "B", "other.html#here", null ]')
        self.assertEqual(self.faults(), [
            "navtreedata.js: none.html leads to no file",
            "navtreedata.js: other.html#here leads to no place in the page"])

    def test_hidden_tests_stay_hidden(self):
        title = "Timestep: tests/exercises/01_a/b/properties.cpp Source File"
        self.write("p.html", f"<title>{title}</title>".encode())
        self.assertEqual(self.faults(), [f"p.html: shows a hidden file, {title}"])


@unittest.skipIf(browser.missing(), browser.missing())
class Pages(SiteCase):
    """browser.py"""

    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.__exit__)

    def faults(self):
        return self.browser.faults(os.path.join(self.folder.name, "index.html"))

    def expect(self, fault, *sentences):
        self.plant(fault)
        self.assertEqual(self.faults(), list(sentences))

    def test_raw_formulas(self):
        self.expect("")
        for raw in (r"\(x\)", r"\[x\]", "$$x$$", r"\f$x\f$", r"\f[x\f]"):
            self.expect(f"<p>{raw}</p>", "raw formula: " + raw)

    def test_images_without_size(self):
        self.write("empty.gif", b"")
        self.expect('<img src="empty.gif">', "image without size: empty.gif")
        self.expect('<div style="height: 9000px"></div><img src="empty.gif" loading="lazy">',
                    "image without size: empty.gif")

    def test_errors_on_the_console(self):
        self.plant("<script>throw new Error('planted')</script>")
        [fault] = self.faults()
        self.assertRegex(fault, "^console: .*planted")
        self.plant('<script src="none.js"></script>')
        [fault] = self.faults()
        self.assertRegex(fault, "^console: .*none.js.*ERR_FILE_NOT_FOUND")

    def test_scrolling_sideways(self):
        self.expect('<div style="width: 370px">wide</div>', "scrolls sideways at 360 px in light mode",
                    "scrolls sideways at 360 px in dark mode")
        self.expect('<div id="doc-content" role="main" style="overflow: auto"><div style="width: 370px">wide</div></div>',
                    "scrolls sideways at 360 px in light mode",
                    "scrolls sideways at 360 px in dark mode")
        self.expect("<style>@media (prefers-color-scheme: dark) { h1 { width: 370px; } }</style>",
                    "scrolls sideways at 360 px in dark mode")

    def test_what_has_no_name(self):
        self.plant('<input id="field"><div id="doc-content"><div class="contents"><a href="other.html"><img src="pixel.gif" alt=""></a>'
                   '<pre style="width:40px;overflow:auto">wider than that</pre></div></div>')
        found = self.faults()
        for fault in ("a field without a label: field", "a link without words: other.html",
                      "the arrow keys cannot scroll: wider", "a screen reader is not told"):
            self.assertTrue(any(line.startswith(fault) for line in found), found)

    def test_modes(self):
        self.expect("<style>body { background: #fff !important; color: #222 !important; } a { color: #00e !important; }</style>",
                    "is light at 360 px in dark mode")
        self.expect("<style>body { background: #111; color: #eee; } a { color: #9cf; }</style>", "is dark at 360 px in light mode")


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    if result.wasSuccessful() and result.skipped:
        print("skipped: " + browser.missing())
        sys.exit(browser.SKIPPED)
    sys.exit(0 if result.wasSuccessful() else 1)
