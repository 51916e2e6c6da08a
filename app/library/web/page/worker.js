// The simulation, on a thread of its own: a frame each time the page asks for one.
import { load } from '../package/index.js';
import { Hand } from './hand.js';
import { addNormals } from './normals.js';

const loading = load();
let taut, run, cloth, hand, wind, body, before;

const SCENES = { hang: 'tshirt-gravity', walk: 'tshirt-walk', flag: 'flag', line: 'washing-line' };
const GUSTS = { 'wind.gust_amplitude': 0.5, 'wind.gust_period': 2, 'wind.gust_turn': 0.2 };

// Only shapes of these settings are computed by the program too, for the page to compare. Scenes without a size have their
// own garment and gusts.
function start({ scene, size, wind: air, settings }) {
  cloth?.close();
  cloth = undefined;
  cloth = taut.cloth({ scene: SCENES[scene], settings: { ...(size ? { 'garment.file': `tshirt_${size}`, ...GUSTS } : {}),
    'wind.speed': air.speed, 'wind.direction': air.direction, ...settings } });
  const triangles = cloth.triangles();
  before = cloth.positions();
  hand = new Hand(before, triangles);
  wind = null;
  body = cloth.info.body_count > 0 ? cloth.bodyTriangles(0) : null;
  self.postMessage({ is: 'started', run, info: cloth.info, triangles, shape: shape(before.slice(), triangles, true),
    body: body?.triangles, build: taut.buildInfo, bodyShape: bodyShape() });
}

function shape(positions, triangles, isColoured) {
  const normals = addNormals(positions, triangles, new Float32Array(positions.length));
  return isColoured ? { positions, normals, stretch: Float32Array.from(cloth.stretch()) } : { positions, normals };
}

function bodyShape() {
  if (!body) return undefined;
  const positions = cloth.bodyPositions(0, new Float32Array(3 * body.vertex_count));
  return { positions, normals: addNormals(positions, body.triangles, new Float32Array(positions.length)) };
}

function step({ isColoured }) {
  if (wind) cloth.setWind(...wind);
  wind = null;
  const began = performance.now();
  const pull = hand.pull(before);
  if (pull) cloth.setForces(pull.vertices, pull.forces);
  const frame = cloth.step();
  const ms = performance.now() - began;
  const positions = cloth.positions();
  hand.moved(before, positions);
  before = positions.slice();
  const made = shape(positions, hand.triangles, isColoured), around = bodyShape();
  const lent = [made, around].filter(Boolean).flatMap((arrays) => Object.values(arrays)).map((array) => array.buffer);
  self.postMessage({ is: 'frame', run, frame, ms, shape: made, bodyShape: around, memory: taut.memoryBytes }, lent);
}

const answers = {
  start, wind({ velocity }) { wind = velocity; },
  set({ key, value }) { cloth.set(key, value); },
  hold({ vertex, point }) { hand.hold(vertex, point, before); },
  drag({ point }) { hand.target = point; },
  release() {
    hand.release();
    cloth.setForces([], []);
  },
  step,
};

self.onmessage = async ({ data }) => {
  try {
    taut = await loading;
    run = data.run ?? run;
    if (data.do === 'start' || cloth) answers[data.do](data);
  } catch (error) {
    // The cloth is as it was before the frame: without the hand it can go on.
    self.postMessage({ is: 'failed', run, text: error.message, at: data.do });
  }
};
