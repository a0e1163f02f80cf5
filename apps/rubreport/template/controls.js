"use strict";
// Controls around the map: the layer, the classes that are shown, and the address that stores layer and
// selected cell.
const firstLayers = [...layerNames.keys()];

function layersOf(data) {
  const skipped = new Set(["speed_hz", "whirl_ratio", "eccentricity_m", ...data.index.keys]);
  const useful = (name) => {
    const column = data.columns.get(name);
    return column && !skipped.has(name) && (name === "class" || (column.words.length ? column.words.some((w) => w !== "")
      : column.values.some(Number.isFinite)));
  };
  const others = [...data.columns.keys()].filter((name) => !firstLayers.includes(name) && name !== "order");
  return [...firstLayers, ...others].filter(useful);
}

function fillLayers(data, state, changed) {
  d3.select("#layer").on("change", function () { state.layer = this.value; changed(); })
    .selectAll("option").data(layersOf(data)).join("option").attr("value", (name) => name).text(columnTitle);
}

// Classes of the map with their colours and shares, each with a box to hide or show it.
function fillClasses(data, state, changed) {
  const counts = new Array(kinds.length).fill(0);
  data.kinds.forEach((kind) => ++counts[kind]);
  const present = kinds.filter((_, place) => counts[place]);
  const labels = d3.select("#classes").selectAll("label").data(present).join("label");
  labels.append("input").attr("type", "checkbox").property("checked", true).attr("data-kind", (kind) => kind.name)
    .on("change", function (kind) {
      if (this.checked) state.hidden.delete(kind.name);
      else state.hidden.add(kind.name);
      changed();
    });
  labels.append("span").attr("class", "swatch");
  labels.append("span").text((kind) => `${kind.label} ${counts[kinds.indexOf(kind)]}`);
  const buttons = d3.select("#classes").append("span").attr("class", "controls");
  const set = (hidden) => {
    state.hidden = new Set(hidden ? present.map((kind) => kind.name) : []);
    labels.select("input").property("checked", !hidden);
    changed();
  };
  buttons.append("button").attr("type", "button").text("all").on("click", () => set(false));
  buttons.append("button").attr("type", "button").text("none").on("click", () => set(true));
  return present;
}

function paintSwatches() {
  d3.selectAll("#classes .swatch").style("background", (kind) => kindColour(kind))
    .style("background-image", (kind) =>
      kind.hatched ? "repeating-linear-gradient(135deg, transparent 0 3px, #fff 3px 4px)" : null);
}

// Names and colours of the layer that is shown, for the legend and the exported picture.
function legendOf(data, view, state, present) {
  if (state.layer === "class") return present.map((kind) => [kind.label, kindColour(kind)]);
  const column = data.columns.get(state.layer);
  if (column.words.length) {
    const scale = wordScale(state.layer, column.words);
    return column.words.map((word) => [word.replaceAll("_", " ") || "does not apply", scale(word)]);
  }
  const { low, high, logarithmic } = view.scale, steps = d3.range(6).map((i) => i / 5);
  const value = (share) => (logarithmic ? low * (high / low) ** share : low + share * (high - low));
  return [...steps.map((share) => [quantity(state.layer, value(share)), view.scale(value(share))]),
    ["does not apply", emptyColour()]];
}

function drawScale(state, legend) {
  d3.select("#scale").attr("class", "controls").selectAll("span.entry").data(state.layer === "class" ? [] : legend)
    .join("span").attr("class", "entry")
    .html("").each(function ([label, colour]) {
      d3.select(this).append("span").attr("class", "swatch").style("background", colour);
      d3.select(this).append("span").text(" " + label);
    });
}

// Part of the address after #: speed_hz, unbalance and layer, so that a link shows the same cell in another
// map, too.
function readAddress(data, state) {
  const given = new URLSearchParams(location.hash.slice(1));
  if (layersOf(data).includes(given.get("layer"))) state.layer = given.get("layer");
  const nearest = (axis, text) => d3.minIndex(axis.values, (value) => Math.abs(value - Number(text)));
  if (!given.has(data.index.across) || !given.has(data.index.measure)) return false;
  const i = nearest(data.x, given.get(data.index.across)), j = nearest(data.y, given.get(data.index.measure));
  if (i < 0 || j < 0) return false;
  state.selected = data.cellAt(i, j);
  return true;
}

let addressTimer = 0, ownAddress = "";
function writeAddress(data, state) {
  const [i, j] = data.placeOf(state.selected);
  const parts = { [data.index.across]: data.x.values[i], [data.index.measure]: data.y.values[j], layer: state.layer };
  ownAddress = "#" + new URLSearchParams(parts);
  // The address is changed with a delay: browsers refuse frequent changes, as while a key is held down.
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => location.replace(ownAddress), 200);
}
