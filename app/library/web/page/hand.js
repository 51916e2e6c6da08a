// A hand that holds some square centimetres of cloth, as the program's window has it: springs, damped critically for
// the vertices they hold, of a limited force, and a hand no faster than an arm.
const REACH_M = 0.045, SWING_RAD_PER_S = 60, STRENGTH = 5, ARM_M_PER_S = 4, FRAME_S = 1 / 60;
const DENSITY_KG_PER_M2 = 0.15;

export class Hand {
  constructor(rest, triangles) {
    this.triangles = triangles;
    this.masses = new Float64Array(rest.length / 3);
    this.neighbours = Array.from(this.masses, () => new Set());
    this.velocities = new Float64Array(rest.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const corners = triangles.subarray(t, t + 3);
      const mass = DENSITY_KG_PER_M2 * area(rest, corners) / 3;
      for (const vertex of corners) {
        this.masses[vertex] += mass;
        for (const other of corners) this.neighbours[vertex].add(other);
      }
    }
    this.mass = this.masses.reduce((sum, mass) => sum + mass, 0);
    this.rest = rest;
  }

  hold(vertex, point, positions) {
    const held = new Set([vertex]);
    for (const at of held) {
      for (const next of this.neighbours[at]) if (distance(this.rest, next, vertex) < REACH_M) held.add(next);
    }
    const weights = [...held].map((at) => 1 - distance(this.rest, at, vertex) / REACH_M);
    const sum = weights.reduce((total, weight) => total + weight, 0);
    this.held = [...held].map((at, k) => ({ vertex: at, share: weights[k] / sum,
      offset: [0, 1, 2].map((axis) => positions[3 * at + axis] - point[axis]) }));
    this.at = point;
    this.target = point;
  }

  release() { this.held = null; }

  moved(from, to) {
    for (let k = 0; k < to.length; ++k) this.velocities[k] = (to[k] - from[k]) / FRAME_S;
  }

  /** The forces on what is held, or nothing. */
  pull(positions) {
    if (!this.held) return null;
    const way = this.target.map((value, axis) => value - this.at[axis]);
    const part = Math.min(1, ARM_M_PER_S * FRAME_S / (Math.hypot(...way) || 1));
    this.at = this.at.map((value, axis) => value + part * way[axis]);
    const forces = this.held.flatMap(({ vertex, share, offset }) => {
      const mass = this.masses[vertex], k = this.mass * SWING_RAD_PER_S ** 2 * share, c = 2 * Math.sqrt(k * mass);
      const force = offset.map((off, axis) => {
        const v = this.velocities[3 * vertex + axis];
        return (k * (this.at[axis] + off - positions[3 * vertex + axis] - FRAME_S * v) - c * v) /
          (1 + FRAME_S * (c + FRAME_S * k) / mass);
      });
      const size = Math.hypot(...force), most = STRENGTH * this.mass * 9.81 * share;
      return size > most ? force.map((value) => value * most / size) : force;
    });
    return { vertices: this.held.map(({ vertex }) => vertex), forces };
  }
}

const distance = (p, a, b) => Math.hypot(p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]);

function area(p, [a, b, c]) {
  const [u, v, w] = [distance(p, a, b), distance(p, b, c), distance(p, c, a)];
  const s = (u + v + w) / 2;
  return Math.sqrt(Math.max(s * (s - u) * (s - v) * (s - w), 0));
}
