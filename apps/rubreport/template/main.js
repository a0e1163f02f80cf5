"use strict";
// Builds the page from its parts.
const state = { layer: "class", hidden: new Set(), selected: null, rectangle: null, view: null, stop: 0 };
const data = new MapData();
let view = null, present = [];

// Cell that a page without an address shows: the middle one of those with the most frequent motion with
// contact.
function typicalCell() {
  const groups = new Map();
  data.kinds.forEach((kind, cell) => {
    if (!kinds[kind].settled_rub) return;
    groups.set(kind, [...(groups.get(kind) || []), cell]);
  });
  const largest = [...groups.values()].sort((a, b) => b.length - a.length)[0];
  return largest ? largest[Math.floor(largest.length / 2)] : 0;
}

function drawMap() {
  view.draw();
  const legend = legendOf(data, view, state, present);
  drawScale(state, legend);
  paintSwatches();
  d3.select("#layer").property("value", state.layer);
  d3.select("#zoom").property("disabled", !state.rectangle && !state.view)
    .text(state.rectangle || !state.view ? "Zoom to the rectangle" : "Whole map");
}

// Writes the line below the map for the cell under the mouse, or else for the selected cell.
function sayNumbers(cell) { document.getElementById("hover").textContent = cell === null ? "" : hoverText(data, cell); }

let asked = 0;
async function showCell() {
  const cell = state.selected, recorded = data.recordedCell(cell), mine = ++asked;
  sayNumbers(cell);
  document.getElementById("cell-title").textContent = `${placeText(data, cell)}: ${motionText(data, cell)}`;
  const measure = data.index.unbalance_measure;
  const keys = data.index.keys.map((key) => ` --set ${key}=${data.value(key, cell)}`).join("");
  document.getElementById("command").textContent =
    `rubtrace config.yaml --speed-hz ${data.value("speed_hz", cell)} --${measure.replace("_", "-")} ` +
    data.value(measure, cell) + keys;
  d3.select("#numbers").selectAll("tr").data([...data.columns.keys()]).join("tr").selectAll("td")
    .data((name) => [columnTitle(name), quantity(name, data.value(name, cell)).replace(unitOf(name)[1], "")]).join("td")
    .text((text) => text);
  const orbit = recorded === null ? undefined : await data.orbit(recorded);
  if (mine !== asked) return;
  let note = hoverText(data, cell);
  if (recorded !== cell && orbit) note += `. No motion of this cell is stored; shown is the one at ${placeText(data, recorded)}.`;
  if (!orbit) note += recorded === null ? ". No motion of its kind is stored." : ". There is no motion to show.";
  document.getElementById("cell-note").textContent = note;
  document.getElementById("panels").dataset.cell = orbit ? recorded : "";
  if (orbit) drawPanels(data, recorded, orbit, state.stop);
  else clearPanels();
}

function select(cell) {
  state.selected = cell;
  view.drawMarks();
  writeAddress(data, state);
  return showCell();
}

// Cells of the shown classes inside the rectangle, in the order of the map.
function chosenCells() {
  const [i0, j0, i1, j1] = state.rectangle || [0, 0, data.x.values.length - 1, data.y.values.length - 1];
  return d3.range(data.cells).filter((cell) => {
    const [i, j] = data.placeOf(cell);
    return data.isComputed(cell) && i >= i0 && i <= i1 && j >= j0 && j <= j1 && !state.hidden.has(kinds[data.kinds[cell]].name);
  });
}

const ordered = ([i, j], [k, l]) => [Math.min(i, k), Math.min(j, l), Math.max(i, k), Math.max(j, l)];

function listenToMouse() {
  let from = null, dragged = false;
  view.box.addEventListener("pointerdown", (event) => {
    from = event.button === 0 ? view.placesAt(event.clientX, event.clientY) : null;
    dragged = false;
  });
  view.box.addEventListener("pointermove", (event) => {
    const at = view.placesAt(event.clientX, event.clientY);
    sayNumbers(at ? data.cellAt(...at) : state.selected);
    // With a finger, dragging scrolls the page instead.
    if (!from || !at || event.pointerType !== "mouse" || event.buttons !== 1) return;
    if (!dragged && at[0] === from[0] && at[1] === from[1]) return;
    dragged = true;
    state.rectangle = ordered(from, at);
    view.drawMarks();
  });
  view.box.addEventListener("pointerleave", () => sayNumbers(state.selected));
  view.box.addEventListener("click", (event) => {
    const at = view.placesAt(event.clientX, event.clientY);
    if (dragged) drawMap();
    else if (at) select(data.cellAt(...at));
    from = null;
  });
}

function listenToKeys() {
  const steps = new Map(Object.entries({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }));
  let anchor = null;
  view.box.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      state.rectangle = anchor = null;
      drawMap();
    }
    const step = steps.get(event.key);
    if (!step) return;
    event.preventDefault();
    const before = data.placeOf(state.selected), [i0, j0, i1, j1] = view.shown;
    const i = Math.max(i0, Math.min(i1, before[0] + step[0])), j = Math.max(j0, Math.min(j1, before[1] + step[1]));
    if (event.shiftKey) {
      anchor = anchor || before;
      state.rectangle = ordered(anchor, [i, j]);
      drawMap();
    } else {
      anchor = null;
    }
    select(data.cellAt(i, j));
  });
}

function listenToButtons() {
  d3.select("#zoom").on("click", () => {
    state.view = state.rectangle;
    state.rectangle = null;
    drawMap();
  });
  d3.select("#map-png").on("click", () => saveMapPng(view, legendOf(data, view, state, present)));
  d3.select("#map-svg").on("click", () => download("map.svg", svgBlob(mapSvg(view, legendOf(data, view, state, present)).copy)));
  d3.select("#rows").on("click", () => download("rows.csv", new Blob([rowsCsv(data, chosenCells())], { type: "text/csv" })));
  for (const id of ["history", "orbit", "spectrum", "section"])
    d3.select("#" + id).append("button").attr("type", "button").text("SVG").on("click", () => saveFigure(id));
}

// Redraws everything that no longer fits its box. A box changes with the window, but also when a scroll bar
// appears, a line wraps or the page is zoomed. The map is drawn at once, before its box is visible. Panels
// change their own heights, and are drawn in the next frame.
function watchBoxes() {
  const refit = () => {
    if (!view.fits()) view.draw();
    if (panelsNeedDrawing()) requestAnimationFrame(showCell);
  };
  const boxes = new ResizeObserver(refit);
  boxes.observe(view.box);
  boxes.observe(document.getElementById("orbit"));
  // If the window is wider than the widest page, a zoom does not change the boxes.
  window.addEventListener("resize", refit);
}

function listenToWindow() {
  const redraw = () => { drawMap(); if (state.selected !== null) showCell(); };
  watchBoxes();
  darkScreen.addEventListener("change", redraw);
  window.addEventListener("beforeprint", () => { printing = true; redraw(); });
  window.addEventListener("afterprint", () => { printing = false; redraw(); });
  window.addEventListener("hashchange", () => {
    if (location.hash !== ownAddress && readAddress(data, state)) { drawMap(); select(state.selected); }
  });
}

// Choice of the wall that the time history shows, where there are several.
function fillStops() {
  const walls = d3.greatest(data.index.wall_lists, (list) => list.length);
  if (walls.length < 2) return;
  const label = d3.select("#stop-choice").append("label").text("Time history towards ");
  label.append("select").attr("id", "stop").on("change", function () { state.stop = Number(this.value); showCell(); })
    .selectAll("option").data(walls).join("option").attr("value", (_, i) => i).text((_, i) => `stop ${i}`);
}

function sayWhatIsStored() {
  const { recorded, speed_stride, unbalance_stride } = data.index.orbits;
  const thinned = speed_stride > 1 || unbalance_stride > 1;
  document.getElementById("orbits-note").textContent = data.index.orbits.cells
    ? `This map is refined: motions are stored for ${recorded} of its computed cells. Other cells show the nearest of ` +
      "them that has their class and order, and say so, or nothing."
    : thinned
    ? `This map is large: motions are stored for ${recorded} of its ${data.cells} cells, every ${speed_stride}. speed and ` +
      `every ${unbalance_stride}. unbalance. Other cells show the nearest of them that has their class and order, and ` +
      "say so, or nothing."
    : `Motions are stored for all ${recorded} cells that have one, as straight lines between as few samples as draw them ` +
      "within 1/400 of the orbit's size.";
}

async function begin() {
  if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old: it has no DecompressionStream");
  await data.load();
  document.getElementById("subtitle").textContent =
    (data.index.across === "speed_hz" ? `${data.x.values.length} speeds`
      : `${data.x.values.length} values of ${axisName(data.index.across)}`) +
    ` × ${data.y.values.length} values of the ${axisName(data.index.measure)}; ` +
    document.getElementById("subtitle").textContent;
  view = new MapView(data, state);
  fillLayers(data, state, () => { drawMap(); writeAddress(data, state); });
  present = fillClasses(data, state, drawMap);
  if (!readAddress(data, state)) state.selected = typicalCell();
  fillStops();
  sayWhatIsStored();
  drawMap();
  listenToMouse();
  listenToKeys();
  listenToButtons();
  listenToWindow();
  await showCell();
  document.documentElement.dataset.ready = "yes";
}

begin().catch((error) => {
  document.getElementById("problem").textContent = `The page cannot be shown: ${error.message}`;
  throw error;
});
