// The simulation and its picture, on a thread of their own: a frame each time the page asks for one.
import { load } from '../package/index.js';
import { Hand } from './hand.js';

const loading = load();
let taut, run, cloth, hand, wind, before, canvas, stage, look, isStretch = false, isDrawn = true;

const SCENES = { hang: 'tshirt-gravity', walk: 'tshirt-walk', flag: 'flag', line: 'washing-line' };
const GUSTS = { 'wind.gust_amplitude': 0.5, 'wind.gust_period': 2, 'wind.gust_turn': 0.2 };

// Only shapes of these settings are computed by the program too, for the page to compare. Scenes without a size have their
// own garment and gusts.
function start({ scene, size, wind: air, settings }) {
  cloth?.close();
  cloth = undefined;
  cloth = taut.cloth({ scene: SCENES[scene], settings: { ...(size ? { 'garment.file': `tshirt_${size}`, ...GUSTS } : {}),
    'wind.speed': air.speed, 'wind.direction': air.direction, ...settings } });
  stage ??= taut.stage(canvas);
  dress();
  before = cloth.positions();
  hand = new Hand(before, cloth.triangles());
  wind = null;
  self.postMessage({ is: 'started', run, info: cloth.info, fabrics: taut.fabrics, build: taut.buildInfo });
}

function dress() {
  cloth.dress(stage, isStretch);
  isDrawn = false;
}

function step() {
  if (wind) cloth.setWind(...wind);
  wind = null;
  const began = performance.now();
  const pull = hand.pull(before);
  if (pull) cloth.setForces(pull.vertices, pull.forces);
  const frame = cloth.step();
  const ms = performance.now() - began;
  const positions = cloth.positions();
  hand.moved(before, positions);
  before = positions;
  isDrawn = false;
  self.postMessage({ is: 'frame', run, frame, ms, memory: taut.memoryBytes });
}

// What the screen shows last is drawn, however many frames are made.
function onPicture() {
  requestAnimationFrame(onPicture);
  if (isDrawn || !look || !cloth || !stage) return;
  isDrawn = true;
  if (canvas.width !== look.width || canvas.height !== look.height) Object.assign(canvas, { width: look.width, height: look.height });
  answer({ do: 'draw' });
}

const answers = {
  start, step,
  canvas(data) {
    canvas = data.canvas;
    requestAnimationFrame(onPicture);
  },
  look(data) {
    look = data.look;
    isDrawn = false;
  },
  draw() { cloth.draw(stage, look.view, look.width, look.height); },
  wind({ velocity }) { wind = velocity; },
  set({ key, value }) {
    cloth.set(key, value);
    dress();
  },
  colour(data) {
    isStretch = data.isStretch;
    if (cloth) dress();
  },
  grip({ from, along }) {
    const grip = cloth.pick(from, along);
    if (grip) hand.hold(grip.vertex, grip.point, before);
    self.postMessage({ is: 'gripped', run, point: grip?.point });
  },
  drag({ point }) { hand.target = point; },
  release() {
    hand.release();
    cloth.setForces([], []);
  },
};
const OF_NO_CLOTH = ['start', 'canvas', 'look', 'colour'];

function answer(data) {
  try {
    if (OF_NO_CLOTH.includes(data.do) || cloth) answers[data.do](data);
  } catch (error) {
    // The cloth is as it was before the frame: without the hand it can go on.
    self.postMessage({ is: 'failed', run, text: error.message, at: data.do });
  }
}

self.onmessage = async ({ data }) => {
  if (data.do !== 'canvas' && data.do !== 'look') taut = await loading;
  run = data.run ?? run;
  answer(data);
};
