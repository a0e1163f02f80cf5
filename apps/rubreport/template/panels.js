"use strict";
// The motion of the selected cell in four pictures. Lengths in mm.
const mm = (values) => values.map((value) => 1e3 * value);

const panelWidth = () => document.getElementById("orbit").clientWidth;
let drawnWidth = null;  // width of a panel; null where none is drawn
const panelsNeedDrawing = () => drawnWidth !== null && drawnWidth !== panelWidth();

function drawPanels(data, cell, orbit, stop) {
  drawnWidth = panelWidth();
  const speed_hz = data.value("speed_hz", cell);
  const walls = data.wallsOf(cell);
  drawHistory(walls[stop], orbit, speed_hz, stop);
  drawOrbit(walls, orbit);
  drawSpectrum(orbit);
  drawSection(orbit);
}

function clearPanels() {
  drawnWidth = null;
  for (const id of ["history", "orbit", "spectrum", "section"]) d3.select("#" + id).selectAll("svg").remove();
}

// Time history: x and y of the rotor and, for one stop, the rotor's displacement towards the wall and the
// position of the wall (clearance plus casing). The last two curves meet where the gap closes.
function drawHistory(wall, orbit, speed_hz, stop) {
  const signals = orbit.stops[stop];
  const time = orbit.steps.map((step) => (1e3 * step) / orbit.steps_per_turn / speed_hz);
  const casing = signals.x.map((x, i) =>
    wall.around ? Math.hypot(x, signals.y[i]) : wall.normal[0] * x + wall.normal[1] * signals.y[i]);
  // Around the rotor the distance is measured from the casing, so that the wall is a constant line.
  const wallAt = mm(casing.map((value) => wall.clearance_m + (wall.around ? 0 : value)));
  const rotor = signals.gap.map((gap, i) => wallAt[i] - 1e3 * gap);
  const x = mm(orbit.x), y = mm(orbit.y), all = [...x, ...y, ...wallAt, ...rotor];
  const plot = makePlot("history", {
    x: [time[0], time[time.length - 1]], y: padded(d3.min(all), d3.max(all), 0.14), height: 300,
    xLabel: `time after revolution ${orbit.first_revolution} (ms)`, yLabel: "displacement (mm)",
  });
  const at = (values) => time.map((t, i) => [t, values[i]]);
  for (let turn = 1; turn < orbit.turns; ++turn)
    addLine(plot, plot.y.domain().map((v) => [(1e3 * turn) / speed_hz, v]), themed("line"), 1);
  const clearance = 1e3 * wall.clearance_m;
  addLine(plot, [[time[0], clearance], [time[time.length - 1], clearance]], themed("text"), 1, "5 4");
  // A wall straight above or beside the rotor is reached along y or x itself.
  const along = (component) => !wall.around && Math.abs(wall.normal[component]) > 0.999;
  const others = [[x, "x", "faint", "3 2"], [y, "y", "second", ""]].filter((_, component) => !along(component));
  for (const [values, , colour, dashes] of others) addLine(plot, at(values), themed(colour), 1, dashes);
  addLine(plot, at(wallAt), themed("wall"), 2.5);
  addLine(plot, at(rotor), themed("rotor"), 1.5);
  addKey(plot, [["to the wall", themed("rotor")], ["wall", themed("wall")],
    ...others.map(([, name, colour, dashes]) => [name, themed(colour), dashes])]);
}

function drawOrbit(walls, orbit) {
  const x = mm(orbit.x), y = mm(orbit.y);
  const reach = d3.max([...x, ...y].map(Math.abs));
  // Distant walls are left out, as the orbit would shrink to a point.
  const near = walls.filter((wall) => wall.at_orbit && 1e3 * wall.clearance_m < 6 * reach);
  const around = near.filter((wall) => wall.around), flat = near.filter((wall) => !wall.around);
  const xs = [...x, 0], ys = [...y, 0];
  for (const wall of flat) {
    xs.push(1e3 * wall.clearance_m * wall.normal[0]);
    ys.push(1e3 * wall.clearance_m * wall.normal[1]);
  }
  for (const wall of around) for (const side of [-1, 1]) {
    xs.push(1e3 * (wall.centre_m[0] + side * wall.clearance_m));
    ys.push(1e3 * (wall.centre_m[1] + side * wall.clearance_m));
  }
  const plot = makePlot("orbit", {
    x: padded(...d3.extent(xs)), y: padded(...d3.extent(ys)), square: true, xLabel: "x (mm)", yLabel: "y (mm)",
  });
  const far = 4 * (plot.x.domain()[1] - plot.x.domain()[0] + Math.abs(reach));
  for (const wall of flat) {
    const [nx, ny] = wall.normal, c = 1e3 * wall.clearance_m;
    const point = (along, out) => [nx * (c + out) - ny * along, ny * (c + out) + nx * along];
    addLine(plot, [point(-far, 0), point(far, 0), point(far, far), point(-far, far)], "none").attr("fill", themed("solid"));
    addLine(plot, [point(-far, 0), point(far, 0)], themed("text"), 1, "5 4");
  }
  for (const wall of around)
    plot.marks.append("circle").attr("cx", plot.x(1e3 * wall.centre_m[0])).attr("cy", plot.y(1e3 * wall.centre_m[1]))
      .attr("r", plot.x(1e3 * wall.clearance_m) - plot.x(0)).attr("fill", "none").attr("stroke", themed("text"))
      .attr("stroke-dasharray", "5 4");
  addLine(plot, x.map((value, i) => [value, y[i]]), themed("rotor"), 1.3);
  contacts(orbit).forEach((range) =>
    addLine(plot, range.map((i) => [x[i], y[i]]), themed("wall"), 3));
  addPoints(plot, orbit.section.map((point) => mm(point)), themed("point"), 3);
}

// Ranges of samples in which a stop is touched.
function contacts(orbit) {
  const ranges = [];
  orbit.x.forEach((_, i) => {
    if (!orbit.stops.some((stop) => stop.gap[i] < 0)) return;
    const latest = ranges[ranges.length - 1];
    if (latest && latest[latest.length - 1] === i - 1) latest.push(i);
    else ranges.push([i]);
  });
  return ranges;
}

function drawSpectrum(orbit) {
  const lines = orbit.spectrum.map((line) => ({ order: line.order, amplitude: 1e3 * line.amplitude_m }));
  const largest = d3.max(lines, (line) => line.amplitude) || 1;
  const reach = Math.max(2, Math.ceil(d3.max(lines.filter((line) => line.amplitude > 0.01 * largest),
    (line) => Math.abs(line.order)) || 2)) + 0.3;
  const plot = makePlot("spectrum", {
    x: [-reach, reach], y: [0, 1.15 * largest], xLabel: "order (× shaft speed)", yLabel: "amplitude (mm)",
  });
  plot.marks.append("g").attr("stroke", themed("rotor")).attr("stroke-width", 2).selectAll("line").data(lines).join("line")
    .attr("x1", (line) => plot.x(line.order)).attr("x2", (line) => plot.x(line.order))
    .attr("y1", plot.y(0)).attr("y2", (line) => plot.y(line.amplitude));
  plot.svg.append("text").attr("class", "label").attr("x", plot.space.left + 6).attr("y", plot.space.top + 12).text("backward");
  plot.svg.append("text").attr("class", "label").attr("text-anchor", "end").attr("x", plot.x(reach) - 6)
    .attr("y", plot.space.top + 12).text("forward");
}

// Zooms to the points; if these are close together or a single one, shows a twentieth of the orbit around
// them.
function drawSection(orbit) {
  const points = orbit.section.map((point) => mm(point));
  const span = (values) => d3.max(values) - d3.min(values);
  const least = Math.max(span(mm(orbit.x)), span(mm(orbit.y))) / 20 || 1e-6;
  const range = (values) => {
    const [low, high] = d3.extent(values), missing = Math.max(0, least - (high - low)) / 2;
    return padded(low - missing, high + missing, 0.1);
  };
  const plot = makePlot("section", {
    x: range(points.map((p) => p[0])), y: range(points.map((p) => p[1])), square: true, xLabel: "x (mm)", yLabel: "y (mm)",
  });
  addLine(plot, orbit.x.map((value, i) => [1e3 * value, 1e3 * orbit.y[i]]), themed("line"), 1);
  addPoints(plot, points, themed("point"), points.length > 24 ? 2 : 3.5);
}
