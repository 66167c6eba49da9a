// view.js — the picture: camera, light, path, machine. Draws when something has changed.

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { inverse, rotationAbout } from './kinematics.js';
import { Materials, buildMachine, uprightOf } from './machine.js';
import { nearestOnPath, toolVectors } from './path.js';

const kReach = 12; // px between a click and the path
const kWideLines = 30000; // pieces of path
const kVectors = 240; // tool vectors along the whole path, about

/** Where the eye looks from, by the axis that goes up: X of a lathe, Y of a horizontal machine. */
const kEyes = [
  { iso: [0.55, 1.6, -0.35], top: [1, 0.001, 0], front: [0, 1, 0], side: [0, 0, 1] },
  { iso: [1.3, 0.75, 1], top: [0, 1, 0.001], front: [0, 0, 1], side: [1, 0, 0] },
  { iso: [-0.9, -1.5, 1.05], top: [0, -0.001, 1], front: [0, -1, 0], side: [1, 0, 0] },
];

/** A line of some pixels is made of triangles: of a long path that would be too many to be drawn. */
function wideLine(positions, options) {
  const geometry = new LineSegmentsGeometry();
  if (positions.length > 0) geometry.setPositions(positions);
  return new LineSegments2(geometry, new LineMaterial({ vertexColors: true, ...options }));
}

function thinLine(positions, { linewidth, ...options }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ vertexColors: true, ...options }));
}

function setColors(line, colors) {
  if (line.isLineSegments2) line.geometry.setColors(colors);
  else line.geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
}

/** Shows so many of its pieces. */
function setCount(line, count) {
  if (line.isLineSegments2) line.geometry.instanceCount = count;
  else line.geometry.setDrawRange(0, 2 * count);
}

export class View {
  /** Throws if the browser has no WebGL. */
  constructor(canvas, run, chain, timeline, path) {
    this.canvas = canvas;
    this.run = run;
    this.timeline = timeline;
    this.path = path;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(32, 1, 1, 1e5);
    this.upright = uprightOf(run, chain);
    this.towardsTool = new THREE.Vector3(...chain.toolDirection);
    this.camera.up.set(...this.upright);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    this.materials = new Materials();
    this.machine = buildMachine(run, chain, path, this.materials);
    this.size = this.machine.size;
    this.world = new THREE.Group(); // what a view that stands with the workpiece turns back
    this.world.matrixAutoUpdate = false;
    this.world.add(this.machine.root);
    this.scene.add(this.world);
    this.#addLight();
    this.#addPath();
    this.#addVector();
    this.isWorkpieceFixed = false;
    this.toolOffset = undefined;
    this.isStale = true;
    this.recolor();
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    this.#resize();
  }

  invalidate() {
    this.isStale = true;
  }

  /** Colours of the theme, from the style sheet. */
  recolor() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(`--${name}`).trim();
    this.scene.background = new THREE.Color(color('scene'));
    this.materials.recolor({
      table: color('scene-table'),
      joint: color('scene-joint'),
      head: color('scene-head'),
      tool: color('scene-tool'),
      stock: color('scene-stock'),
    });
    this.vector.setColor(new THREE.Color(color('accent')));
    this.fan.material.color.set(color('accent'));
    this.tip.material.color.set(color('accent'));
    this.#colorPath();
    this.invalidate();
  }

  /** `block`: every block differs from its neighbours; `kind`: rapid and feed. */
  colorBy(what) {
    this.coloring = what;
    this.#colorPath();
    this.invalidate();
  }

  showVectors(isShown) {
    this.fan.visible = isShown;
    this.invalidate();
  }

  fixWorkpiece(isFixed) {
    this.isWorkpieceFixed = isFixed;
    if (this.state) this.pose(this.state, this.index, this.tool);
  }

  /** `state` as forward() gives it, `index` of the sample, `tool` that hangs at the spindle. */
  pose(state, index, tool) {
    Object.assign(this, { state, index, tool });
    if (tool !== this.toolOffset) this.machine.setTool(tool);
    this.toolOffset = tool;
    this.machine.pose(state, rotationAbout);
    const map = this.isWorkpieceFixed ? inverse(state.table) : { r: [1, 0, 0, 0, 1, 0, 0, 0, 1], t: [0, 0, 0] };
    const { r, t } = map;
    this.world.matrix.set(r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2], 0, 0, 0, 1);
    this.tip.position.set(...state.tip);
    this.vector.position.set(...state.tip);
    this.vector.setDirection(new THREE.Vector3(...state.tool));
    setCount(this.done, index);
    this.done.visible = index > 0;
    this.invalidate();
  }

  look(from) {
    const eyes = kEyes[this.upright.indexOf(1)];
    const { lower, upper } = this.path;
    const hasPath = this.path.count > 0;
    const middle = hasPath
      ? new THREE.Vector3(...lower).add(new THREE.Vector3(...upper)).multiplyScalar(0.5)
      : new THREE.Vector3();
    // Where the tool comes from there is more to see.
    if (!this.run.machine.lathe) middle.addScaledVector(this.towardsTool, this.machine.extent * this.machine.rise);
    const distance = this.machine.extent / Math.tan((this.camera.fov * Math.PI) / 360) / Math.min(1, this.camera.aspect);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(new THREE.Vector3(...eyes[from]).normalize().multiplyScalar(distance));
    this.camera.near = distance / 100;
    this.camera.far = distance * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.invalidate();
  }

  /** A point of the workpiece as [x, y] in px of the canvas; nothing if it is behind the eye. */
  project(point) {
    return this.#projector()(point);
  }

  /** The time at which the tip was nearest to a place of the canvas; nothing: it is not on the path. */
  timeAt(x, y) {
    const found = nearestOnPath(this.path, this.#projector(), x, y, kReach);
    if (!found) return undefined;
    const { time } = this.run.samples;
    return time[found.index] + found.share * (time[found.index + 1] - time[found.index]);
  }

  draw() {
    if (!this.isStale) return;
    this.isStale = false;
    this.renderer.render(this.scene, this.camera);
  }

  #projector() {
    this.world.updateMatrixWorld(true);
    this.camera.updateMatrixWorld(true);
    const matrix = new THREE.Matrix4()
      .multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse)
      .multiply(this.machine.workpiece.matrixWorld);
    const e = matrix.elements;
    const { clientWidth, clientHeight } = this.canvas;
    return ([x, y, z]) => {
      const w = e[3] * x + e[7] * y + e[11] * z + e[15];
      if (w <= 0) return undefined;
      const right = (e[0] * x + e[4] * y + e[8] * z + e[12]) / w;
      const up = (e[1] * x + e[5] * y + e[9] * z + e[13]) / w;
      return [((right + 1) / 2) * clientWidth, ((1 - up) / 2) * clientHeight];
    };
  }

  #addLight() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8899aa, 1.7));
    const sun = new THREE.DirectionalLight(0xffffff, 1.9);
    sun.position.set(-0.6, -1, 1.6);
    this.scene.add(sun);
  }

  #addPath() {
    const { points, count } = this.path;
    const segments = Math.max(count - 1, 0);
    const positions = new Float32Array(6 * segments);
    for (let i = 0; i < segments; i++) positions.set(points.subarray(3 * i, 3 * i + 6), 6 * i);
    const line = (options) => {
      const body = segments > kWideLines ? thinLine(positions, options) : wideLine(positions, options);
      body.frustumCulled = false;
      body.visible = segments > 0;
      this.machine.workpiece.add(body);
      return body;
    };
    this.whole = line({ linewidth: 1.4, transparent: true, opacity: 0.45 });
    this.done = line({ linewidth: 2.6 });
    this.done.renderOrder = 1;
    this.coloring = 'block';
  }

  #colorPath() {
    const segments = Math.max(this.path.count - 1, 0);
    if (segments === 0) return;
    const style = getComputedStyle(document.documentElement);
    const read = (name) => new THREE.Color(style.getPropertyValue(`--${name}`).trim());
    const rapid = read('path-rapid');
    const feed = read('path-feed');
    const shades = [0, 1, 2, 3, 4, 5].map((i) => read(`path-${i}`));
    const { blocks } = this.run;
    const colors = new Float32Array(6 * segments);
    for (let i = 0; i < segments; i++) {
      const block = this.path.block[i];
      const isCut = blocks.kinds[blocks.kind[block]] === 'feed';
      const color = !isCut ? rapid : this.coloring === 'kind' ? feed : shades[block % shades.length];
      for (const at of [6 * i, 6 * i + 3]) color.toArray(colors, at);
    }
    for (const body of [this.whole, this.done]) setColors(body, colors);
    setCount(this.done, this.index ?? 0);
  }

  #addVector() {
    const { workpiece } = this.machine;
    const length = this.size * 0.55;
    this.tip = new THREE.Mesh(
      new THREE.SphereGeometry(this.size * 0.012, 16, 12),
      new THREE.MeshBasicMaterial({ depthTest: false }),
    );
    this.vector = new THREE.ArrowHelper(
      new THREE.Vector3(0, 0, 1), new THREE.Vector3(), length, 0xffffff, length * 0.12, length * 0.05,
    );
    for (const part of [this.vector.line, this.vector.cone]) part.material.depthTest = false;
    for (const body of [this.tip, this.vector.line, this.vector.cone]) body.renderOrder = 2;
    const lines = toolVectors(this.path, this.timeline, kVectors, this.size * 0.14);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(lines, 3));
    this.fan = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55 }));
    this.fan.frustumCulled = false;
    this.fan.visible = false;
    this.vector.visible = !this.run.machine.lathe; // whose tool has no such direction
    workpiece.add(this.tip, this.vector, this.fan);
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }
}

