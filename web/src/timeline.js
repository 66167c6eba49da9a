// timeline.js — what is when: positions and blocks by time, times by lines.

/** The index of the last value that is not above `wanted`, 0 if all are. `values` ascend. */
export function lastNotAbove(values, wanted) {
  let low = 0;
  let high = values.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= wanted) low = middle;
    else high = middle;
  }
  return low;
}

export class Timeline {
  constructor(run) {
    this.run = run;
    const { time } = run.samples;
    this.start = time.length > 0 ? time[0] : 0;
    this.end = time.length > 0 ? time[time.length - 1] : 0;
    this.lines = { iso: this.#linesOf('iso'), source: this.#linesOf('source') };
  }

  clamp(time) {
    return Math.min(Math.max(time, this.start), this.end);
  }

  /** Axes (mm, degrees) and feed (mm/min) at a time; between two samples they go evenly. */
  at(time) {
    const { samples } = this.run;
    const i = lastNotAbove(samples.time, time);
    const next = Math.min(i + 1, samples.count - 1);
    const span = samples.time[next] - samples.time[i];
    const share = span > 0 ? Math.min(Math.max((time - samples.time[i]) / span, 0), 1) : 0;
    const between = (column) => column[i] + share * (column[next] - column[i]);
    return { index: i, axes: samples.axes.map(between), feed: between(samples.feed) };
  }

  /** The block that acts at a time; -1 if there is none at all. */
  blockAt(time) {
    return this.run.blocks.count > 0 ? lastNotAbove(this.run.blocks.time, time) : -1;
  }

  /** The offset of the tool that hangs at the spindle in a block. */
  toolOf(block) {
    const { blocks, tools } = this.run;
    return (block >= 0 && tools[blocks.tool[block]]) || { offset: [0, 0, 0], radius: null, name: '' };
  }

  timeOfBlock(block) {
    const { blocks } = this.run;
    return block < blocks.count ? blocks.time[Math.max(block, 0)] : this.end;
  }

  /**
   * When the line of a text first acts; a line without motion stands for the next one that has.
   * The nearest time behind `after` is preferred, so that one can go through the turns of a loop.
   */
  timeOfLine(text, line, after = -Infinity) {
    for (const which of ['iso', 'source']) {
      const next = this.lines[which].get(text)?.find((entry) => entry >= line);
      if (next !== undefined) return this.#nearest(which, text, next, after);
    }
    return undefined;
  }

  /** The place of a block in one of the texts: its line, or 0 if the block is not of this text. */
  lineOfBlock(block, text) {
    const { blocks } = this.run;
    if (block < 0) return 0;
    if (blocks.sourceText[block] === text) return blocks.sourceLine[block];
    return blocks.isoText[block] === text ? blocks.isoLine[block] : 0;
  }

  /** For each text the lines that act, in their order. */
  #linesOf(which) {
    const { blocks } = this.run;
    const texts = new Map();
    for (let i = 0; i < blocks.count; i++) {
      const text = blocks[`${which}Text`][i];
      if (text < 0) continue;
      if (!texts.has(text)) texts.set(text, new Set());
      texts.get(text).add(blocks[`${which}Line`][i]);
    }
    for (const [text, lines] of texts) texts.set(text, [...lines].sort((a, b) => a - b));
    return texts;
  }

  #nearest(which, text, line, after) {
    const { blocks } = this.run;
    let first;
    for (let i = 0; i < blocks.count; i++) {
      if (blocks[`${which}Text`][i] !== text || blocks[`${which}Line`][i] !== line) continue;
      first ??= blocks.time[i];
      if (blocks.time[i] > after) return blocks.time[i];
    }
    return first;
  }
}
