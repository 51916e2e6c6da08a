// Taut in JavaScript: cloth that keeps a bound on its stretch and crosses nothing. index.d.ts says what each call does;
// numbers below are places of members in the structs of taut.h, where pointers take four bytes.
import createTaut from 'generated/taut.cjs';
import pack from 'generated/pack.js';

/** Loads the engine with the scenes and models that come with it. Everything is part of the package. */
export async function load() {
  const files = await unpack();
  const module = await createTaut({ wasmBinary: files.get('taut.wasm') });
  files.delete('taut.wasm');
  for (const [name, bytes] of files) {
    const path = `/taut/${name}`;
    module.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    module.FS.writeFile(path, bytes);
  }
  return new Taut(module);
}

// The length of an index, the index as JSON, the files one after the other: compressed, as text.
async function unpack() {
  const text = atob(pack);
  const compressed = Uint8Array.from(text, (character) => character.charCodeAt(0));
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const begin = 4 + new DataView(bytes.buffer).getUint32(0, true);
  let at = begin;
  return new Map(JSON.parse(new TextDecoder().decode(bytes.subarray(4, begin))).map(([name, size]) =>
    [name, bytes.subarray(at, (at += size))]));
}

/** A call failed; `result` is its number in taut.h. */
export class TautError extends Error {
  constructor(result, text) {
    super(text);
    this.name = 'TautError';
    this.result = result;
  }
}

class Taut {
  constructor(module) {
    this.module = module;
    this.version = module.UTF8ToString(module._taut_version());
    this.buildInfo = module.UTF8ToString(module._taut_build_info());
  }

  get scenes() { return this.#names(0); }
  get fabrics() { return this.#names(1); }
  get memoryBytes() { return this.module.HEAPU8.length; }
  cloth(options) { return new Cloth(this.module, options); }

  /** Returns what draws cloth on a canvas with the program's renderer, by WebGL 2. */
  stage(canvas) {
    const context = this.module.GL.createContext(canvas, { majorVersion: 2, alpha: false, antialias: false, depth: false });
    if (!context) throw new TautError(7, 'this browser draws no WebGL 2');
    this.module.GL.makeContextCurrent(context);
    const stage = this.module._taut_page_stage();
    if (!stage) throw new TautError(7, 'this browser cannot draw the cloth');
    return stage;
  }

  #names(kind) {
    return lent(this.module, (memory) => {
      const size = memory.take(4);
      this.module._taut_list(kind, 0, 0, size);
      const text = memory.take(memory.view.getUint32(size, true));
      this.module._taut_list(kind, text, memory.view.getUint32(size, true), size);
      return this.module.UTF8ToString(text).trim().split('\n');
    });
  }
}

/** Memory of the engine for the time of one call. */
class Lent {
  constructor(module) {
    this.module = module;
    this.taken = [];
  }
  take(bytes) {
    const at = this.module._malloc(Math.max(bytes, 8));
    if (at === 0) throw new TautError(7, 'out of memory');
    this.taken.push(at);
    this.module.HEAPU8.fill(0, at, at + Math.max(bytes, 8));
    return at;
  }
  // Memory grows, and what was a view of it before is none any more.
  get view() { return new DataView(this.module.HEAPU8.buffer); }
  set(at, value) { this.view.setUint32(at, value, true); }
  struct(bytes, members = {}) {
    const at = this.take(bytes);
    this.set(at, bytes);
    for (const [place, value] of Object.entries(members)) this.set(at + Number(place), value);
    return at;
  }
  array(array) {
    const at = this.take(array.byteLength);
    this.module.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
    return at;
  }
  text(text) { return this.array(new TextEncoder().encode(`${text}\0`)); }
  texts(texts) { return this.array(Uint32Array.from(texts, (text) => this.text(text))); }
  points(array) {
    const points = array instanceof Float32Array || array instanceof Float64Array ? array : Float64Array.from(array);
    const data = this.array(points);
    return this.array(Uint32Array.of(data, points.length / 3, 3 * points.BYTES_PER_ELEMENT,
      points instanceof Float64Array ? 1 : 0));
  }
  mesh(positions, triangles) {
    const points = this.points(positions);
    const mesh = this.struct(36, { 20: this.array(Uint32Array.from(triangles)), 24: triangles.length });
    this.module.HEAPU8.copyWithin(mesh + 4, points, points + 16);
    return mesh;
  }
  free() { for (const at of this.taken) this.module._free(at); }
}

function lent(module, work) {
  const memory = new Lent(module);
  try {
    return work(memory);
  } finally {
    memory.free();
  }
}

const settingText = ([key, value]) => `${key} = ${Array.isArray(value) ? JSON.stringify(value) : value}`;

export class Cloth {
  #module;
  #id = 0n;

  constructor(module, { scene, text, positions, triangles, start, settings = {}, log } = {}) {
    if ([scene, text, positions].filter((given) => given !== undefined).length !== 1) {
      throw new TautError(3, 'expected exactly one of scene, text and positions');
    }
    this.#module = module;
    const listener = log ? module.addFunction((_user, line) => log(module.UTF8ToString(line)), 'vii') : 0;
    lent(module, (memory) => {
      const lines = Object.entries(settings).map(settingText);
      const options = memory.struct(56, {
        8: scene === undefined ? 0 : memory.text(scene), 12: text === undefined ? 0 : memory.text(text),
        16: positions ? memory.mesh(positions, triangles) : 0, 20: start ? memory.points(start) : 0,
        24: memory.texts(lines), 28: lines.length, 36: listener, 4: 1,
      });
      const cloth = memory.take(8);
      const error = memory.struct(1024);
      const result = module._taut_create(options, cloth, error);
      if (result !== 0) throw new TautError(result, module.UTF8ToString(error + 8));
      this.#id = memory.view.getBigUint64(cloth, true);
    });
    this.info = this.#readInfo();
  }

  #call(name, ...values) {
    const result = this.#module[`_taut_${name}`](this.#id, ...values);
    if (result !== 0) throw new TautError(result, this.#module.UTF8ToString(this.#module._taut_last_error(this.#id)));
  }

  #readInfo() {
    return lent(this.#module, (memory) => {
      const at = memory.struct(56);
      this.#call('get_info', at);
      const { view } = memory;
      const count = (place) => view.getUint32(at + place, true);
      return { frame: count(4), time_s: view.getFloat64(at + 8, true), frame_rate_hz: view.getFloat64(at + 16, true),
        max_stretch: view.getFloat64(at + 24, true), vertex_count: count(32), triangle_count: count(36),
        edge_count: count(40), pin_count: count(44), body_count: count(48), crossings_at_start: count(52) };
    });
  }

  step() {
    return lent(this.#module, (memory) => {
      const at = memory.struct(104);
      this.#call('step', at);
      const { view } = memory;
      const real = (place) => view.getFloat64(at + place, true);
      const whole = (place) => view.getInt32(at + place, true);
      return { frame: whole(4), time_s: real(8), max_edge_stretch: real(16), max_surface_stretch: real(24),
        smallest_distance_m: real(32), state_hash: hex(view.getBigUint64(at + 48, true)), substeps: whole(56),
        is_bound_kept: whole(60) === 1, is_contact_kept: whole(64) === 1, is_asleep: whole(68) === 1,
        measured_crossings: Number(view.getBigUint64(at + 72, true)), left_out_share: real(80),
        wind_force_n: real(88), wind_power_w: real(96) };
    });
  }

  set(key, value) {
    lent(this.#module, (memory) => this.#call('set', memory.text(key), memory.text(value)));
  }
  setWind(x, y, z) { this.#call('set_wind', x, y, z); }
  setGravity(x, y, z) { this.#call('set_gravity', x, y, z); }
  setForces(vertices, forces) { this.#at('set_forces', vertices, forces); }
  movePins(vertices, targets) { this.#at('move_pins', vertices, targets); }
  #at(name, vertices, points) {
    lent(this.#module, (memory) =>
      this.#call(name, memory.array(Uint32Array.from(vertices)), memory.points(points)));
  }

  get pins() {
    const count = this.#readInfo().pin_count;
    return this.#filled(new Uint32Array(count), (at) => this.#call('get_pins', at, count));
  }
  set pins(vertices) {
    lent(this.#module, (memory) => this.#call('set_pins', memory.array(Uint32Array.from(vertices)), vertices.length));
  }

  positions(out = new Float32Array(3 * this.info.vertex_count)) {
    return this.#points(out, (at) => this.#call('get_positions', at));
  }
  setPositions(positions) {
    lent(this.#module, (memory) => this.#call('set_positions', memory.points(positions)));
  }
  stretch() {
    const count = this.info.vertex_count;
    return this.#filled(new Float64Array(count), (at) => this.#call('get_stretch', at, count));
  }
  triangles() {
    const count = 3 * this.info.triangle_count;
    return this.#filled(new Uint32Array(count), (at) => this.#call('get_triangles', at, count));
  }

  bodyTriangles(body) {
    return lent(this.#module, (memory) => {
      const counts = memory.take(8);
      this.#call('page_body', body, 0, counts);
      const corners = new Uint32Array(memory.view.getUint32(counts, true));
      this.#filled(corners, (at) => this.#call('page_body', body, at, counts));
      return { triangles: corners, vertex_count: memory.view.getUint32(counts + 4, true) };
    });
  }
  bodyPositions(body, out) { return this.#points(out, (at) => this.#call('page_body_positions', body, at)); }

  /** How many triangles the largest T-shirt has that is in real time here, of which this cloth is one. Steps it. */
  largestShirt() { return this.#filled(new Int32Array(1), (at) => this.#call('page_shirt', at))[0]; }

  /** Has a stage draw this cloth from now on, as its scene draws it or with its stretch as colours. */
  dress(stage, isStretch) { this.#call('page_dress', stage, isStretch ? 1 : 0); }
  /** Draws it. `view`: eye and target in metres, vertical angle of view in radians. */
  draw(stage, view, width, height, level = 0) {
    lent(this.#module, (memory) =>
      this.#call('page_draw', stage, memory.array(Float32Array.from(view)), width, height, level));
  }
  /** After a picture, the level for the next one and how long to wait with it. */
  nextPicture(stage, pictureMs, lostMs) {
    const [level, restMs] = this.#filled(new Float64Array(2), (at) =>
      this.#call('page_next_picture', stage, pictureMs, lostMs, at));
    return { level, restMs };
  }
  /** The nearest vertex of the cloth that a ray meets and the point, or nothing. */
  pick(from, along) {
    const [vertex, ...point] = this.#filled(new Float64Array(4), (at) => lent(this.#module, (memory) =>
      this.#call('page_pick', memory.array(Float64Array.of(...from, ...along)), at)));
    return vertex < 0 ? null : { vertex, point };
  }

  get stateHash() {
    return hex(this.#filled(new BigUint64Array(1), (at) => this.#call('state_hash', at))[0]);
  }
  save() {
    return lent(this.#module, (memory) => {
      const size = memory.take(4);
      this.#call('save', 0, 0, size);
      const bytes = new Uint8Array(memory.view.getUint32(size, true));
      return this.#filled(bytes, (at) => this.#call('save', at, bytes.length, size));
    });
  }
  restore(bytes) {
    lent(this.#module, (memory) => this.#call('restore', memory.array(bytes), bytes.length));
  }
  close() {
    this.#module._taut_destroy(this.#id);
    this.#id = 0n;
  }

  #filled(array, fill) {
    return lent(this.#module, (memory) => {
      const at = memory.take(array.byteLength);
      fill(at);
      new Uint8Array(array.buffer, array.byteOffset, array.byteLength)
        .set(this.#module.HEAPU8.subarray(at, at + array.byteLength));
      return array;
    });
  }
  #points(out, fill) {
    return this.#filled(out, (at) => lent(this.#module, (memory) => fill(memory.array(Uint32Array.of(
      at, out.length / 3, 3 * out.BYTES_PER_ELEMENT, out instanceof Float64Array ? 1 : 0)))));
  }
}

const hex = (hash) => hash.toString(16).padStart(16, '0');
