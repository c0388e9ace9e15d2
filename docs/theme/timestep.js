// What the pages do themselves: typeset formulas, show where a table goes on, and begin what moves.

// Formulas come as \(…\) and \[…\]. KaTeX is loaded where there are some; where it is not to be had
// they stay as they are. Listings are left alone: a backslash in a source file is no formula.
const formulaOptions = {
    delimiters: [
        { left: "\\(", right: "\\)", display: false },
        { left: "\\[", right: "\\]", display: true },
    ],
    ignoredClasses: ["fragment", "ttc", "run"],
    throwOnError: false,
};

// Doxygen does not tell those who hear a page read which part of it is what.
for (const [part, role, label] of [["#doc-content", "main"], ["#titlearea", "banner"], ["#side-nav", "navigation", "Contents"],
    ["#nav-path", "navigation", "Where this page is"], ["div.header .title", "heading"]])
    for (const element of document.querySelectorAll(part)) Object.assign(element, { role, ariaLabel: label ?? null });
document.querySelector("div.header .title")?.setAttribute("aria-level", "1");
for (const icon of document.querySelectorAll("a > .icondoc")) icon.parentElement.ariaLabel = "Source";

function load(tag, attributes) {
    return new Promise((loaded, failed) => {
        const element = Object.assign(document.createElement(tag), attributes);
        element.onload = loaded;
        element.onerror = failed;
        document.head.append(element);
    });
}

// A page that is opened from its file may read scripts alone: NAME.js hands over the bytes of the file NAME.
const pageBytes = {};
async function bytesOf(name) {
    if (!pageBytes[name]) await load("script", { src: name + ".js" });
    const text = atob(pageBytes[name]), bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);  // a film has millions: quickly
    return bytes;
}

async function typesetFormulas() {
    const contents = document.querySelector(".contents");
    if (typeof katexFolder === "undefined" || !contents || !/\\[(\[]/.test(contents.textContent)) return;
    const page = document.documentElement.classList;
    page.add("typesetting");  // nobody needs to see TeX
    try {
        const style = load("link", { rel: "stylesheet", href: katexFolder + "katex.min.css" });
        await load("script", { src: katexFolder + "katex.min.js" });
        await load("script", { src: katexFolder + "auto-render.js" });
        await style;
        renderMathInElement(document.body, formulaOptions);
        document.querySelectorAll(".contents :not(.katex-display) > .katex").forEach(keepComma);
    } finally {
        page.remove("typesetting");
    }
    goToPlace();  // what an address leads to has moved
}

// No line begins with the comma behind a formula: it goes into the same span, or, where that may have to be broken, into its last part.
function keepComma(formula) {
    const text = formula.parentElement.nextSibling, comma = text?.nodeType === 3 && text.data.match(/^[,.;:!?)]+/)?.[0];
    if (!comma) return;
    text.data = text.data.slice(comma.length);
    const parts = formula.querySelectorAll(".base");
    if (parts.length > 1) return void parts[parts.length - 1].append(comma);
    formula.after(comma);
    formula.parentElement.classList.add("number");
}

// What a mark tells stands above it, and within the page.
function placeMark(event) {
    const mark = event.target.closest?.(".check");
    if (!mark) return;
    const page = document.getElementById("doc-content").getBoundingClientRect(), half = 11.9 * 0.85 * 16 + 12;
    const at = mark.getBoundingClientRect().left;
    mark.style.setProperty("--aside", Math.max(0, page.left + half - at) - Math.max(0, at + half - page.right) + "px");
}

// An address with a place in the page that is folded away.
function goToPlace() {
    const place = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (let around = place; around; around = around.parentElement)
        if (around.tagName === "DETAILS") around.open = true;
    place?.scrollIntoView();
}
// Nobody can unfold paper.
function unfoldAll() {
    for (const fold of document.querySelectorAll("details.ask")) fold.open = true;
}

// Long lines of a listing are broken (those of whole sources are not: they are numbered), and the line that matters is marked.
function setListings() {
    for (const line of document.querySelectorAll(".contents div.fragment div.line")) {
        if (line.querySelector(".lineno")) continue;
        line.classList.add("breaks");
        line.style.setProperty("--indent", Math.min(line.textContent.search(/\S|$/), 16) + "ch");
    }
    for (const listing of document.querySelectorAll("figure.listing[data-line]"))
        listing.querySelectorAll("div.line")[listing.dataset.line - 1]?.classList.add("marked");
}

// What is wider than the page scrolls in itself. Its edge fades where it goes on.
function fadeWhatGoesOn() {
    for (const box of document.querySelectorAll("table.markdownTable, table.markdownTable tbody, p.formulaDsp, a.card, pre, div.fragment, .memproto")) {
        const look = () => {
            box.classList.toggle("goes-on", box.scrollLeft + box.clientWidth < box.scrollWidth - 4);
            if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;  // so that the arrow keys scroll it
        };
        box.addEventListener("scroll", look, { passive: true });
        new ResizeObserver(look).observe(box);
        document.fonts.ready.then(look);  // letters that come late make a formula wider, and no box
    }
}

// A figure is enlarged at a touch, in the colours of the page: on a phone it is the wide picture, to be moved about. Another
// touch, or Esc, and it is gone.
function enlarge(event) {
    const card = event.target.closest?.("figure.picture:not(.live) a.card");
    if (!card || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    const small = card.querySelector("img"), image = new Image(), dialog = document.createElement("dialog");
    Object.assign(image, { src: card.href, alt: small.alt });
    image.style = `--width: ${small.getAttribute("width")}px; --shape: ${small.getAttribute("width") / small.getAttribute("height")}`;
    dialog.className = "enlarged";
    dialog.setAttribute("aria-label", "Enlarged: " + small.alt);
    dialog.append(image);
    dialog.onclick = () => dialog.close();
    dialog.onclose = () => dialog.remove();
    document.body.append(dialog);
    dialog.showModal();
}

// Where GitHub publishes the site, the address tells the repository.
function offerDownload() {
    const link = document.getElementById("download"), owner = location.hostname.match(/^(.+)[.]github[.]io$/)?.[1];
    const name = location.pathname.split("/")[1];
    if (!link || !owner || !name || name.endsWith(".html")) return;
    link.href = `https://github.com/${owner}/${name}/archive/HEAD.zip`;
    link.hidden = false;
    link.previousElementSibling.hidden = true;  // that there is none
}

// A phone shows no tree: there the menu leads to the chapters, after the start.
function putChaptersIntoMenu() {
    const start = document.querySelector("#main-menu > li");
    const chapters = window.NAVTREE?.[0][2].filter(([, address]) => /^chapter_\d+[.]html$/.test(address)) ?? [];
    start?.after(...chapters.map(([textContent, href]) => {
        const item = Object.assign(document.createElement("li"), { className: "chapter" });
        item.append(Object.assign(document.createElement("a"), { href, textContent }));
        return item;
    }));
}

document.addEventListener("DOMContentLoaded", () => {
    setListings();
    offerDownload();
    window.jQuery?.(putChaptersIntoMenu);  // after Doxygen has made its menu
    if (document.querySelector("figure[data-module]")) load("script", { src: "live.js" });
    if (document.querySelector("figure.animation")) load("script", { src: "film.js" });
    typesetFormulas().finally(fadeWhatGoesOn);
    addEventListener("hashchange", goToPlace);
    addEventListener("click", enlarge);
    addEventListener("pointerover", placeMark);
    addEventListener("focusin", placeMark);
    addEventListener("beforeprint", unfoldAll);
    goToPlace();
});
