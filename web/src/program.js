// program.js — the texts of the run: tabs, and the lines of one of them with the current one marked.
//
// Only the lines that can be seen are elements: a program may have a hundred thousand.

const kLineHeight = 21; // px, as in style.css
const kBeyond = 12; // lines above and below what is seen

export class ProgramPanel {
  constructor(root, run, { onLine }) {
    this.run = run;
    this.onLine = onLine;
    this.tabs = root.querySelector('[role=tablist]');
    this.list = root.querySelector('[role=listbox]');
    this.rows = this.list.querySelector('.rows');
    this.current = 0;
    this.text = -1;
    this.byUser = false; // a tab that was chosen stays
    run.texts.forEach((text, i) => this.#addTab(text, i));
    this.list.addEventListener('scroll', () => this.#draw());
    this.list.addEventListener('click', (event) => this.#click(event));
    new ResizeObserver(() => this.#draw()).observe(this.list);
    if (run.texts.length > 0) this.show(0);
    else this.rows.textContent = 'The page has no text of this program.';
  }

  show(text) {
    if (text === this.text || !this.run.texts[text]) return;
    this.text = text;
    [...this.tabs.children].forEach((tab, i) => {
      tab.setAttribute('aria-selected', String(i === text));
      tab.tabIndex = i === text ? 0 : -1;
    });
    const { lines, isCut } = this.run.texts[text];
    this.rows.style.height = `${(lines.length + (isCut ? 1 : 0)) * kLineHeight}px`;
    this.list.setAttribute('aria-label', this.run.texts[text].name);
    this.current = 0;
    this.list.scrollTop = 0;
    this.#draw();
  }

  /** Marks a line and brings it into sight. */
  mark(line) {
    if (line === this.current) return;
    this.current = line;
    const top = (line - 1) * kLineHeight;
    const { scrollTop, clientHeight } = this.list;
    const margin = Math.min(3 * kLineHeight, clientHeight / 4);
    if (line > 0 && (top < scrollTop + margin || top + kLineHeight > scrollTop + clientHeight - margin)) {
      this.list.scrollTop = Math.max(0, top - clientHeight / 2);
    }
    this.#draw();
  }

  #addTab(text, i) {
    const tab = document.createElement('button');
    tab.type = 'button';
    tab.setAttribute('role', 'tab');
    tab.setAttribute('aria-controls', this.list.id);
    tab.textContent = text.name.split('/').pop();
    tab.title = text.name;
    tab.addEventListener('click', () => {
      this.byUser = true;
      this.show(i);
      this.onLine(undefined);
    });
    this.tabs.append(tab);
  }

  #click(event) {
    const row = event.target.closest('[data-line]');
    if (row) this.onLine({ text: this.text, line: Number(row.dataset.line) });
  }

  #draw() {
    if (this.text < 0) return;
    const { lines, isCut } = this.run.texts[this.text];
    const first = Math.max(0, Math.floor(this.list.scrollTop / kLineHeight) - kBeyond);
    const count = Math.ceil((this.list.clientHeight || 600) / kLineHeight) + 2 * kBeyond;
    const last = Math.min(lines.length, first + count);
    const rows = [];
    for (let i = first; i < last; i++) rows.push(this.#row(i + 1, lines[i]));
    if (isCut && last === lines.length) rows.push(this.#note(lines.length));
    this.rows.replaceChildren(...rows);
    const marked = this.rows.querySelector('[aria-selected=true]');
    if (marked) this.list.setAttribute('aria-activedescendant', marked.id);
    else this.list.removeAttribute('aria-activedescendant');
  }

  #row(number, text) {
    const row = document.createElement('div');
    row.id = `line-${number}`;
    row.className = 'line';
    row.dataset.line = number;
    row.setAttribute('role', 'option');
    row.setAttribute('aria-selected', String(number === this.current));
    row.style.top = `${(number - 1) * kLineHeight}px`;
    const mark = document.createElement('span');
    mark.className = 'number';
    mark.textContent = number;
    const words = document.createElement('span');
    words.className = 'text';
    words.textContent = text;
    row.append(mark, words);
    return row;
  }

  #note(lines) {
    const note = document.createElement('div');
    note.className = 'line note';
    note.style.top = `${lines * kLineHeight}px`;
    note.textContent = 'The rest of the text has no room in this page.';
    return note;
  }
}
