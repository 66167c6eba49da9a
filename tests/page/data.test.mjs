// What a page says of a run: the columns decode to the setpoints, times and lines belong together.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeColumn, decodeRun } from '../../web/src/data.js';
import { chainOf, forward } from '../../web/src/kinematics.js';
import { nearestOnPath, pathOf, toolVectors } from '../../web/src/path.js';
import { Player } from '../../web/src/player.js';
import { clock, decimals, isAtLimit } from '../../web/src/readouts.js';
import { Timeline, lastNotAbove } from '../../web/src/timeline.js';
import { Scratch, dataOf, kadr, rowsOf } from './kadr.mjs';
import { kFiveAxes } from './programs.mjs';

const scratch = new Scratch();

/** A run with its setpoints. */
function recorded(text, machine, dialect = 'sinumerik', name = 'part.mpf') {
  const program = scratch.save(name, text);
  const page = scratch.file('part.html');
  const table = scratch.file('part.csv');
  kadr('run', program, '-d', dialect, '-m', machine, '--page', page, '--setpoints', table);
  return { run: decodeRun(dataOf(page)), rows: rowsOf(table) };
}

test('numbers are multiples of a unit', () => {
  const bytes = new Uint8Array(new Int32Array([1, -2, 2147483647]).buffer);
  const data = btoa(String.fromCharCode(...bytes));
  assert.deepEqual([...decodeColumn({ unit: 0.5, data })], [0.5, -1, 1073741823.5]);
});

test('every setpoint of a run is met within the tolerance', () => {
  const { run, rows } = recorded(kFiveAxes, 'trunnion-ac');
  const timeline = new Timeline(run);
  const chain = chainOf(run.machine);
  const { tolerance } = run.samples;
  assert.equal(tolerance, 0.01);
  assert.ok(run.samples.count < rows.length / 3, `${run.samples.count} of ${rows.length}`);
  assert.ok(Math.abs(timeline.end - rows.at(-1).t) < 1e-9);
  let transformed = 0;
  for (const row of rows) {
    const { axes, feed } = timeline.at(row.t);
    run.machine.axes.forEach(({ name }, i) => {
      assert.ok(Math.abs(axes[i] - row[name]) < tolerance + 2e-5, `${name} at ${row.t}: ${axes[i]} ${row[name]}`);
    });
    assert.ok(Math.abs(feed - row.feed) < 5.01 + 0.02 * row.feed, `feed at ${row.t}: ${feed} ${row.feed}`);
    if (row.iso < 8) continue; // the transformation is on from line 4, and the tool is in from line 2
    transformed++;
    const block = timeline.blockAt(row.t + 1e-7);
    assert.equal(run.blocks.isoLine[block], row.iso, `line at ${row.t}`);
    const { tip, tool } = forward(chain, axes, timeline.toolOf(block).offset);
    // 0.01° at 150 mm from the axis are 0.026 mm, and each axis adds its own.
    [row.tip_x, row.tip_y, row.tip_z].forEach((value, k) => assert.ok(Math.abs(tip[k] - value) < 0.08));
    [row.tool_i, row.tool_j, row.tool_k].forEach((value, k) => assert.ok(Math.abs(tool[k] - value) < 5e-4));
  }
  assert.ok(transformed > 1000);
});

test('texts stand in a page as they are, whatever they contain', () => {
  const nasty = 'G0 X1 ; </script><script>alert(1)</script> <!-- "\\" \u20ac &amp;\n';
  const { run } = recorded(`${nasty}M30\n`, 'mill');
  assert.deepEqual(run.texts[0].lines, [nasty.trimEnd(), 'M30']);
  assert.equal(run.texts[0].isCut, false);
});

test('a Kadr program stands beside the text that it became', () => {
  const source = 'program part() {\n  tool(1);\n  S500 M3 F200;\n  for (int i = 1; i < 4; ++i) {\n    G1 X=10*i;\n  }\n  M30;\n}\n';
  const { run } = recorded(source, 'mill', 'fanuc', 'part.kadr');
  const [program, iso] = run.texts;
  assert.ok(program.isKadr && !iso.isKadr);
  assert.equal(program.lines[4], '    G1 X=10*i;');
  const timeline = new Timeline(run);
  // Three turns of the loop: each click goes to the next one, behind the last to the first.
  const times = [0, 1, 2].map((turn, i, _, last = [-1]) => {
    for (let k = 0; k <= turn; k++) last[0] = timeline.timeOfLine(0, 5, last[0]);
    return last[0];
  });
  assert.ok(times[0] < times[1] && times[1] < times[2], String(times));
  assert.equal(timeline.timeOfLine(0, 5, times[2]), times[0]);
  const block = timeline.blockAt(times[1] + 1e-6);
  assert.match(iso.lines[run.blocks.isoLine[block] - 1], /X20/);
  assert.equal(timeline.lineOfBlock(block, 0), 5);
});

test('a lathe and a mill have their way, too', () => {
  const mill = recorded('T1 D1\nS1000 M3\nG0 X0 Y0 Z5\nG1 X30 Y40 Z-1 F1000\nM30\n', 'mill');
  const timeline = new Timeline(mill.run);
  const path = pathOf(timeline, chainOf(mill.run.machine));
  const last = mill.rows.at(-1);
  [last.tip_x, last.tip_y, last.tip_z].forEach((value, k) => {
    assert.ok(Math.abs(path.points[3 * (path.count - 1) + k] - value) < 0.02);
  });
  const lathe = recorded('G18 G90 G95 S500 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nM30\n', 'lathe');
  assert.equal(lathe.run.machine.lathe, true);
  const end = lathe.rows.at(-1);
  const { axes } = new Timeline(lathe.run).at(end.t);
  assert.ok(Math.abs(axes[0] - 20) < 0.01 && Math.abs(axes[1] + 20) < 0.01, String(axes));
});

test('an alarm leaves what came before it, and a warning', () => {
  const program = scratch.save('alarm.mpf', 'T1 D1\nS500 M3\nG1 X10 F500\nG1 X99999\nM30\n');
  const page = scratch.file('alarm.html');
  assert.throws(() => kadr('run', program, '-d', 'sinumerik', '--page', page), (error) => error.status === 3);
  const run = decodeRun(dataOf(page));
  assert.match(run.warning, /^not complete, ended by /);
  assert.ok(run.samples.count > 2);
});

test('an empty program has a page', () => {
  const { run } = recorded('M30\n', 'mill');
  const timeline = new Timeline(run);
  assert.equal(timeline.start, timeline.end);
  assert.equal(pathOf(timeline, chainOf(run.machine)).count, run.samples.count);
});

test('what is looked for by time', () => {
  assert.equal(lastNotAbove([0, 1, 2], -1), 0);
  assert.equal(lastNotAbove([0, 1, 2], 1), 1);
  assert.equal(lastNotAbove([0, 1, 2], 1.5), 1);
  assert.equal(lastNotAbove([0, 1, 2], 9), 2);
});

test('stepping goes from begin to begin of blocks, and stops at both ends', () => {
  const { run } = recorded('T1 D1\nS1000 M3\nG0 X10\nG1 X30 F1000\nG1 X40\nM30\n', 'mill');
  const timeline = new Timeline(run);
  const player = new Player(timeline);
  const times = [];
  for (let i = 0; i < run.blocks.count + 2; i++) {
    times.push(player.time);
    player.step(1);
  }
  assert.equal(player.time, timeline.end);
  times.slice(1, run.blocks.count).forEach((time, i) => assert.equal(time, run.blocks.time[i + 1]));
  for (let i = 0; i < run.blocks.count + 2; i++) player.step(-1);
  assert.equal(player.time, timeline.start);
  player.play();
  player.frame(1000);
  player.frame(1250);
  assert.ok(Math.abs(player.time - timeline.start - 0.25) < 1e-12);
  player.speed = 1e6;
  player.frame(1300);
  assert.equal(player.time, timeline.end);
  assert.equal(player.isPlaying, false);
});

test('the path is found under the pointer', () => {
  const points = Float64Array.from([0, 0, 0, 10, 0, 0, 10, 0, 0, 10, 10, 0]);
  const path = { count: 4, points };
  const flat = ([x, y]) => [x, y];
  assert.deepEqual(nearestOnPath(path, flat, 4, 1, 2), { index: 0, share: 0.4 });
  assert.deepEqual(nearestOnPath(path, flat, 11, 5, 2), { index: 2, share: 0.5 });
  assert.equal(nearestOnPath(path, flat, 4, 3, 2), undefined);
});

test('tool vectors stand along what is cut, as many as are asked for', () => {
  const { run } = recorded(kFiveAxes, 'trunnion-ac');
  const timeline = new Timeline(run);
  const lines = toolVectors(pathOf(timeline, chainOf(run.machine)), timeline, 100, 10);
  const count = lines.length / 6;
  assert.ok(count >= 98 && count <= 101, String(count));
  for (let i = 0; i < lines.length; i += 6) {
    assert.ok(Math.abs(Math.hypot(...[3, 4, 5].map((k) => lines[i + k] - lines[i + k - 3])) - 10) < 1e-9);
  }
});

test('numbers for people', () => {
  assert.equal(decimals(-0.0001, 3), '0.000');
  assert.equal(decimals(1.23456, 3), '1.235');
  assert.equal(clock(7.25), '0:07.250');
  assert.equal(clock(3723.5), '1:02:03.500');
  assert.equal(clock(59.9999), '1:00.000');
  assert.ok(isAtLimit({ lower: -30, upper: 120 }, 120, 0.01));
  assert.ok(!isAtLimit({ lower: -30, upper: 120 }, 119.9, 0.01));
  assert.ok(!isAtLimit({ lower: -Infinity, upper: Infinity }, 1e6, 0.01));
});
