#!/usr/bin/env python3
"""Are the pages of the site in order in a browser, opened from their files?

    browser.py SITE [--all]    prints a line for each fault; exit status 0 when there is none, 1 when there is one, 77
                               (skipped) when Chromium, Selenium, or what makes the site pretty is not there

The largest page of each kind is opened. With --all every page that somebody has written is, every index, every page with
a formula or a figure, and a twentieth of those that Doxygen makes from one template, chosen by what stands in them.

One headless Chromium opens every page at the width of a phone, in light and in dark mode. A page is
in order when the console reports no error, no formula stands unset, every image has arrived, nothing makes the
page scroll sideways, figures are those for phones and in the colours of the page, all words stand out from their ground, and the language, fields and links have names.
"""

import importlib.util
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import zlib

SKIPPED = 77
PHONE = (360, 740)  # CSS pixels
FOLDS = "chapter_03.html"  # has figures and tables that are folded away
KINDS = {  # of pages made from one template
    "sources": r".*_source\.html",
    "lists of members": r".*-members\.html",
    "classes": r"(class|struct|union|concept)(?!s\.html|es\.html).*\.html",
    "files": r".*_8[a-z]+\.html",
    "folders": r"dir_.*\.html",
}
SHOWS_SOMETHING = re.compile(rb'\\\(|\\\[|class="formula|src="(?!logo\.svg|doxygen\.svg)[^"]*\.(svg|gif|png)')

# Both scripts hand a list of sentences to their last argument. Listings are sources: what looks like
# a formula there is none. KaTeX keeps its TeX for screen readers.
LOOK = r"""
const done = arguments[arguments.length - 1];
const listing = ".fragment, .ttc, pre, code, script, style, textarea, .katex, #side-nav";

async function look() {
    while (document.documentElement.classList.contains("typesetting"))
        await new Promise(resolve => setTimeout(resolve, 5));
    const faults = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const node = walker.currentNode;
        if (/\\[()\[\]]|\$\$|\\f[$\[\]]/.test(node.data) && !node.parentElement.closest(listing))
            faults.push("raw formula: " + node.data.trim().slice(0, 60));
    }
    for (const error of document.querySelectorAll(".katex-error"))
        faults.push("KaTeX cannot set " + error.textContent.slice(0, 60));

    for (const image of document.images) {
        image.loading = "eager";
        await image.decode().catch(() => {});
        if (!(image.naturalWidth > 0 && image.naturalHeight > 0))
            faults.push("image without size: " + image.getAttribute("src"));
    }
    await document.fonts.ready;
    const arrived = [...document.fonts].some(f => /KaTeX_Main/.test(f.family) && f.status === "loaded");
    if (document.querySelector(".katex") && !arrived) faults.push("KaTeX's fonts are missing");
    return faults;
}
look().then(done);
"""

# In the mode that the browser now prefers: the background, and whether anything is too wide.
LOOK_AT_COLOURS = """
const [dark, done] = arguments;
const faults = [];
function look() {
    const boxes = [document.scrollingElement, document.getElementById("doc-content")];
    const colour = getComputedStyle(document.body).backgroundColor;
    const brightness = colour.match(/[0-9.]+/g).slice(0, 3).reduce((sum, c) => sum + Number(c) / 3, 0);
    const transparent = /, 0\\)$/.test(colour);
    if (boxes.some(box => box && box.scrollWidth > box.clientWidth + 1)) faults.push("scrolls sideways");
    // The content scrolls in its own box; beside it the window must not, or the page can be scrolled away.
    if (boxes[1] && boxes[0].scrollHeight > innerHeight + 1) faults.push("the window scrolls beside the content");
    for (const image of document.querySelectorAll("figure.picture:not(.live) img, .chapters img")) {
        if (getComputedStyle(image).colorScheme !== (dark ? "dark" : "light")) faults.push("a figure does not take the page's colours: " + image.getAttribute("src"));
        const box = image.closest("a.card");
        if (box && box.scrollWidth > box.clientWidth + 1) faults.push("a figure scrolls sideways: " + image.getAttribute("src"));
        // Drawn with letters of 17 px: on a phone the narrow one has them at 12.
        if (/\\.svg$/.test(image.currentSrc) && image.naturalWidth > 500) faults.push("a wide figure on a phone: " + image.getAttribute("src"));
    }
    if (dark && (transparent || brightness > 80)) faults.push("is light");
    if (!dark && !transparent && brightness < 200) faults.push("is dark");
    faults.push(...new Set(pale()), ...unnamed());
    done(faults);
}

const numbers = colour => colour.match(/[0-9.]+/g).map(Number);
function luminance(colour) {
    const [r, g, b] = colour.map(c => (c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
// What stands behind an element; nothing where it is a picture or shines through.
function behind(element) {
    for (; element; element = element.parentElement) {
        const style = getComputedStyle(element), [r, g, b, opaque = 1] = numbers(style.backgroundColor);
        if (style.backgroundImage !== "none" || (opaque > 0 && opaque < 1) || style.opacity < 1) return null;
        if (opaque === 1) return [r, g, b];
    }
    return [255, 255, 255];
}
// Words that stand out less than the rules for the Web's contents ask (WCAG 2.1, 1.4.3).
function* pale() {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), seen = new Set();
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        if (!walker.currentNode.data.trim() || seen.has(element) || element.closest("svg, .katex, script, style")) continue;
        seen.add(element);
        if (!element.checkVisibility?.() || element.getBoundingClientRect().width < 2) continue;
        const style = getComputedStyle(element), ground = behind(element), [r, g, b, opaque = 1] = numbers(style.color);
        if (!ground || opaque < 1) continue;
        const [light, less] = [luminance([r, g, b]), luminance(ground)].sort((x, y) => y - x);
        const large = parseFloat(style.fontSize) >= (style.fontWeight >= 700 ? 18.66 : 24);
        const contrast = (light + 0.05) / (less + 0.05);
        if (contrast < (large ? 3 : 4.5))
            yield `contrast of ${contrast.toFixed(2)}: ${element.tagName.toLowerCase()}.${element.className} ${style.color}`;
    }
}
function* unnamed() {
    if (document.querySelector("#doc-content:not([role=main]), div.header .title:not([role=heading])")) yield "a screen reader is not told what is the main part and its heading";
    for (const box of document.querySelectorAll(".contents :is(pre, div.fragment, table, tbody, p.formulaDsp, .memproto)"))
        if (box.checkVisibility?.() && box.scrollWidth > box.clientWidth + 4 && /auto|scroll/.test(getComputedStyle(box).overflowX) && box.tabIndex < 0 && !box.querySelector("a[href]"))
            yield "the arrow keys cannot scroll: " + box.textContent.trim().slice(0, 40);
    if (!document.documentElement.lang) yield "does not say its language";
    for (const field of document.querySelectorAll("input:not([type=checkbox]):not([type=hidden]), select"))
        if (!field.labels?.length && !field.ariaLabel && field.checkVisibility?.()) yield "a field without a label: " + (field.id || field.name);
    for (const link of document.querySelectorAll(".contents a[href]:not([aria-hidden])"))
        if (!link.textContent.trim() && !link.getAttribute("aria-label") && ![...link.querySelectorAll("img")].some(image => image.alt)) yield "a link without words: " + link.getAttribute("href");
}
// The page hears of the change to dark, and of what is too wide for it, in the next frame, and changes in the one after it.
requestAnimationFrame(() => requestAnimationFrame(look));
"""


# On a desk: listings are not cut, no line begins with the comma behind a formula, and what a mark tells lies on the page.
LOOK_AT_DESK = r"""
const done = arguments[arguments.length - 1], faults = [], range = document.createRange();
for (const fold of document.querySelectorAll("details")) fold.open = true;
const page = document.getElementById("doc-content").getBoundingClientRect();
for (const listing of document.querySelectorAll(".contents div.fragment"))
    if (listing.scrollWidth > listing.clientWidth + 1) faults.push("a listing is cut: " + listing.textContent.slice(0, 40));
const half = 11.9 * 0.85 * parseFloat(getComputedStyle(document.documentElement).fontSize);  // as wide as it may get
for (const mark of document.querySelectorAll(".check")) {
    mark.dispatchEvent(new PointerEvent("pointerover", { bubbles: true }));
    const aside = parseFloat(mark.style.getPropertyValue("--aside")), at = mark.getBoundingClientRect().left + aside;
    if (!(at - half >= page.left && at + half <= page.right)) faults.push("what a mark tells is cut: " + mark.dataset.statement);
}
for (const formula of document.querySelectorAll(".contents .katex")) {
    const text = formula.parentElement.nextSibling, part = [...formula.querySelectorAll(".base")].pop();
    if (text?.nodeType !== 3 || !/^[,.;:]/.test(text.data) || !part) continue;
    range.setStart(text, 0), range.setEnd(text, 1);
    if (range.getBoundingClientRect().top > part.getBoundingClientRect().bottom) faults.push("a line begins with " + text.data.slice(0, 20));
}
if (!document.querySelector(".contents div.line.marked")) faults.push("no line of a listing is marked");
done(faults);
"""


CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def wait(holds, looks=2400):
    """Does this hold at last? Two minutes are given to it, for the machine may be busy."""
    for _ in range(looks):
        if found := holds():
            return found
        time.sleep(0.05)
    return False


class Faults(list):
    def unless(self, holds, sentence):
        if not holds:
            self.append(sentence)


class Browser:
    """A headless Chromium that looks at pages."""

    def __init__(self):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--disable-background-networking", "--no-first-run", "--hide-scrollbars",
                         "--disable-component-update", "--disable-sync",
                         "--user-data-dir=" + self.profile.name):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_script_timeout(300)
        self.run = self.driver.execute_script
        self.screen(*PHONE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()
        self.profile.cleanup()

    def screen(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def prefer(self, value, what="color-scheme"):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-" + what, "value": value}]})

    def open(self, path, anchor=""):
        """The page anew, which begins at the anchor."""
        self.driver.get("about:blank")
        self.driver.get(pathlib.Path(path).resolve().as_uri() + anchor)

    def errors(self):
        """What the console reports."""
        return ["console: " + entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def look_at_colours(self, scheme):
        return [f"{fault} at {PHONE[0]} px in {scheme} mode"
                for fault in self.driver.execute_async_script(LOOK_AT_COLOURS, scheme == "dark")]

    def faults(self, path):
        """A sentence for each fault of the page in this file."""
        self.prefer("light")
        self.open(path)
        found = self.driver.execute_async_script(LOOK)
        found += self.look_at_colours("light")
        self.prefer("dark")
        return found + self.look_at_colours("dark") + self.errors()

    def at_a_desk(self, path):
        """What is wrong with the page on a wide screen."""
        self.prefer("light")
        self.screen(1280, 900)
        self.open(path)
        return self.driver.execute_async_script(LOOK) + self.driver.execute_async_script(LOOK_AT_DESK)

    def folds_open(self, path):
        """Does an address lead to a place that is folded away, by a link, too, and does paper show what is folded?"""
        self.open(path)
        inside = self.run("return [...document.querySelectorAll('details.ask [id]')].map(e => e.id)")
        if not inside:
            return ["no place is folded away, so nothing is tried"]
        found = Faults()
        is_shown = lambda place: self.run("return document.getElementById(arguments[0]).closest('details').open", place)
        found.unless(not is_shown(inside[0]), f"#{inside[0]} is not folded to begin with")
        self.run("location.hash = arguments[0]; dispatchEvent(new HashChangeEvent('hashchange'))", inside[0])
        found.unless(is_shown(inside[0]), f"a link to #{inside[0]} leads into a fold that stays shut")
        self.open(path, "#" + inside[-1])
        found.unless(is_shown(inside[-1]), f"the address #{inside[-1]} leads into a fold that stays shut")
        self.run("dispatchEvent(new Event('beforeprint'))")
        found.unless(self.run("return [...document.querySelectorAll('details.ask')].every(e => e.open)"), "paper does not show what is folded")
        return found

    def menu_leads(self, path, chapters):
        """Does the menu of a phone show a link to each of these pages, once it is opened?"""
        self.screen(*PHONE)
        self.open(path)
        found = self.driver.execute_async_script("""
            const done = arguments[1];
            jQuery(() => setTimeout(() => {
                document.getElementById("main-menu-state").click();
                setTimeout(() => done(arguments[0].filter(page => !document.querySelector(`#main-menu a[href="${page}"]`)?.checkVisibility())), 1000);
            }));""", chapters)
        return [f"the phone's menu does not lead to {page}" for page in found]


def skip(why):
    print("skipped: " + why)
    sys.exit(SKIPPED)


def skip_without_browser():
    if not importlib.util.find_spec("selenium"):
        skip("Selenium is not there (package python3-selenium)")
    if not CHROMIUM or not shutil.which("chromedriver"):
        skip("Chromium or its driver is not there (packages chromium, chromium-driver)")


def report(faults, tried, what):
    """Prints the faults, and ends the program: 0 when there is none and something was tried, else 1."""
    print("\n".join([*faults, f"{tried} {what}, {len(faults)} faults"]))
    sys.exit(1 if faults or not tried else 0)


def kind_of(page):
    template = next((kind for kind, names in KINDS.items() if re.fullmatch(names, page)), None)
    return template or re.sub(r"_*\d+", "", page)


def sample(site, whole):
    """The names of the pages to open, and how many of the site's that are."""
    pages = sorted(name for name in os.listdir(site) if name.endswith(".html"))
    contents = {page: pathlib.Path(site, page).read_bytes() for page in pages}
    largest = {kind_of(page): page for page in sorted(pages, key=lambda page: len(contents[page]))}
    opened = [page for page in pages
              if page in largest.values() or whole and (
                  kind_of(page) not in KINDS or zlib.crc32(contents[page]) % 20 == 0
                  or (kind_of(page) != "sources" and SHOWS_SOMETHING.search(contents[page])))]
    return opened, len(pages)


def main():
    if len(sys.argv) != 2 and sys.argv[2:] != ["--all"]:
        sys.exit("usage: browser.py SITE [--all]")
    skip_without_browser()
    site = sys.argv[1]
    for part, package in (("katex", "libjs-katex"), ("doxygen-awesome.css", "doxygen-awesome-css")):
        if not os.path.exists(os.path.join(site, part)):
            skip(f"the site was made without {part} (package {package})")
    pages, whole = sample(site, len(sys.argv) == 3)
    chapters = [page for page in os.listdir(site) if re.fullmatch(r"chapter_\d\d[.]html", page)]
    found = []
    with Browser() as browser:
        def look(page, at, *more):
            found.extend(f"{page}: {fault}" for fault in at(os.path.join(site, page), *more))
        for page in pages:
            look(page, browser.faults)
        for page in pages:
            if page.startswith(("chapter_", "more_")):
                look(page, browser.at_a_desk)
        look("index.html", browser.menu_leads, chapters)
        look(FOLDS, browser.folds_open)
    report(found, len(pages), f"of {whole} pages")


if __name__ == "__main__":
    main()
