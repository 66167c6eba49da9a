// The page in a real browser: opened from disk, the network off, WebGL by software.
//
// KADR_SCREENSHOTS=folder keeps what was seen, for a person to look at.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { Scratch, kadr, rowsOf } from './kadr.mjs';
import { decodePng } from './png.mjs';
import { kFiveAxes } from './programs.mjs';

const kSoftware = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const kWidth = 1000;
const kHeight = 640;

const scratch = new Scratch();
const table = scratch.file('part.csv');

function pageOf(name, text, machine) {
  const program = scratch.save(`${name}.mpf`, text);
  const page = scratch.file(`${name}.html`);
  kadr('run', program, '-d', 'sinumerik', '-m', machine, '--page', page, '--setpoints', table);
  return pathToFileURL(page).href;
}

const five = pageOf('five', kFiveAxes, 'trunnion-ac');
const rows = rowsOf(table);
const browser = await Browser.open(kSoftware);
const tab = await browser.newTab(kWidth, kHeight);
await tab.theme('light');
await tab.open(five);
await tab.settled();

/** What is on the screen; kept if somebody wants to look. */
async function seen(name, from = tab) {
  const bytes = Buffer.from(await from.screenshot(), 'base64');
  const folder = process.env.KADR_SCREENSHOTS;
  if (folder) {
    mkdirSync(folder, { recursive: true });
    writeFileSync(join(folder, `${name}.png`), bytes);
  }
  return decodePng(bytes);
}

const boxOf = (selector, from = tab) =>
  from.evaluate(`(({x, y, width, height}) => ({x, y, width, height}))(document.querySelector('${selector}').getBoundingClientRect())`);

/** Colours in the picture, and what share of it is not the commonest of them. */
async function coloursOfPicture(name, from = tab) {
  const box = await boxOf('canvas', from);
  const picture = await seen(name, from);
  const counts = new Map();
  let all = 0;
  // Below the buttons.
  for (let y = Math.ceil(box.y) + 60; y < box.y + box.height - 2; y += 2) {
    for (let x = Math.ceil(box.x) + 2; x < box.x + box.width - 2; x += 2) {
      const color = picture.at(x, y).join();
      counts.set(color, (counts.get(color) ?? 0) + 1);
      all++;
    }
  }
  return { kinds: counts.size, drawn: 1 - Math.max(...counts.values()) / all };
}

/** To a time by the slider, as near as its steps are; the time at which the page then stands. */
async function scrubTo(time) {
  await tab.evaluate(`(() => {
    const slider = document.querySelector('#scrub');
    slider.value = Math.round(${time} / ${rows.at(-1).t} * slider.max);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  })()`);
  return tab.evaluate('kadr.player.time');
}

/** The numbers that a person reads. */
function numbers(from = tab) {
  return from.evaluate(`(() => {
    const number = (name) => Number(document.querySelector('[data-field="' + name + '"]').textContent);
    const axes = {};
    for (const row of document.querySelectorAll('.axes tr')) axes[row.dataset.axis] = Number(row.cells[1].textContent);
    return {
      axes,
      tip: ['X', 'Y', 'Z'].map((letter) => number('tip-' + letter)),
      tool: ['I', 'J', 'K'].map((letter) => number('tool-' + letter)),
      feed: number('feed'),
      block: document.querySelector('[data-field=block]').textContent,
      line: Number(document.querySelector('.line[aria-selected=true]')?.dataset.line ?? 0),
    };
  })()`);
}

/** A column of the setpoints at any time. */
function setpoint(column, time) {
  const i = Math.max(1, rows.findIndex((row) => row.t >= time));
  const [a, b] = [rows[i - 1], rows[i]];
  return a[column] + ((b[column] - a[column]) * (time - a.t)) / (b.t - a.t);
}

/** Where a line of the text begins to act. */
const beginOf = (line) => rows.find((row) => row.iso === line).t;

function near(value, expected, tolerance, what) {
  assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value}, not ${expected}`);
}

test('the page opens without a complaint and shows the machine', async () => {
  assert.equal(await tab.evaluate('document.title'), 'five.mpf');
  assert.match(await tab.text('.subtitle'), /trunnion table/);
  assert.equal(await tab.evaluate("document.querySelector('.no-picture').hidden"), true);
  const { kinds, drawn } = await coloursOfPicture('light');
  assert.ok(kinds > 200 && drawn > 0.1, `${kinds} colours, ${drawn} of the picture`);
  assert.deepEqual(tab.complaints, []);
});

test('the read-outs are the setpoints', async () => {
  const end = rows.at(-1).t;
  // Behind line 8 every setpoint has the tip in the workpiece system.
  const times = [0.13, 0.31, 0.52, 0.68, 0.83, 0.97].map((share) => beginOf(8) + share * (end - beginOf(8)));
  for (const share of times) {
    const time = await scrubTo(share);
    near(time, share, end / 15000, 'time of the slider');
    const { axes, tip, tool, feed } = await numbers();
    for (const [name, value] of Object.entries(axes)) near(value, setpoint(name, time), 0.011, `${name} at ${time}`);
    ['x', 'y', 'z'].forEach((letter, k) => near(tip[k], setpoint(`tip_${letter}`, time), 0.08, `tip ${letter} at ${time}`));
    ['i', 'j', 'k'].forEach((letter, k) => near(tool[k], setpoint(`tool_${letter}`, time), 5e-4, `tool ${letter} at ${time}`));
    const wanted = setpoint('feed', time);
    near(feed, wanted, 6 + 0.02 * wanted, `feed at ${time}`);
  }
});

test('it plays, and stands when it is told to', async () => {
  await scrubTo(beginOf(8));
  const from = await tab.evaluate('kadr.player.time');
  await tab.key(' ');
  assert.equal(await tab.evaluate("document.querySelector('#play').getAttribute('aria-label')"), 'Pause');
  const begun = Date.now();
  await tab.evaluate(`new Promise((resolve) => {
    const look = () => (kadr.player.time > ${from} + 0.1 ? resolve() : requestAnimationFrame(look));
    look();
  })`);
  await tab.key(' ');
  const to = await tab.evaluate('kadr.player.time');
  // At single speed a second of motion takes one; what passed before the key is in it.
  assert.ok(to - from < (Date.now() - begun) / 1000 + 1, `${from} to ${to}`);
  await tab.settled();
  assert.equal(await tab.evaluate('kadr.player.time'), to);
  await tab.clickOn('#play');
  assert.equal(await tab.evaluate('kadr.player.isPlaying'), true);
  await tab.clickOn('#play');
  assert.equal(await tab.evaluate('kadr.player.isPlaying'), false);
  await tab.evaluate('document.activeElement.blur()');
});

test('arrows go block by block', async () => {
  await scrubTo((beginOf(8) + beginOf(9)) / 2);
  assert.equal((await numbers()).line, 8);
  await tab.key('ArrowRight');
  assert.equal((await numbers()).line, 9);
  assert.match((await numbers()).block, /^N90, line 9$/);
  near(await tab.evaluate('kadr.player.time'), beginOf(9), 0.0011, 'begin of line 9');
  await tab.key('ArrowLeft');
  await tab.key('ArrowLeft');
  assert.equal((await numbers()).line, 7);
  await tab.key('End');
  near(await tab.evaluate('kadr.player.time'), rows.at(-1).t, 1e-9, 'end');
  await tab.key('Home');
  assert.equal(await tab.evaluate('kadr.player.time'), 0);
});

test('a click on a line goes to its time', async () => {
  await tab.clickOn('.line[data-line="11"]');
  near(await tab.evaluate('kadr.player.time'), beginOf(11), 0.0011, 'begin of line 11');
  assert.equal((await numbers()).line, 11);
  // A line without motion stands for the next one.
  await tab.clickOn('.line[data-line="5"]');
  assert.equal((await numbers()).line, 6);
});

test('a click on the path goes to its block', async () => {
  await tab.evaluate("document.querySelector('[data-look=top]').click()");
  const stage = await boxOf('canvas');
  for (const line of [8, 9, 11]) {
    const next = rows.find((row) => row.t > beginOf(line) && row.iso !== line).t;
    const middle = (beginOf(line) + next) / 2;
    // The picture stands with the machine, which must not move between looking and clicking.
    await scrubTo(middle);
    const [x, y] = await tab.evaluate(`(() => {
      const time = ${middle};
      const i = kadr.run.samples.time.findIndex((t) => t > time);
      const at = (k) => [...kadr.view.path.points.subarray(3 * k, 3 * k + 3)];
      const share = (time - kadr.run.samples.time[i - 1]) / (kadr.run.samples.time[i] - kadr.run.samples.time[i - 1]);
      return kadr.view.project(at(i - 1).map((v, k) => v + share * (at(i)[k] - v)));
    })()`);
    await tab.key('End');
    await scrubTo(middle);
    await tab.click(stage.x + x, stage.y + y);
    assert.equal((await numbers()).line, line);
    near(await tab.evaluate('kadr.player.time'), middle, 0.2, `time of a click on line ${line}`);
  }
  await tab.evaluate("document.querySelector('[data-look=iso]').click()");
});

test('the workpiece stands if it is told to', async () => {
  const place = () => tab.evaluate('kadr.view.project([20, 10, 0])');
  await scrubTo(beginOf(9));
  const machine = await place();
  await scrubTo(beginOf(11));
  const turned = await place();
  assert.ok(Math.hypot(turned[0] - machine[0], turned[1] - machine[1]) > 3, 'the table turns');
  await tab.key('w');
  const fixed = await place();
  await seen('workpiece');
  await scrubTo(beginOf(9));
  const still = await place();
  near(Math.hypot(still[0] - fixed[0], still[1] - fixed[1]), 0, 1e-6, 'the workpiece on the screen');
  await tab.key('w');
});

test('tool vectors and colours can be switched', async () => {
  await scrubTo(beginOf(12));
  const before = await seen('before');
  await tab.clickOn('#vectors');
  await tab.evaluate(`(() => {
    const select = document.querySelector('#coloring');
    select.value = 'kind';
    select.dispatchEvent(new Event('change', { bubbles: true }));
  })()`);
  await tab.settled();
  const after = await seen('vectors');
  let changed = 0;
  for (let y = 100; y < 560; y += 3) {
    for (let x = 20; x < 600; x += 3) changed += before.at(x, y).join() === after.at(x, y).join() ? 0 : 1;
  }
  assert.ok(changed > 50, `${changed} pixels`);
});

test('the page is dark where the system is', async () => {
  const light = (await seen('theme')).at(3, 3);
  await tab.theme('dark');
  await tab.settled();
  const { kinds, drawn } = await coloursOfPicture('dark');
  const dark = (await seen('dark')).at(3, 3);
  assert.ok(Math.max(...dark) < 60 && Math.min(...light) > 200, `${light} ${dark}`);
  assert.ok(kinds > 200 && drawn > 0.1, `${kinds} colours, ${drawn} of the picture`);
  await tab.theme('light');
});

test('it has room on a narrow screen', async () => {
  await tab.size(390, 800, true);
  await tab.settled();
  await seen('narrow');
  assert.ok((await tab.evaluate('document.documentElement.scrollWidth')) <= 390);
  await tab.size(kWidth, kHeight);
});

test('nothing was complained of in all this', () => assert.deepEqual(tab.complaints, []));

const kOthers = {
  'head-cb': kFiveAxes,
  nutating: kFiveAxes,
  borer: 'T1 D1\nS500 M3\nG0 X0 Y0 Z300 B0\nG1 X50 Y20 F2000\nB45 F2000\nG1 X0\nM30\n',
  lathe: 'G18 G90 G95\nS500 M3\nG0 X42 Z2\nG1 X30 F0.3\nG1 Z-25\nG1 X40 Z-40\nG1 Z-60\nG0 X60\nM30\n',
};
for (const [machine, text] of Object.entries(kOthers)) {
  test(`${machine} has a page`, async () => {
    const other = await browser.newTab(kWidth, kHeight);
    await other.open(pageOf(machine, text, machine));
    await other.evaluate('kadr.player.seek(kadr.timeline.end * 0.8)');
    await other.settled();
    const { kinds, drawn } = await coloursOfPicture(machine, other);
    assert.ok(kinds > 200 && drawn > 0.05, `${kinds} colours, ${drawn} of the picture`);
    assert.deepEqual(other.complaints, []);
    await other.send('Page.close');
  });
}

test('a long path is drawn, too', async () => {
  const other = await browser.newTab(kWidth, kHeight);
  const zigzag = Array.from({ length: 2500 }, (_, i) => `G1 X${i % 2 ? 40 : 0} Y${i / 50} Z${(i % 7) / 10}`);
  await other.open(pageOf('long', `T1 D1\nS500 M3\nF6000\n${zigzag.join('\n')}\nM30\n`, 'mill'));
  assert.ok((await other.evaluate('kadr.path.count')) > 30000);
  assert.equal(await other.evaluate('kadr.view.whole.isLineSegments2 === undefined'), true);
  await other.evaluate('kadr.player.seek(kadr.timeline.end * 0.5)');
  await other.settled();
  const { kinds, drawn } = await coloursOfPicture('long', other);
  assert.ok(kinds > 100 && drawn > 0.05, `${kinds} colours, ${drawn} of the picture`);
  assert.deepEqual(other.complaints, []);
  await other.send('Page.close');
});

test('an axis at its limit is marked', async () => {
  const other = await browser.newTab(kWidth, kHeight);
  await other.open(pageOf('limit', 'G0 X100 Y0 Z0\nG0 X1000\nM30\n', 'mill'));
  const marked = () => other.evaluate("[...document.querySelectorAll('.at-limit')].map((row) => row.dataset.axis).join()");
  assert.equal(await marked(), '');
  await other.evaluate('kadr.player.seek(kadr.timeline.end)');
  assert.equal(await marked(), 'X');
  assert.equal(await other.text('.at-limit .limit'), 'limit');
  await other.send('Page.close');
});

test('without WebGL the numbers and the program are there, and a message', async () => {
  const plain = await Browser.open(['--disable-3d-apis']);
  try {
    const other = await plain.newTab(kWidth, kHeight);
    await other.open(five);
    await other.settled();
    assert.match(await other.text('.no-picture'), /cannot draw with WebGL/);
    assert.equal(await other.evaluate("document.querySelector('.no-picture').hidden"), false);
    await other.evaluate('kadr.player.seek(kadr.timeline.end)');
    const { tip, line } = await numbers(other);
    ['x', 'y', 'z'].forEach((letter, k) => near(tip[k], rows.at(-1)[`tip_${letter}`], 0.05, `tip ${letter}`));
    assert.equal(line, rows.at(-1).iso);
    await seen('plain', other);
  } finally {
    await plain.close();
  }
});

// Tests run in their order, whatever became of the ones before.
test('the browser goes', () => browser.close());
