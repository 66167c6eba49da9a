// player.js — the clock of the page: plays, stands, jumps. Knows no screen.

export class Player extends EventTarget {
  constructor(timeline) {
    super();
    this.timeline = timeline;
    this.time = timeline.start;
    this.speed = 1;
    this.isPlaying = false;
    this.last = undefined; // ms, of the frame before
  }

  seek(time) {
    this.time = this.timeline.clamp(time);
    this.#tell('time');
  }

  play() {
    if (this.isPlaying) return;
    if (this.time >= this.timeline.end) this.time = this.timeline.start;
    this.isPlaying = true;
    this.last = undefined;
    this.#tell('state');
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.#tell('state');
  }

  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  /** To the begin of another block: +1 the next one; -1 that of this one, or the one before it. */
  step(direction) {
    this.pause();
    const { timeline } = this;
    const block = timeline.blockAt(this.time);
    if (block < 0) return;
    const begin = timeline.timeOfBlock(block);
    const isInside = this.time > begin + 1e-9;
    const back = isInside ? begin : timeline.timeOfBlock(Math.max(block - 1, 0));
    this.seek(direction > 0 ? timeline.timeOfBlock(block + 1) : back);
  }

  /** What passed since the frame before, `now` in ms. */
  frame(now) {
    if (!this.isPlaying) return;
    const passed = this.last === undefined ? 0 : (now - this.last) / 1000;
    this.last = now;
    this.seek(this.time + passed * this.speed);
    if (this.time >= this.timeline.end) this.pause();
  }

  #tell(what) {
    this.dispatchEvent(new Event(what));
  }
}
