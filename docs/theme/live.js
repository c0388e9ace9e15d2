// Live panels: the chapter's own C++, compiled to WebAssembly (tools/live), moves in the page. A panel's module is
// a script of its own beside its still picture, live_NAME.js, loaded when the panel comes near the screen.

"use strict";

const liveModules = {};  // what such a script hands over: liveModules[name] = base64
const calmReader = window.matchMedia("(prefers-reduced-motion: reduce)");

function element(tag, attributes = {}, ...children) {
    const made = Object.assign(document.createElement(tag), attributes);
    made.append(...children);
    return made;
}

const count = n => [...Array(n).keys()];

// ---- The picture: draws the commands of tools/live/live.hpp, as still.hpp does --------------------------

class LiveCanvas {
    constructor(canvas, text) {
        this.canvas = canvas;
        this.pen = canvas.getContext("2d");
        this.text = text;  // the words of a number among the commands
    }

    resize(aspect) {
        const scale = window.devicePixelRatio || 1;
        this.width = this.canvas.clientWidth;
        this.height = Math.round(this.width * aspect);
        this.canvas.style.height = this.height + "px";
        this.canvas.width = Math.round(this.width * scale);
        this.canvas.height = Math.round(this.height * scale);
        this.pen.setTransform(scale, 0, 0, scale, 0, 0);
    }

    x(at) { return this.part.left + (at - this.part.fromX) * this.part.scaleX; }
    y(at) { return this.part.bottom - (at - this.part.fromY) * this.part.scaleY; }
    // Where a place of the canvas is in the scene, as its first part shows it.
    place(px, py) {
        const part = this.main;
        return [part.fromX + (px - part.left) / part.scaleX, part.fromY + (part.bottom - py) / part.scaleY];
    }

    fit() {
        const part = this.part, [left, right, bottom, top, equal] = part.shown;
        const w = part.right - part.left, h = part.bottom - part.top;
        part.fromX = left, part.fromY = bottom;
        part.scaleX = w / (right - left), part.scaleY = h / (top - bottom);
        if (!equal) return;
        part.scaleX = part.scaleY = Math.min(part.scaleX, part.scaleY);
        part.fromX -= (w / part.scaleX - (right - left)) / 2;
        part.fromY -= (h / part.scaleY - (top - bottom)) / 2;
    }

    draw(commands) {
        const pen = this.pen, lengths = [10, 5, 4, 3, 3, 1, 1, 4, 4];
        let path = false;  // is one begun? Moves before its stroke add to it
        this.main = null;
        pen.clearRect(0, 0, this.width, this.height);
        pen.save();
        for (let i = 0; i < commands.length; i += lengths[commands[i]]) {
            const [what, a, b, c, d] = commands.subarray(i, i + 5);
            if (what === 0) {
                const [left, right, bottom, top] = commands.subarray(i + 6, i + 10);
                this.part = { shown: commands.slice(i + 1, i + 6), left: left * this.width + 8, right: right * this.width - 8,
                    bottom: (1 - bottom) * this.height - 8, top: (1 - top) * this.height + 8 };
                this.main = this.main || this.part;
                this.fit();
                this.clip();
            } else if (what === 1) {
                this.axes(this.text(a), this.text(b), c, d);
                this.clip();
            } else if (what === 2) {
                pen.strokeStyle = pen.fillStyle = this.text(a, "colour");
                pen.setLineDash(this.text(a, "dashes").split(",").filter(Boolean).map(Number));
                pen.lineWidth = b, pen.globalAlpha = c;
            } else if (what === 3) {
                if (!path) pen.beginPath();
                path = true, pen.moveTo(this.x(a), this.y(b));
            } else if (what === 4) pen.lineTo(this.x(a), this.y(b));
            else if (what === 5) path = false, pen.stroke();
            else if (what === 6) path = false, pen.fill();
            else if (what === 7) path = false, pen.beginPath(), pen.arc(this.x(a), this.y(b), c, 0, 7), pen.fill();
            else pen.fillText(this.text(c), this.x(a), this.y(b));
        }
        pen.restore();
    }

    // Nothing leaves its part of the picture.
    clip() {
        const { left, right, top, bottom } = this.part, pen = this.pen;
        pen.restore(), pen.save();
        pen.beginPath(), pen.rect(left, top, right - left, bottom - top), pen.clip();
        pen.font = this.font(), pen.lineJoin = "round";
    }
    font() { return (this.width < 500 ? 12 : 14) + "px sans-serif"; }

    // Ticks at 1, 2 or 5 times a power of ten; on a log axis at whole powers.
    ticks(from, to, log, most) {
        let gap = 10 ** Math.floor(Math.log10((to - from) / 5));
        if ((to - from) / gap > most) gap *= (to - from) / gap > 2.5 * most ? 5 : 2;
        if (log) gap = Math.max(1, Math.ceil(gap));
        const all = [];
        for (let n = Math.ceil(from / gap); n * gap <= to + gap / 1000; ++n) all.push(n * gap);
        return all.map(at => [at, log ? "1e" + at : String(Number(at.toPrecision(6)))]);
    }

    axes(wordX, wordY, logX, logY) {
        const pen = this.pen, part = this.part;
        const line = (x1, y1, x2, y2, colour) => {
            pen.strokeStyle = colour, pen.beginPath(), pen.moveTo(x1, y1), pen.lineTo(x2, y2), pen.stroke();
        };
        const write = (words, x, y, align) => { pen.textAlign = align, pen.fillText(words, x, y); };
        pen.restore(), pen.save();
        part.left += 48, part.bottom -= 38;
        this.fit();
        const { left, right, top, bottom } = part, most = right - left < 300 ? 6 : 10;
        pen.lineWidth = 1, pen.fillStyle = "#333", pen.font = this.font();
        for (const [at, words] of this.ticks(part.fromX, part.fromX + (right - left) / part.scaleX, logX, most)) {
            line(this.x(at), top, this.x(at), bottom, "#ddd");
            write(words, this.x(at), bottom + 16, "center");
        }
        for (const [at, words] of this.ticks(part.fromY, part.fromY + (bottom - top) / part.scaleY, logY, 10)) {
            line(left, this.y(at), right, this.y(at), "#ddd");
            write(words, left - 5, this.y(at) + 5, "right");
        }
        line(left, bottom, right, bottom, "#333");
        line(left, top, left, bottom, "#333");
        write(wordX, (left + right) / 2, bottom + 33, "center");
        write(wordY, left + 6, top + 12, "left");
    }
}

// ---- A panel -------------------------------------------------------------------------------------------

class LivePanel {
    constructor(figure) {
        this.figure = figure;
        this.name = figure.dataset.live;
        this.plays = this.wanted = this.seen = false;
    }

    async start() {
        await load("script", { src: this.figure.dataset.module });
        const bytes = Uint8Array.from(atob(liveModules[this.name]), c => c.charCodeAt(0));
        const none = () => { throw new Error("the module calls what a page has not"); };
        const missing = new Proxy({}, { get: (_, name) => name === "clock" ? () => performance.now() : none });
        const { instance } = await WebAssembly.instantiate(bytes, new Proxy({}, { get: () => missing }));
        this.of = instance.exports;
        this.of._initialize();
        this.of.begin();
        this.build();
        this.settings(location.hash);
        this.shape();
        new ResizeObserver(() => this.shape()).observe(this.canvas);
        this.play(!calmReader.matches);
        this.figure.classList.add("is-live");
    }

    words(at) {
        const memory = new Uint8Array(this.of.memory.buffer);
        let end = at;
        while (memory[end] !== 0) ++end;
        return new TextDecoder().decode(memory.subarray(at, end));
    }

    // The native controls of what can be set.
    build() {
        this.canvas = element("canvas", { tabIndex: 0 });
        this.canvas.setAttribute("role", "img");
        this.canvas.setAttribute("aria-label", this.words(this.of.title()) + ". " +
            (Number.isNaN(this.of.handle(0)) ? "" : "The arrow keys move the dot."));
        this.picture = new LiveCanvas(this.canvas, (i, what = "said") => this.words(this.of[what](i)));
        const form = element("form", { className: "live-controls", autocomplete: "off" });
        form.addEventListener("submit", event => event.preventDefault());
        this.controls = count(this.of.controls()).map(i => this.control(i, form));

        const button = (words, action) => {
            const made = element("button", { type: "button", className: "play", textContent: words });
            made.addEventListener("click", action);
            return made;
        };
        this.playButton = button("", () => this.play(!this.wanted));
        this.linkButton = button("Link", () => this.link());
        const buttons = element("div", { className: "live-buttons" }, this.playButton,
            button("One step", () => { this.play(false), this.steps(1); }),
            button("Restart", () => { this.of.begin(), this.show(); }), this.linkButton);

        const list = element("dl", { className: "live-readouts" });
        this.readouts = count(this.of.readouts()).map(i => {
            const output = element("span", { className: "number" });
            const [label, unit, colour] = [0, 1, 2].map(n => this.words(this.of.readout_text(i, n)));
            const term = element("dt", { textContent: label });
            if (colour) term.style.borderLeft = "14px solid " + colour;
            list.append(element("div", {}, term, element("dd", {}, output, " " + unit)));
            return output;
        });
        this.status = element("p", { className: "live-status" });
        this.status.setAttribute("role", "status");  // read aloud when it changes, and only then
        this.figure.querySelector("a.card").replaceWith(element("div", { className: "live" }, this.canvas, buttons, this.status, form, list));
        this.touch();
    }

    control(i, form) {
        const [kind, least, most, step, first] = [0, 1, 2, 3, 4].map(n => this.of.control_number(i, n));
        const [name, label, unit] = [0, 1, 2].map(n => this.words(this.of.control_text(i, n)));
        const id = `live-${this.name}-${name}`;
        const control = { i, name, first, get: () => this.of.control_number(i, 5) };
        const set = value => {
            if (!Number.isFinite(value)) return;
            this.of.set(i, value);
            control.show();
            this.show();
        };
        const row = element("div", { className: "live-control" }, element("label", { htmlFor: id, textContent: label }));
        if (kind === 2) {
            const list = element("select", { id });
            unit.split("|").forEach((words, n) => list.append(element("option", { value: n, textContent: words })));
            list.addEventListener("change", () => set(Number(list.value)));
            control.show = () => { list.value = control.get(); };
            row.append(list);
        } else if (kind === 3) {
            const box = element("input", { id, type: "checkbox" });
            box.addEventListener("change", () => set(box.checked ? 1 : 0));
            control.show = () => { box.checked = control.get() !== 0; };
            row.append(box);
        } else {
            const there = kind === 1 ? Math.log10 : x => x, back = kind === 1 ? x => Number((10 ** x).toPrecision(3)) : x => x;
            const range = element("input", { id, type: "range", min: there(least), max: there(most),
                step: kind === 1 ? 0.01 : step });
            const typed = element("input", { type: "number", min: least, max: most, step: "any" });
            typed.setAttribute("aria-label", label + " as a number" + (unit && ", " + unit));
            range.addEventListener("input", () => set(Math.min(Math.max(back(Number(range.value)), least), most)));
            typed.addEventListener("change", () => { set(typed.value === "" ? NaN : Number(typed.value)), control.show(); });
            control.show = () => {
                range.value = there(control.get());
                typed.value = Number(control.get().toPrecision(6));
            };
            row.append(range, typed, element("span", { className: "unit", textContent: unit }));
        }
        control.set = set;
        control.show();
        form.append(row);
        return control;
    }

    // A finger or the mouse; what is not taken hold of scrolls the page.
    touch() {
        let held = false;
        const place = at => {
            const box = this.canvas.getBoundingClientRect();
            return this.picture.place(at.clientX - box.left, at.clientY - box.top);
        };
        const begin = (at, event) => {
            held = this.of.grab(...place(at)) !== 0;
            if (held) event.preventDefault(), this.show();
        };
        const move = at => { if (held) this.of.drag(...place(at)), this.moved(); };
        const end = () => { if (held) held = false, this.of.let_go(), this.show(); };
        this.canvas.addEventListener("touchstart", event => begin(event.touches[0], event), { passive: false });
        this.canvas.addEventListener("touchmove", event => {
            if (held) event.preventDefault(), move(event.touches[0]);
        }, { passive: false });
        for (const over of ["touchend", "touchcancel"]) this.canvas.addEventListener(over, end);
        this.canvas.addEventListener("mousedown", event => { begin(event, event); if (held) this.canvas.focus(); });
        window.addEventListener("mousemove", move);
        window.addEventListener("mouseup", end);
        const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
        this.canvas.addEventListener("keydown", event => {
            const arrow = arrows[event.key], x = this.of.handle(0), y = this.of.handle(1);
            if (!arrow || Number.isNaN(x) || !this.of.grab(x, y)) return;
            event.preventDefault();
            const far = 10 / this.picture.main.scaleX;
            this.of.drag(x + arrow[0] * far, y + arrow[1] * far);
            this.of.let_go();
            this.moved();
        });
    }
    moved() {
        for (const control of this.controls) control.show();
        this.show();
    }

    // ---- Time

    play(wanted) {
        this.wanted = wanted;
        this.playButton.textContent = wanted ? "■ Stop" : "▶ Play";
        this.look(this.seen);
    }
    look(seen) {
        this.seen = seen;
        const plays = Boolean(this.of) && this.wanted && seen;
        if (plays && !this.plays) {
            this.then = performance.now(), this.owed = 0;
            requestAnimationFrame(now => this.frame(now));
        }
        this.plays = plays;
    }
    // Chapter 2's loop: a frame pays what it owes in whole steps. After a hitch the rest is forgiven.
    frame(now) {
        if (!this.plays) return;
        const h = this.of.seconds() * 1000;
        this.owed = Math.min(this.owed + Math.max(0, now - this.then), 10 * h);
        this.then = now;
        let n = 0;
        for (; this.owed >= h; this.owed -= h) ++n;
        if (n > 0) this.steps(n);
        requestAnimationFrame(next => this.frame(next));
    }
    steps(n) {
        try {
            for (; n > 0; --n) this.of.step();
        } catch (stopped) {
            this.play(false);
            this.status.textContent = "The module stopped: it was asked for what the library refuses. Restart it.";
        }
        this.show();
    }

    // ---- What is shown

    shape() {
        this.narrow = this.canvas.clientWidth < 500;
        this.picture.resize(this.of.aspect(this.narrow ? 1 : 0));
        this.show();
    }
    commands() {
        const size = this.of.draw(this.narrow ? 1 : 0);
        return new Float64Array(this.of.memory.buffer, this.of.commands(), size);
    }
    show() {
        if (!this.picture) return;
        this.picture.draw(this.commands());
        this.readouts.forEach((output, i) => {
            const value = this.of.readout(i), size = Math.abs(value);
            output.textContent = size === Infinity ? (value < 0 ? "−∞" : "∞") : Number.isNaN(value) ? "no number" : size !== 0 && (size >= 1e6 || size < 1e-3)
                ? value.toExponential(2) : Number(value.toPrecision(4)).toString();
        });
        const blown = count(this.of.fuses()).filter(i => this.of.fuse(i) >= 0)
            .map(i => `${this.words(this.of.fuse_text(i))} blew up at step ${this.of.fuse(i)}.`);
        if (this.of.broken()) blown.push(`At step ${this.of.steps()} a place is no number any more, and is not drawn.`);
        if (this.status.textContent !== blown.join(" ")) this.status.textContent = blown.join(" ");
    }

    // ---- A link that carries the settings: #live-NAME:omega_h=1.2,x=1

    link() {
        const set = this.controls.filter(c => c.get() !== c.first).map(c => `${c.name}=${Number(c.get().toPrecision(12))}`);
        history.replaceState(null, "", `#${this.figure.id}:${set.join(",")}`);
        const copied = navigator.clipboard ? navigator.clipboard.writeText(location.href) : Promise.reject();
        copied.then(() => { this.linkButton.textContent = "Link copied"; },
            () => { this.linkButton.textContent = "In the address bar"; });
        setTimeout(() => { this.linkButton.textContent = "Link"; }, 2000);
    }
    settings(hash) {
        const [id, words = ""] = decodeURIComponent(hash.slice(1)).split(":");
        if (id !== this.figure.id) return;
        for (const [name, value] of words.split(",").map(word => word.split("=")))
            this.controls.find(control => control.name === name)?.set(Number(value));
        this.figure.scrollIntoView();
    }
}

function startLivePanels() {
    const near = new IntersectionObserver(entries => {
        for (const { target, isIntersecting } of entries) {
            if (!isIntersecting || target.live) continue;
            target.live = new LivePanel(target);
            target.live.start().then(() => on.observe(target), () => target.classList.add("stands-still"));
        }
    }, { rootMargin: "200px" });
    const on = new IntersectionObserver(entries => {
        for (const { target, isIntersecting } of entries) target.live.look(isIntersecting);
    });
    for (const figure of document.querySelectorAll("figure[data-module]")) near.observe(figure);
    const named = location.hash.startsWith("#live-") && document.getElementById(location.hash.slice(1).split(":")[0]);
    if (named) named.scrollIntoView();  // and so it starts
}
startLivePanels();
