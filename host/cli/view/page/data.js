// What the command has put into the page: facts as JSON, paths and texts as base64.

const bytesOf = (text) => {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
};

const take = (id) => {
  const element = document.getElementById(id);
  const text = element.textContent;
  element.remove();
  return text;
};

export const Kind = { rapid: 0, feed: 1, arc: 2, dwell: 3 };

// The path of one dialect: a column for each property of a move, and the points of all moves.
class ToolPath {
  constructor(facts, bytes) {
    Object.assign(this, facts);
    let at = 0;
    const column = (Type, length) => {
      const values = new Type(bytes.buffer, at, length);
      at += values.byteLength;
      return values;
    };
    this.xyz = column(Float32Array, 3 * facts.points);
    this.turns = facts.turnsAxes ? column(Float32Array, 6 * facts.points) : null;
    this.line = column(Uint32Array, facts.moves);
    this.seconds = column(Float32Array, facts.moves);
    this.feed = column(Float32Array, facts.moves);
    this.segments = column(Uint16Array, facts.moves);
    this.context = column(Uint16Array, facts.moves);
    this.flags = column(Uint8Array, facts.moves);
    this.#findPlaces();
    this.#findExtent();
  }

  // The first point of each move, and when it begins.
  #findPlaces() {
    this.first = new Uint32Array(this.moves + 1);
    this.begin = new Float64Array(this.moves + 1);
    let point = 0, time = 0;
    for (let i = 0; i < this.moves; ++i) {
      if (this.flags[i] & 4) ++point;
      this.first[i] = point;
      this.begin[i] = time;
      point += this.segments[i];
      time += this.seconds[i];
    }
    this.first[this.moves] = point;
    this.begin[this.moves] = time;
  }

  // Where the part is: the extent of all feeds, from the origin of the points; of all moves where nothing is fed.
  #findExtent() {
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.moves; ++i) {
      if (this.kind(i) !== Kind.feed && this.kind(i) !== Kind.arc) continue;
      for (let k = 3 * this.first[i], end = k + 3 * this.segments[i] + 3; k < end; ++k) {
        const value = this.xyz[k], axis = k % 3;
        if (value < this.low[axis]) this.low[axis] = value;
        if (value > this.high[axis]) this.high[axis] = value;
      }
    }
    if (this.low[0] <= this.high[0]) return;
    this.low = this.minimum.map((value, i) => value - this.origin[i]);
    this.high = this.maximum.map((value, i) => value - this.origin[i]);
  }

  kind(move) { return this.flags[move] & 3; }
  differs(move) { return (this.flags[move] & 8) !== 0; }
  isAssumed(move) { return (this.flags[move] & 16) !== 0; }
  tool(move) { return this.contexts[this.context[move]][0]; }
  file(move) { return this.contexts[this.context[move]][1]; }
  get totalSeconds() { return this.begin[this.moves]; }

  // The move under way at a time; -1 where there is none.
  moveAt(time) {
    let low = 0, high = this.moves - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.begin[middle] <= time) low = middle; else high = middle - 1;
    }
    return this.moves ? low : -1;
  }

  // The place on the path at a time: coordinates, the axis of the tool, the angles of A B C.
  placeAt(time) {
    const move = this.moveAt(time);
    if (move < 0) return null;
    const first = this.first[move], count = this.segments[move];
    const part = this.seconds[move] > 0 ? Math.min(1, (time - this.begin[move]) / this.seconds[move]) : 1;
    const lengths = [];
    let all = 0;
    for (let i = 0; i < count; ++i) lengths.push(all += this.#distance(first + i));
    let segment = all > 0 ? lengths.findIndex((length) => length >= part * all) : Math.floor(part * count);
    segment = Math.max(0, Math.min(segment, count - 1));
    const before = segment > 0 ? lengths[segment - 1] : 0;
    const length = count ? lengths[segment] - before : 0;
    const within = length > 0 ? (part * all - before) / length : all > 0 ? 1 : part * count - segment;
    return this.#between(move, first + segment, count ? first + segment + 1 : first, Math.min(1, Math.max(0, within)));
  }

  #distance(point) {
    const p = this.xyz, i = 3 * point;
    return Math.hypot(p[i + 3] - p[i], p[i + 4] - p[i + 1], p[i + 5] - p[i + 2]);
  }

  #between(move, a, b, part) {
    const mix = (values, width, i) => values[width * a + i] + (values[width * b + i] - values[width * a + i]) * part;
    const at = [0, 1, 2].map((i) => mix(this.xyz, 3, i));
    const turn = [0, 1, 2, 3, 4, 5].map((i) => this.turns ? mix(this.turns, 6, i) : i === 5 ? 1 : 0);
    return { move, at, angles: turn.slice(0, 3), axis: turn.slice(3) };
  }
}

// A program's bytes and where its lines begin; lines end with LF, CR or both, as in a run.
class ProgramText {
  #bytes;
  #lines;
  #decoder;
  #whole = null;

  constructor(name, bytes) {
    this.name = name;
    this.#bytes = bytes;
    this.#decoder = new TextDecoder(isUtf8(bytes) ? 'utf-8' : 'windows-1252');
    this.#lines = linesOf(bytes);
  }

  get lines() { return this.#lines.length; }
  text(line) {
    const begin = this.#lines[line - 1], end = line < this.lines ? this.#lines[line] : this.#bytes.length;
    return this.#decoder.decode(this.#bytes.subarray(begin, end)).replace(/[\r\n]+$/, '');
  }

  // The lines that hold a text, in any case of letters; at most `most` of them.
  find(text, most) {
    this.#whole ??= this.#decode();
    const wanted = text.toLowerCase(), found = [];
    let line = 1;
    for (let at = this.#whole.text.indexOf(wanted); at >= 0 && wanted; at = this.#whole.text.indexOf(wanted, at)) {
      line = lineAt(this.#whole.begins, at, line);
      found.push(line);
      if (found.length >= most || line >= this.lines) break;
      at = this.#whole.begins[line];
    }
    return found;
  }

  #decode() {
    const text = this.#decoder.decode(this.#bytes).toLowerCase();
    return { text, begins: linesOf(text) };
  }
}

const isUtf8 = (bytes) => {
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    return true;
  } catch {
    return false;
  }
};

const linesOf = (content) => {
  const code = typeof content === 'string' ? (i) => content.charCodeAt(i) : (i) => content[i];
  let begins = new Uint32Array(1024), count = 1;
  for (let i = 0; i < content.length; ++i) {
    const c = code(i);
    if (c !== 10 && c !== 13) continue;
    if (c === 13 && i + 1 < content.length && code(i + 1) === 10) ++i;
    if (i + 1 >= content.length) break;
    if (count === begins.length) {
      const grown = new Uint32Array(2 * count);
      grown.set(begins);
      begins = grown;
    }
    begins[count++] = i + 1;
  }
  return begins.subarray(0, count);
};

const lineAt = (begins, at, from) => {
  let low = from - 1, high = begins.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (begins[middle] <= at) low = middle; else high = middle - 1;
  }
  return low + 1;
};

export const readData = () => {
  const facts = JSON.parse(take('facts'));
  const paths = facts.paths.map((path, i) => new ToolPath(path, bytesOf(take(`path-${i}`))));
  const texts = facts.files.map((name, i) => new ProgramText(name, bytesOf(take(`text-${i}`))));
  return { facts, paths, texts };
};
