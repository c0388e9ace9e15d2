// Live panels: the chapter's own C++, compiled to WebAssembly (tools/live), moves in the page. A panel's module is
// a script of its own beside its still picture, loaded when the panel comes near the screen.
"use strict";

function make(tag, attributes = {}, ...children) {
    const made = Object.assign(document.createElement(tag), attributes);
    made.append(...children);
    return made;
}
const count = n => [...Array(n).keys()];
// Numbers as they are printed: −1.5, 10⁻⁸, 2.5·10⁷.
const minus = words => String(words).replace("-", "−");
const powerOfTen = n => "10" + String(+n).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
const written = value => {
    const size = Math.abs(value);
    if (!(size >= 1e6 || size > 0 && size < 1e-3)) return minus(+value.toPrecision(4));
    const [digits, tens] = value.toExponential(2).replace("Infinity", "∞").split("e");
    return minus(digits) + (tens ? "·" + powerOfTen(tens) : "");
};
// A colour as it is on the page: on the dark ground as tools/page/svg_for_web.cpp has it. What is not here stays.
const onDark = { "#000000": "#ededed", "#333333": "#dfdfdf", "#8a8a8a": "#717171", "#dddddd": "#343434", "#ffffff": "#1c1d1f",
    "#0072b2": "#4e93d3", "#2f4b7c": "#89a0d6", "#332288": "#9f93ff", "#7a4a1e": "#c6977a", "#808000": "#888826",
    "#882255": "#e681ab", "#b15a98": "#bc67a3", "#d55e00": "#d76111" };
const shade = colour => document.documentElement.classList.contains("dark-mode") && onDark[colour] || colour;
// The colour, with a line's strokes and gaps.
function dashed(colour, dashes) {
    let at = 0;
    return `repeating-linear-gradient(90deg,${(dashes || "1").split(",").map((n, i) => `${i % 2 ? "#0000" : colour} ${at}px ${at += +n}px`)})`;
}

// ---- The picture: draws the commands of tools/live/live.hpp, as still.hpp does --------------------------

class LiveCanvas {
    constructor(canvas, text) {
        Object.assign(this, { canvas, text, pen: canvas.getContext("2d") });  // text: the words of a number among the commands
    }

    resize(aspect) {
        const { canvas } = this, scale = devicePixelRatio;
        this.width = canvas.clientWidth;
        this.height = Math.round(this.width * aspect);
        canvas.style.height = this.height + "px";
        canvas.width = this.width * scale;
        canvas.height = this.height * scale;
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
        Object.assign(part, { fromX: left, fromY: bottom, scaleX: w / (right - left), scaleY: h / (top - bottom) });
        if (!equal) return;
        part.scaleX = part.scaleY = Math.min(part.scaleX, part.scaleY);
        part.fromX -= (w / part.scaleX - (right - left)) / 2;
        part.fromY -= (h / part.scaleY - (top - bottom)) / 2;
    }

    draw(commands) {
        const pen = this.pen, sizes = [10, 5, 4, 3, 3, 1, 1, 4, 4], looks = [];
        let veil = "", path = false;  // is one begun? Moves before its stroke add to it
        this.main = null;
        pen.clearRect(0, 0, this.width, this.height);
        pen.save();
        for (let i = 0; i < commands.length; i += sizes[commands[i]]) {
            const a = commands[i + 1], b = commands[i + 2], c = commands[i + 3];
            switch (commands[i]) {
            case 0: {
                // At whole pixels: there it is clipped quickly.
                const [left, right, bottom, top] = commands.subarray(i + 6, i + 10).map((at, n) => Math.round(n < 2 ? at * this.width : (1 - at) * this.height));
                this.part = { shown: commands.slice(i + 1, i + 6), left: left + 8, right: right - 8, bottom: bottom - 8, top: top + 8 };
                this.main ||= this.part;
                this.fit();
                this.clip();
                break;
            }
            case 1: this.axes(this.text(a), this.text(b), c, commands[i + 4]); break;
            case 2: {
                const [look, dashes] = looks[a] ||= [this.text(a, "colour"), this.text(a, "dashes").split(",").filter(Boolean).map(Number)];
                pen.strokeStyle = pen.fillStyle = shade(look);
                veil = /^#(.)\1*$/.test(look) && look;  // a grey body, and light and shadow on it, are the same in the dark
                pen.setLineDash(dashes);
                pen.lineWidth = b, pen.globalAlpha = c;
                break;
            }
            case 3:
                if (!path) pen.beginPath();
                path = true, pen.moveTo(this.x(a), this.y(b));
                break;
            case 4: pen.lineTo(this.x(a), this.y(b)); break;
            case 5: path = false, pen.stroke(); break;
            case 6: path = false, pen.fillStyle = veil || pen.fillStyle, pen.fill(); break;
            case 7:  // dots that follow each other are filled together
                if (!path) pen.beginPath();
                pen.moveTo(this.x(a) + c, this.y(b)), pen.arc(this.x(a), this.y(b), c, 0, 7);
                path = commands[i + 4] === 7;
                if (!path) pen.fill();
                break;
            case 8: pen.fillText(this.text(c), this.x(a), this.y(b));
            }
        }
        pen.restore();
    }

    // Nothing leaves its part of the picture.
    clip() {
        const { left, right, top, bottom } = this.part, pen = this.pen;
        this.fresh();
        pen.beginPath(), pen.rect(left, top, right - left, bottom - top), pen.clip();
    }
    fresh() {
        this.pen.restore(), this.pen.save();
        this.pen.font = (this.width < 600 ? 12 : 14) + "px sans-serif", this.pen.lineJoin = "round";
    }

    // Ticks at 1, 2 or 5 times a power of ten; on a log axis at whole powers.
    ticks(from, length, log, most) {
        let gap = 10 ** Math.floor(Math.log10(length / 5));
        const many = length / gap / most;
        gap *= many > 5 ? 10 : many > 2.5 ? 5 : many > 1 ? 2 : 1;
        if (log) gap = Math.max(1, Math.ceil(gap));
        const all = [];
        for (let n = Math.ceil(from / gap); n <= (from + length) / gap + .001; ++n)
            all.push([n * gap, log ? powerOfTen(n * gap) : minus(+(n * gap).toPrecision(6))]);
        return all;
    }

    axes(wordX, wordY, logX, logY) {
        const pen = this.pen, part = this.part;
        const write = (words, x, y, align) => { pen.textAlign = align, pen.fillText(words, x, y); };
        this.fresh();
        part.left += 48, part.right -= 8, part.bottom -= 38, part.top += 22;  // the words stand outside
        this.fit();
        const { left, right, top, bottom } = part;
        pen.lineWidth = 1, pen.fillStyle = shade("#333333"), pen.beginPath();
        for (const [at, words] of this.ticks(part.fromX, (right - left) / part.scaleX, logX, (right - left) / 50)) {
            pen.moveTo(this.x(at), top), pen.lineTo(this.x(at), bottom);
            write(words, this.x(at), bottom + 16, "center");
        }
        for (const [at, words] of this.ticks(part.fromY, (bottom - top) / part.scaleY, logY, (bottom - top) / 30)) {
            pen.moveTo(left, this.y(at)), pen.lineTo(right, this.y(at));
            write(words, left - 5, this.y(at) + 5, "right");
        }
        pen.strokeStyle = shade("#dddddd"), pen.stroke(), pen.beginPath();
        pen.moveTo(left, top), pen.lineTo(left, bottom), pen.lineTo(right, bottom);
        pen.strokeStyle = shade("#333333"), pen.stroke();
        write(wordX, (left + right) / 2, bottom + 33, "center");
        write(wordY, left - 40, top - 11, "left");
        this.clip();
    }
}

// ---- A panel -------------------------------------------------------------------------------------------

class LivePanel {
    constructor(figure) {
        this.figure = figure;
    }

    async start() {
        const { figure } = this, { instance } = await WebAssembly.instantiate(await bytesOf(figure.dataset.module), { page, wasi_snapshot_preview1: page });
        this.of = instance.exports;
        this.of._initialize();
        this.of.begin();
        // What it grows by moves what comes after it. Else a browser keeps that in place, and the sliders leave the screen.
        const { style } = figure.closest("#doc-content") || figure;
        if (figure.getBoundingClientRect().bottom > 0) style.overflowAnchor = "none";
        this.build();
        this.shape();
        figure.offsetTop, style.overflowAnchor = "";
        this.play(!matchMedia("(prefers-reduced-motion)").matches);
        this.settings();
        new ResizeObserver(() => this.shape()).observe(this.canvas);
        const recolour = () => this.recolour.forEach(f => f());
        new MutationObserver(recolour).observe(document.documentElement, { attributeFilter: ["class"] });
        recolour();
        figure.classList.add("is-live");
    }

    words(at) {
        const bytes = new Uint8Array(this.of.memory.buffer);
        return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
    }

    // Native controls of all that can be set.
    build() {
        const of = this.of;
        const button = (words, onclick) => make("button", { type: "button", className: "play", onclick }, words);
        this.canvas = make("canvas", { tabIndex: 0, role: "img",
            ariaLabel: this.words(of.title()) + (isNaN(of.handle(0)) ? "" : ". The arrow keys drag.") });
        this.picture = new LiveCanvas(this.canvas, (i, what = "said") => this.words(of[what](i)));
        this.playButton = button("", () => this.play(!this.wanted));
        this.linkButton = button("Link", () => this.link());
        this.status = make("p", { className: "live-status", role: "status" });  // read aloud when it changes
        const form = make("div", { className: "live-controls" });
        const list = make("dl", { className: "live-readouts" });
        this.recolour = [() => this.show()];
        this.controls = count(of.controls()).map(i => this.control(i, form));
        this.swept = this.controls.find((c, i) => of.moves(i));  // by the panel itself
        this.readouts = count(of.readouts()).map(i => {
            const [label, , colour, dashes] = count(4).map(n => this.words(of.readout_text(i, n)));
            const key = make("span", { className: colour && "key" }), output = make("dd");
            this.recolour.push(() => { key.style.backgroundImage = colour && dashed(shade(colour), dashes); });
            list.append(make("div", {}, make("dt", {}, key, label), output));
            return output;
        });
        this.shell = make("code");
        this.figure.querySelector("a.card").replaceWith(make("div", { className: "live" }, this.canvas,
            make("div", { className: "live-buttons" }, this.playButton,
                button("One step", () => { this.play(false), this.steps(1); }),
                button("Restart", () => { of.begin(), this.show(); }), this.linkButton),
            form, list, this.status, make("details", { className: "live-shell", ontoggle: () => this.showInShell() },
                make("summary", {}, "The same run in a shell"), this.shell)));
        this.touch();
    }

    control(i, form) {
        const of = this.of, [kind, least, most, step, first] = count(5).map(n => of.control_number(i, n));
        const [name, label, unit] = count(3).map(n => this.words(of.control_text(i, n)));
        const id = `${this.figure.id}-${name}`, row = make("div", { className: "live-control" });
        const control = { name, first, get: () => of.control_number(i, 5), set: value => {
            if (!isNaN(value)) this.trying(() => of.set(i, value));
            control.taken = (value < least || value > most) && `${label}: ${written(least)} to ${written(most)} ${unit}, ${written(control.get())} taken.`;
            if (of.moves(i)) this.play(false);
            this.show();
        } };
        row.append(make("label", { htmlFor: id }, label));
        if (kind === 2) {  // one of several
            const list = make("select", { id, onchange: () => control.set(+list.value) },
                ...unit.split("|").map((words, n) => make("option", { value: n }, words)));
            control.show = () => list.value = control.get();
            row.append(list);
        } else if (kind === 3) {  // on or off
            const box = make("input", { id, type: "checkbox", onchange: () => control.set(+box.checked) });
            control.show = () => box.checked = control.get() !== 0;
            row.append(box);
        } else {  // a number, on a log slider by its logarithm
            const log = kind === 1, there = x => log ? Math.log10(x) : x, back = x => log ? +(10 ** x).toPrecision(3) : x;
            const range = make("input", { id, type: "range", min: there(least), max: there(most), step: log ? .01 : step });
            const typed = make("input", { type: "number", min: least, max: most, step: "any", ariaLabel: label + " as a number" });
            range.oninput = () => control.set(back(+range.value));
            const fill = () => {
                const value = +control.get().toPrecision(log ? 3 : 6);
                typed.value = log && value < 1e-3 ? value.toExponential() : value;
            };
            typed.onchange = () => { control.set(typed.valueAsNumber), fill(); };
            control.show = () => {
                range.value = there(control.get());
                if (document.activeElement !== typed) fill();  // while it is being typed a number is left alone
            };
            row.append(range, typed, make("span", { className: "unit" }, unit));
        }
        control.show();
        form.append(row);
        return control;
    }

    // A finger or the mouse; where there is nothing to take hold of, the page scrolls as ever.
    touch() {
        const { canvas, of } = this, on = (where, names, action) => {
            for (const name of names.split(" ")) where.addEventListener(name, action, { passive: false });
        };
        let held = false;
        const at = event => {
            const box = canvas.getBoundingClientRect(), point = event.touches?.[0] || event;
            return this.picture.place(point.clientX - box.left, point.clientY - box.top);
        };
        on(canvas, "touchstart mousedown", event => {
            held = of.grab(...at(event)) !== 0;
            if (!held) return;
            event.preventDefault();
            canvas.focus({ preventScroll: true });
            this.show();
        });
        const drag = event => {
            if (!held) return;
            event.preventDefault();
            const before = this.swept?.get();
            of.drag(...at(event));
            this.swept?.get() === before ? this.show() : this.play(false);
        };
        on(canvas, "touchmove", drag);
        on(window, "mousemove", drag);
        const end = () => { if (held) held = false, of.let_go(), this.show(); };
        on(window, "touchend touchcancel mouseup", end);
        on(canvas, "keydown", event => {
            const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
            const x = of.handle(0), y = of.handle(1), far = 10 / this.picture.main.scaleX;
            if (!arrow || isNaN(x) || !of.grab(x, y)) return;
            event.preventDefault();
            of.drag(x + arrow[0] * far, y + arrow[1] * far);
            of.let_go();
            this.show();
        });
    }

    // ---- Time

    play(wanted) {
        this.wanted = wanted;
        this.playButton.textContent = wanted ? "■ Stop" : "▶ Play";
        this.look(this.seen);
        this.show();
    }
    // Off screen nothing is done.
    look(seen) {
        const before = this.plays;
        this.seen = seen;
        this.plays = this.wanted && seen;
        if (!this.plays || before) return;
        this.then = performance.now(), this.owed = 0;
        requestAnimationFrame(this.frame);
    }
    // Chapter 2's loop: a frame pays what it owes in whole steps. After a hitch the rest is forgiven.
    frame = now => {
        if (!this.plays) return;
        const h = this.of.seconds() * 1000;
        this.owed = Math.min(this.owed + Math.max(0, now - this.then), Math.max(10 * h, 50));
        this.then = now;
        const n = Math.floor(this.owed / h);
        this.owed -= n * h;
        if (n > 0) this.steps(n, now);
        requestAnimationFrame(this.frame);
    };
    steps(n, frame) {
        this.trying(() => { for (; n > 0; --n) this.of.step(); });
        this.show(frame);
    }
    trying(action) {
        try {
            action();
        } catch {
            this.broke = "The library refused these settings: load the page again.";
            this.play(false);
        }
    }

    // ---- What is shown

    shape() {
        const wide = this.canvas.clientWidth;
        this.narrow = wide < 480;
        this.canvas.parentElement.classList.toggle("is-narrow", this.narrow);
        // It leaves room for the sliders; on a phone it stays on the screen beside them (timestep.css).
        this.picture.resize(Math.min(this.of.aspect(this.narrow), (this.narrow ? .5 : .6) * innerHeight / wide));
        this.show();
    }
    // Sixty times a second what has moved; what is read, some times a second and whenever the reader does something.
    show(frame) {
        const of = this.of, size = of.draw(this.narrow);
        if (!frame || of.changed()) this.picture.draw(new Float64Array(of.memory.buffer, of.commands(), size));
        if (frame < this.readAt) return;
        this.readAt = frame + 150;
        for (const c of this.controls)  // the panel may have moved it, too
            if (c.get() !== c.shown) c.shown = c.get(), c.show();
        this.readouts.forEach((out, i) => out.textContent = of.known(i) ? written(of.readout(i)) + " " + this.words(of.readout_text(i, 1)) : "not yet");
        const blown = count(of.fuses()).filter(i => of.fuse(i) >= 0).map(i => `${this.words(of.fuse_text(i))} at step ${of.fuse(i)}`);
        const said = [...this.controls.map(c => c.taken), blown.length && `Blew up: ${blown.join(", ")}.`, this.broke,
            of.broken() && "A place is no number, and is not drawn."].filter(Boolean).join(" ");
        if (this.status.textContent !== said) this.status.textContent = said;
        this.showInShell();
    }

    // ---- The settings, as words: in a link, #live-three_eulers:omega_h=1.2,x=1, and for the shell

    set() {
        return this.controls.filter(c => c.get() !== c.first).map(c => `${c.name}=${c.get()}`);
    }
    link() {
        history.replaceState(null, "", `#${this.figure.id}:${this.set().join(",")}`);
        const say = words => this.linkButton.textContent = words;
        const copied = navigator.clipboard?.writeText(location.href) || Promise.reject();
        copied.then(() => say("Copied"), () => say("In the address bar"));
        setTimeout(() => say("Link"), 2000);
    }
    settings() {
        const [id, words = ""] = location.hash.slice(1).split(":");
        if (id !== this.figure.id) return;
        for (const [name, value] of words.split(",").map(word => word.split("=")))
            this.controls.find(c => c.name === name)?.set(+value);
    }
    // While it is open it says what stands there. A panel that moves a control stands where that one is.
    showInShell() {
        if (!this.shell.parentElement.open) return;
        const source = `chapters/${this.figure.dataset.live.replace("/", "/live/")}.cpp`;
        const steps = this.swept ? 0 : this.of.steps();
        const words = `c++ -std=c++20 -Iinclude -Itools/live -I/usr/include/eigen3 ${source} -o panel && ` +
            `./panel ${[...this.set(), `steps=${steps}`].join(" ")}`;
        if (this.shell.textContent !== words) this.shell.textContent = words;
    }
}

// What a module may ask of the page; who puts words together brings along how they would be written to a file.
const page = { clock: () => performance.now(), fd_close() {}, fd_seek() {}, fd_write() {} };

// ---- Each panel begins when it comes near the screen ----------------------------------------------------

{
    const on = new IntersectionObserver(all => all.forEach(e => e.target.live.look(e.isIntersecting)));
    const near = new IntersectionObserver(all => {
        for (const { target, isIntersecting } of all) {
            if (!isIntersecting || target.live) continue;
            target.live = new LivePanel(target);
            target.live.start().then(() => on.observe(target), () => target.classList.add("stands-still"));
        }
    }, { rootMargin: "200px" });
    for (const figure of document.querySelectorAll("figure[data-module]")) near.observe(figure);
    addEventListener("hashchange", () => {
        for (const figure of document.querySelectorAll("figure.is-live")) figure.live.settings();
    });
    if (location.hash.startsWith("#live-")) document.getElementById(location.hash.slice(1).split(":")[0])?.scrollIntoView();
}
