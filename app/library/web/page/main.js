// Joins the picture, the panel and the simulation's worker.
import natives from 'generated/hashes.json';
import { Promises } from './promises.js';
import { Stage } from './stage.js';

const byId = (id) => document.getElementById(id);
const canvas = byId('stage');
window.addEventListener('error', ({ message }) => notice(message));
const stage = new Stage(canvas, (look) => worker?.postMessage({ do: 'look', look }));
const promises = new Promises();
const chosen = { scene: 'hang', size: 0 };  // until the worker has found the largest T-shirt in real time
// By scene: the usual wind in m/s, the degrees it comes from, and that direction as the program's scene has it, to the
// last bit; and whether it is of a T-shirt of any size.
const USUAL = { hang: { wind: 1, from: 17, direction: [0.3, 0, 1], isSized: true },
  walk: { wind: 1, from: 17, direction: [0.3, 0, 1], isSized: true },
  flag: { wind: 6, from: 101, direction: [1, 0, -0.2] }, line: { wind: 3, from: 14, direction: [0.25, 0, 1] } };
let worker, run = 0, isSteered = false, isReady = false, times = [];

window.addEventListener('load', () => {
  // From a file a page may not start a worker's file, but one of text.
  worker = new Worker(URL.createObjectURL(new Blob([globalThis.tautEngine], { type: 'text/javascript' })));
  // Frames may still come of the cloth before.
  worker.onmessage = ({ data }) => data.run === run && answers[data.is](data);
  const drawn = canvas.transferControlToOffscreen();
  worker.postMessage({ do: 'canvas', canvas: drawn }, [drawn]);
  worker.postMessage({ do: 'measure' });
  sayWhetherShown();
});

const isFromUsual = () => Number(byId('direction').value) === USUAL[chosen.scene].from;

function air() {
  const speed = Number(byId('wind').value), from = Number(byId('direction').value) * Math.PI / 180;
  const direction = isFromUsual() ? USUAL[chosen.scene].direction : [Math.sin(from), 0, Math.cos(from)];
  return { speed, direction };
}

function choose(key, value) {
  for (const button of byId(key).children) button.classList.toggle('chosen', button.value === value);
  chosen[key] = key === 'size' ? Number(value) : value;
}

function start() {
  if (!chosen.size) return;
  isReady = isSteered = false;
  const fabric = byId('fabric').value, bound = byId('bound').value, wind = air();
  const settings = { 'solver.max_stretch': bound, ...(fabric ? { 'cloth.fabric': fabric } : {}) };
  const isUsual = fabric === '' && bound === '0.01' && isFromUsual();
  const size = USUAL[chosen.scene].isSized ? chosen.size : 0;
  promises.begin(Number(bound), isUsual ? natives[`${chosen.scene}-${size}-${wind.speed}`] : undefined);
  notice(chosen.scene === 'walk' ? 'Dressing the mannequin …' : 'Making the cloth …');
  stage.view(chosen.scene);
  worker.postMessage({ do: 'start', run: ++run, scene: chosen.scene, size, wind, settings });
}

const answers = {
  measured({ size }) {
    if (chosen.size) return;
    choose('size', `${size}`);
    start();
  },
  started({ info, fabrics, build }) {
    if (byId('fabric').length === 1) byId('fabric').append(...fabrics.map((name) => new Option(name, name)));
    isReady = true;
    times = [];
    notice('');
    byId('build').textContent = build;
    document.body.dataset.state = `${chosen.scene}-${info.triangle_count}`;
  },
  frame(data) {
    promises.add(data.frame, isSteered);
    note(data);
  },
  // The cloth that a finger meets is held until it is lifted.
  gripped({ point }) {
    isHolding = isAsking && Boolean(point);
    isAsking = false;
    canvas.classList.toggle('holding', isHolding);
    if (isHolding) isSteered = true;
    else if (point) worker.postMessage({ do: 'release' });
    gripped = point;
  },
  failed({ text, at }) {
    notice(at === 'step' ? `This frame could not be made: ${text}` : text);
    if (at === 'step') worker.postMessage({ do: 'release' });
  },
};

function note({ ms, frame, memory }) {
  const now = performance.now();
  times.push({ now, ms });
  if (times.length > 60) times.shift();
  const rate = (times.length - 1) / (now - times[0].now) * 1000;
  const mean = times.reduce((sum, time) => sum + time.ms, 0) / times.length;
  if (frame.frame % 15 === 0) byId('speed').textContent = `${mean.toFixed(1)} ms a frame, ${rate.toFixed(0)} a second`;
  Object.assign(document.body.dataset, { ms: mean, rate, memory, frame: frame.frame, hash: frame.state_hash });
}

const sayWhetherShown = () => worker.postMessage({ do: 'show', isShown: !document.hidden });
document.addEventListener('visibilitychange', sayWhetherShown);

function steer(message) {
  if (!isReady) return;
  isSteered = true;
  worker.postMessage(message);
}

function notice(text) {
  byId('notice').textContent = text || byId('notice').textContent;
  byId('notice').classList.toggle('gone', !text);
}

// The panel.

const SIDES = ['behind', 'the right', 'the front', 'the left'];
function showWind() {
  const { speed } = air(), from = Number(byId('direction').value);
  byId('wind-value').textContent = `${speed.toFixed(1)} m/s`;
  byId('direction-value').textContent = `${SIDES[(Math.round(-from / 90) + 4) % 4]} (${from}°)`;
}
for (const id of ['wind', 'direction']) {
  byId(id).addEventListener('input', () => {
    showWind();
    const { speed, direction } = air(), length = Math.hypot(...direction);
    steer({ do: 'wind', velocity: direction.map((value) => speed * value / length) });
  });
}
for (const key of ['scene', 'size']) {
  byId(key).addEventListener('click', ({ target }) => {
    if (!target.value) return;
    choose(key, target.value);
    if (key === 'scene') {
      const { wind, from, isSized } = USUAL[chosen.scene];
      Object.assign(byId('wind'), { value: wind });
      Object.assign(byId('direction'), { value: from });
      byId('size').hidden = !isSized;
      showWind();
    }
    start();
  });
}
byId('fabric').append(new Option('own fabric', ''));
byId('fabric').addEventListener('change', start);
byId('bound').addEventListener('change', ({ target }) => {
  promises.bound = Number(target.value);
  byId('legend-end').textContent = `${100 * promises.bound} % bound`;
  steer({ do: 'set', key: 'solver.max_stretch', value: target.value });
});
byId('colours').addEventListener('change', ({ target }) => {
  worker.postMessage({ do: 'colour', isStretch: target.checked });
  byId('legend').hidden = !target.checked;
});
// The colours of the program's pictures (viridis: van der Walt and Smith 2015, CC0), from no stretch to the bound.
const STRETCH_COLOURS = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b',
                         '#fde725'];
byId('legend').querySelector('i').style.background = `linear-gradient(to right, ${STRETCH_COLOURS})`;
byId('restart').addEventListener('click', start);

// The hand: on the cloth it pulls, beside it it turns the picture; two fingers move nearer.

const fingers = new Map();
let isHolding = false, isAsking = false, gripped;
function letGo() {
  if (isHolding) steer({ do: 'release' });
  isHolding = isAsking = false;
  canvas.classList.remove('holding');
}
canvas.addEventListener('pointerdown', (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, event);
  letGo();
  isAsking = fingers.size === 1 && isReady;
  if (isAsking) worker.postMessage({ do: 'grip', ...stage.ray(event.clientX, event.clientY) });
});
canvas.addEventListener('pointermove', (event) => {
  const before = fingers.get(event.pointerId);
  if (!before) return;
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  const wide = fingers.size === 2 ? spread() : 0;
  fingers.set(event.pointerId, event);
  if (isAsking) return;
  if (isHolding) {
    steer({ do: 'drag', point: stage.handAt(event.clientX, event.clientY, gripped) });
  } else if (fingers.size === 2) {
    stage.zoom(wide / (spread() || 1));
  } else {
    stage.turn((event.clientX - before.clientX) * 0.006, (event.clientY - before.clientY) * 0.006);
  }
});
for (const end of ['pointerup', 'pointercancel']) {
  canvas.addEventListener(end, (event) => {
    fingers.delete(event.pointerId);
    letGo();
  });
}
canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  stage.zoom(Math.exp(event.deltaY * 0.001));
}, { passive: false });

stage.view(chosen.scene);
showWind();
