// build.mjs — bundles the page into one template: markup, style, program and licence in one file.
//
//     node build.mjs OUT.html

import { readFile, mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, 'dist', 'page.html');

const bundle = async (entry) => {
  const { outputFiles } = await build({
    entryPoints: [join(here, 'src', entry)],
    bundle: true,
    minify: true,
    format: 'iife',
    target: ['es2022'],
    legalComments: 'inline',
    write: false,
    logLevel: 'warning',
  });
  return outputFiles[0].text.trim();
};

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

const script = await bundle('app.js');
const parts = {
  style: await bundle('style.css'),
  licence: escaped((await readFile(join(here, 'node_modules/three/LICENSE'), 'utf8')).trim()),
  script,
};
// A script element ends at the first of these, whatever the program means by it.
if (/<\/script|<!--/i.test(script)) throw new Error('the bundle contains an end of its script element');

const template = await readFile(join(here, 'src/index.html'), 'utf8');
const page = template.replace(/\{\{bundle:(\w+)\}\}/g, (_, name) => parts[name]);
// What a run puts in has its places once, and in this order.
const places = [...page.matchAll(/\{\{kadr:(\w+)\}\}/g)].map((match) => match[1]);
if (places.join() !== 'title,data') throw new Error(`places in the template: ${places}`);
await mkdir(dirname(out), { recursive: true });
await writeFile(out, page);
