"""Does the search of the site lead readers to what they ask for?

    search.py SITE

Types every query of queries.tsv beside this file into the search field of the start page, in a real browser and from a
file:// address, and reads the first hit. Then the keyboard alone: down, up, Enter, Escape; what is not there; another page."""

import os
import pathlib
import sys

from browser import Browser, report, skip, skip_without_browser, wait


def queries():
    lines = pathlib.Path(__file__).with_name("queries.tsv").read_text().splitlines()
    return [(text, places.split()) for text, places in (line.split("\t") for line in lines if line and line[0] != "#")]


class Search:
    def __init__(self, driver, page):
        self.driver = driver
        driver.get(pathlib.Path(page).resolve().as_uri())
        wait(lambda: driver.execute_script("return !!document.getElementById('found')"))
        self.field = driver.find_element("id", "MSearchField")

    def hits(self, text):
        """The addresses that are offered, below the site."""
        self.driver.execute_script("document.getElementById('found').replaceChildren()")
        if self.field.get_attribute("value"):
            self.field.clear()
        self.field.send_keys(text)
        shown = ("const list = document.getElementById('found'); return list.hidden || list.textContent.startsWith('Reading') || "
                 "!list.textContent ? null : [...list.querySelectorAll('a')].map(a => a.getAttribute('href'))")
        return wait(lambda: (found := self.driver.execute_script(shown)) is not None and [found])[0]


def faults(driver, site):
    from selenium.webdriver.common.keys import Keys
    search = Search(driver, os.path.join(site, "index.html"))
    for text, places in queries():
        hits = search.hits(text)
        if not hits or not hits[0].startswith(tuple(places)):
            yield f"{text}: the first hit is {hits[0] if hits else 'none'}, not {' or '.join(places)}; then {hits[1:4]}"
    if search.hits("zzzzqqq"):
        yield "zzzzqqq is found"
    first, second = search.hits("eigenvalue")[:2]
    focused = "return document.activeElement.getAttribute('href') ?? document.activeElement.id"
    for key, right in ((Keys.ARROW_DOWN, first), (Keys.ARROW_DOWN, second), (Keys.ARROW_UP, first), (Keys.ESCAPE, "MSearchField")):
        driver.switch_to.active_element.send_keys(key)
        if driver.execute_script(focused) != right:
            yield f"after {key!r} {driver.execute_script(focused)} has the focus, not {right}"
    if driver.execute_script("return !document.getElementById('found').hidden"):
        yield "after Escape the hits are still there"
    search.hits("eigenvalue")
    search.field.send_keys(Keys.ENTER)
    if not wait(lambda: driver.current_url.endswith(first)):
        yield f"Enter leads to {driver.current_url}, not to {first}"
    for page in ("chapter_05", "exercises_5", "glossary", "annotated"):  # short ones are loaded before Doxygen is done
        for again in range(3):
            if not Search(driver, os.path.join(site, page + ".html")).hits("stiff"):
                yield f"the page {page} finds nothing"
    driver.set_window_size(390, 844)
    if not Search(driver, os.path.join(site, "chapter_05.html")).hits("stiff"):
        yield "a phone finds nothing"
    wide = driver.execute_script("const box = document.getElementById('found').getBoundingClientRect(); return [box.left, box.right, innerWidth]")
    if wide[0] < 0 or wide[1] > wide[2]:
        yield f"on a phone the hits go from {wide[0]} to {wide[1]}, and the screen ends at {wide[2]}"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: search.py SITE")
    skip_without_browser()
    if not os.path.exists(os.path.join(sys.argv[1], "lunr.min.js")):
        skip("the site was made without lunr (package libjs-lunr)")
    with Browser() as browser:
        found = list(faults(browser.driver, sys.argv[1]))
    report(found, len(queries()), "queries")


if __name__ == "__main__":
    main()
