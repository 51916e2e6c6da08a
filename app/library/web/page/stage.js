// The picture: cloth with its own smooth normals and a sheen, who wears it, and their shadow on the ground.
import * as THREE from 'three';

// What of a scene is always in sight, `size` metres wide and high about the target.
const VIEWS = { hang: { target: [0, 1.31, 0], size: [1.05, 0.95], azimuth: 0.62, elevation: 0.2, ground: 0.72 },
  walk: { target: [0, 0.93, 0], size: [0.9, 1.87], azimuth: 0.5, elevation: 0.12, ground: 0 },
  flag: { target: [0.48, 2.0, 0], size: [1.35, 1.25], azimuth: 0.35, elevation: 0.04, ground: 0 },
  line: { target: [0, 1.5, 0], size: [3.3, 2.5], azimuth: 0.4, elevation: 0.08, ground: 0 } };
const VIEW_DEGREES = 26, MARGIN_PX = 20, PANEL_PX = 344, PANEL_PART = 0.46, NARROW_PX = 760;  // the latter as in style.css
// Shadows are looked up a little off the cloth, on the side of the light: it would shade itself in stripes.
const OFF_CLOTH_M = 0.007;
// The inside is seen where both the triangle and the smooth normal face away: by one of them it is jagged at folds.
const SIDE = 'float side = !gl_FrontFacing && dot(vNormal, vViewPosition) < 0.0 ? -1.0 : 1.0;';
const COLOUR_OF_SIDE = 'if (side < 0.0) diffuseColor.rgb *= inside;';

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    Object.assign(this.renderer, { gammaOutput: true, gammaFactor: 2.2, physicallyCorrectLights: true,
      toneMapping: THREE.ACESFilmicToneMapping, toneMappingExposure: 1.0 });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(VIEW_DEGREES, 1, 0.1, 60);
    this.inside = { value: new THREE.Color(1, 1, 1) };
    this.#addLights();
    this.ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(12, 12), new THREE.ShadowMaterial({ opacity: 0.26 }));
    this.ground.rotation.x = -Math.PI / 2;
    this.ground.receiveShadow = true;
    this.cloth = this.#mesh(this.#clothMaterial());
    this.body = this.#mesh(new THREE.MeshStandardMaterial({ color: '#cfc8be', roughness: 0.72 }));
    this.scene.add(this.ground);
    this.ray = new THREE.Raycaster();
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.#resize();
  }

  #addLights() {
    const light = (colour, strength, x, y, z) => {
      const lamp = new THREE.DirectionalLight(colour, strength);
      lamp.position.set(x, y, z);
      this.scene.add(lamp, lamp.target);
      return lamp;
    };
    this.scene.add(new THREE.HemisphereLight('#f4f7ff', '#8d8175', 1.15));
    light('#e6eeff', 0.5, -2.5, 1.2, 2.5);
    light('#ffffff', 1.6, -1.6, 2.4, -2.6);
    this.key = light('#fff1de', 4.4, 2.6, 3.4, 1.5);
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(2048, 2048);
    this.key.shadow.bias = -0.0008;
    this.key.shadow.radius = 2.5;
  }

  // The sheen of three.js stands in for the highlight: light of the fibres that stand off the cloth.
  #clothMaterial() {
    const material = new THREE.MeshPhysicalMaterial({ color: '#3f6fa8', roughness: 0.6, side: THREE.DoubleSide,
      sheen: new THREE.Color(0.1, 0.1, 0.1), shadowSide: THREE.DoubleSide });
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, { inside: this.inside, keyPlace: { value: this.key.position } });
      shader.vertexShader = `uniform vec3 keyPlace;\n${shader.vertexShader.replace('#include <shadowmap_vertex>',
        `vec3 away = objectNormal * sign(dot(objectNormal, keyPlace - worldPosition.xyz));
        worldPosition.xyz += ${OFF_CLOTH_M} * away;
        #include <shadowmap_vertex>`)}`;
      const { fragmentShader } = shader;
      shader.fragmentShader = `uniform vec3 inside;\n${fragmentShader
        .replace('#include <color_fragment>', `#include <color_fragment>\n${SIDE}\n${COLOUR_OF_SIDE}`)
        .replace('#include <normal_fragment_begin>', `vec3 normal = side * normalize(vNormal);
          vec3 geometryNormal = normal;`)}`;
    };
    return material;
  }

  #mesh(material) {
    const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
    Object.assign(mesh, { castShadow: true, receiveShadow: true, frustumCulled: false, visible: false });
    this.scene.add(mesh);
    return mesh;
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    if (!this.eye) return;
    this.#fit();
    this.draw();  // what has been resized is empty
  }

  // The middle of the picture is that of the part that the panel and the headline leave, and the scene fills this part.
  #fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas, isNarrow = width <= NARROW_PX;
    const beside = isNarrow ? 0 : PANEL_PX, below = isNarrow ? PANEL_PART * height : 0;
    const above = document.querySelector('header').getBoundingClientRect().bottom;
    this.camera.setViewOffset(width, height, beside / 2, (below - above) / 2, width, height);
    const free = [width - beside - 2 * MARGIN_PX, height - below - above - 2 * MARGIN_PX];
    const metresOfPixel = Math.max(...this.eye.size.map((size, k) => size / Math.max(free[k], 1)));
    this.distance = metresOfPixel * height / (2 * Math.tan(THREE.Math.degToRad(VIEW_DEGREES / 2)));
  }

  view(scene) {
    this.eye = { ...VIEWS[scene], zoom: 1, target: new THREE.Vector3(...VIEWS[scene].target) };
    this.ground.position.y = this.eye.ground;
    const { key } = this, height = 0.5 * (2.0 - this.eye.ground);
    key.target.position.set(0, this.eye.ground + height, 0);
    key.position.set(2.6, 3.4, 1.5).add(key.target.position);
    const reach = height + 0.35;
    Object.assign(key.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 2.5, far: 7 });
    key.shadow.camera.updateProjectionMatrix();
    this.#fit();
  }
  turn(x, y) {
    this.eye.azimuth -= x;
    this.eye.elevation = Math.min(1.3, Math.max(-0.1, this.eye.elevation + y));
  }
  zoom(factor) { this.eye.zoom = Math.min(2.4, Math.max(0.24, this.eye.zoom * factor)); }

  /** Colours of a fabric. */
  dress({ outside, inside, roughness, sheen }) {
    const { material } = this.cloth;
    this.colour = new THREE.Color(outside).convertGammaToLinear(2.2);
    material.roughness = Math.min(1, 0.25 + 0.6 * roughness);
    const fibres = this.colour.clone().lerp(new THREE.Color(1, 1, 1), 0.35).multiplyScalar(0.25 + 0.55 * sheen);
    material.sheen.copy(fibres);
    const within = new THREE.Color(inside ?? outside).convertGammaToLinear(2.2);
    this.ownInside = ['r', 'g', 'b'].map((c) => within[c] * 0.85 / Math.max(this.colour[c], 1e-3));
    this.colourBy(this.bound);
  }

  /** Draws stretch as colours, from none to the bound; with none the fabric. */
  colourBy(bound) {
    this.bound = bound;
    const { material } = this.cloth;
    material.vertexColors = bound ? THREE.VertexColors : THREE.NoColors;
    material.color.copy(bound ? new THREE.Color(1, 1, 1) : this.colour);
    this.inside.value.setRGB(...(bound ? [0.8, 0.8, 0.8] : this.ownInside));
    material.needsUpdate = true;
  }

  begin(triangles, body) {
    for (const [mesh, corners] of [[this.cloth, triangles], [this.body, body]]) {
      mesh.geometry.dispose();
      mesh.geometry = new THREE.BufferGeometry();
      mesh.visible = Boolean(corners);
      if (corners) mesh.geometry.setIndex(new THREE.BufferAttribute(corners, 1));
    }
  }

  show(shape, body) {
    this.#put(this.cloth.geometry, 'position', shape.positions);
    this.#put(this.cloth.geometry, 'normal', shape.normals);
    if (this.bound && shape.stretch) this.#put(this.cloth.geometry, 'color', stretchColours(shape.stretch, this.bound));
    if (body) {
      this.#put(this.body.geometry, 'position', body.positions);
      this.#put(this.body.geometry, 'normal', body.normals);
    }
  }

  #put(geometry, name, array) {
    const attribute = geometry.getAttribute(name);
    if (attribute) {
      attribute.array.set(array);
      attribute.needsUpdate = true;
    } else {
      geometry.setAttribute(name, new THREE.BufferAttribute(array, 3).setUsage(THREE.DynamicDrawUsage));
    }
  }

  draw() {
    const { azimuth, elevation, target } = this.eye, away = this.distance * this.eye.zoom;
    this.camera.position.set(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation),
      Math.cos(azimuth) * Math.cos(elevation)).multiplyScalar(away).add(target);
    this.camera.lookAt(target);
    this.renderer.render(this.scene, this.camera);
  }

  #look(x, y) {
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new THREE.Vector2(2 * (x - left) / width - 1, 1 - 2 * (y - top) / height), this.camera);
    return this.ray.ray;
  }

  /** The cloth that is seen there: its nearest vertex and the point, or nothing. */
  grip(x, y) {
    this.#look(x, y);
    const { geometry } = this.cloth;
    geometry.computeBoundingSphere();
    const [hit] = this.ray.intersectObject(this.cloth);
    const [front] = this.body.visible ? this.#hits(this.body) : [];
    if (!hit || (front && front.distance < hit.distance)) return null;
    const positions = geometry.getAttribute('position');
    const distance = (v) => new THREE.Vector3().fromBufferAttribute(positions, v).distanceTo(hit.point);
    const { a, b, c } = hit.face;
    const vertex = [a, b, c].reduce((best, v) => (distance(v) < distance(best) ? v : best));
    // The hand moves in the plane that faces the eye.
    this.plane = new THREE.Plane().setFromNormalAndCoplanarPoint(
      this.camera.getWorldDirection(new THREE.Vector3()), hit.point);
    return { vertex, point: hit.point.toArray() };
  }
  #hits(mesh) {
    mesh.geometry.computeBoundingSphere();
    return this.ray.intersectObject(mesh);
  }
  /** Where the hand is that holds cloth. */
  handAt(x, y) {
    const at = this.#look(x, y).intersectPlane(this.plane, new THREE.Vector3());
    return at && at.toArray();
  }
}

// The colours of the program's pictures (viridis: van der Walt and Smith 2015, CC0), from no stretch to the bound.
export const STRETCH_COLOURS = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b',
                                '#fde725'];
const STEPS = STRETCH_COLOURS.map((colour) => new THREE.Color(colour).convertGammaToLinear(2.2).toArray());

function stretchColours(stretch, bound) {
  const colours = new Float32Array(3 * stretch.length);
  stretch.forEach((value, v) => {
    const at = Math.min(Math.max(value / bound, 0), 1) * (STEPS.length - 1);
    const k = Math.min(Math.floor(at), STEPS.length - 2);
    for (let c = 0; c < 3; ++c) colours[3 * v + c] = STEPS[k][c] + (at - k) * (STEPS[k + 1][c] - STEPS[k][c]);
  });
  return colours;
}
