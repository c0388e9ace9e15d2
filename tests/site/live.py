#!/usr/bin/env python3
"""Do the live panels of the site work in a browser, with real events, and do they end on the bits of the programs?

    live.py SITE BUILD [PANEL]    prints a line for each fault; exit status 0 when there is none, 1 when there is one, 77
                                  (skipped) when Chromium, Selenium or a panel's module is not there

BUILD/chapters/NN_name/live/live_panel are the same panels as programs: what they print is compared.
"""

import pathlib
import re
import subprocess
import sys
import time

import browser
from browser import Faults, wait

MODULE, SCRIPT = 60_000, 15_000  # bytes, at most
DESK, LAPTOP, PHONE = (900, 900), (1280, 800), (390, 844)
PANEL = re.compile(r'<figure id="live-(\w+)"[^>]*data-live="([^"]+)" data-module="([^"]+)"')
# What the test asks of a panel on the page: the object that live.js leaves at its figure.
READY = "return document.getElementById(arguments[0]).classList.contains('is-live')"
LIVE = "const live = document.getElementById(arguments[0]).live, of = live.of; "
CONTROLS = LIVE + """
return live.controls.map((c, i) => ({ name: c.name, kind: of.control_number(i, 0), least: of.control_number(i, 1),
    most: of.control_number(i, 2), value: c.get() }));"""
# Restarts, carries out the words as the program for the shell does, and hashes what is drawn (FNV-1a, 64 bits). Each look at
# the clock is 2 ms after the one before, as the program has it by its word clock=2.
BITS = LIVE + """
live.play(false);
const now = performance.now;
let ticks = 0;
performance.now = () => ticks += 2;
for (const c of live.controls) c.set(c.first);
of.begin();
for (const word of arguments[1]) {
    const [name, value] = word.split("=");
    if (name === "steps") live.steps(Number(value));
    else if (name === "grab" || name === "drag") of[name](...value.split(",").map(Number));
    else if (name === "let_go") of.let_go();
    else live.controls.find(c => c.name === name).set(Number(value));
}
performance.now = now;
const size = of.draw(0), bytes = new Uint8Array(of.memory.buffer, of.commands(), size * 8);
let sum = 14695981039346656037n;
for (const byte of bytes) sum = (sum ^ BigInt(byte)) * 1099511628211n & 0xffffffffffffffffn;
const readouts = [...Array(of.readouts()).keys()].map(i => of.readout(i));
return [sum.toString(16).padStart(16, "0"), readouts, of.broken(), live.broke || ""];"""
# All places of the picture, as one number.
PICTURE = LIVE + """
const size = of.draw(0);
return new Float64Array(of.memory.buffer, of.commands(), size).reduce((sum, x, i) => sum + x * (1 + i % 97), 0);"""
STEPS = LIVE + "return of.steps()"
DRAWN = LIVE + """
const pixels = live.picture.pen.getImageData(0, 0, live.canvas.width, live.canvas.height).data;
let inked = 0;
for (let i = 3; i < pixels.length; i += 4) inked += pixels[i] > 0;
return inked / (pixels.length / 4);"""


class Page:
    """A panel's page in the browser."""

    def __init__(self, on, file, name):
        self.on, self.driver, self.file = on, on.driver, file
        self.id = "live-" + name

    def run(self, script, *arguments):
        return self.on.run(script, self.id, *arguments)

    def open(self, words=""):
        self.on.open(self.file, "#" + self.id + (":" + words if words else ""))
        there = wait(lambda: self.run(READY))
        self.run("document.getElementById(arguments[0]).scrollIntoView()")
        return there

    def part(self, what):
        return self.driver.find_element("css selector", f"#{self.id} {what}")

    def button(self, words):
        return next(b for b in self.driver.find_elements("css selector", f"#{self.id} button") if words in b.text)

    def controls(self):
        return self.run(CONTROLS)

    def box(self, what):
        return self.on.run(
            "const b = arguments[0].getBoundingClientRect(); return [b.left, b.top, b.width, b.height]", self.part(what))

    def touch(self, *places):
        """A finger: down at the first place, through the others, and up."""
        for i, (x, y) in enumerate(places):
            self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": "touchMove" if i else "touchStart", "touchPoints": [{"x": x, "y": y}]})
        self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def native(build, live, words):
    """Hash and readouts of the panel as a program."""
    chapter, name = live.split("/")
    program = pathlib.Path(build, "chapters", "live_" + name)
    said = subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout
    return (re.search(r"^bits: (\w+)$", said, re.M)[1],
            [float(number) for number in re.findall(r"^.*: (?!not yet)(\S+) \S*$", said, re.M)])


def same_bits(page, build, live, source, faults):
    excused = re.search(r"^// not the same bits: (.*)", source, re.M)
    sliders = [c for c in page.controls() if c["kind"] < 2]
    middle = [f"{c['name']}={(c['least'] + c['most']) / 2!r}" for c in sliders]
    for words in (["steps=400"], middle + ["steps=300"], ["steps=3", "grab=0.5,0.25", "drag=0.75,0.5", "steps=50", "let_go", "steps=200"]):
        found, readouts, broken, refused = page.run(BITS, words)
        right, numbers = native(build, live, ["clock=2", *words])
        faults.unless(not refused, f"{words}: {refused}")
        if not excused:
            faults.unless(found == right, f"after {words} its bits are {found}, natively {right}; readouts "
                                          f"{readouts}, natively {numbers}")


def goes_and_stops(page, faults):
    run = lambda script, *more: page.run(script, *more)
    faults.unless(page.open(), "does not start")
    first = run(STEPS)
    faults.unless(wait(lambda: run(STEPS) > first), "does not move by itself")
    faults.unless(run(DRAWN) > 0.002, "draws nothing")
    page.button("Stop").click()
    stopped = run(STEPS)
    time.sleep(0.3)
    faults.unless(run(STEPS) == stopped, "goes on when it is stopped")
    page.button("One step").click()
    faults.unless(run(STEPS) == stopped + 1, "One step is none")
    page.button("Restart").click()
    faults.unless(run(STEPS) == 0, "Restart does not")
    page.button("Play").click()
    faults.unless(wait(lambda: run(STEPS) > 0), "Play does not")

    # Off screen it stands; back on screen it goes on.
    scroll = "(document.getElementById('doc-content') || document.scrollingElement).scrollTop = arguments[0]; " \
             "document.scrollingElement.scrollTop = arguments[0]"
    page.on.run("document.getElementById(arguments[0]).parentElement.style.paddingBottom = '4000px';", page.id)
    page.on.run(scroll, 1e6)
    faults.unless(wait(lambda: not run("return document.getElementById(arguments[0]).live.plays")), "goes on off screen")
    there = run(STEPS)
    time.sleep(0.3)
    faults.unless(run(STEPS) == there, "steps off screen")
    run("document.getElementById(arguments[0]).scrollIntoView()")
    faults.unless(wait(lambda: run(STEPS) > there), "does not go on when it is back on screen")


def moves(page, action):
    """Does the picture a few steps after a restart depend on what the action does before them?"""
    restart, on = LIVE + "live.play(false); of.begin(); live.show()", LIVE + "live.steps(5)"
    page.run(restart)
    page.run(on)
    without = page.run(PICTURE)
    page.run(restart)
    action()
    page.run(on)
    return page.run(PICTURE) != without


def by_keyboard(page, faults):
    from selenium.webdriver.common.keys import Keys
    page.open()
    page.button("Stop").click()
    before = page.controls()
    sliders = [c for c in before if c["kind"] < 2]
    if sliders:
        slider = page.part(f"input[type=range]")
        slider.send_keys(Keys.HOME)
        faults.unless(page.controls()[before.index(sliders[0])]["value"] <= sliders[0]["least"] * 1.001, "Home does not move its slider")
        slider.send_keys(Keys.ARROW_RIGHT)
        faults.unless(page.controls()[before.index(sliders[0])]["value"] > sliders[0]["least"], "an arrow does not move its slider")
        typed = page.part("input[type=number]")
        typed.clear()
        typed.send_keys("1e999" + Keys.ENTER)
        value = page.controls()[before.index(sliders[0])]["value"]
        faults.unless(value <= sliders[0]["most"], f"takes {value} for a number")
    if not page.run(LIVE + "return Number.isNaN(of.handle(0))"):
        faults.unless(moves(page, lambda: page.part("canvas").send_keys(Keys.ARROW_RIGHT + Keys.ARROW_UP)),
                      "the arrow keys move nothing")


def by_finger(page, faults):
    page.open()
    page.button("Stop").click()
    if any(c["kind"] < 2 for c in page.controls()):
        page.run("document.querySelector(`#${arguments[0]} input[type=range]`).scrollIntoView({block: 'center'})")
        left, top, width, height = page.box("input[type=range]")
        faults.unless(height >= 24, f"its sliders are {height} px high")
        before = page.controls()
        page.touch((left + width / 2, top + height / 2), (left + width * 0.8, top + height / 2))
        faults.unless(page.controls() != before, "a finger does not move its slider")
    if page.run(LIVE + "live.canvas.scrollIntoView({block: 'center'}); return Number.isNaN(of.handle(0))"):
        return
    held = lambda: page.run(LIVE + """const box = live.canvas.getBoundingClientRect(), p = live.picture; p.part = p.main;
        return [p.x(of.handle(0)), p.y(of.handle(1)), box.left, box.top]""")

    def finger():
        x, y, left, top = held()
        x, y = left + x, top + y
        page.touch((x, y), (x + 10, y - 8), (x + 25, y - 20))
    faults.unless(moves(page, finger), "a finger does not drag what can be dragged")

    def mouse():
        from selenium.webdriver import ActionChains
        x, y, _, _ = held()
        canvas = page.part("canvas")
        ActionChains(page.driver).move_to_element_with_offset(
            canvas, int(x - canvas.size["width"] / 2), int(y - canvas.size["height"] / 2)) \
            .click_and_hold().move_by_offset(-20, 15).release().perform()
    page.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})
    faults.unless(moves(page, mouse), "the mouse does not drag what can be dragged")
    page.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})


def scrolls_under_a_finger(page, faults):
    """Where there is nothing to take hold of, a finger is left to the page: in some corner at least."""
    page.open()
    page.run("document.getElementById(arguments[0]).live.canvas.scrollIntoView({block: 'center'}); window.taken = [];"
             "window.addEventListener('touchstart', event => window.taken.push(event.defaultPrevented))")
    left, top, width, height = page.box("canvas")
    for x, y in ((4, 4), (width - 4, 4), (4, height - 4), (width - 4, height - 4)):
        page.touch((left + x, top + y))
    taken = page.on.run("return window.taken")
    faults.unless(len(taken) == 4 and not all(taken), f"no corner of it lets the page scroll under a finger ({taken})")


def carries_settings(page, faults):
    page.open()
    sliders = [c for c in page.controls() if c["kind"] < 2]
    page.run(LIVE + "const c = live.controls[arguments[1]]; c.set(of.control_number(arguments[1], 2))", 0)
    wanted = page.controls()[0]["value"]
    page.button("Link").click()
    address = page.driver.current_url
    faults.unless("#" + page.id + ":" in address, f"its link is {address}")
    page.on.open(page.file, address[address.index("#"):])
    faults.unless(wait(lambda: page.run(READY)), "does not start from its link")
    faults.unless(page.controls()[0]["value"] == wanted, "its link does not carry the settings")
    page.open("no_such_control=1," + (sliders[0]["name"] + "=nonsense" if sliders else ""))
    faults.unless(wait(lambda: page.run(READY)), "does not start from a link with nonsense in it")


def keeps_calm(page, faults):
    page.on.prefer("reduce", "reduced-motion")
    page.open()
    time.sleep(0.3)
    faults.unless(page.run(STEPS) == 0, "moves though the reader prefers reduced motion")
    page.button("Play").click()
    faults.unless(wait(lambda: page.run(STEPS) > 0), "Play does not with reduced motion")
    page.on.prefer("no-preference", "reduced-motion")


def seen_together(page, faults):
    """On a phone the picture stands whole above each slider that has been scrolled to."""
    page.on.screen(*PHONE)
    page.open()
    hidden = page.run("""
        const figure = document.getElementById(arguments[0]), canvas = figure.querySelector("canvas");
        return [...figure.querySelectorAll(".live-control")].filter(row => {
            row.querySelector("input, select").scrollIntoView({ block: "nearest" });
            const picture = canvas.getBoundingClientRect(), control = row.getBoundingClientRect();
            const at = document.elementFromPoint(picture.left + picture.width / 2, picture.top + 2);
            return at !== canvas || picture.bottom > control.top + 1 || control.bottom > innerHeight + 1;
        }).map(row => row.textContent)""")
    faults.unless(not hidden, f"on a phone its picture is not whole while one slides {', '.join(hidden)}")
    page.on.screen(*DESK)


def fits_the_screen(page, faults):
    """One sees the whole picture with all that can be set; on a phone with the first two of it."""
    for screen, most in (LAPTOP, 99), (PHONE, 2):
        page.on.screen(*screen)
        page.open()
        last = page.run("""const figure = document.getElementById(arguments[0]);
            return [...figure.querySelectorAll(".live-control")].slice(0, arguments[1]).at(-1).getBoundingClientRect().bottom""", most)
        faults.unless(last <= screen[1], f"at {screen[0]} px its controls end {last - screen[1]:.0f} px below the screen")
    page.on.screen(*DESK)


LOOKS = (fits_the_screen, by_keyboard, by_finger, scrolls_under_a_finger, seen_together,
         carries_settings, keeps_calm)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: live.py SITE BUILD [PANEL]")
    browser.skip_without_browser()
    site, build = sys.argv[1:3]
    panels = [(file, *found) for file in sorted(pathlib.Path(site).glob("*.html"))
              for found in PANEL.findall(file.read_text(encoding="utf-8", errors="replace"))
              if len(sys.argv) == 3 or found[0] == sys.argv[3]]
    if not panels:
        browser.skip("the site has no panel that moves (no compiler for WebAssembly)")
    root = pathlib.Path(__file__).resolve().parents[2]
    found = Faults()
    script = (pathlib.Path(site) / "live.js").stat().st_size
    found.unless(script <= SCRIPT, f"live.js: has {script} bytes, must have at most {SCRIPT}")
    with browser.Browser() as on:
        on.screen(*DESK)
        on.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})
        seen = set()
        for file, name, live, module in panels:
            if live in seen:
                continue
            seen.add(live)
            faults = Faults()
            size = pathlib.Path(build, "chapters", live.split("/")[0], "live", name + ".wasm").stat().st_size
            faults.unless(size <= MODULE, f"has {size} bytes, must have at most {MODULE}")
            page = Page(on, file, name)
            goes_and_stops(page, faults)
            page.open()
            same_bits(page, build, live, (root / "chapters" / live.replace("/", "/live/")).with_suffix(".cpp").read_text(), faults)
            for look in LOOKS:
                look(page, faults)
            found += [f"{live}: {fault}" for fault in faults + on.errors()]
    browser.report(found, len(seen), "panels")


if __name__ == "__main__":
    main()
