"use strict";
// Rows of the map and motions of its cells, which are decoded when needed.
const dataText = (id) => document.getElementById(id).textContent;

class MapData {
  constructor() {
    this.index = JSON.parse(dataText("index"));
    this.columns = new Map(this.index.columns.map((column, place) => [column.name, { ...column, place }]));
    const [across, up] = this.index.shown_axes;
    for (const [name, shown] of [[this.index.across, across], [this.index.measure, up]])
      if (shown.unit !== undefined) writtenUnits.set(name, [shown.units_per_si, shown.unit, shown.name]);
    this.x = this.axis(this.index.speed_hz, across.logarithmic);
    this.y = this.axis(this.index.unbalance, up.logarithmic);
    this.cells = this.index.speed_hz.length * this.index.unbalance.length;
    this.blocks = new Map();
  }

  // An axis in rising order: its values, the edges of its cells half way between values (for a logarithmic
  // axis, between their logarithms), and the index of each value in the configuration.
  axis(values, logarithmic = false) {
    if (logarithmic && d3.min(values) > 0) {
      const of = this.axis(values.map(Math.log));
      return { ...of, values: of.source.map((place) => values[place]), edges: of.edges.map(Math.exp), logarithmic };
    }
    const source = d3.range(values.length).sort((a, b) => values[a] - values[b]);
    const sorted = source.map((place) => values[place]), last = sorted.length - 1;
    const edges = d3.range(1, sorted.length).map((i) => (sorted[i - 1] + sorted[i]) / 2);
    const margin = (i, j) => (last > 0 ? (sorted[i] - sorted[j]) / 2 : Math.abs(sorted[0]) / 10 || 0.1);
    const place = [];
    source.forEach((from, to) => (place[from] = to));
    return { values: sorted, edges: [sorted[0] - margin(1, 0), ...edges, sorted[last] + margin(last, last - 1)], source, place };
  }

  // Cell with index i of the speed and j of the unbalance, both in rising order, and the inverse.
  cellAt(i, j) { return this.y.source[j] * this.x.source.length + this.x.source[i]; }
  placeOf(cell) {
    const speeds = this.x.source.length;
    return [this.x.place[cell % speeds], this.y.place[Math.floor(cell / speeds)]];
  }

  async load() {
    await Promise.all([...this.columns.values()].map(async (column) => {
      const planes = await inflate(dataText("column-" + column.place));
      column.values = column.words.length ? placesOf(planes) : numbersOf(planes);
    }));
    this.kinds = new Uint8Array(this.cells);
    for (let cell = 0; cell < this.cells; ++cell)
      this.kinds[cell] = kindByName.get(kindOf((name) => this.value(name, cell))) ?? kinds.length - 1;
  }

  // Number (NaN where the cell is empty) or word of a column; "" where the column does not exist.
  value(name, cell) {
    const column = this.columns.get(name);
    if (!column) return "";
    return column.words.length ? column.words[column.values[cell]] : column.values[cell];
  }

  // Walls in a cell. Keys change them, speed and unbalance do not.
  wallsOf(cell) {
    const lists = this.index.wall_list_of_keys;
    return this.index.wall_lists[lists[Math.floor(cell / (this.cells / lists.length))]];
  }

  isWord(name) { return this.columns.get(name).words.length > 0; }

  // False for a cell of a refined map whose class is only known from its block.
  isComputed(cell) { return this.value("status", cell) !== "not computed"; }

  // Cells whose motions are stored.
  recordedCells() {
    const { cells, speed_stride, unbalance_stride } = this.index.orbits, speeds = this.x.source.length;
    if (cells) return cells;
    const kept = (count, stride) => d3.range(Math.floor(stride / 2), count, stride);
    return kept(this.y.source.length, unbalance_stride).flatMap((j) => kept(speeds, speed_stride).map((i) => j * speeds + i));
  }

  // Nearest cell to `cell` of the same kind and order with a stored motion; null where there is none.
  recordedCell(cell) {
    const order = this.value("order", cell), [i, j] = this.placeOf(cell);
    const distance = (other) => { const [k, l] = this.placeOf(other); return (i - k) ** 2 + (j - l) ** 2; };
    const alike = (this.recorded ||= this.recordedCells()).filter((other) =>
      this.kinds[other] === this.kinds[cell] && Object.is(this.value("order", other), order));
    return alike.length ? alike[d3.minIndex(alike, distance)] : null;
  }

  // Motion of a cell with recordedCell(cell) === cell; undefined for any other.
  async orbit(cell) {
    const speeds = this.x.source.length, { speed_stride, unbalance_stride, cells_per_block } = this.index.orbits;
    const kept = (count, stride) => Math.floor((count - 1 - Math.floor(stride / 2)) / stride) + 1;
    const listed = this.index.orbits.cells;
    const place = listed ? d3.bisectLeft(listed, cell)
      : Math.floor(Math.floor(cell / speeds) / unbalance_stride) * kept(speeds, speed_stride) +
        Math.floor((cell % speeds) / speed_stride);
    const block = Math.floor(place / cells_per_block);
    if (!this.blocks.has(block)) this.blocks.set(block, inflate(dataText("orbits-" + block)).then(readOrbits));
    return (await this.blocks.get(block)).get(cell);
  }
}
