// The simulation and its picture, on a thread of their own.
import { load } from '../package/index.js';
import { Hand } from './hand.js';

const loading = load();
let taut, run, cloth, hand, wind, before, canvas, stage, look, isStretch = false, isDrawn = true, isAsleep = false, isShown = true;

const SCENES = { hang: 'tshirt-gravity', walk: 'tshirt-walk', flag: 'flag', line: 'washing-line' };
const GUSTS = { 'wind.gust_amplitude': 0.5, 'wind.gust_period': 2, 'wind.gust_turn': 0.2 };

// Answers with the largest T-shirt that is in real time in the wind for which the slider is made.
function measure() {
  const smallest = taut.cloth({ scene: SCENES.hang,
    settings: { 'garment.file': 'tshirt_1028', ...GUSTS, 'wind.speed': 10, 'wind.direction': [0.3, 0, 1] } });
  self.postMessage({ is: 'measured', run: 0, size: smallest.largestShirt() });
  smallest.close();
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
  if (!due) setTimeout(onDue);
  due = performance.now();
  self.postMessage({ is: 'started', run, info: cloth.info, fabrics: taut.fabrics, build: taut.buildInfo });
}

function dress() {
  cloth.dress(stage, isStretch);
  isDrawn = false;
}

// A frame each 1/60 s, however often the screen wants a picture. What is more than some frames late is given up; if
// simulating takes less, drawing needs the processors. A message comes sooner than a timer, which waits 4 ms.
const FRAME_MS = 1000 / 60, MAX_LATE_MS = 8 * FRAME_MS, FAILED_MS = 500;
const late = new MessageChannel();
let due = 0, stepMs = 0;
late.port1.onmessage = onDue;
function onDue() {
  const now = performance.now();
  if (now - due > MAX_LATE_MS) {
    if (stepMs < FRAME_MS) lostMs += now - due - MAX_LATE_MS;
    due = now - MAX_LATE_MS;
  }
  due += FRAME_MS;
  if (isShown) answer({ do: 'step' });
  const waitMs = due - performance.now();
  if (waitMs > 0) setTimeout(onDue, waitMs);
  else late.port2.postMessage(null);
}

function step() {
  if (wind) cloth.setWind(...wind);
  wind = null;
  const began = performance.now();
  const pull = hand.pull(before);
  if (pull) cloth.setForces(pull.vertices, pull.forces);
  const frame = cloth.step();
  const ms = stepMs = performance.now() - began;
  const positions = cloth.positions();
  hand.moved(before, positions);
  before = positions;
  isDrawn &&= frame.is_asleep;
  isAsleep = frame.is_asleep;
  self.postMessage({ is: 'frame', run, frame, ms, memory: taut.memoryBytes });
}

// What the screen shows last is drawn, however many frames are made. Where drawing takes long, it is drawn in a quality that
// leaves time for the cloth, below the best with half of the canvas's pixels along each side. What stands still is drawn
// once more in the best.
const BEST = 0, STILL_MS = 250;
let level = BEST, drawnLevel = BEST, lostMs = 0, restsUntil = 0, lookedAt = 0, picture = null;
function onPicture(now) {
  requestAnimationFrame(onPicture);
  if (!look || !cloth || !stage || isBeingDrawn() || now < restsUntil) return;
  const isStill = isDrawn && (isAsleep || !isShown) && now > lookedAt + STILL_MS;
  if (isDrawn && !(isStill && drawnLevel > BEST)) return;
  isDrawn = true;
  drawnLevel = isStill ? BEST : level;
  const part = drawnLevel > BEST ? 0.5 : 1, size = { width: part * look.width, height: part * look.height };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  const began = performance.now(), gl = canvas.getContext('webgl2');
  answer({ do: 'draw' });
  picture = { began, gl, fence: gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0), isStill };
}

// Whether the last picture is not finished. Its time decides on the next one's quality.
function isBeingDrawn() {
  if (!picture) return false;
  const { began, gl, fence, isStill } = picture;
  if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return true;
  gl.deleteSync(fence);
  picture = null;
  if (isStill) return false;
  const now = performance.now(), next = cloth.nextPicture(stage, now - began, lostMs);
  lostMs = 0;
  level = next.level;
  restsUntil = now + next.restMs;
  return false;
}

const answers = {
  measure, start, step,
  show(data) { isShown = data.isShown; },
  canvas(data) {
    canvas = data.canvas;
    requestAnimationFrame(onPicture);
  },
  look(data) {
    look = data.look;
    lookedAt = performance.now();
    isDrawn = false;
  },
  draw() { cloth.draw(stage, look.view, canvas.width, canvas.height, drawnLevel); },
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
const OF_NO_CLOTH = ['measure', 'start', 'canvas', 'look', 'colour', 'show'];

function answer(data) {
  try {
    if (OF_NO_CLOTH.includes(data.do) || cloth) answers[data.do](data);
  } catch (error) {
    // The cloth is as it was before the frame: without the hand it can go on.
    if (data.do === 'step') due = performance.now() + FAILED_MS;
    self.postMessage({ is: 'failed', run, text: error.message, at: data.do });
  }
}

self.onmessage = async ({ data }) => {
  if (data.do !== 'canvas' && data.do !== 'look') taut = await loading;
  run = data.run ?? run;
  answer(data);
};
