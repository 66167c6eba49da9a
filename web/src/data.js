// data.js — the data of a run as `kadr run --page` puts them into the page; see README.md.

/** Numbers that were written as multiples of a unit: 32-bit, little-endian, base64. */
export function decodeColumn({ unit, data }) {
  const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const values = new Float64Array(bytes.length / 4);
  for (let i = 0; i < values.length; i++) values[i] = view.getInt32(4 * i, true) * unit;
  return values;
}

/** The same for counts, indices and line numbers. */
function decodeCounts(column) {
  return Int32Array.from(decodeColumn(column), Math.round);
}

/** JSON has no infinite numbers: null stands for an axis without a limit. */
function axisOf(axis) {
  return { ...axis, lower: axis.lower ?? -Infinity, upper: axis.upper ?? Infinity };
}

/** Everything that the page knows, with its columns as arrays of numbers. */
export function decodeRun(raw) {
  const { samples, blocks, machine } = raw;
  return {
    title: raw.title,
    subtitle: raw.subtitle,
    warning: raw.warning,
    machine: { ...machine, axes: machine.axes.map(axisOf) },
    tools: raw.tools,
    samples: {
      count: samples.count,
      tolerance: samples.tolerance,
      time: decodeColumn(samples.time),
      feed: decodeColumn(samples.feed),
      axes: samples.axes.map(decodeColumn),
    },
    blocks: {
      count: blocks.count,
      kinds: blocks.kinds,
      time: decodeColumn(blocks.time),
      kind: decodeCounts(blocks.kind),
      tool: decodeCounts(blocks.tool),
      isoText: decodeCounts(blocks.isoText),
      isoLine: decodeCounts(blocks.isoLine),
      sourceText: decodeCounts(blocks.sourceText),
      sourceLine: decodeCounts(blocks.sourceLine),
    },
    texts: raw.texts.map(({ name, kadr, cut, text }) => ({
      name,
      isKadr: kadr,
      isCut: cut,
      lines: text.replace(/\r?\n$/, '').split(/\r?\n/),
    })),
  };
}
