// The menu of the documentation's site: its search field, and the current page scrolled into view.
"use strict";

const form = document.getElementById("search");
const field = form.querySelector("input");
const found = document.getElementById("found");

// The index is loaded when somebody begins to search: a page without a search does not wait for it.
let isLoading = false;
function loadIndex() {
    if (isLoading)
        return;
    isLoading = true;
    const script = document.createElement("script");
    script.src = "search_index.js";
    script.onload = showFound;
    script.onerror = () => (found.textContent = "The index of the search cannot be loaded.");
    document.head.append(script);
}

function element(name, className, ...children) {
    const made = document.createElement(name);
    made.className = className;
    made.append(...children);
    return made;
}

// The items of one list of results.
function listOf(title, entries, words) {
    if (entries.length === 0)
        return [];
    const items = entries.map(([name, heading, address, text]) => {
        const link = element("a", "", heading && text !== "" ? `${name}: ${heading}` : name);
        link.href = address;
        const about = text === "" ? heading : excerpt(text, words);
        return element("li", "", link, element("span", "about", about));
    });
    return [element("p", "group", title), element("ul", "", ...items)];
}

function showFound() {
    const query = field.value.trim();
    document.getElementById("menu").classList.toggle("searching", query !== "");
    if (query === "" || !globalThis.searchIndex) {
        found.replaceChildren();
        return;
    }
    const { words, pages, names } = searchSite(globalThis.searchIndex, query);
    const lists = [...listOf("Guide, lessons, documents", pages, words), ...listOf("Names", names, words)];
    found.replaceChildren(...(lists.length > 0 ? lists : [`Nothing has ${words.length > 1 ? "all these words" : "this word"}.`]));
}

form.hidden = false;
field.addEventListener("focus", loadIndex);
field.addEventListener("input", showFound);
form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = found.querySelector("a");
    if (first)
        location.href = first.href;
});
addEventListener("keydown", (event) => {
    const isTyping = /^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName);
    if (event.key === "/" && !isTyping && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        document.getElementById("menu-shown").checked = true;
        field.focus();
    } else if (event.key === "Escape" && document.activeElement === field) {
        field.value = "";
        showFound();
    }
});

const menu = document.getElementById("menu");
const current = menu.querySelector("[aria-current]");
if (current && menu.scrollHeight > menu.clientHeight)
    menu.scrollTop = Math.max(0, current.offsetTop - menu.clientHeight / 2);
