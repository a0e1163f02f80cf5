"use strict";
// Export of pictures and tables. They are made inside the page and offered as downloads.
function download(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// Copy of an SVG that looks the same without the page: styles of the style sheet are written into its
// elements.
function standaloneSvg(svg) {
  const copy = svg.cloneNode(true), names = ["fill", "stroke", "stroke-width", "stroke-dasharray", "font-family",
    "font-size", "text-anchor", "opacity"];
  const originals = [svg, ...svg.querySelectorAll("*")], copies = [copy, ...copy.querySelectorAll("*")];
  originals.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of names) copies[i].setAttribute(name, style.getPropertyValue(name));
  });
  const { width, height } = svg.viewBox.baseVal.width ? svg.viewBox.baseVal : svg.getBoundingClientRect();
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
  return { copy, width, height };
}

function addNode(parent, name, attributes, text) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text) node.textContent = text;
  parent.append(node);
  return node;
}

function ground(copy, width, height) {
  const back = addNode(copy, "rect", { width, height, fill: themed("ground") });
  copy.prepend(back);
}

// Text without the characters that XML forbids. Names in a table may have them and browsers keep them, but no
// program reads a picture with one.
const allowedInXml = (text) => text.replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]|[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g, "\ufffd");
const svgText = (copy) => allowedInXml(new XMLSerializer().serializeToString(copy));
const svgBlob = (copy) => new Blob([svgText(copy)], { type: "image/svg+xml" });

function saveFigure(id) {
  const { copy, width, height } = standaloneSvg(document.querySelector(`#${id} svg`));
  ground(copy, width, height);
  download(id + ".svg", svgBlob(copy));
}

// The map as an SVG with its legend to the right; the cells are embedded as a bitmap.
function mapSvg(view, legend) {
  const { copy, width, height } = standaloneSvg(document.getElementById("overlay"));
  const whole = width + 230;
  copy.setAttribute("width", whole);
  copy.setAttribute("viewBox", `0 0 ${whole} ${height}`);
  const left = margin.left, top = margin.top, right = width - margin.right, bottom = height - margin.bottom;
  const ratio = view.canvas.width / view.width, cells = document.createElement("canvas");
  cells.width = Math.round((right - left) * ratio);
  cells.height = Math.round((bottom - top) * ratio);
  cells.getContext("2d").drawImage(view.canvas, -left * ratio, -top * ratio);
  copy.prepend(addNode(copy, "image", { x: left, y: top, width: right - left, height: bottom - top,
    href: cells.toDataURL("image/png") }));
  ground(copy, whole, height);
  legend.forEach(([label, colour], i) => {
    addNode(copy, "rect", { x: width + 4, y: top + 20 * i, width: 14, height: 14, fill: colour, stroke: themed("line") });
    addNode(copy, "text", { x: width + 24, y: top + 20 * i + 12, fill: themed("text"), "font-size": "12px",
      "font-family": "DejaVu Sans, Verdana, sans-serif" }, label);
  });
  return { copy, width: whole, height };
}

async function saveMapPng(view, legend) {
  const { copy, width, height } = mapSvg(view, legend), ratio = 2, picture = new Image();
  picture.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(svgText(copy));
  await picture.decode();
  const canvas = document.createElement("canvas");
  canvas.width = ratio * width;
  canvas.height = ratio * height;
  canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => download("map.png", blob));
}

// Rows of these cells as in map.csv: equal words, and numbers that read back to the same values.
function rowsCsv(data, cells) {
  const names = [...data.columns.keys()];
  const text = (value) => {
    if (typeof value !== "number") return /[",\n\r]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
    return Number.isNaN(value) ? "" : value === Infinity ? "inf" : value === -Infinity ? "-inf" : String(value);
  };
  const lines = cells.map((cell) => names.map((name) => text(data.value(name, cell))).join(","));
  return [`# rubsweep ${data.index.version}`, `# digest ${data.index.digest}`,
    `# rows chosen in the report: ${cells.length} of ${data.cells}`, names.map(text).join(","), ...lines].join("\n") + "\n";
}
