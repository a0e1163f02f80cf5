"use strict";
// Reads what the program wrote: base64 of zlib of the records that encode_orbit.hpp and encode_column.hpp describe.

async function inflate(text) {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Records of `width` bytes from their byte planes.
function fromPlanes(planes, width) {
  const count = planes.length / width, records = new Uint8Array(planes.length);
  for (let plane = 0; plane < width; ++plane)
    for (let i = 0, from = plane * count, to = plane; i < count; ++i, ++from, to += width) records[to] = planes[from];
  return records.buffer;
}

// Typed arrays have the byte order of the machine. All browsers run on machines that store the lowest byte
// first.
const numbersOf = (planes) => new Float64Array(fromPlanes(planes, 8));
const placesOf = (planes) => new Uint32Array(fromPlanes(planes, 4));

class Reader {
  constructor(bytes) { this.view = new DataView(bytes.buffer); this.at = 0; }
  take(method, size) { const value = this.view[method](this.at, true); this.at += size; return value; }
  u16() { return this.take("getUint16", 2); }
  i16() { return this.take("getInt16", 2); }
  u32() { return this.take("getUint32", 4); }
  f32() { return this.take("getFloat32", 4); }
  many(count, read) { return Array.from({ length: count }, () => read.call(this)); }
  planes16(count) {
    const low = this.at, high = this.at + count;
    this.at += 2 * count;
    return Array.from({ length: count }, (_, i) => this.view.getUint8(low + i) | (this.view.getUint8(high + i) << 8));
  }
  levels(count) {
    const base = this.f32(), width = this.f32();
    let level = 0;
    return this.planes16(count).map((difference) => base + width * (level = (level + difference) & 0xffff));
  }
}

function readOrbit(reader) {
  const orbit = { first_revolution: reader.u32(), turns: reader.u16(), steps_per_turn: reader.u16() };
  const samples = reader.u16(), signals = reader.u16();
  let step = 0;
  orbit.steps = reader.planes16(samples).map((gap) => (step += gap));
  orbit.x = reader.levels(samples);
  orbit.y = reader.levels(samples);
  orbit.stops = d3.range((signals - 2) / 3).map(() =>
    ({ x: reader.levels(samples), y: reader.levels(samples), gap: reader.levels(samples) }));
  const points = reader.u16();
  const x = reader.levels(points), y = reader.levels(points);
  orbit.section = x.map((value, i) => [value, y[i]]);
  const turns = reader.u16(), lines = reader.u16(), largest = reader.f32();
  const places = reader.many(lines, reader.i16), amplitudes = reader.many(lines, reader.u16);
  orbit.spectrum = places.map((k, i) => ({ order: k / turns, amplitude_m: (largest * amplitudes[i]) / 65535 }));
  return orbit;
}

// Reads a block of records and returns the orbits by their cells.
function readOrbits(bytes) {
  const reader = new Reader(bytes), orbits = new Map();
  while (reader.at < bytes.length) {
    const cell = reader.u32(), end = reader.u32() + reader.at;
    orbits.set(cell, readOrbit(reader));
    reader.at = end;
  }
  return orbits;
}
