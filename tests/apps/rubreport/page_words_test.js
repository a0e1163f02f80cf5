"use strict";
// Columns and words of a table may be called as the members of every plain object: the page takes them for what they are.
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const vm = require("node:vm");

const format = () => (value) => String(value);
const selection = new Proxy(function () {}, { get: () => () => selection, apply: () => selection });
const page = { d3: { format, select: () => selection, range: (n) => [...Array(n).keys()] }, window: { matchMedia: () => ({ matches: false }) }, URLSearchParams };
page.document = { getElementById: () => ({ textContent: '{"motion_kinds": []}' }) };
vm.createContext(page);
const template = process.argv[2];
const sources = ["quantities", "palette", "controls", "export"].map((name) =>
  fs.readFileSync(path.join(template, name + ".js"), "utf8").replace('"use strict";', ""));
const wanted = "({ columnTitle, axisName, axisTitle, wordScale, layersOf, rowsCsv, quantity, emptyColour, placeText, writtenUnits, allowedInXml })";
const { columnTitle, axisName, axisTitle, wordScale, layersOf, rowsCsv, placeText, writtenUnits, allowedInXml } = vm.runInContext(sources.join("\n") + wanted, page);

const members = ["constructor", "__proto__", "toString", "hasOwnProperty", "valueOf", "__defineGetter__"];
for (const name of members) {
  assert.strictEqual(columnTitle(name), name.replaceAll("_", " "));
  assert.strictEqual(axisName(name), name);
  assert.strictEqual(axisTitle(name), name);
}
for (const layer of ["proof", "robust", "class", ...members]) {
  const colour = wordScale(layer, members);
  for (const word of members) assert.match(colour(word), /^#[0-9A-F]{6}$/, `${layer}: ${word}`);
}
assert.strictEqual(columnTitle("floquet_modulus"), "largest multiplier");
assert.strictEqual(axisTitle("speed_hz"), "speed (Hz)");
assert.strictEqual(wordScale("proof", ["rest"])("rest"), "#44AA99");

const column = { words: [], values: [1] };
const columns = new Map([["class", { words: ["chaotic"], values: [0] }], ...members.map((name) => [name, column])]);
const data = { columns, cells: 1, index: { keys: [], version: "1", digest: "2" }, value: (name) => (name === "class" ? "chaotic" : 1) };
assert.deepStrictEqual([...layersOf(data)], ["class", ...members]);

// Places of cells are said in rpm, too, once where that is how the speeds are written.
const placed = { index: { across: "speed_hz", measure: "whirl_ratio" }, value: (name) => (name === "speed_hz" ? 75 : 0.4) };
assert.strictEqual(placeText(placed, 0), "75 Hz (4500 rpm), whirl ratio 0.4");
writtenUnits.set("speed_hz", [60, "rpm", "speed"]);
assert.strictEqual(placeText(placed, 0), "4500 rpm, whirl ratio 0.4");

// Names with commas and quotes are quoted as words are.
data.columns = new Map([['a,"b"', column], ["c", column]]);
assert.strictEqual(rowsCsv(data, [0]).split("\n").slice(-3).join("|"), '"a,""b""",c|1,1|');

// A saved picture is XML whatever a column is called: signs that XML has not are shown as unknown ones, others stay.
assert.strictEqual(allowedInXml("a\u0001b\u001bc\uffff\ud800d"), "a\ufffdb\ufffdc\ufffd\ufffdd");
assert.strictEqual(allowedInXml("\t\n\r µ \u{1f600} <>"), "\t\n\r µ \u{1f600} <>");
