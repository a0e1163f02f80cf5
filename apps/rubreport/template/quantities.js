"use strict";
// Names of columns and texts of numbers on the page. Maps are used since a table may have columns called
// constructor or __proto__, which every plain object has.
const layerNames = new Map(Object.entries({
  class: "class", proof: "proof", floquet_modulus: "largest multiplier", peak_contact_force_n: "peak contact force",
  peak_displacement_m: "peak displacement", hits_per_revolution: "hits per revolution", revolutions: "revolutions",
  robust: "robust",
}));
const fourDigits = d3.format(".4~g"), whole = d3.format(".0f");
// Four digits, but whole numbers for large values: 10800 rpm, not 1.08e+4.
const significant = (value) => (Math.abs(value) >= 9999.5 && Math.abs(value) < 1e6 ? whole : fourDigits)(value);

// Columns that the configuration gives in other units: column -> [factor, unit, name].
const writtenUnits = new Map();

// Unit in which a column is shown, and the factor to convert to it.
function unitOf(name) {
  if (writtenUnits.has(name)) return writtenUnits.get(name);
  if (name.endsWith("_m")) return [1e3, "mm"];
  if (name.endsWith("_n")) return [1, "N"];
  if (name.endsWith("_hz")) return [1, "Hz"];
  return [1, ""];
}

function quantity(name, value) {
  if (typeof value !== "number") return String(value).replaceAll("_", " ");
  if (Number.isNaN(value)) return "";
  if (!Number.isFinite(value)) return value > 0 ? "infinite" : "-infinite";
  const [factor, unit] = unitOf(name);
  return (significant(factor * value) + " " + unit).trim();
}

function columnTitle(name) {
  const unit = unitOf(name)[1], words = (layerNames.get(name) ?? name.replace(/_(m|n|hz)$/, "")).replaceAll("_", " ");
  return unit ? words + " (" + unit + ")" : words;
}

const axisNames = new Map(Object.entries({ speed_hz: "speed", whirl_ratio: "whirl ratio", eccentricity_m: "eccentricity" }));
const axisName = (name) => writtenUnits.get(name)?.[2] ?? axisNames.get(name) ?? name;
function axisTitle(name) {
  const unit = unitOf(name)[1];
  return axisName(name) + (unit ? ` (${unit})` : "");
}

// Whether a column is a shaft speed in Hz, which is shown in rpm, too.
const inHz = (name) => name === "speed_hz" && !writtenUnits.has(name);
const rpmPerHz = 60;
function speedText(value) {
  return quantity("speed_hz", value) + (inHz("speed_hz") ? ` (${significant(rpmPerHz * value)} rpm)` : "");
}

function placeText(data, cell) {
  const { across, measure } = data.index, value = data.value(across, cell);
  return (across === "speed_hz" ? speedText(value) : axisName(across) + " " + quantity(across, value)) + ", " +
    axisName(measure) + " " + quantity(measure, data.value(measure, cell));
}

// Name of a motion, such as "subharmonic 1/3" or "quasi-periodic oval".
function motionText(data, cell) {
  const order = data.value("order", cell), kind = kinds[data.kinds[cell]];
  if (data.value("class", cell) === "subharmonic") return "subharmonic 1/" + order;
  return kind.label;
}

function hoverText(data, cell) {
  const parts = ["proof", "hits_per_revolution", "peak_displacement_m", "peak_contact_force_n", "floquet_modulus",
    "revolutions", "robust"];
  const said = parts.filter((name) => data.columns.has(name))
    .map((name) => [columnTitle(name).replace(/ \(.*\)/, ""), quantity(name, data.value(name, cell))])
    .filter((pair) => pair[1] !== "").map((pair) => pair.join(" "));
  const status = data.value("status", cell);
  if (status !== "ok") said.push("status " + status);
  return placeText(data, cell) + ": " + [motionText(data, cell), ...said].join("; ");
}
