// The colours of panels, on light and on dark pages.
"use strict";

// A colour as it is on the page: on the dark ground as tools/page/drawing.cpp has it.
function shade(colour) {
    if (!document.documentElement.classList.contains("dark-mode")) return colour;
    const below = .0623;  // the ground's light, and what contrast adds
    const light = [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16) / 255).map(x => x <= .04045 ? x / 12.92 : ((x + .055) / 1.055) ** 2.4);
    const here = .2126 * light[0] + .7152 * light[1] + .0722 * light[2], onWhite = 1.05 / (here + .05);
    const rgb = all => `rgb(${all.map(x => Math.round(255 * (x <= .0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - .055)))})`;
    if (light.every(x => x === light[0])) return rgb(light.fill(Math.min(onWhite * below - .05, .85)));
    const aim = Math.min(Math.max(onWhite, 4.5), 6.5) * below - .05;
    if (here >= aim) return colour;
    const more = Math.min((here + aim) / 2 / here, 1 / Math.max(...light)), share = (aim - more * here) / (1 - more * here);
    return rgb(light.map(x => more * x + share * (1 - more * x)));
}
// The colour, with a line's strokes and gaps.
function dashed(colour, dashes) {
    let at = 0;
    return `repeating-linear-gradient(90deg,${(dashes || "1").split(",").map((n, i) => `${i % 2 ? "#0000" : colour} ${at}px ${at += +n}px`)})`;
}
// Does what paints now, and whenever the page turns dark or light.
const painters = [];
function paint(painter) {
    painters.push(painter);
    painter();
}
new MutationObserver(() => painters.forEach(painter => painter())).observe(document.documentElement, { attributeFilter: ["class"] });
