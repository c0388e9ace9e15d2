// Films: the frames of a GIF on a canvas, with a button, a place in time, and a speed. Where there are no scripts its
// first frame stands.
"use strict";

// Where the frames of a GIF begin and end, and how long each is shown. A frame may hold only what has changed.
function framesOf(gif) {
    const tableAfter = flags => flags & 0x80 ? 3 << (flags & 7) + 1 : 0;
    const pastBlocks = at => { while (gif[at] !== 0) at += gif[at] + 1; return at + 1; };
    let at = 13 + tableAfter(gif[10]);
    const head = gif.subarray(0, at), frames = [];
    let control = null, seconds = .05;
    for (;;) {
        const begin = at;
        if (gif[at] === 0x21) {
            at = pastBlocks(at + 2);
            if (gif[begin + 1] === 0xf9) control = gif.subarray(begin, at), seconds = (gif[begin + 4] + 256 * gif[begin + 5]) / 100;
        } else if (gif[at] === 0x2c) {
            at = pastBlocks(at + 11 + tableAfter(gif[at + 9]));
            frames.push({ seconds, blob: new Blob([head, control || "", gif.subarray(begin, at), "\x3b"], { type: "image/gif" }) });
        } else return frames;
    }
}

class Film {
    constructor(figure) {
        this.figure = figure;
        this.image = figure.querySelector("img");
        this.plays = this.wanted = this.seen = false;
        this.shown = -1;   // the frame on the canvas
        this.kept = [];    // every sixteenth, whole
        this.speed = 1;
    }

    async start() {
        this.frames = framesOf(await bytesOf(this.image.getAttribute("src").replace(".still", "")));
        this.canvas = document.createElement("canvas");
        this.canvas.width = 2 * this.image.width, this.canvas.height = 2 * this.image.height;
        this.canvas.setAttribute("role", "img");
        this.canvas.setAttribute("aria-label", this.image.alt);
        this.pen = this.canvas.getContext("2d");
        await this.show(0);
        this.figure.querySelector("a.card").replaceWith(Object.assign(document.createElement("div"), { className: "card" }));
        this.figure.querySelector("div.card").append(this.canvas);
        this.build();
        this.play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches);
        this.figure.classList.add("is-film");
    }

    build() {
        const make = (tag, attributes, ...children) => {
            const made = Object.assign(document.createElement(tag), attributes);
            made.append(...children);
            return made;
        };
        this.button = make("button", { type: "button", className: "play" });
        this.button.addEventListener("click", () => this.play(!this.wanted));
        this.range = make("input", { type: "range", min: 0, max: this.frames.length - 1, step: 1, value: 0 });
        this.range.setAttribute("aria-label", "frame");
        this.range.addEventListener("input", () => { this.play(false); this.show(Number(this.range.value)); });
        const speed = make("select", {}, ...[.25, .5, 1, 2, 4].map(x => make("option", { value: x, textContent: x + "×" })));
        speed.value = 1;
        speed.setAttribute("aria-label", "speed");
        speed.addEventListener("change", () => { this.speed = Number(speed.value); });
        this.figure.insertBefore(make("div", { className: "film" }, this.button, this.range, speed),
            this.figure.querySelector("figcaption"));
    }

    play(wanted) {
        this.wanted = wanted;
        this.button.textContent = wanted ? "■ Stop" : "▶ Play";
        this.look(this.seen);
    }
    look(seen) {
        const before = this.plays;
        this.seen = seen;
        this.plays = this.wanted && seen;
        if (this.plays && !before) this.next(performance.now());
    }
    // The next frame when its time has come; a slow machine drops none, and takes longer.
    async next(due) {
        if (!this.plays) return;
        const wait = this.frames[Math.max(this.shown, 0)].seconds * 1000 / this.speed;
        await new Promise(over => setTimeout(over, Math.max(0, due + wait - performance.now())));
        if (!this.plays) return;
        await this.show((this.shown + 1) % this.frames.length);
        this.next(Math.max(due + wait, performance.now() - wait));
    }

    // Draws frame `wanted`: on from what is shown, or from the last whole one that was kept before it.
    async show(wanted) {
        this.asked = wanted;
        if (this.drawing) return this.drawing;
        const draw = async () => {
            while (this.shown !== this.asked) {
                const last = Math.floor(this.asked / 16) * 16;
                if (this.shown > this.asked || this.shown < last && this.kept[last / 16]) {
                    let from = last / 16;
                    while (from > 0 && !this.kept[from]) --from;
                    if (this.kept[from]) this.pen.drawImage(this.kept[from], 0, 0), this.shown = from * 16;
                    if (this.shown === this.asked) break;
                }
                const i = this.shown + 1, frame = await createImageBitmap(this.frames[i].blob);
                this.pen.drawImage(frame, 0, 0, this.canvas.width, this.canvas.height);
                frame.close();
                if (i % 16 === 0 && !this.kept[i / 16]) this.kept[i / 16] = await createImageBitmap(this.canvas);
                this.shown = i;
            }
            if (this.range) this.range.value = this.shown;
        };
        this.drawing = draw().finally(() => { this.drawing = null; });
        return this.drawing;
    }
}

function startFilms() {
    const on = new IntersectionObserver(all => all.forEach(one => one.target.film.look(one.isIntersecting)));
    const near = new IntersectionObserver(all => {
        for (const { target, isIntersecting } of all) {
            if (!isIntersecting || target.film) continue;
            target.film = new Film(target);
            target.film.start().then(() => on.observe(target), () => target.classList.add("stands-still"));
        }
    }, { rootMargin: "200px" });
    for (const figure of document.querySelectorAll("figure.animation")) near.observe(figure);
}
startFilms();
