// The camera: how it stands to the scene, and rays through pixels. The worker draws with the program's renderer.

// What of a scene is always in sight, `size` metres wide and high about the target.
const VIEWS = { hang: { target: [0, 1.31, 0], size: [1.05, 0.95], azimuth: 0.62, elevation: 0.2 },
  walk: { target: [0, 0.93, 0], size: [0.9, 1.87], azimuth: 0.5, elevation: 0.12 },
  flag: { target: [0.48, 2.0, 0], size: [1.35, 1.25], azimuth: 0.35, elevation: 0.04 },
  line: { target: [0, 1.5, 0], size: [3.3, 2.5], azimuth: 0.4, elevation: 0.08 } };
const VIEW_RAD = 26 * Math.PI / 180, MARGIN_PX = 20, PANEL_PX = 344, PANEL_PART = 0.46, NARROW_PX = 760;  // as in style.css
// Drawn pixels per pixel of the page: the browser shrinks the canvas, which smooths outlines.
const FINENESS = 2;

const plus = (a, b, factor = 1) => a.map((value, axis) => value + factor * b[axis]);
const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);

export class Stage {
  /** `onLook` gets what the worker needs to draw each time that the camera moves. */
  constructor(canvas, onLook) {
    this.canvas = canvas;
    this.onLook = onLook;
    new ResizeObserver(() => this.#look()).observe(canvas);
  }

  view(scene) {
    this.eye = { ...VIEWS[scene], zoom: 1 };
    this.#look();
  }
  turn(x, y) {
    this.eye.azimuth -= x;
    this.eye.elevation = Math.min(1.3, Math.max(-0.1, this.eye.elevation + y));
    this.#look();
  }
  zoom(factor) {
    this.eye.zoom = Math.min(2.4, Math.max(0.24, this.eye.zoom * factor));
    this.#look();
  }

  // The middle of the picture is that of the part that the panel and the headline leave, and the scene fills this part.
  #look() {
    const { clientWidth: width, clientHeight: height } = this.canvas, isNarrow = width <= NARROW_PX;
    if (!this.eye || width * height === 0) return;
    const beside = isNarrow ? 0 : PANEL_PX, below = isNarrow ? PANEL_PART * height : 0;
    const above = document.querySelector('header').getBoundingClientRect().bottom;
    const free = [width - beside - 2 * MARGIN_PX, height - below - above - 2 * MARGIN_PX];
    const metresOfPixel = this.eye.zoom * Math.max(...this.eye.size.map((size, k) => size / Math.max(free[k], 1)));
    const { azimuth, elevation } = this.eye, [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
    this.back = [sin * Math.cos(elevation), Math.sin(elevation), cos * Math.cos(elevation)];
    this.right = [cos, 0, -sin];
    this.up = [-sin * Math.sin(elevation), Math.cos(elevation), -cos * Math.sin(elevation)];
    const aside = plus(this.eye.target, this.right, 0.5 * beside * metresOfPixel);
    const target = plus(aside, this.up, 0.5 * (above - below) * metresOfPixel);
    this.at = plus(target, this.back, metresOfPixel * height / (2 * Math.tan(VIEW_RAD / 2)));
    this.onLook({ view: [...this.at, ...target, VIEW_RAD], width: FINENESS * width, height: FINENESS * height });
  }

  /** The ray through a pixel of the page. */
  ray(x, y) {
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    const slope = 2 * Math.tan(VIEW_RAD / 2) / height;
    const across = plus(this.back.map((value) => -value), this.right, slope * (x - left - width / 2));
    return { from: this.at, along: plus(across, this.up, slope * (height / 2 - y + top)) };
  }

  /** Where the hand is that holds cloth: in the plane through this point that faces the eye. */
  handAt(x, y, point) {
    const { from, along } = this.ray(x, y);
    return plus(from, along, dot(plus(point, from, -1), this.back) / dot(along, this.back));
  }
}
