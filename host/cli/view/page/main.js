// Puts the page together: the path, the program, the time, and what a click on one shows of the others.
import { readData } from './data.js';
import { ProgramList } from './program.js';
import { Stage } from './scene.js';
import { Timeline } from './timeline.js';
import {
  duration, element, explanationElements, explanationOf, fillDifferences, fillReports, fillTools, kinematicsText, number,
  timesText, toolName,
} from './panels.js';

const by = (id) => document.getElementById(id);
const dark = matchMedia('(prefers-color-scheme: dark)');

class Page {
  constructor({ facts, paths, texts }) {
    this.facts = facts;
    this.paths = paths;
    this.hidden = paths.map(() => new Set());
    this.#fillHeader();
    this.#makeStage();
    this.list = new ProgramList({
      list: by('lines'), rows: by('lines-shown'), height: by('lines-height'), select: by('file'), search: by('search'),
      tell: by('found'), foundBefore: by('found-before'), foundNext: by('found-next'),
    }, texts, (file, line) => this.choose(file, line));
    this.#markLines();
    this.#fillPanels();
    this.timeline = new Timeline({
      slider: by('slider'), playButton: by('play'), beforeButton: by('before'), nextButton: by('next'), clock: by('clock'),
      speed: by('speed'),
    }, this.#longest(), (time) => this.showTo(time));
    this.#listen();
  }

  #longest() {
    return this.paths.reduce((a, b) => b.totalSeconds > a.totalSeconds ? b : a);
  }

  #fillHeader() {
    const { facts, paths } = this;
    document.title = `${facts.program === '-' ? 'standard input' : facts.program} – Isogloss`;
    by('program').textContent = facts.program === '-' ? 'standard input' : facts.program;
    by('dialects').append(...paths.map((path) => element('b', { textContent: path.dialect })));
    if (paths.length > 1) by('names').append(...paths.map((path) => element('b', { textContent: path.dialect })));
    const path = paths[0];
    const sizes = path.isEmpty ? 'moves nothing' : ['X', 'Y', 'Z']
      .map((axis, i) => `${axis} ${number(path.minimum[i], 1)} … ${number(path.maximum[i], 1)}`).join('   ') + ' mm';
    by('facts-of-run').textContent = `${sizes}   ${path.moves.toLocaleString('en-US')} moves   ${duration(path.totalSeconds)}`;
  }

  #makeStage() {
    const page = this;
    const style = getComputedStyle(document.documentElement);
    this.looks = this.paths.map((_, side) => ({
      shows: (tool) => !page.hidden[side].has(tool),
      get showsRapids() { return by('rapids').checked; },
      get showsAhead() { return by('ahead').checked; },
      get turnsPart() { return by('turning').checked; },
      get isDark() { return dark.matches; },
      colour: (name) => style.getPropertyValue(name).trim(),
    }));
    this.stage = new Stage(by('canvas'), by('above'), this.paths, this.looks);
    this.stage.afterRender = () => this.#drawCompass();
  }

  // Which lines move, and which have something to tell.
  #markLines() {
    for (const path of this.paths)
      for (let i = 0; i < path.moves; ++i) this.list.moving[path.file(i)][path.line[i]] = 1;
    for (const report of this.facts.diagnostics)
      if (report.file !== null && report.line) this.list.mark(report.file, report.line, report.severity, report.message);
    for (const one of this.facts.differences) this.list.mark(one.file, one.line, 'apart', one.what);
  }

  #fillPanels() {
    const { facts, paths } = this, choose = (file, line) => {
      this.#openTab('program');
      this.choose(file, line);
    };
    fillTools(by('tools'), paths, dark.matches, (side, tool, isShown) => {
      if (isShown) this.hidden[side].delete(tool); else this.hidden[side].add(tool);
      this.stage.rebuild();
    });
    fillReports(by('reports'), facts, choose);
    fillDifferences(by('differences'), facts, choose);
    const count = (severity) => facts.diagnostics.filter((report) => report.severity === severity).length;
    by('reports-count').textContent = facts.reported || '';
    by('reports-count').className = count('error') ? 'error' : count('warning') ? 'warning' : '';
    by('differences-count').textContent = facts.differences.length;
    document.querySelector('[data-tab="differences"]').hidden = paths.length < 2;
    by('times').textContent = timesText(paths[0]);
    by('kinematics').textContent = kinematicsText(paths[0]);
    const hasTables = paths.some((path) => path.kinematics?.tables.length && path.turnsAxes);
    by('turning').disabled = !hasTables;
    by('turning').closest('label').hidden = !paths.some((path) => path.turnsAxes);
  }

  #openTab(name) {
    for (const tab of document.querySelectorAll('[role="tab"]')) tab.setAttribute('aria-selected', tab.dataset.tab === name);
    for (const panel of document.querySelectorAll('.panel')) panel.hidden = panel.dataset.panel !== name;
  }

  #listen() {
    for (const tab of document.querySelectorAll('[role="tab"]'))
      tab.addEventListener('click', () => this.#openTab(tab.dataset.tab));
    for (const button of document.querySelectorAll('[data-camera]'))
      button.addEventListener('click', () => this.stage.show(button.dataset.camera));
    for (const id of ['rapids', 'ahead', 'turning'])
      by(id).addEventListener('change', () => {
        this.showTo(this.timeline.time);
        this.stage.request('all');
      });
    dark.addEventListener('change', () => this.stage.rebuild());
    this.#listenToCanvas();
    addEventListener('keydown', (event) => {
      if (event.target.closest('input, select, button') || event.ctrlKey || event.metaKey) return;
      const action = { ' ': () => this.timeline.toggle(), ArrowLeft: () => this.timeline.step(-1), ArrowRight: () => this.timeline.step(1) }[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    });
  }

  // A click is a press that has not become a turn of the view.
  #listenToCanvas() {
    const canvas = by('above');
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => { pressed = [event.offsetX, event.offsetY]; });
    canvas.addEventListener('pointerup', (event) => {
      const hasMoved = !pressed || Math.hypot(event.offsetX - pressed[0], event.offsetY - pressed[1]) > 4;
      pressed = null;
      if (hasMoved) return;
      const hit = this.stage.pick(event.offsetX, event.offsetY);
      if (hit) this.chooseMove(hit.path, hit.move);
    });
  }

  chooseMove(side, move) {
    const path = this.paths[side];
    this.#openTab('program');
    this.choose(path.file(move), path.line[move], { side, move });
  }

  // Lights up the moves of a line and says what the line does.
  async choose(file, line, hit = null) {
    this.list.show(file, line);
    this.stage.light(this.paths.map((path) => movesOf(path, file, line)));
    if (hit) this.#tellMove(hit);
    const asked = this.asked = `${file}:${line}`;
    const sentences = await Promise.all(this.paths.map((_, side) =>
      explanationOf(this.facts, side, file, line).catch(() => 'The command that served this page does not answer.')));
    if (asked !== this.asked) return;
    by('explanation').replaceChildren(...explanationElements(this.facts, file, line, sentences));
    this.list.show(file, line);  // the explanation may have covered it
  }

  #tellMove({ side, move }) {
    const path = this.paths[side], place = path.placeAt(path.begin[move + 1] - 1e-9);
    if (place) by('readout').textContent = this.#placeText(path, { ...place, move });
  }

  showTo(time) {
    this.stage.setTimes(this.paths.map((path) => path === this.#longest() ? time
      : time * path.totalSeconds / (this.#longest().totalSeconds || 1)));
    const path = this.paths[0], place = this.stage.paths[0].place;
    by('readout').textContent = place ? this.#placeText(path, place) : 'The program moves nothing.';
    if (place) this.list.follow(path.file(place.move), path.line[place.move], this.timeline?.isPlaying ?? false);
  }

  #placeText(path, place) {
    const axes = place.at.map((value, i) => `${'XYZ'[i]} ${number(value + path.origin[i]).padStart(8)}`);
    if (path.turnsAxes) place.angles.forEach((angle, i) => { if (angle || path.kinematics?.axes.includes('ABC'[i])) axes.push(`${'ABC'[i]} ${number(angle, 2).padStart(7)}`); });
    const kind = ['rapid', 'feed', 'arc', 'dwell'][path.kind(place.move)], feed = path.feed[place.move];
    return `${axes.join('  ')}\n${toolName(path.tools[path.tool(place.move)])}, ${kind}` +
      `${feed > 0 ? ` F ${number(feed * 60, 0)} mm/min` : ''}, line ${path.line[place.move]}`;
  }

  #drawCompass() {
    const svg = by('compass'), namespace = 'http://www.w3.org/2000/svg';
    if (!svg.childElementCount)
      for (const axis of ['x', 'y', 'z']) {
        const group = document.createElementNS(namespace, 'g');
        group.setAttribute('class', axis);
        group.append(document.createElementNS(namespace, 'line'), document.createElementNS(namespace, 'text'));
        group.lastChild.textContent = axis.toUpperCase();
        svg.append(group);
      }
    this.stage.compass().forEach(([x, y], i) => {
      const [line, text] = svg.children[i].children;
      line.setAttribute('x2', 24 * x);
      line.setAttribute('y2', -24 * y);
      text.setAttribute('x', 33 * x);
      text.setAttribute('y', -33 * y);
      svg.children[i].style.opacity = Math.hypot(x, y) < 0.1 ? 0 : 1;
    });
  }
}

const movesOf = (path, file, line) => {
  const out = [];
  for (let i = 0; i < path.moves; ++i) if (path.line[i] === line && path.file(i) === file) out.push(i);
  return out;
};

// A page that is served asks once a second whether there is a newer one.
const watchVersion = (facts) => {
  by('served').hidden = false;
  by('served').textContent = 'live';
  const ask = async () => {
    if (!document.hidden) await fetch('/version').then((answer) => answer.json()).then(({ version, failure }) => {
      by('served').textContent = failure || 'live';
      by('served').classList.toggle('fails', Boolean(failure));
      if (version !== facts.version && !failure) location.reload();
    }).catch(() => {
      by('served').textContent = 'the command has ended';
      by('served').classList.add('fails');
    });
    setTimeout(ask, 1000);
  };
  setTimeout(ask, 1000);
};

export const start = () => {
  const data = readData();
  const page = new Page(data);
  if (data.facts.version !== null) watchVersion(data.facts);
  globalThis.isogloss = page;  // for the console of a browser, and for tests
  requestAnimationFrame(() => setTimeout(() => {
    document.body.dataset.state = 'ready';
    document.body.dataset.openedAfter = Math.round(performance.now());
  }));
};
