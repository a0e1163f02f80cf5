"use strict";
// Drawing of the map: cells on a canvas, and above it an SVG with axes, boundaries, marked rectangle and
// selected cell.
const margin = { left: 58, right: 14, top: 26, bottom: 44 };
const rpmHeight = 20;  // height of the numbers in rpm above a map over speeds in Hz

class MapView {
  // `state` has layer, hidden (a set of kinds), selected (cell or null), rectangle ([i0, j0, i1, j1] in
  // indices, or null) and view (the part of the map that is shown, or null).
  constructor(data, state) {
    this.data = data;
    this.state = state;
    this.box = document.getElementById("map");
    this.canvas = document.getElementById("cells");
    this.svg = d3.select("#overlay");
    this.parts = {};
    for (const name of ["axes", "boundaries", "marks"]) this.parts[name] = this.svg.append("g").attr("class", name);
    this.svg.append("clipPath").attr("id", "inside").append("rect");
  }

  // Whether the drawing fits the present size of its box and the pixels of the screen.
  fits() {
    const { width, height } = this.box.getBoundingClientRect();
    return width === this.width && height === this.height && window.devicePixelRatio === this.ratio;
  }

  measure() {
    const { data, state } = this;
    ({ width: this.width, height: this.height } = this.box.getBoundingClientRect());
    this.ratio = window.devicePixelRatio;
    // Cells and axes stay aligned also in a box of another size, as on paper.
    this.svg.attr("viewBox", `0 0 ${this.width} ${this.height}`).attr("preserveAspectRatio", "xMinYMin meet");
    margin.top = inHz(data.index.across) ? 26 + rpmHeight : 26;
    const [i0, j0, i1, j1] = state.view || [0, 0, data.x.values.length - 1, data.y.values.length - 1];
    this.shown = [i0, j0, i1, j1];
    const scale = (axis) => (axis.logarithmic ? d3.scaleLog() : d3.scaleLinear());
    this.x = scale(data.x).domain([data.x.edges[i0], data.x.edges[i1 + 1]])
      .range([margin.left, this.width - margin.right]);
    this.y = scale(data.y).domain([data.y.edges[j0], data.y.edges[j1 + 1]])
      .range([this.height - margin.bottom, margin.top]);
  }

  // Function that gives the colour of a cell on the layer that is shown.
  painter() {
    const { data, state } = this;
    if (state.layer === "class") return (cell) => kindColour(kinds[data.kinds[cell]]);
    const column = data.columns.get(state.layer);
    if (!column.words.length) {
      const scale = (this.scale = numberScale(Array.from(column.values)));
      return (cell) => scale(column.values[cell]);
    }
    const scale = wordScale(state.layer, column.words);
    return (cell) => scale(column.words[column.values[cell]]);
  }

  draw() {
    this.measure();
    this.drawCells();
    this.drawAxes();
    this.drawBoundaries();
    this.drawMarks();
  }

  drawCells() {
    const { data, state, ratio } = this, context = this.canvas.getContext("2d");
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    const colour = this.painter(), empty = emptyColour();
    const [i0, j0, i1, j1] = this.shown;
    // Edges lie on device pixels, so that no seam shows between cells.
    const snap = (value) => Math.round(value * ratio) / ratio;
    const left = d3.range(i0, i1 + 2).map((i) => snap(this.x(data.x.edges[i])));
    const low = d3.range(j0, j1 + 2).map((j) => snap(this.y(data.y.edges[j])));
    for (let j = j0; j <= j1; ++j) {
      const bottom = low[j - j0], top = low[j - j0 + 1];
      for (let i = i0; i <= i1; ++i) {
        const cell = data.cellAt(i, j), kind = kinds[data.kinds[cell]], hidden = state.hidden.has(kind.name);
        const from = left[i - i0], width = left[i - i0 + 1] - from;
        context.fillStyle = hidden ? empty : colour(cell);
        context.fillRect(from, top, width, bottom - top);
        if (kind.hatched && !hidden && state.layer === "class") this.hatch(context, from, top, width, bottom - top);
      }
    }
  }

  hatch(context, left, top, width, height) {
    if (width < 4 || height < 4) return;
    context.strokeStyle = "#FFFFFF";
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(left, top + height);
    context.lineTo(left + width, top);
    context.stroke();
  }

  drawAxes() {
    const g = this.parts.axes, ends = { bottom: this.height - margin.bottom, left: margin.left };
    const { across, measure } = this.data.index;
    const inUnit = (axis, name) => axis.copy().domain(axis.domain().map((value) => value * unitOf(name)[0]));
    g.html("");
    g.append("g").attr("transform", `translate(0,${ends.bottom})`)
      .call(d3.axisBottom(inUnit(this.x, across)).ticks(Math.max(3, this.width / 90), this.x.base && "~g"));
    g.append("g").attr("transform", `translate(${ends.left},0)`)
      .call(d3.axisLeft(inUnit(this.y, measure)).ticks(Math.max(3, this.height / 60), this.y.base && "~g"));
    if (inHz(across)) {
      const rpm = this.x.copy().domain(this.x.domain().map((value) => value * rpmPerHz));
      g.append("g").attr("class", "rpm").attr("transform", `translate(0,${margin.top})`)
        .call(d3.axisTop(rpm).ticks(Math.max(3, this.width / 90), "~f"));
      g.append("text").attr("class", "label").attr("text-anchor", "end").attr("x", margin.left - 8)
        .attr("y", margin.top - 9).text("rpm");
    }
    g.append("text").attr("class", "label").attr("text-anchor", "middle")
      .attr("x", (margin.left + this.width - margin.right) / 2).attr("y", this.height - 8).text(axisTitle(across));
    g.append("text").attr("class", "label").attr("text-anchor", "middle")
      .attr("transform", `translate(14,${(margin.top + ends.bottom) / 2}) rotate(-90)`)
      .text(axisTitle(measure));
    g.append("text").attr("class", "label").attr("x", margin.left).attr("y", 16)
      .text(this.state.layer === "class" ? "Motion of each cell" : columnTitle(this.state.layer));
  }

  drawBoundaries() {
    const families = [...new Set(this.data.index.boundaries.map((line) => line.family))];
    const line = d3.line().x((point) => this.x(point[0])).y((point) => this.y(point[1]));
    this.svg.select("#inside rect").attr("x", margin.left).attr("y", margin.top)
      .attr("width", this.width - margin.left - margin.right).attr("height", this.height - margin.top - margin.bottom);
    const g = this.parts.boundaries.attr("clip-path", "url(#inside)").attr("fill", "none").attr("stroke-width", 2);
    g.selectAll("path").data(this.data.index.boundaries).join("path")
      .attr("d", (boundary) => line(boundary.points))
      .attr("stroke", themed("mark"))
      .attr("stroke-dasharray", (boundary) => ["", "6 3", "2 3", "8 3 2 3"][families.indexOf(boundary.family) % 4])
      .selectAll("title").data((boundary) => [boundary]).join("title")
      .text((boundary) => [boundary.family, boundary.kind].filter(Boolean).join(": "));
  }

  drawMarks() {
    const { data, state } = this, marks = [];
    const box = ([i0, j0, i1, j1]) => ({
      left: this.x(data.x.edges[i0]), right: this.x(data.x.edges[i1 + 1]),
      top: this.y(data.y.edges[j1 + 1]), bottom: this.y(data.y.edges[j0]),
    });
    if (state.rectangle) marks.push({ ...box(state.rectangle), dashes: "5 4", widen: 0 });
    if (state.selected !== null) {
      const [i, j] = data.placeOf(state.selected);
      marks.push({ ...box([i, j, i, j]), dashes: "", widen: 2 });
    }
    // A dark line with a light line around it is visible on every colour.
    const lines = marks.flatMap((mark) => [{ ...mark, stroke: "#FFFFFF", size: 4 }, { ...mark, stroke: "#000000", size: 2 }]);
    this.parts.marks.attr("clip-path", "url(#inside)").attr("fill", "none").selectAll("rect").data(lines).join("rect")
      .attr("x", (m) => m.left - m.widen).attr("y", (m) => m.top - m.widen)
      .attr("width", (m) => m.right - m.left + 2 * m.widen).attr("height", (m) => m.bottom - m.top + 2 * m.widen)
      .attr("stroke", (m) => m.stroke).attr("stroke-width", (m) => m.size).attr("stroke-dasharray", (m) => m.dashes);
  }

  // Indices of the cell under a point of the page; null outside the map.
  placesAt(clientX, clientY) {
    const { left, top } = this.box.getBoundingClientRect(), { data } = this;
    const x = this.x.invert(clientX - left), y = this.y.invert(clientY - top), [i0, j0, i1, j1] = this.shown;
    const i = d3.bisectRight(data.x.edges, x) - 1, j = d3.bisectRight(data.y.edges, y) - 1;
    return i < i0 || i > i1 || j < j0 || j > j1 ? null : [i, j];
  }

  // Centre of a cell, in pixels of the page.
  middleOf(cell) {
    const { left, top } = this.box.getBoundingClientRect(), [i, j] = this.data.placeOf(cell);
    const middle = (scale, edges, place) => (scale(edges[place]) + scale(edges[place + 1])) / 2;
    return [left + middle(this.x, this.data.x.edges, i), top + middle(this.y, this.data.y.edges, j)];
  }
}
