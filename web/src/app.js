// app.js — puts the page together: data, clock, picture, numbers, program.

import { decodeRun } from './data.js';
import { chainOf, forward, poleDistance } from './kinematics.js';
import { pathOf } from './path.js';
import { Player } from './player.js';
import { ProgramPanel } from './program.js';
import { Readouts, clock } from './readouts.js';
import { Timeline } from './timeline.js';
import { View } from './view.js';

const kNearPole = 0.5; // degrees between the tool and the axis R1 that are told of

const find = (selector) => document.querySelector(selector);

class Page {
  constructor(run) {
    this.run = run;
    this.chain = chainOf(run.machine);
    this.timeline = new Timeline(run);
    this.player = new Player(this.timeline);
    this.readouts = new Readouts(document, run);
    this.program = new ProgramPanel(find('.program'), run, { onLine: (place) => this.#goToLine(place) });
    this.#fillHead();
    this.path = pathOf(this.timeline, this.chain);
    this.view = this.#openView();
    this.#connect();
    this.player.seek(this.timeline.start);
    requestAnimationFrame((now) => this.#frame(now));
  }

  #fillHead() {
    const { title, subtitle, warning, samples } = this.run;
    find('h1').textContent = title;
    find('.subtitle').textContent = subtitle;
    find('.warning').textContent = warning;
    find('.warning').hidden = warning === '';
    find('.accuracy').textContent =
      `Positions are those of the setpoints within ${Number(samples.tolerance.toFixed(3))} mm or degrees; ` +
      'bodies are made up around the axes.';
  }

  /** The picture, or nothing: then numbers and program are there all the same. */
  #openView() {
    try {
      const view = new View(find('canvas'), this.run, this.chain, this.timeline, this.path);
      view.look('iso');
      return view;
    } catch (error) {
      const note = find('.no-picture');
      note.textContent =
        'There is no picture: this browser cannot draw with WebGL, or it is switched off. ' +
        `The numbers and the program work without it. (${error.message})`;
      note.hidden = false;
      find('canvas').hidden = true;
      find('.views').hidden = true;
      return undefined;
    }
  }

  #connect() {
    const { player, view } = this;
    player.addEventListener('time', () => this.#show());
    player.addEventListener('state', () => {
      const button = find('#play');
      button.classList.toggle('is-playing', player.isPlaying);
      button.setAttribute('aria-label', player.isPlaying ? 'Pause' : 'Play');
    });
    find('#play').addEventListener('click', () => player.toggle());
    find('#back').addEventListener('click', () => player.step(-1));
    find('#next').addEventListener('click', () => player.step(1));
    find('#scrub').addEventListener('input', (event) => {
      player.pause();
      const { start, end } = this.timeline;
      player.seek(start + (Number(event.target.value) / Number(event.target.max)) * (end - start));
    });
    find('#speed').addEventListener('change', (event) => {
      player.speed = Number(event.target.value);
    });
    document.addEventListener('keydown', (event) => this.#key(event));
    if (!view) return;
    for (const button of document.querySelectorAll('[data-look]')) {
      button.addEventListener('click', () => view.look(button.dataset.look));
    }
    find('#fixed').addEventListener('change', (event) => view.fixWorkpiece(event.target.value === 'workpiece'));
    find('#coloring').addEventListener('change', (event) => view.colorBy(event.target.value));
    find('#vectors').addEventListener('change', (event) => view.showVectors(event.target.checked));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view.recolor());
    this.#connectClicks();
  }

  /** A click is no drag: the pointer stays where it went down. */
  #connectClicks() {
    const canvas = find('canvas');
    let down;
    canvas.addEventListener('pointerdown', (event) => {
      down = [event.offsetX, event.offsetY];
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) > 4) return;
      const time = this.view.timeAt(event.offsetX, event.offsetY);
      if (time === undefined) return;
      this.player.pause();
      this.player.seek(time);
    });
  }

  #key(event) {
    const isField = event.target.closest?.('select, input[type=checkbox], summary');
    if (isField || event.ctrlKey || event.metaKey || event.altKey) return;
    const { player, timeline } = this;
    const far = event.shiftKey ? 1 : 0;
    const turn = (direction) => (far ? player.seek(player.time + direction) : player.step(direction));
    const actions = {
      ' ': () => player.toggle(),
      ArrowLeft: () => turn(-1),
      ArrowRight: () => turn(1),
      ArrowUp: () => this.#changeSpeed(1),
      ArrowDown: () => this.#changeSpeed(-1),
      Home: () => player.seek(timeline.start),
      End: () => player.seek(timeline.end),
      w: () => this.#toggleFixed(),
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    // A button is pressed by the space bar, as everywhere.
    if (!action || (event.key === ' ' && event.target.closest?.('button'))) return;
    event.preventDefault();
    action();
  }

  #changeSpeed(direction) {
    const select = find('#speed');
    const index = Math.min(Math.max(select.selectedIndex + direction, 0), select.options.length - 1);
    select.selectedIndex = index;
    this.player.speed = Number(select.value);
  }

  #toggleFixed() {
    if (!this.view) return;
    const select = find('#fixed');
    select.value = select.value === 'machine' ? 'workpiece' : 'machine';
    this.view.fixWorkpiece(select.value === 'workpiece');
  }

  /** To the time of a line; without a place only the mark is put anew. */
  #goToLine(place) {
    if (place) {
      const time = this.timeline.timeOfLine(place.text, place.line, this.player.time);
      if (time !== undefined) {
        this.player.pause();
        this.player.seek(time);
      }
    }
    this.#show();
  }

  #show() {
    const { player, timeline, run } = this;
    const { time } = player;
    if (run.samples.count === 0) return;
    const { index, axes, feed } = timeline.at(time);
    const block = timeline.blockAt(time);
    const tool = timeline.toolOf(block);
    const state = forward(this.chain, axes, tool.offset);
    const pole = poleDistance(this.chain, state.tool);
    this.readouts.show({
      axes,
      feed,
      tip: state.tip,
      tool: state.tool,
      blockText: this.#blockText(block),
      kind: block < 0 ? '' : run.blocks.kinds[run.blocks.kind[block]],
      toolName: this.#toolText(tool),
      pole: pole !== undefined && pole < Math.max(kNearPole, this.chain.poleTolerance),
    });
    this.#markLine(block);
    const { start, end } = timeline;
    const scrub = find('#scrub');
    scrub.value = String(end > start ? ((time - start) / (end - start)) * Number(scrub.max) : 0);
    scrub.setAttribute('aria-valuetext', clock(time));
    find('#clock').textContent = `${clock(time)} / ${clock(end)}`;
    this.view?.pose(state, index, tool);
  }

  #markLine(block) {
    if (block < 0) return;
    const { blocks } = this.run;
    // Where the block is not of the text that is shown, the page goes to the one that has it.
    if (timelineHas(this.timeline, block, this.program.text)) {
      this.program.mark(this.timeline.lineOfBlock(block, this.program.text));
      return;
    }
    const isSource = this.program.text >= 0 && this.run.texts[this.program.text].isKadr;
    const other = isSource && blocks.sourceText[block] >= 0 ? blocks.sourceText[block] : blocks.isoText[block];
    if (this.program.byUser && this.player.isPlaying && isSource) return;
    this.program.show(other);
    this.program.mark(this.timeline.lineOfBlock(block, other));
  }

  #blockText(block) {
    if (block < 0) return '';
    const { blocks, texts } = this.run;
    const line = blocks.isoLine[block];
    const words = texts[blocks.isoText[block]]?.lines[line - 1] ?? '';
    const number = /^\s*\/?\s*:?(N\d+)/i.exec(words)?.[1];
    return number ? `${number}, line ${line}` : `line ${line}`;
  }

  #toolText({ offset, name }) {
    const length = Math.hypot(...offset);
    const words = `length ${Number(length.toFixed(3))} mm`;
    return name ? `${name}, ${words}` : words;
  }

  #frame(now) {
    this.player.frame(now);
    this.view?.controls.update();
    this.view?.draw();
    requestAnimationFrame((next) => this.#frame(next));
  }
}

const timelineHas = (timeline, block, text) => timeline.lineOfBlock(block, text) > 0;

// For the curious, and for tests.
window.kadr = new Page(decodeRun(JSON.parse(find('#data').textContent)));
