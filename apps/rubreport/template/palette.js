"use strict";
// Kinds of motions with their colours, the same as in all pictures of the program.
const kinds = JSON.parse(document.getElementById("index").textContent).motion_kinds;
const kindByName = new Map(kinds.map((kind, place) => [kind.name, place]));
const wordColours = ["#332288", "#88CCEE", "#DDCC77", "#CC6677", "#117733", "#AA4499", "#44AA99", "#999933", "#882255"];
// Colours by word. Words of a table may be any, so that these are Maps and not plain objects.
const fixedColours = new Map([
  ["proof", new Map(Object.entries({ rest: "#44AA99", floquet: "#332288", floquet_observed: "#88CCEE", observed: "#DDCC77" }))],
  ["robust", new Map(Object.entries({ yes: "#88CCEE", no: "#882255" }))],
]);

// True while the page is printed; its colours are then those of the light theme.
let printing = false;
const darkScreen = window.matchMedia("(prefers-color-scheme: dark)");
const isDark = () => darkScreen.matches && !printing;
const themed = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
const kindColour = (kind) => (isDark() && kind.dark) || kind.colour;
const emptyColour = () => (isDark() ? "#22252A" : "#FFFFFF");

// Name of the kind as which a row is drawn. Maps of older programs have no column `kind`, and show only the
// class.
const kindOf = (row) => row("kind") || row("class");

// Colours for a layer of words: one for each word that occurs.
function wordScale(name, words) {
  const fixed = fixedColours.get(name) ?? new Map();
  const sorted = words.filter((word) => word !== "").sort();
  const colours = new Map(sorted.map((word, place) => [word, fixed.get(word) ?? wordColours[place % wordColours.length]]));
  return (word) => colours.get(word) || emptyColour();
}

// Colours for a layer of numbers: cividis, which looks alike to colour-blind readers and gets steadily
// lighter.
function numberScale(values) {
  const finite = values.filter(Number.isFinite);
  let [low, high] = d3.extent(finite);
  if (low === undefined) [low, high] = [0, 1];
  if (low === high) [low, high] = [low - 0.5, high + 0.5];
  const logarithmic = low > 0 && high / low > 50;
  const axis = (logarithmic ? d3.scaleLog() : d3.scaleLinear()).domain([low, high]).range([0, 1]);
  const table = d3.range(256).map((level) => d3.interpolateCividis(level / 255));
  const scale = (value) =>
    Number.isFinite(value) ? table[Math.max(0, Math.min(255, Math.round(255 * axis(value))))] : emptyColour();
  return Object.assign(scale, { low, high, logarithmic });
}
