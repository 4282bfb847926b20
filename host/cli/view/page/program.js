// The text of the program: only the lines in view are elements, so that a million lines cost no more than a hundred.

const rowHeight = 21;
const tallest = 8e6;  // px; browsers do not scroll much further

const severityOrder = ['error', 'warning', 'note'];

export class ProgramList {
  // `choose(file, line)` is called when a person picks a line.
  constructor(elements, texts, choose) {
    Object.assign(this, elements);
    this.texts = texts;
    this.choose = choose;
    this.file = 0;
    this.chosen = 0;
    this.current = 0;
    this.wanted = '';
    this.found = [];
    this.signs = texts.map(() => new Map());
    this.moving = texts.map((text) => new Uint8Array(text.lines + 1));
    this.list.addEventListener('scroll', () => this.#draw());
    this.list.addEventListener('keydown', (event) => this.#onKey(event));
    this.rows.addEventListener('click', (event) => this.#onClick(event));
    new ResizeObserver(() => this.#draw()).observe(this.list);
    this.search.addEventListener('input', () => this.#find());
    this.search.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.step(event.shiftKey ? -1 : 1);
    });
    this.foundBefore.addEventListener('click', () => this.step(-1));
    this.foundNext.addEventListener('click', () => this.step(1));
    this.select.hidden = texts.length < 2;
    this.select.append(...texts.map((text, i) => new Option(text.name, i)));
    this.select.addEventListener('change', () => this.open(Number(this.select.value)));
    this.open(0);
  }

  // A sign before a line: a severity, or 'apart' for a difference. The gravest one is shown.
  mark(file, line, kind, title) {
    const signs = this.signs[file], before = signs?.get(line);
    if (!signs) return;
    const isGraver = !before || severityOrder.indexOf(kind) < severityOrder.indexOf(before.kind);
    signs.set(line, { kind: isGraver ? kind : before.kind, title: before ? `${before.title}\n${title}` : title });
  }

  open(file) {
    if (file >= this.texts.length) return;
    this.file = file;
    this.select.value = file;
    this.chosen = 0;
    this.height.style.height = `${Math.min(tallest, this.#lines * rowHeight)}px`;
    this.list.scrollTop = 0;
    this.#find();
  }

  show(file, line) {
    if (file !== this.file) this.open(file);
    this.chosen = line;
    this.#scrollTo(line);
    this.#draw();
  }

  // The line whose move is under way; the list follows it.
  follow(file, line, scrolls) {
    if (file !== this.file) {
      if (!scrolls) return;
      this.open(file);
    }
    if (line === this.current) return;
    this.current = line;
    if (scrolls) this.#scrollTo(line);
    this.#draw();
  }

  step(by) {
    if (!this.found.length) return;
    const next = by > 0 ? this.found.findIndex((line) => line > this.chosen) : this.found.findLastIndex((line) => line < this.chosen);
    const at = next >= 0 ? next : by > 0 ? 0 : this.found.length - 1;
    this.choose(this.file, this.found[at]);
    this.#tellFound(at);
  }

  get #lines() { return this.texts[this.file].lines; }
  get #visible() { return Math.ceil(this.list.clientHeight / rowHeight); }
  get #isTooTall() { return this.#lines * rowHeight > tallest; }

  #firstVisible() {
    if (!this.#isTooTall) return Math.floor(this.list.scrollTop / rowHeight);
    const part = this.list.scrollTop / (this.list.scrollHeight - this.list.clientHeight);
    return Math.round(part * (this.#lines - this.#visible + 1));
  }

  #scrollTo(line) {
    const first = this.#firstVisible();
    if (line > first + 1 && line < first + this.#visible - 1) return;
    const wanted = Math.max(0, line - 1 - Math.floor(this.#visible / 3));
    const scale = (this.list.scrollHeight - this.list.clientHeight) / Math.max(1, this.#lines - this.#visible + 1);
    this.list.scrollTop = this.#isTooTall ? wanted * scale : wanted * rowHeight;
  }

  #draw() {
    const first = this.#firstVisible(), count = Math.min(this.#visible + 1, this.#lines - first);
    this.rows.style.transform = this.#isTooTall ? '' : `translateY(${-(this.list.scrollTop % rowHeight)}px)`;
    while (this.rows.childElementCount > count) this.rows.lastElementChild.remove();
    while (this.rows.childElementCount < count) this.rows.append(newRow());
    for (let i = 0; i < count; ++i) this.#fill(this.rows.children[i], first + i + 1);
  }

  #fill(row, line) {
    const [number, sign, text] = row.children, mark = this.signs[this.file].get(line);
    row.dataset.line = line;
    row.setAttribute('aria-selected', line === this.chosen);
    row.className = `line${line === this.chosen ? ' chosen' : ''}${line === this.current ? ' current' : ''}` +
      `${this.moving[this.file][line] ? '' : ' idle'}`;
    number.textContent = line;
    sign.className = `sign ${mark?.kind ?? ''}`;
    sign.textContent = mark ? (mark.kind === 'apart' ? '≠' : '●') : '';
    row.title = mark?.title ?? '';
    this.#fillText(text, this.texts[this.file].text(line));
  }

  #fillText(element, text) {
    const at = this.wanted ? text.toLowerCase().indexOf(this.wanted) : -1;
    if (at < 0) {
      element.textContent = text;
      return;
    }
    const hit = document.createElement('mark');
    hit.textContent = text.slice(at, at + this.wanted.length);
    element.replaceChildren(text.slice(0, at), hit, text.slice(at + this.wanted.length));
  }

  #onClick(event) {
    const row = event.target.closest('.line');
    if (row) this.choose(this.file, Number(row.dataset.line));
  }

  #onKey(event) {
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: this.#visible - 1, PageUp: 1 - this.#visible }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    this.choose(this.file, Math.max(1, Math.min(this.#lines, (this.chosen || this.current || 1) + by)));
  }

  #find() {
    const most = 100000;
    this.wanted = this.search.value.toLowerCase();
    this.found = this.wanted ? this.texts[this.file].find(this.wanted, most) : [];
    this.#tellFound(-1);
    this.#draw();
  }

  #tellFound(at) {
    this.tell.textContent = !this.wanted ? '' : at < 0 ? `${this.found.length}` : `${at + 1}/${this.found.length}`;
  }
}

const newRow = () => {
  const row = document.createElement('div');
  row.setAttribute('role', 'option');
  for (const name of ['number', 'sign', 'text']) {
    const cell = document.createElement('span');
    cell.className = name;
    row.append(cell);
  }
  return row;
};
