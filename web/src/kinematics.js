// kinematics.js — where tip and tool are for given axes: the chain of runtime/machine/kinematics.h.
//
// Plain arrays, no drawing. The chain reads workpiece – R1 – R2 – spin – tool; a joint on the table
// carries the workpiece, one on the head the tool, the linear axes stand between both. A map is
// { r: rotation, nine numbers by rows, t: what is added }, mm.

export const identity = () => ({ r: [1, 0, 0, 0, 1, 0, 0, 0, 1], t: [0, 0, 0] });

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a, f) => [a[0] * f, a[1] * f, a[2] * f];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);
export const unit = (a) => scaled(a, 1 / (norm(a) || 1));

export const turned = ({ r }, v) => [
  r[0] * v[0] + r[1] * v[1] + r[2] * v[2],
  r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
  r[6] * v[0] + r[7] * v[1] + r[8] * v[2],
];
export const mapped = (map, v) => add(turned(map, v), map.t);

/** First `b`, then `a`. */
export function product(a, b) {
  const r = new Array(9);
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) {
      r[3 * i + j] = a.r[3 * i] * b.r[j] + a.r[3 * i + 1] * b.r[3 + j] + a.r[3 * i + 2] * b.r[6 + j];
    }
  }
  return { r, t: mapped(a, b.t) };
}

export function inverse({ r, t }) {
  const back = { r: [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]], t: [0, 0, 0] };
  return { r: back.r, t: scaled(turned(back, t), -1) };
}

/** A turn about an axis in space by the right-hand rule (Rodrigues). `axis` is a unit vector. */
export function rotationAbout(axis, point, degrees) {
  const angle = (degrees * Math.PI) / 180;
  const s = Math.sin(angle);
  const c = Math.cos(angle);
  const [x, y, z] = axis;
  const v = 1 - c;
  const r = [
    c + x * x * v, x * y * v - z * s, x * z * v + y * s,
    y * x * v + z * s, c + y * y * v, y * z * v - x * s,
    z * x * v - y * s, z * y * v + x * s, c + z * z * v,
  ];
  return { r, t: sub(point, turned({ r }, point)) };
}

/** The chain of a machine, ready to be asked; one without rotary axes has no joints. */
export function chainOf(machine) {
  const column = new Map(machine.axes.map((axis, i) => [axis.letter, i]));
  const description = machine.chain ?? {
    toolDirection: [0, 0, 1],
    compensatesParallel: false,
    joints: [],
  };
  return {
    toolDirection: description.toolDirection,
    poleTolerance: description.poleTolerance ?? 0,
    joints: description.joints,
    linear: ['X', 'Y', 'Z'].map((letter) => column.get(letter)),
    parallel: description.compensatesParallel
      ? ['U', 'V', 'W'].map((letter) => column.get(letter))
      : [],
    rotary: description.joints.map((joint) => column.get(joint.letter)),
  };
}

/**
 * Where everything stands.
 *
 * axes    positions in the order of the machine's axes, mm and degrees
 * offset  from the tip to the end of the zero tool, at base position
 * returns stand  the end of the zero tool as the linear axes carry it, machine coordinates
 *         turns  of the joints, degrees: a table turns against the tool
 *         table  map from the workpiece to the machine
 *         head   map from the end of the zero tool (as origin) to the machine
 *         tip, tool  in the workpiece system: point and unit vector
 */
export function forward(chain, axes, offset) {
  const at = (i) => (i === undefined ? 0 : axes[i]);
  let stand = chain.linear.map(at);
  if (chain.parallel.length > 0) stand = add(stand, chain.parallel.map(at));
  let table = identity();
  let head = { ...identity(), t: stand };
  const turns = [];
  chain.joints.forEach((joint, k) => {
    const angle = joint.sign * at(chain.rotary[k]);
    const isTable = joint.side === 'table';
    turns.push(isTable ? -angle : angle);
    const turn = rotationAbout(joint.direction, joint.point, turns[k]);
    // From the workpiece outwards; from the machine to the tool.
    if (isTable) table = product(turn, table);
    else head = product(head, turn);
  });
  const back = inverse(table);
  const carried = mapped(head, scaled(offset, -1));
  const direction = chain.joints.length > 0 || norm(offset) === 0 ? chain.toolDirection : unit(offset);
  return {
    stand,
    turns,
    table,
    head,
    tip: mapped(back, carried),
    tool: turned(back, turned(head, direction)),
  };
}

/** The angle between the tool and the axis R1, degrees; nothing without two rotary axes. */
export function poleDistance(chain, tool) {
  if (chain.joints.filter((joint) => joint.role !== 'spin').length < 2) return undefined;
  const axis = chain.joints[0].direction;
  const angle = (Math.atan2(norm(cross(axis, tool)), Math.abs(dot(axis, tool))) * 180) / Math.PI;
  return angle;
}
