// The search: sections, the glossary's words and the library's names, found in the reader's browser by lunr. It takes the
// place of Doxygen's, which knows names alone.

let searchIndex;
const apart = /[^\p{L}\p{N}]+/u;  // what stands between words

// Read when somebody begins to search.
async function readIndex() {
    await load("script", { src: "lunr.min.js" });
    await load("script", { src: "search_places.js" });
    lunr.tokenizer.separator = apart;
    return lunr(function () {
        this.ref("i");
        this.field("t", { boost: 6 });
        this.field("x");
        this.pipeline.remove(lunr.stopWordFilter);  // "what if" may be a title
        searchPlaces.forEach((place, i) => this.add({ i, t: place.t, x: place.x }, { boost: place.p === "Glossary" ? 3 : place.p === "The library" || place.u.startsWith("exercises_") ? 0.6 : 1 }));
    });
}

// What a question has besides what it asks about.
const small = new Set("an and are can do does for how in is it my of on or should that the to use what when which why with".split(" "));

// The places that fit, best first: every word counts, its beginning less, and a misspelt one least.
function placesFor(index, text) {
    const words = text.toLowerCase().split(apart).filter(word => word.length > 1), telling = words.filter(word => !small.has(word));
    if (!words.length) return [];
    const found = index.query(query => {
        for (const word of telling.length ? telling : words) {
            query.term(word, { boost: 10 });
            query.term(word, { boost: 4, wildcard: lunr.Query.wildcard.TRAILING, usePipeline: false });
            if (word.length > 4) query.term(word, { boost: 0.5, editDistance: 1, usePipeline: false });
        }
    });
    // Where the words stand together is nearer than where they stand anywhere.
    const phrase = words.join(" "), together = words => (" " + words.toLowerCase().split(apart).join(" ")).includes(" " + phrase);
    for (const one of found) {
        const place = searchPlaces[one.ref];
        one.score *= place.u.endsWith("exercise_" + text.trim()) ? 20 ** words.length : words.length < 2 ? 1 : together(place.t) ? 4 : together(place.x) ? 2 : 1;
    }
    found.sort((a, b) => b.score - a.score);
    const addresses = new Set();  // the glossary leads where a section's own words do
    return found.map(one => searchPlaces[one.ref]).filter(place => !addresses.has(place.u) && addresses.add(place.u));
}

// Some words around the first that was looked for.
function excerpt(place, text) {
    const word = text.toLowerCase().split(/\s+/)[0], at = Math.max(0, place.x.toLowerCase().indexOf(word) - 40);
    const from = at ? place.x.indexOf(" ", at) + 1 : 0;
    return (from ? "… " : "") + place.x.slice(from, from + 120) + (place.x.length > from + 120 ? " …" : "");
}

function showPlaces(list, places, text) {
    list.replaceChildren(...places.slice(0, 12).map(place => {
        const link = Object.assign(document.createElement("a"), { href: place.u, className: "found" });
        const part = (name, words) => link.append(Object.assign(document.createElement(name), { textContent: words }));
        part("b", place.t), part("i", place.p), part("span", place.p === "The library" ? "" : excerpt(place, text));
        return link;
    }));
    if (!places.length) list.textContent = "Nothing is found.";
    list.hidden = false;
}

function beginSearch() {
    const old = document.getElementById("MSearchField");
    const field = old.cloneNode();  // without what Doxygen listens to
    for (const name of ["onfocus", "onblur", "onkeyup", "value"]) field.removeAttribute(name);
    field.placeholder = "Search";
    field.setAttribute("aria-label", "Search the course");
    old.replaceWith(field);
    const glass = document.getElementById("MSearchSelect");
    for (const name of ["onmouseover", "onmouseout"]) glass?.removeAttribute(name);
    const list = Object.assign(document.createElement("div"), { id: "found", hidden: true });
    document.body.append(list);
    const look = async () => {
        const text = field.value.trim();
        if (!text) return void (list.hidden = true);
        if (!searchIndex) list.textContent = "Reading the index …", list.hidden = false;
        const index = await (searchIndex ??= readIndex());
        if (field.value.trim() === text) showPlaces(list, placesFor(index, text), text);
    };
    field.addEventListener("input", look);
    field.addEventListener("click", look);
    const step = event => {
        const links = [...list.children], at = links.indexOf(document.activeElement);
        if (event.key === "Escape") list.hidden = true, field.focus();
        else if (event.key === "Enter" && event.target === field) links[0]?.click();
        else if (event.key === "ArrowDown") (links[at + 1] ?? links[at])?.focus();
        else if (event.key === "ArrowUp") (links[at - 1] ?? field).focus();
        else return;
        event.preventDefault();
    };
    field.addEventListener("keydown", step);
    list.addEventListener("keydown", step);
    document.addEventListener("click", event => {
        if (event.target.closest("#found a") || !event.target.closest("#found, #MSearchBox")) list.hidden = true;
    });
}
// Doxygen makes the field some time after the page has been read, on a short page after it has been loaded.
const waiting = new MutationObserver(() => {
    if (!document.getElementById("MSearchField")) return;
    waiting.disconnect();
    beginSearch();
});
waiting.observe(document.body, { childList: true, subtree: true });
