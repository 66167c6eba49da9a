// path.js — the way of the tip in the workpiece system, and the tool along it.

import { add, forward, scaled, unit } from './kinematics.js';

/**
 * The tip at every sample.
 *
 * returns points  3 numbers a sample, workpiece system, mm
 *         tools   likewise: the direction of the tool
 *         block   of the way from a sample to the next one
 *         lower, upper  a box around what is cut; around all of it if nothing is
 */
export function pathOf(timeline, chain) {
  const { samples, blocks } = timeline.run;
  const { count } = samples;
  const points = new Float64Array(3 * count);
  const tools = new Float64Array(3 * count);
  const block = new Int32Array(count);
  const all = emptyBox();
  const cut = emptyBox();
  const axes = new Array(samples.axes.length);
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < axes.length; k++) axes[k] = samples.axes[k][i];
    const begin = timeline.blockAt(samples.time[i]);
    const { tip, tool } = forward(chain, axes, timeline.toolOf(begin).offset);
    points.set(tip, 3 * i);
    tools.set(tool, 3 * i);
    // A sample at the end of a block is the begin of the next one: what is between counts.
    const next = samples.time[Math.min(i + 1, count - 1)];
    block[i] = timeline.blockAt((samples.time[i] + next) / 2);
    widen(all, tip);
    if (blocks.kinds[blocks.kind[block[i]]] === 'feed') widen(cut, tip);
  }
  const box = cut.lower[0] <= cut.upper[0] ? cut : all;
  return { count, points, tools, block, ...box };
}

const emptyBox = () => ({ lower: [Infinity, Infinity, Infinity], upper: [-Infinity, -Infinity, -Infinity] });

function widen(box, point) {
  for (let k = 0; k < 3; k++) {
    box.lower[k] = Math.min(box.lower[k], point[k]);
    box.upper[k] = Math.max(box.upper[k], point[k]);
  }
}

/** Begins and ends of lines that show the tool along what is cut, about `count` of them. */
export function toolVectors(path, timeline, count, length) {
  const { blocks } = timeline.run;
  const isCut = (i) => blocks.kinds[blocks.kind[path.block[i]]] === 'feed';
  // A turn about the tip counts, too: as the way of a point so far from it.
  const way = (i) => distance(path.points, i + 1) + length * distance(path.tools, i + 1);
  let total = 0;
  for (let i = 0; i + 1 < path.count; i++) total += isCut(i) ? way(i) : 0;
  const step = total / Math.max(count - 1, 1);
  const lines = [];
  let left = 0; // until the next one
  for (let i = 0; i + 1 < path.count; i++) {
    if (!isCut(i)) continue;
    const whole = way(i);
    for (; left <= whole && whole > 0; left += step) {
      const between = (values) => [0, 1, 2].map((k) => {
        const from = values[3 * i + k];
        return from + (left / whole) * (values[3 * i + 3 + k] - from);
      });
      const tip = between(path.points);
      lines.push(...tip, ...add(tip, scaled(unit(between(path.tools)), length)));
    }
    left -= whole;
  }
  return lines;
}

function distance(points, i) {
  return Math.hypot(
    points[3 * i] - points[3 * i - 3],
    points[3 * i + 1] - points[3 * i - 2],
    points[3 * i + 2] - points[3 * i - 1],
  );
}

/**
 * The sample from which the way on comes nearest to a place on the screen.
 *
 * project  a point of the workpiece to [x, y, depth] in pixels; nothing if it is behind the eye
 * reach    px
 * returns  { index, share } or nothing
 */
export function nearestOnPath(path, project, x, y, reach) {
  let best;
  let least = reach;
  let from = project([path.points[0], path.points[1], path.points[2]]);
  for (let i = 0; i + 1 < path.count; i++) {
    const to = project([path.points[3 * i + 3], path.points[3 * i + 4], path.points[3 * i + 5]]);
    if (from && to) {
      const dx = to[0] - from[0];
      const dy = to[1] - from[1];
      const length2 = dx * dx + dy * dy;
      // A point that stands is no way: the block that goes there or on is meant.
      if (length2 > 0) {
        const share = Math.min(Math.max(((x - from[0]) * dx + (y - from[1]) * dy) / length2, 0), 1);
        const away = Math.hypot(x - from[0] - share * dx, y - from[1] - share * dy);
        if (away < least) {
          least = away;
          best = { index: i, share };
        }
      }
    }
    from = to;
  }
  return best;
}
