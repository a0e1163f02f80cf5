"use strict";
// Colours: Paul Tol's "muted" scheme, made for colour-blind readers, as the other figures of rubsweep have them. The last
// three kinds are hatched as well.
const kinds = [
  { name: "non_contact", label: "no contact", colour: "#F4F4F4", dark: "#2B2F36" },
  { name: "synchronous_circle", label: "synchronous circle", colour: "#4F9BD0" },
  { name: "synchronous_circle_backward", label: "backward circle", colour: "#F4A6B8" },
  { name: "synchronous", label: "synchronous", colour: "#88CCEE" },
  { name: "resting_contact", label: "at rest on a stop", colour: "#A8C686" },
  { name: "subharmonic_2", label: "subharmonic 1/2", colour: "#CC6677" },
  { name: "subharmonic_3", label: "subharmonic 1/3", colour: "#332288", dark: "#5A48C8" },
  { name: "subharmonic_4", label: "subharmonic 1/4", colour: "#DDCC77" },
  { name: "subharmonic_5", label: "subharmonic 1/5", colour: "#117733" },
  { name: "subharmonic_6", label: "subharmonic 1/6", colour: "#882255" },
  { name: "subharmonic_7", label: "subharmonic 1/7", colour: "#44AA99" },
  { name: "subharmonic_8", label: "subharmonic 1/8 and smaller", colour: "#999933" },
  { name: "quasi_periodic_oval", label: "quasi-periodic oval", colour: "#EE8866" },
  { name: "quasi_periodic_whip", label: "backward dry whip", colour: "#7A4F20" },
  { name: "quasi_periodic", label: "quasi-periodic", colour: "#AA4499" },
  { name: "chaotic", label: "chaotic", colour: "#000000", dark: "#FFFFFF" },
  { name: "unsettled", label: "unsettled", colour: "#555555", dark: "#8A8A8A", hatched: true },
  { name: "initial_contact", label: "pressed on the wall", colour: "#999999", hatched: true },
  { name: "failed", label: "failed", colour: "#CC0000", hatched: true },
];
const kindByName = new Map(kinds.map((kind, place) => [kind.name, place]));
const wordColours = ["#332288", "#88CCEE", "#DDCC77", "#CC6677", "#117733", "#AA4499", "#44AA99", "#999933", "#882255"];
// By the words of a table, which may be any: Maps, not plain objects.
const fixedColours = new Map([
  ["proof", new Map(Object.entries({ rest: "#44AA99", floquet: "#332288", floquet_observed: "#88CCEE", observed: "#DDCC77" }))],
  ["robust", new Map(Object.entries({ yes: "#88CCEE", no: "#882255" }))],
]);

// While the page is printed its colours are those of a light screen.
let printing = false;
const darkScreen = window.matchMedia("(prefers-color-scheme: dark)");
const isDark = () => darkScreen.matches && !printing;
const themed = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
const kindColour = (kind) => (isDark() && kind.dark) || kind.colour;
const emptyColour = () => (isDark() ? "#22252A" : "#FFFFFF");

// Kind that a row is drawn as: its class with the order of a subharmonic, and the motions of an annular stop apart.
function kindOf(row) {
  const motion = row("class");
  if (motion === "subharmonic") return "subharmonic_" + Math.min(row("order"), 8);
  if (motion === "synchronous" && row("orbit") === "circle")
    return row("whirl") === "backward" ? "synchronous_circle_backward" : "synchronous_circle";
  if (motion === "quasi_periodic" && !Number.isNaN(row("comb_spacing")) && row("comb_spacing") !== "")
    return row("whirl") === "backward" ? "quasi_periodic_whip" : "quasi_periodic_oval";
  return motion;
}

// Colours of a layer of words: one for each word that occurs.
function wordScale(name, words) {
  const fixed = fixedColours.get(name) ?? new Map();
  const sorted = words.filter((word) => word !== "").sort();
  const colours = new Map(sorted.map((word, place) => [word, fixed.get(word) ?? wordColours[place % wordColours.length]]));
  return (word) => colours.get(word) || emptyColour();
}

// Colours of a layer of numbers: cividis, which colour-blind readers see as others do, and which grows lighter steadily.
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
