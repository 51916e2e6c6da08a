// The simulation and its picture, on a thread of their own: a frame each time the page asks for one.
import { load } from '../package/index.js';
import { Hand } from './hand.js';

const loading = load();
let taut, run, cloth, hand, wind, before, canvas, stage, look, isStretch = false, isDrawn = true;

const SCENES = { hang: 'tshirt-gravity', walk: 'tshirt-walk', flag: 'flag', line: 'washing-line' };
const GUSTS = { 'wind.gust_amplitude': 0.5, 'wind.gust_period': 2, 'wind.gust_turn': 0.2 };

// The T-shirts of the page, and how many times as long as the smallest's a frame takes in a wind of 10 m/s.
const TIMES = [[10600, 21], [5280, 7.4], [2640, 2.6], [1028, 1]];
// Frames until the cloth flutters, and frames that are timed from there on.
const FRAMES_BEFORE = 12, FRAMES_TIMED = 24;

// Largest time of a frame there, as a fraction of real time: in 20 m/s it takes 2.3 times as long.
const MOST_TIME = 0.5;

// Answers with the largest T-shirt that is in real time in the wind for which the slider is made.
function measure() {
  const smallest = taut.cloth({ scene: SCENES.hang,
    settings: { 'garment.file': 'tshirt_1028', ...GUSTS, 'wind.speed': 10, 'wind.direction': [0.3, 0, 1] } });
  for (let frame = 0; frame < FRAMES_BEFORE; ++frame) smallest.step();
  const began = performance.now();
  for (let frame = 0; frame < FRAMES_TIMED; ++frame) smallest.step();
  const ms = (performance.now() - began) / FRAMES_TIMED;
  smallest.close();
  const [size] = TIMES.find(([, times]) => times * ms < MOST_TIME * 1000 / 60) ?? TIMES.at(-1);
  self.postMessage({ is: 'measured', run: 0, size });
}

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
  measure, start, step,
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
const OF_NO_CLOTH = ['measure', 'start', 'canvas', 'look', 'colour'];

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
