/** Cloth that keeps a bound on its stretch and crosses nothing. Units: metres, kilograms, seconds, newtons; y is up. */

/** Loads the engine with the scenes and models that come with it. Everything is part of the package. */
export function load(): Promise<Taut>;

export interface Taut {
  readonly version: string;
  readonly buildInfo: string;
  /** Names for ClothOptions.scene. */
  readonly scenes: string[];
  /** Names for the key cloth.fabric. */
  readonly fabrics: string[];
  /** The memory that all its cloths take together. */
  readonly memoryBytes: number;
  /** Makes a cloth. Throws TautError. */
  cloth(options: ClothOptions): Cloth;
  /** What draws cloth on a canvas with the program's renderer, by WebGL 2. */
  stage(canvas: OffscreenCanvas | HTMLCanvasElement): number;
}

export type Numbers = ArrayLike<number>;
export type Setting = string | number | boolean | Setting[];

/** One of scene, text, and positions with triangles. */
export interface ClothOptions {
  /** The name of a scene that comes with Taut. */
  scene?: string;
  /** A scene as TOML. */
  text?: string;
  /** A garment at rest: three numbers a vertex, and three vertices a triangle. */
  positions?: Numbers;
  triangles?: Numbers;
  /** Where its vertices begin; otherwise as at rest. */
  start?: Numbers;
  /** Keys of scenes: { 'solver.max_stretch': 0.01, 'cloth.fabric': 'silk' }. */
  settings?: Record<string, Setting>;
  /** Told what was guessed, repaired or chosen. */
  log?: (line: string) => void;
}

/** The promises and measures of a frame: TautFrame of taut.h. */
export interface Frame {
  frame: number;
  time_s: number;
  max_edge_stretch: number;
  max_surface_stretch: number;
  /** Infinity: nothing is nearer than twice the cloth's thickness. */
  smallest_distance_m: number;
  /** 16 hexadecimal digits: of all bits of positions and velocities, the same on every machine. */
  state_hash: string;
  substeps: number;
  is_bound_kept: boolean;
  is_contact_kept: boolean;
  is_asleep: boolean;
  measured_crossings: number;
  left_out_share: number;
  /** Of the wind on the whole cloth; 0 without wind. */
  wind_force_n: number;
  /** Below 0 where air brakes the cloth. */
  wind_power_w: number;
}

export interface Info {
  frame: number;
  time_s: number;
  frame_rate_hz: number;
  max_stretch: number;
  vertex_count: number;
  triangle_count: number;
  edge_count: number;
  pin_count: number;
  body_count: number;
  crossings_at_start: number;
}

/** Every call may throw TautError and has changed nothing then. */
export class Cloth {
  private constructor();
  /** As it was made. */
  readonly info: Info;
  /** One frame on, 1/60 s unless the scene says otherwise. */
  step(): Frame;
  /** Changes a setting while the cloth moves: set('cloth.fabric', 'silk'). */
  set(key: string, value: string | number): void;
  setWind(x: number, y: number, z: number): void;
  setGravity(x: number, y: number, z: number): void;
  /** Forces in N on these vertices until the next call. */
  setForces(vertices: Numbers, forces: Numbers): void;
  /** The vertices that only movePins() moves. */
  pins: Uint32Array;
  /** Where these pins are at the end of the next frame. */
  movePins(vertices: Numbers, targets: Numbers): void;
  positions<Out extends Float32Array | Float64Array = Float32Array>(out?: Out): Out;
  setPositions(positions: Numbers): void;
  /** At each vertex the largest surface stretch of its triangles. */
  stretch(): Float64Array;
  triangles(): Uint32Array;
  /** The mesh of a body of the scene, by its number. */
  bodyTriangles(body: number): { triangles: Uint32Array; vertex_count: number };
  /** Where that is at the end of the last frame; `out` has three numbers a vertex. */
  bodyPositions<Out extends Float32Array | Float64Array>(body: number, out: Out): Out;
  /** Has a stage draw this cloth from now on, as its scene draws it or with its stretch as colours. */
  dress(stage: number, isStretch: boolean): void;
  /** Draws it. `view`: eye and target in metres and the vertical angle of view in radians; sizes in pixels; `level`: 0, the
   *  best, to 5, which takes a third of the time. */
  draw(stage: number, view: Numbers, width: number, height: number, level?: number): void;
  /** Chooses the best level for 30 pictures a second, from the time of each picture and the simulated time that was given up
   *  meanwhile, and how long to wait before the next one so that the cloth does not fall behind. */
  nextPicture(stage: number, pictureMs: number, lostMs: number): { level: number; restMs: number };
  /** Steps a T-shirt 36 times. How many triangles the largest T-shirt has that takes half of real time. */
  largestShirt(): number;
  /** The point of the cloth that a ray meets and its nearest vertex; null if a body is in front or nothing is met. */
  pick(from: Numbers, along: Numbers): { vertex: number; point: number[] } | null;
  readonly stateHash: string;
  /** All that is needed to go on with the same bits. */
  save(): Uint8Array;
  restore(bytes: Uint8Array): void;
  /** Ends the cloth; every later call throws. */
  close(): void;
}

export class TautError extends Error {
  /** The number of the result in taut.h. */
  readonly result: number;
}
