// The page's chain against Kadr's own: random positions of every stock machine with rotary axes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chainOf, forward, mapped, poleDistance } from '../../web/src/kinematics.js';
import { Scratch, dataOf, kadr } from './kadr.mjs';

const kMachines = [
  'trunnion-ac', 'trunnion-bc', 'head-cb', 'head-ab', 'mixed-cb', 'nutating', 'six-axis', 'rotary-a', 'borer',
];
const kLength = 87.5;
const kTolerance = 1e-9; // mm; what is printed has twelve decimals

const scratch = new Scratch();

/** Seeded, so that every run has the same positions (mulberry32). */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function machineOf(name) {
  const program = scratch.save('still.mpf', 'M30\n');
  const page = scratch.file(`${name}.html`);
  kadr('run', program, '-d', 'sinumerik', '-m', name, '--page', page);
  return dataOf(page).machine;
}

for (const name of kMachines) {
  test(`tip and tool of ${name} are those of kadr machine solve`, () => {
    const machine = machineOf(name);
    const chain = chainOf(machine);
    assert.ok(chain.joints.length > 0);
    const next = random(7);
    for (let round = 0; round < 6; round++) {
      const axes = machine.axes.map(({ rotary }) => {
        const value = (next() - 0.5) * (rotary ? 340 : 700);
        return Number(value.toFixed(4));
      });
      const words = machine.axes.map(({ name: axis }, i) => `${axis}${axes[i]}`).join(' ');
      const solved = JSON.parse(
        kadr('machine', 'solve', name, '--axes', words, '--length', String(kLength), '--json'),
      );
      const state = forward(chain, axes, chain.toolDirection.map((c) => c * kLength));
      for (let k = 0; k < 3; k++) {
        assert.ok(Math.abs(state.tip[k] - solved.tip[k]) < kTolerance, `${words}: ${state.tip} ${solved.tip}`);
        assert.ok(Math.abs(state.tool[k] - solved.tool[k]) < 1e-11, `${words}: ${state.tool} ${solved.tool}`);
      }
      // The tool at the spindle and the point of the workpiece meet in the machine.
      const atTool = mapped(state.head, chain.toolDirection.map((c) => -c * kLength));
      const atWork = mapped(state.table, solved.tip);
      atTool.forEach((value, k) => assert.ok(Math.abs(value - atWork[k]) < 1e-8));
    }
  });
}

test('a machine without rotary axes carries its tool along the axes', () => {
  const machine = { axes: ['X', 'Y', 'Z'].map((letter) => ({ letter })), chain: null };
  const { tip, tool } = forward(chainOf(machine), [1, 2, 103], [0, 0, 100]);
  assert.deepEqual(tip, [1, 2, 3]);
  assert.deepEqual(tool, [0, 0, 1]);
});

test('a lathe has no Y', () => {
  const machine = { axes: ['X', 'Z'].map((letter) => ({ letter })), chain: null };
  assert.deepEqual(forward(chainOf(machine), [30, -5], [0, 0, 0]).tip, [30, 0, -5]);
});

test('the pole is where the tool stands along the axis R1, either way', () => {
  const chain = chainOf(machineOf('trunnion-ac'));
  assert.equal(poleDistance(chain, [0, 0, 1]), 0);
  assert.equal(poleDistance(chain, [0, 0, -1]), 0);
  const tilted = [0, Math.sin(0.001), Math.cos(0.001)];
  assert.ok(Math.abs(poleDistance(chain, tilted) - (0.001 * 180) / Math.PI) < 1e-12);
  assert.equal(poleDistance(chainOf({ axes: [], chain: null }), [0, 0, 1]), undefined);
});
