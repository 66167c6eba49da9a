// machine.js — bodies for a machine of which only its axes are known: recognisable, not to scale.
//
// Where the axes are is exact; how thick a table is and how wide a fork is made up from the size of
// the path and from the distances of the axes.

import * as THREE from 'three';
import { add, cross, dot, norm, scaled, sub, unit } from './kinematics.js';

const vector = (a) => new THREE.Vector3(...a);

/** Bodies of one look share a material; its colours follow the theme. */
export class Materials {
  constructor() {
    const solid = (options) => new THREE.MeshLambertMaterial(options);
    this.all = {
      table: solid({}),
      joint: solid({}),
      head: solid({}),
      tool: solid({}),
      stock: solid({ transparent: true, opacity: 0.22, depthWrite: false, side: THREE.DoubleSide }),
    };
  }
  recolor(colors) {
    for (const [name, material] of Object.entries(this.all)) material.color.set(colors[name]);
  }
}

function mesh(geometry, material) {
  const body = new THREE.Mesh(geometry, material);
  const edges = new THREE.LineSegments(
    new THREE.EdgesGeometry(geometry, 35),
    new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.28 }),
  );
  body.add(edges);
  return body;
}

/** A cylinder (or cone) from one point to another. */
function rod(from, to, radius, material, endRadius = radius) {
  const way = sub(to, from);
  const geometry = new THREE.CylinderGeometry(endRadius, radius, norm(way), 40);
  geometry.applyQuaternion(new THREE.Quaternion().setFromUnitVectors(vector([0, 1, 0]), vector(unit(way))));
  const middle = scaled(add(from, to), 0.5);
  geometry.translate(...middle);
  return mesh(geometry, material);
}

/** A beam of square section between two points; none if they are one. */
function beam(from, to, width, material) {
  const way = sub(to, from);
  const length = norm(way);
  if (length < width / 10) return new THREE.Group();
  const geometry = new THREE.BoxGeometry(width, length, width);
  geometry.applyQuaternion(new THREE.Quaternion().setFromUnitVectors(vector([0, 1, 0]), vector(unit(way))));
  geometry.translate(...scaled(add(from, to), 0.5));
  return mesh(geometry, material);
}

/** The point of a line that is nearest to a point. */
const onAxis = (point, direction, to) => add(point, scaled(direction, dot(direction, sub(to, point))));

/** Any direction square to another one. */
function acrossOf(direction) {
  const helper = Math.abs(direction[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
  return unit(cross(direction, helper));
}

/** A frame of three coloured arrows. */
function frameOf(size) {
  const group = new THREE.Group();
  const colors = [0xd64545, 0x3f9b4f, 0x3f7fd6];
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((direction, i) => {
    const arrow = new THREE.ArrowHelper(vector(direction), vector([0, 0, 0]), size, colors[i], size * 0.22, size * 0.1);
    group.add(arrow);
  });
  return group;
}

/** The largest distance that the picture has to show, mm. */
export function sizeOf(path) {
  const size = norm(sub(path.upper, path.lower));
  return Math.min(Math.max(Number.isFinite(size) ? size : 100, 40), 4000);
}

/**
 * The machine as groups that move: `pose(state)` puts them where forward() says.
 *
 * returns root       everything
 *         extent     from the middle of the path to what should be seen of the machine, mm
 *         rise       how far the middle of the picture lies above that of the path, share of extent
 *         workpiece  group whose coordinates are the workpiece system
 *         pose, setTool
 */
export function buildMachine(run, chain, path, materials) {
  const m = materials.all;
  const size = sizeOf(path);
  const root = new THREE.Group();
  const workpiece = new THREE.Group();
  const carrier = new THREE.Group();
  const spindle = new THREE.Group();
  root.add(carrier);
  const frame = frameOf(size * 0.3);
  workpiece.add(frame);

  const movers = chain.joints.map((joint) => {
    const group = new THREE.Group();
    group.matrixAutoUpdate = false;
    return { joint, group };
  });
  const tables = movers.filter(({ joint }) => joint.side === 'table');
  const heads = movers.filter(({ joint }) => joint.side === 'head');

  // The innermost table carries the workpiece, the outermost stands on the floor.
  let inner = root;
  for (const { group } of [...tables].reverse()) {
    inner.add(group);
    inner = group;
  }
  inner.add(workpiece);
  let carried = carrier;
  for (const { group } of heads) {
    carried.add(group);
    carried = group;
  }
  carried.add(spindle);

  if (run.machine.lathe) addChuck(workpiece, root, path, size, m);
  else addTables(tables, root, workpiece, path, size, chain, m);
  const spindleRadius = Math.min(Math.max(size * 0.12, headLength(run, chain) * 0.13, 14), 90);
  if (run.machine.lathe) addTurret(spindle, size, m);
  else addHeads(heads, carrier, spindle, spindleRadius, size, chain, m);

  const tool = new THREE.Group();
  spindle.add(tool);

  const setMatrix = (group, map) => {
    const { r, t } = map;
    group.matrix.set(r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2], 0, 0, 0, 1);
  };
  return {
    root,
    workpiece,
    size,
    extent: extentOf(run, chain, path, size),
    rise: heads.length > 0 ? 0.55 : 0.12,
    pose(state, rotationAbout) {
      carrier.position.set(...state.stand);
      movers.forEach(({ joint, group }, k) =>
        setMatrix(group, rotationAbout(joint.direction, joint.point, state.turns[k])),
      );
    },
    setTool(data) {
      tool.clear();
      addTool(tool, data, spindleRadius, size, chain, run.machine.lathe, m);
    },
  };
}

// ------------------------------------------------------------------------------------- the table

/** The face on which the workpiece stands: across the axis, below the path. */
function faceOf(path, direction, point, size, upwards) {
  const n = dot(direction, upwards) < -1e-6 ? scaled(direction, -1) : direction;
  let lowest = Infinity;
  for (let corner = 0; corner < 8; corner++) {
    const at = [0, 1, 2].map((k) => (corner & (1 << k) ? path.upper[k] : path.lower[k]));
    lowest = Math.min(lowest, dot(n, sub(at, point)));
  }
  return { n, center: add(point, scaled(n, lowest - size * 0.1)) };
}

/** From the tip of the longest tool to the farthest axis of the head. */
function headLength(run, chain) {
  const tool = Math.max(0, ...run.tools.map(({ offset }) => norm(offset)));
  const heads = chain.joints.filter(({ side }) => side === 'head');
  return tool + Math.max(0, ...heads.map(({ point }) => Math.abs(dot(point, chain.toolDirection))));
}

/**
 * What is up in the picture. Spindles stand upright, but where the table alone turns, about Y, it is
 * a horizontal borer: there Y is upright. The slide of a lathe goes up.
 */
export function uprightOf(run, chain) {
  if (run.machine.lathe) return [1, 0, 0];
  const tables = chain.joints.filter(({ side }) => side === 'table');
  const isHorizontal = tables.length === 1 && Math.abs(tables[0].direction[1]) > 0.9;
  return isHorizontal ? [0, 1, 0] : [0, 0, 1];
}

/** The table, and of the tool and its head as much as tells what they are. */
function extentOf(run, chain, path, size) {
  if (run.machine.lathe) return size * 1.15;
  const head = chain.joints.some(({ side }) => side === 'head') ? headLength(run, chain) * 0.85 : 0;
  const table = chain.joints.find(({ side }) => side === 'table');
  const radius = table ? Math.max(reachOf(path, table.point, table.direction) * 1.3, size * 0.6) : size * 0.8;
  const tool = Math.max(0, ...run.tools.map(({ offset }) => norm(offset)));
  return Math.max(radius * 1.25, tool * 0.9, head, size);
}

/** How far the path reaches from an axis. */
function reachOf(path, point, direction) {
  let most = 0;
  for (let corner = 0; corner < 8; corner++) {
    const at = [0, 1, 2].map((k) => (corner & (1 << k) ? path.upper[k] : path.lower[k]));
    most = Math.max(most, norm(sub(at, onAxis(point, direction, at))));
  }
  return most;
}

function addTables(tables, root, workpiece, path, size, chain, m) {
  const up = chain.toolDirection;
  const middle = scaled(add(path.lower, path.upper), 0.5);
  if (tables.length === 0) {
    const { n, center } = faceOf(path, up, middle, size, up);
    const a = acrossOf(n);
    const b = cross(n, a);
    const extent = (direction) => Math.abs(dot(direction, sub(path.upper, path.lower)));
    const plate = new THREE.BoxGeometry(extent(a) + size * 0.7, size * 0.1, extent(b) + size * 0.7);
    plate.applyMatrix4(new THREE.Matrix4().makeBasis(vector(a), vector(n), vector(cross(a, n))));
    plate.translate(...sub(center, scaled(n, size * 0.05)));
    workpiece.add(mesh(plate, m.table));
    return;
  }
  const { joint: first, group: plateGroup } = tables[0];
  const { n, center } = faceOf(path, first.direction, first.point, size, up);
  const thick = size * 0.09;
  const radius = Math.max(reachOf(path, first.point, first.direction) * 1.12, size * 0.45);
  const under = sub(center, scaled(n, thick));
  plateGroup.add(rod(under, center, radius, m.table));
  // A groove, so that one sees it turn.
  const across = acrossOf(n);
  for (const side of [1, -1]) {
    plateGroup.add(
      beam(add(center, scaled(across, side * radius * 0.35)), add(center, scaled(across, side * radius * 0.95)), thick * 0.25, m.joint),
    );
  }
  const hub = sub(under, scaled(n, thick * 1.2));
  const carrierOfFirst = tables[1]?.group ?? root;
  carrierOfFirst.add(rod(hub, under, radius * 0.5, m.joint));
  if (!tables[1]) {
    root.add(beam(hub, sub(hub, scaled(n, thick * 1.6)), radius * 1.5, m.joint));
    return;
  }
  addCradle(tables[1], root, { hub, n, radius, thick, size }, m);
}

/** The second table axis, which carries the first one: arms to bearings on its axis. */
function addCradle({ joint, group }, root, { hub, n, radius, thick, size }, m) {
  const d = joint.direction;
  const foot = onAxis(joint.point, d, hub);
  const isSquare = Math.abs(dot(d, n)) < 0.35;
  const width = thick * 1.5;
  if (!isSquare) {
    // A slanted one: a console from the table to a bearing on its axis.
    const away = norm(sub(foot, hub)) < size * 0.05 ? add(foot, scaled(d, -size * 0.5)) : foot;
    group.add(beam(hub, away, width * 2, m.joint));
    group.add(rod(sub(away, scaled(d, size * 0.1)), add(away, scaled(d, size * 0.1)), width * 1.4, m.table));
    root.add(rod(sub(away, scaled(d, size * 0.35)), sub(away, scaled(d, size * 0.1)), width * 2, m.head));
    return;
  }
  for (const side of [1, -1]) {
    const bearing = add(foot, scaled(d, side * radius * 1.18));
    const under = add(hub, scaled(d, side * radius * 1.18));
    group.add(beam(hub, under, width, m.joint));
    group.add(beam(under, bearing, width, m.joint));
    group.add(rod(bearing, add(bearing, scaled(d, side * thick * 1.2)), width * 0.9, m.table));
    const block = add(bearing, scaled(d, side * thick * 2.2));
    root.add(rod(add(bearing, scaled(d, side * thick * 1.2)), add(block, scaled(d, side * thick)), width * 1.5, m.head));
    root.add(beam(block, sub(block, scaled(n, radius * 1.25 + thick)), thick * 2, m.head));
  }
}

// --------------------------------------------------------------------------------------- the head

function addHeads(heads, carrier, spindle, radius, size, chain, m) {
  const up = chain.toolDirection;
  const swivels = heads.filter(({ joint }) => joint.role !== 'spin');
  if (swivels.length === 0) {
    const top = scaled(up, radius * 4);
    spindle.add(rod([0, 0, 0], scaled(up, radius * 0.5), radius * 0.6, m.head, radius));
    spindle.add(rod(scaled(up, radius * 0.5), top, radius, m.head));
    carrier.add(beam(top, scaled(up, radius * 9), radius * 2.6, m.joint));
    return;
  }
  const last = swivels[swivels.length - 1];
  const pivot = onAxis(last.joint.point, last.joint.direction, onAxis([0, 0, 0], up, last.joint.point));
  const height = Math.max(dot(up, pivot), radius * 3);
  spindle.add(rod([0, 0, 0], scaled(up, radius * 0.5), radius * 0.6, m.head, radius));
  spindle.add(rod(scaled(up, radius * 0.5), scaled(up, height + radius), radius, m.head));
  const axle = last.joint.direction;
  const isSquare = Math.abs(dot(axle, up)) < 0.35;
  const half = radius * 1.45;
  const outer = swivels.length > 1 ? swivels[0].group : carrier;
  const yokeHeight = add(pivot, scaled(up, radius * 2.6));
  if (isSquare) {
    for (const side of [1, -1]) {
      const end = add(pivot, scaled(axle, side * half));
      spindle.add(rod(add(pivot, scaled(axle, side * radius * 0.8)), end, radius * 0.75, m.table));
      const cheek = add(end, scaled(axle, side * radius * 0.35));
      outer.add(beam(sub(cheek, scaled(up, radius * 0.6)), add(cheek, sub(yokeHeight, pivot)), radius * 0.8, m.joint));
    }
    outer.add(
      beam(add(yokeHeight, scaled(axle, half * 1.4)), sub(yokeHeight, scaled(axle, half * 1.4)), radius * 1.1, m.joint),
    );
  } else {
    // A slanted axis: the head turns on a disc that lies across it.
    spindle.add(rod(pivot, add(pivot, scaled(axle, radius * 0.5)), radius * 1.4, m.table));
    outer.add(rod(add(pivot, scaled(axle, radius * 0.5)), add(pivot, scaled(axle, radius * 1.6)), radius * 1.4, m.joint));
    outer.add(beam(add(pivot, scaled(axle, radius * 1.3)), yokeHeight, radius * 1.3, m.joint));
  }
  if (swivels.length === 1) {
    carrier.add(beam(yokeHeight, add(yokeHeight, scaled(up, radius * 5)), radius * 2.4, m.joint));
    return;
  }
  const first = swivels[0].joint;
  const foot = onAxis(first.point, first.direction, yokeHeight);
  const isUpright = Math.abs(dot(first.direction, up)) > 0.7;
  const direction = isUpright && dot(first.direction, up) < 0 ? scaled(first.direction, -1) : first.direction;
  swivels[0].group.add(beam(yokeHeight, foot, radius * 1.1, m.joint));
  if (isUpright) {
    const base = onAxis(first.point, first.direction, add(yokeHeight, scaled(up, radius * 0.5)));
    swivels[0].group.add(rod(base, add(base, scaled(direction, radius * 0.8)), radius * 1.6, m.table));
    const top = add(base, scaled(direction, radius * 0.8));
    carrier.add(rod(top, add(top, scaled(direction, radius * 1.2)), radius * 1.9, m.head));
    carrier.add(beam(add(top, scaled(direction, radius)), add(top, scaled(direction, radius * 6)), radius * 2.6, m.joint));
    return;
  }
  // Both axes lie: the outer one carries a gimbal.
  for (const side of [1, -1]) {
    const end = add(foot, scaled(direction, side * radius * 2.4));
    swivels[0].group.add(beam(foot, end, radius * 0.9, m.joint));
    swivels[0].group.add(rod(end, add(end, scaled(direction, side * radius * 0.6)), radius * 0.8, m.table));
    const cheek = add(end, scaled(direction, side * radius * 0.9));
    carrier.add(beam(cheek, add(cheek, scaled(up, radius * 4)), radius * 0.9, m.head));
  }
  const bridge = add(foot, scaled(up, radius * 4));
  carrier.add(beam(add(bridge, scaled(direction, radius * 3.6)), sub(bridge, scaled(direction, radius * 3.6)), radius * 1.4, m.head));
}

/** Holder and cutter; the tip is where the tool's offset begins. */
function addTool(group, { offset, radius }, spindleRadius, size, chain, isLathe, m) {
  const length = norm(offset);
  const tip = scaled(offset, -1);
  if (isLathe) {
    // An insert, and its shank away from the workpiece.
    const edge = size * 0.06;
    group.add(rod(tip, add(tip, [edge, 0, edge * 0.35]), edge * 0.02, m.tool, edge * 0.5));
    group.add(beam(add(tip, [edge, 0, edge * 0.35]), add(tip, [size * 0.4, 0, edge * 0.35]), edge * 0.9, m.joint));
    return;
  }
  const along = length > 0 ? unit(offset) : chain.toolDirection;
  const cutter = Math.min(radius ?? size * 0.03, spindleRadius * 0.9);
  if (length < cutter) {
    group.add(rod(tip, add(tip, scaled(along, size * 0.06)), size * 0.001, m.tool, size * 0.03));
    return;
  }
  const neck = add(tip, scaled(along, length * 0.62));
  group.add(rod(tip, neck, cutter, m.tool));
  group.add(rod(neck, [0, 0, 0], Math.min(cutter * 1.6, spindleRadius * 0.6), m.joint, spindleRadius * 0.55));
}

// -------------------------------------------------------------------------------------- the lathe

function addChuck(workpiece, root, path, size, m) {
  const radius = Math.max(Math.abs(path.upper[0]), Math.abs(path.lower[0]), size * 0.1);
  const back = path.lower[2] - size * 0.12;
  const front = Math.max(path.upper[2], back + size * 0.2);
  root.add(rod([0, 0, back - size * 0.22], [0, 0, back], radius * 1.35, m.table));
  root.add(rod([0, 0, back - size * 0.6], [0, 0, back - size * 0.22], radius * 0.9, m.joint));
  for (let jaw = 0; jaw < 3; jaw++) {
    const angle = (jaw * 2 * Math.PI) / 3 + Math.PI / 6;
    const at = (r, z) => [r * Math.cos(angle), r * Math.sin(angle), z];
    root.add(beam(at(radius * 1.12, back), at(radius * 1.12, back + size * 0.08), radius * 0.28, m.joint));
  }
  workpiece.add(rod([0, 0, back], [0, 0, front], radius, m.stock));
}

function addTurret(spindle, size, m) {
  const at = size * 0.4;
  spindle.add(rod([at, 0, -size * 0.02], [at, 0, size * 0.18], size * 0.2, m.head));
}
