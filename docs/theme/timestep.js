// What the pages do themselves: typeset formulas, and let a reader stop an animation.

// Formulas come as \(…\) and \[…\]. Where KaTeX is not there they stay as they are. Listings are
// left alone: a backslash in a source file is no formula.
function typesetFormulas() {
    if (typeof renderMathInElement !== "function") return;
    renderMathInElement(document.body, {
        delimiters: [
            { left: "\\(", right: "\\)", display: false },
            { left: "\\[", right: "\\]", display: true },
        ],
        ignoredClasses: ["fragment", "ttc", "run"],
        throwOnError: false,
    });
}

// A button below each animation: it shows the first frame, or the animation from its beginning.
// Readers who asked for less motion begin with the first frame.
function addPlayButtons() {
    for (const figure of document.querySelectorAll("figure.animation")) {
        const image = figure.querySelector("img");
        const moving = image.getAttribute("src");
        const still = moving.replace(/\.gif$/, ".still.gif");
        const button = document.createElement("button");
        let plays = !window.matchMedia("(prefers-reduced-motion: reduce)").matches;
        figure.querySelector("source").remove();

        function show() {
            image.src = plays ? moving : still;
            button.textContent = plays ? "❚❚ Pause" : "▶ Play";
        }
        button.type = "button";
        button.className = "play";
        button.addEventListener("click", () => { plays = !plays; show(); });
        figure.insertBefore(button, figure.querySelector("figcaption"));
        show();
    }
}

document.addEventListener("DOMContentLoaded", () => { typesetFormulas(); addPlayButtons(); });
