"use strict";
// Common part of all panels: an SVG with two axes.
function makePlot(id, { x, y, xLabel, yLabel, square = false, height = 240 }) {
  const figure = document.getElementById(id), width = Math.max(260, figure.clientWidth);
  const space = { left: 54, right: 12, top: 8, bottom: 40 };
  const size = square ? Math.min(width, 420) : height;
  const inner = { width: width - space.left - space.right, height: size - space.top - space.bottom };
  const xScale = d3.scaleLinear().domain(x).range([space.left, space.left + inner.width]);
  const yScale = d3.scaleLinear().domain(y).range([space.top + inner.height, space.top]);
  if (square) widenToScale(xScale, yScale, inner);
  const svg = d3.select(figure).selectAll("svg").data([0]).join("svg")
    .attr("viewBox", `0 0 ${width} ${size}`).attr("width", "100%").attr("role", "img")
    .attr("aria-label", figure.querySelector("figcaption").textContent);
  svg.html("");
  const clip = id + "-inside";
  svg.append("clipPath").attr("id", clip).append("rect").attr("x", space.left).attr("y", space.top)
    .attr("width", inner.width).attr("height", inner.height);
  const marks = svg.append("g").attr("clip-path", `url(#${clip})`);
  const axes = svg.append("g");
  axes.append("g").attr("transform", `translate(0,${space.top + inner.height})`)
    .call(d3.axisBottom(xScale).ticks(Math.max(3, inner.width / 70)));
  axes.append("g").attr("transform", `translate(${space.left},0)`)
    .call(d3.axisLeft(yScale).ticks(Math.max(3, inner.height / 40)));
  axes.append("text").attr("class", "label").attr("text-anchor", "middle")
    .attr("x", space.left + inner.width / 2).attr("y", size - 6).text(xLabel);
  axes.append("text").attr("class", "label").attr("text-anchor", "middle")
    .attr("transform", `translate(12,${space.top + inner.height / 2}) rotate(-90)`).text(yLabel);
  return { svg, marks, x: xScale, y: yScale, space, inner };
}

// Widens the scales so that a millimetre is equally long on both axes.
function widenToScale(xScale, yScale, inner) {
  const [x0, x1] = xScale.domain(), [y0, y1] = yScale.domain();
  const unit = Math.max((x1 - x0) / inner.width, (y1 - y0) / inner.height);
  const middle = (a, b, length) => [(a + b - unit * length) / 2, (a + b + unit * length) / 2];
  xScale.domain(middle(x0, x1, inner.width));
  yScale.domain(middle(y0, y1, inner.height));
}

function padded(low, high, share = 0.06) {
  const space = (high - low) * share || Math.abs(high) * share || 1e-6;
  return [low - space, high + space];
}

function addLine(plot, points, colour, width = 1.5, dashes = "") {
  return plot.marks.append("path").attr("fill", "none").attr("stroke", colour).attr("stroke-width", width)
    .attr("stroke-dasharray", dashes).attr("stroke-linejoin", "round")
    .attr("d", d3.line().x((p) => plot.x(p[0])).y((p) => plot.y(p[1]))(points));
}

function addPoints(plot, points, colour, radius = 3) {
  plot.marks.append("g").attr("fill", colour).selectAll("circle").data(points).join("circle")
    .attr("cx", (p) => plot.x(p[0])).attr("cy", (p) => plot.y(p[1])).attr("r", radius);
}

// Names of the curves in a row above the plot's lower edge.
function addKey(plot, entries) {
  let at = plot.space.left + 6;
  for (const [name, colour, dashes] of entries) {
    const y = plot.space.top + 8;
    plot.svg.append("line").attr("x1", at).attr("x2", at + 18).attr("y1", y).attr("y2", y)
      .attr("stroke", colour).attr("stroke-width", 2).attr("stroke-dasharray", dashes || "");
    const text = plot.svg.append("text").attr("class", "label").attr("x", at + 22).attr("y", y + 4).text(name);
    at += 34 + text.node().getComputedTextLength();
  }
}
