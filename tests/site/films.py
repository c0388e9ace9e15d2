#!/usr/bin/env python3
"""Do the films of the site play, stop, and show each frame in a browser, with real events?

    films.py SITE    prints a line for each fault; exit status 0 when there is none, 1 when there is one,
                     77 (skipped) when Chromium or Selenium is not there
"""

import pathlib
import sys
import time

import browser
from browser import Faults, wait

# What the test asks of a film: a hash of each of these frames, as the canvas shows it.
FRAMES = """
const film = document.querySelectorAll("figure.animation")[arguments[0]].film, done = arguments[2];
film.play(false);
(async () => {
    const hashes = [];
    for (const k of arguments[1]) {
        await film.show(Math.min(k, film.frames.length - 1));
        const data = film.pen.getImageData(0, 0, film.canvas.width, film.canvas.height).data;
        let sum = 0;
        for (let i = 0; i < data.length; i += 4) sum = Math.imul(sum, 31) + data[i] + 7 * data[i + 1] | 0;
        hashes.push(sum);
    }
    return hashes;
})().then(done);"""


def film_plays(on, i, faults):
    """The page is open: its film number i plays, stops, shows each frame wherever it comes from, and stays calm."""
    driver = on.driver
    film = lambda what: driver.execute_script(f"const f = document.querySelectorAll('figure.animation')[arguments[0]]; {what}", i)
    film("f.scrollIntoView({block: 'center'})")
    if not wait(lambda: film("return f.classList.contains('is-film')")):
        faults.append(f"film {i} does not start")
        return
    shown = film("return f.film.shown")
    faults.unless(wait(lambda: film("return f.film.shown") != shown), f"film {i} does not play")
    film("f.querySelector('button.play').click()")
    wait(lambda: film("return f.film.drawing === null"))  # the frame that was under way
    shown = film("return f.film.shown")
    time.sleep(0.3)
    faults.unless(film("return f.film.shown") == shown, f"film {i} plays on when it is stopped")
    there, back, again, first, last = driver.execute_async_script(FRAMES, i, [40, 5, 40, 0, 1e6])
    faults.unless(there == again, f"frame 40 of film {i} is another when it comes after frame 5")
    faults.unless(len({there, back, first, last}) >= 3, f"film {i} stands still")
    from selenium.webdriver.common.keys import Keys
    slider = film("return f.querySelector('input[type=range]')")
    slider.send_keys(Keys.HOME)
    faults.unless(wait(lambda: film("return f.film.shown") == 0), f"Home does not lead film {i} to its start")
    slider.send_keys(Keys.ARROW_RIGHT)
    faults.unless(wait(lambda: film("return f.film.shown") == 1), f"an arrow does not move film {i} by a frame")
    faults.unless(film("f.querySelector('select').value = 4; f.querySelector('select').dispatchEvent(new Event('change')); "
                       "return f.film.speed") == 4, f"film {i} has no speed")


def films(on, site, faults):
    count = 0
    for file in sorted(pathlib.Path(site).glob("*.html")):
        number = file.read_text(encoding="utf-8", errors="replace").count('class="picture animation"')
        if number == 0:
            continue
        count += number
        on.open(file)
        found = Faults()
        for i in range(number):
            film_plays(on, i, found)
        on.prefer("reduce", "reduced-motion")
        on.open(file)
        on.run("document.querySelector('figure.animation').scrollIntoView({block: 'center'})")
        wait(lambda: on.run("return document.querySelector('figure.animation').classList.contains('is-film')"))
        time.sleep(0.4)
        found.unless(on.run("return document.querySelector('figure.animation').film.shown") == 0,
                     "a film plays though the reader prefers reduced motion")
        on.prefer("no-preference", "reduced-motion")
        faults += [f"{file.name}: {fault}" for fault in found + on.errors()]
    return count


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: films.py SITE")
    browser.skip_without_browser()
    faults = Faults()
    with browser.Browser() as on:
        on.screen(900, 900)
        count = films(on, sys.argv[1], faults)
    browser.report(faults, count, "films")


if __name__ == "__main__":
    main()
