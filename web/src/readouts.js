// readouts.js — the numbers beside the picture: axes, tip, tool, feed, block, time.

export const decimals = (value, count) => {
  const text = value.toFixed(count);
  return Number(text) === 0 ? (0).toFixed(count) : text; // no minus in front of zero
};

/** 0:07.250, 12:03.004, 1:02:03.500 */
export function clock(seconds) {
  const ms = Math.round(seconds * 1000);
  const h = Math.floor(ms / 3600000);
  const m = Math.floor(ms / 60000) % 60;
  const s = ((ms % 60000) / 1000).toFixed(3).padStart(6, '0');
  return h > 0 ? `${h}:${String(m).padStart(2, '0')}:${s}` : `${m}:${s}`;
}

/** At the end of its way, or beyond it; `tolerance` is what the page does not know better. */
export function isAtLimit(axis, value, tolerance) {
  return value <= axis.lower + tolerance || value >= axis.upper - tolerance;
}

export class Readouts {
  constructor(root, run) {
    this.run = run;
    this.fields = new Map(
      [...root.querySelectorAll('[data-field]')].map((field) => [field.dataset.field, field]),
    );
    this.axes = run.machine.axes.map((axis) => this.#axisRow(root.querySelector('.axes tbody'), axis));
  }

  show({ axes, feed, tip, tool, blockText, kind, toolName, pole }) {
    const { tolerance } = this.run.samples;
    axes.forEach((value, i) => {
      const axis = this.run.machine.axes[i];
      const { row, number, bar, limit } = this.axes[i];
      const isAt = isAtLimit(axis, value, tolerance);
      number.textContent = decimals(value, 3);
      row.classList.toggle('at-limit', isAt);
      limit.textContent = isAt ? 'limit' : '';
      const share = (value - axis.lower) / (axis.upper - axis.lower);
      if (bar) bar.style.left = `${100 * Math.min(Math.max(share, 0), 1)}%`;
    });
    ['X', 'Y', 'Z'].forEach((letter, i) => this.#put(`tip-${letter}`, decimals(tip[i], 3)));
    ['I', 'J', 'K'].forEach((letter, i) => this.#put(`tool-${letter}`, decimals(tool[i], 4)));
    this.#put('feed', decimals(feed, 0));
    this.#put('block', blockText);
    this.#put('kind', kind);
    this.#put('tool-name', toolName);
    this.fields.get('pole').hidden = !pole;
  }

  #put(name, text) {
    const field = this.fields.get(name);
    if (field.textContent !== text) field.textContent = text;
  }

  #axisRow(table, axis) {
    const row = table.insertRow();
    row.dataset.axis = axis.name;
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = axis.name;
    row.append(head);
    const number = row.insertCell();
    number.className = 'number';
    // The slide of a lathe counts the radius, whatever its program says.
    const isRadius = this.run.machine.lathe && axis.letter === 'X';
    row.insertCell().textContent = axis.rotary ? '°' : isRadius ? 'mm radius' : 'mm';
    const way = row.insertCell();
    let bar;
    if (Number.isFinite(axis.lower) && Number.isFinite(axis.upper)) {
      way.innerHTML = '<span class="way" aria-hidden="true"><span class="mark"></span></span>';
      bar = way.querySelector('.mark');
      way.title = `limits ${axis.lower} to ${axis.upper}`;
    } else {
      way.textContent = axis.rotary ? 'endless' : '';
    }
    const limit = row.insertCell();
    limit.className = 'limit';
    return { row, number, bar, limit };
  }
}
