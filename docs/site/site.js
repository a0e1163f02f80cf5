"use strict";
// The menu on narrow screens, dark and light, pictures that open, and the search over all pages.

const top_ = document.currentScript.dataset.top;
const byId = (id) => document.getElementById(id);

function setUpMenu() {
  const menu = byId("menu"), button = byId("menu-button");
  const show = (open) => { menu.classList.toggle("open", open); button.setAttribute("aria-expanded", open); };
  button.addEventListener("click", () => show(!menu.classList.contains("open")));
  byId("text").addEventListener("click", () => show(false));
  const here = menu.querySelector(".here");
  if (here && here.offsetTop > menu.clientHeight) menu.scrollTop = here.offsetTop - menu.clientHeight / 2;
}

function setUpTheme() {
  const root = document.documentElement;
  byId("theme-button").addEventListener("click", () => {
    const dark = getComputedStyle(root).colorScheme === "dark";
    const wanted = dark ? "light" : "dark";
    const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    // Who comes back to what the system says follows the system again.
    root.dataset.theme = wanted === system ? "" : wanted;
    try { localStorage.setItem("rubsweep-theme", root.dataset.theme); } catch (error) { /* no storage */ }
  });
}

function setUpPictures() {
  const dialog = document.body.appendChild(document.createElement("dialog"));
  const large = dialog.appendChild(document.createElement("img"));
  for (const link of document.querySelectorAll("a.picture")) {
    link.addEventListener("click", (event) => {
      event.preventDefault();
      large.src = link.href;
      large.alt = link.querySelector("img").alt;
      dialog.showModal();
    });
  }
  dialog.addEventListener("click", () => dialog.close());
}

// The index is a script beside this one, so that it can be read from a file, too. It is read when it is first needed.
let reading = null;
function readIndex() {
  reading ??= new Promise((done) => {
    const script = document.createElement("script");
    script.src = `${top_}/search_index.js`;
    script.onload = () => done(window.rubsweepSearchIndex.map(([page, anchor, title, where, text]) =>
      ({ page, anchor, title, where, text, low: { title: title.toLowerCase(), text: text.toLowerCase() } })));
    document.head.append(script);
  });
  return reading;
}

// How well a part of a page fits the words that are looked for; 0: a word is missing.
function score(part, words, whole) {
  // Who looks for a word rarely wants the derivation or what was before.
  const deep = /\/(method|history|validation)\/|CHANGELOG/.test(part.page);
  let sum = (part.low.title === whole ? 1000 : 0) + (deep ? 0 : 20);
  for (const word of words) {
    const inTitle = part.low.title.includes(word), count = part.low.text.split(word).length - 1;
    if (!inTitle && count === 0) return 0;
    sum += (inTitle ? 60 - Math.min(part.low.title.length, 50) / 2 : 0) + Math.min(count, 8);
  }
  return sum;
}

function marked(text, words) {
  const at = Math.max(0, Math.min(...words.map((word) => text.toLowerCase().indexOf(word)).filter((i) => i >= 0), text.length) - 50);
  const shown = document.createElement("span");
  shown.className = "text";
  const escaped = words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  const cut = (at > 0 ? "... " : "") + text.slice(at, at + 170);
  for (const piece of cut.split(new RegExp(`(${escaped.join("|")})`, "i"))) {
    const hit = words.includes(piece.toLowerCase());
    shown.append(hit ? Object.assign(document.createElement("mark"), { textContent: piece }) : piece);
  }
  return shown;
}

function entry(part, words) {
  const item = document.createElement("li"), link = item.appendChild(document.createElement("a"));
  link.href = `${top_}/${part.page}${part.anchor ? `#${part.anchor}` : ""}`;
  link.append(Object.assign(document.createElement("b"), { textContent: part.title }), " ",
    Object.assign(document.createElement("span"), { className: "where", textContent: part.where }));
  if (part.text) link.append(marked(part.text, words));
  return item;
}

function setUpSearch() {
  const field = byId("search"), found = byId("found");
  let chosen = -1, asked = 0;
  const hide = (hidden) => { found.hidden = hidden; field.setAttribute("aria-expanded", !hidden); };
  const links = () => [...found.querySelectorAll("a")];
  const choose = (i) => {
    const all = links();
    chosen = all.length ? (i + all.length) % all.length : -1;
    all.forEach((link, k) => link.classList.toggle("chosen", k === chosen));
    all[chosen]?.scrollIntoView({ block: "nearest" });
  };
  const look = async () => {
    const whole = field.value.trim().toLowerCase(), words = whole.split(/\s+/).filter(Boolean), mine = ++asked;
    if (whole.length < 2) return hide(true);
    const parts = (await readIndex()).map((part) => [score(part, words, whole), part]).filter(([points]) => points > 0);
    if (mine !== asked) return;
    parts.sort((a, b) => b[0] - a[0]);
    found.replaceChildren(...parts.slice(0, 25).map(([, part]) => entry(part, words)));
    if (!parts.length) found.append(Object.assign(document.createElement("li"), { textContent: "Nothing found." }));
    hide(false);
    choose(0);
  };
  field.addEventListener("focus", readIndex);
  field.addEventListener("input", look);
  field.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      choose(chosen + (event.key === "ArrowDown" ? 1 : -1));
    } else if (event.key === "Enter") {
      links()[chosen]?.click();
      hide(true);
    } else if (event.key === "Escape") {
      hide(true);
    }
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== field) {
      event.preventDefault();
      field.focus();
    }
  });
  document.addEventListener("click", (event) => { if (!event.target.closest(".search")) hide(true); });
  found.addEventListener("click", () => hide(true));
}

setUpMenu();
setUpTheme();
setUpPictures();
setUpSearch();
document.documentElement.dataset.ready = "yes";
