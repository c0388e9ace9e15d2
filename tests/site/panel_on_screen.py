"""How a panel stands on the screen: what of it is seen at once, where its parts are, and whether its words can be read."""

from panel import BITS, LIVE

DESK, LAPTOP, PHONE = ({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
                       for width, height in ((900, 900), (1280, 800), (390, 844)))


def on_screen(page, screen):
    page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)


def says_what_it_took(page, faults):
    """A number beyond an end, typed or in a link, is taken for that end, and it says so until another one is set."""
    from selenium.webdriver.common.keys import Keys
    page.open()
    page.button("Stop").click()
    slider = next((c for c in page.controls() if c["kind"] < 2), None)
    if not slider:
        return
    said = lambda: page.part(".live-status").text

    def enter(number):
        page.run("document.querySelector(`#${arguments[0]} input[type=number]`).select()")
        page.part("input[type=number]").send_keys(number + Keys.ENTER)
        return next(c["value"] for c in page.controls() if c["name"] == slider["name"])
    for number, end in (repr(2 * slider["most"] + 1), slider["most"]), ("-1000000", slider["least"]):
        taken = enter(number)
        words = page.run("return written(arguments[1])", end)
        faults.unless(taken == end and words + " taken." in said(), f"typed {number} it takes {taken} and says '{said()}'")
    taken = enter(repr(slider["most"]))
    faults.unless(taken == slider["most"] and "taken." not in said(), f"typed {slider['most']} it takes {taken} and says '{said()}'")
    page.open(f"{slider['name']}=-1000000")
    faults.unless(page.wait(lambda: " taken." in said(), 40), f"with -1000000 in its link it says '{said()}'")


def seen_together(page, faults):
    """On a phone the picture stands whole above each slider that has been scrolled to."""
    on_screen(page, PHONE)
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
    on_screen(page, DESK)


def fits_the_screen(page, faults):
    """One sees the whole picture with all that can be set; on a phone with the first two of it."""
    for screen, most in (LAPTOP, 99), (PHONE, 2):
        on_screen(page, screen)
        page.open()
        last = page.run("""const figure = document.getElementById(arguments[0]);
            return [...figure.querySelectorAll(".live-control")].slice(0, arguments[1]).at(-1).getBoundingClientRect().bottom""", most)
        faults.unless(last <= screen["height"], f"at {screen['width']} px its controls end {last - screen['height']:.0f} px below the screen")
    on_screen(page, DESK)


# What a panel writes into its picture: words, their box, and how much they stand out from the ground.
WRITTEN = LIVE + """
const pen = live.picture.pen, all = [], ground = getComputedStyle(live.canvas).backgroundColor;
const light = colour => { pen.fillStyle = colour; const n = parseInt(pen.fillStyle.slice(1), 16);
    return [16, 8, 0].map(k => (n >> k & 255) / 255).map(c => c < .04 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4)
        .reduce((sum, c, i) => sum + c * [.2126, .7152, .0722][i], .05); };
pen.fillText = (words, x, y) => {
    const box = pen.measureText(words), colour = pen.fillStyle, contrast = light(colour) / light(ground);
    pen.fillStyle = colour;
    const whole = { left: 0, top: 0, right: live.picture.width, bottom: live.picture.height };
    // Beside the axes is room; what a panel itself writes is cut where its part of the picture ends.
    if (words) all.push({ words, within: pen.textAlign === "start" ? live.picture.part : whole,
        left: x - box.actualBoundingBoxLeft, right: x + box.actualBoundingBoxRight, top: y - box.actualBoundingBoxAscent,
        bottom: y + box.actualBoundingBoxDescent, contrast: Math.max(contrast, 1 / contrast) });
};
live.picture.draw(new Float64Array(of.memory.buffer, of.commands(), of.draw(live.narrow)));
delete pen.fillText;
const cut = all.filter(({ within, ...w }) => w.left < within.left - 1 || w.top < within.top - 1 || w.right > within.right + 1
    || w.bottom > within.bottom + 1);
const touch = all.filter((w, i) => all.slice(0, i).some(v => w.left < v.right + 2 && v.left < w.right + 2
    && w.top < v.bottom && v.top < w.bottom));
return [cut, touch, all.filter(w => w.contrast < 2)].map(some => some.map(w => w.words))"""


def can_be_read(page, faults):
    """The words in the picture are whole, apart, and stand out from the ground: on a phone and a desk, in light and in dark."""
    for screen in PHONE, DESK:
        for scheme in "light", "dark":
            on_screen(page, screen)
            page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
            page.open()
            ends = [f"{c['name']}={c['most']}" for c in page.controls()]
            for words in [], ["steps=300"], ends + ["steps=300"]:
                page.run(BITS, words)
                cut, touch, pale = page.run(WRITTEN)
                faults.unless(not cut + touch + pale, f"{screen['width']} px, {scheme}, {words}: cut {cut}, touching {touch}, pale {pale}")
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
