"""A panel's page in the browser, and what a test asks of it."""

import pathlib
import time

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


def wait(holds, looks=2400):
    """Does this hold at last? Two minutes are given to it, for the machine may be busy."""
    for _ in range(looks):
        if holds():
            return True
        time.sleep(0.05)
    return False


class Faults(list):
    def unless(self, holds, sentence):
        if not holds:
            self.append(sentence)


class Page:
    """A panel's page in the browser."""

    def __init__(self, on, file, name):
        self.on, self.driver = on, on.driver
        self.address = pathlib.Path(file).resolve().as_uri()
        self.id = "live-" + name

    def run(self, script, *arguments):
        return self.driver.execute_script(script, self.id, *arguments)

    wait = staticmethod(wait)

    def open(self, words=""):
        self.driver.get("about:blank")
        self.driver.get(self.address + "#" + self.id + (":" + words if words else ""))
        there = self.wait(lambda: self.run(READY))
        self.run("document.getElementById(arguments[0]).scrollIntoView()")
        return there

    def part(self, what):
        return self.driver.find_element("css selector", f"#{self.id} {what}")

    def button(self, words):
        return next(b for b in self.driver.find_elements("css selector", f"#{self.id} button") if words in b.text)

    def controls(self):
        return self.run(CONTROLS)

    def box(self, what):
        return self.driver.execute_script(
            "const b = arguments[0].getBoundingClientRect(); return [b.left, b.top, b.width, b.height]", self.part(what))

    def touch(self, *places):
        """A finger: down at the first place, through the others, and up."""
        for i, (x, y) in enumerate(places):
            self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": "touchMove" if i else "touchStart", "touchPoints": [{"x": x, "y": y}]})
        self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
