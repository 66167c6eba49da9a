// kadr.mjs — runs `kadr` and reads what it wrote.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kBinary = process.env.KADR_BINARY;
if (!kBinary) throw new Error('KADR_BINARY names no program');

/** A folder of its own, gone when the test is. */
export class Scratch {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'kadr-page-test-'));
    process.on('exit', () => rmSync(this.folder, { recursive: true, force: true }));
  }
  file(name) {
    return join(this.folder, name);
  }
  save(name, text) {
    writeFileSync(this.file(name), text);
    return this.file(name);
  }
}

/** What it prints. */
export function kadr(...args) {
  return execFileSync(kBinary, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** Exit status, and what it complains of. */
export function tryKadr(...args) {
  const { status, stderr } = spawnSync(kBinary, args, { encoding: 'utf8' });
  return { status, stderr };
}

/** The data in a page, as the browser would read them. */
export function dataOf(page) {
  const text = readFileSync(page, 'utf8');
  const [, json] = /<script type="application\/json" id="data">(.*?)<\/script>/s.exec(text);
  return JSON.parse(json);
}

/** The rows of a table of setpoints as objects of numbers. */
export function rowsOf(csv) {
  const [head, ...lines] = readFileSync(csv, 'utf8').trim().split('\n');
  const names = head.split(',');
  return lines
    .filter((line) => !line.startsWith('#'))
    .map((line) => Object.fromEntries(line.split(',').map((cell, i) => [names[i], Number(cell)])));
}
