// The lines of a path as few buffers: feeds with a colour for each tool, rapids dashed. They stand in the order of the
// program, so that a range of a buffer is what has been done up to a move.
import { BufferAttribute, BufferGeometry, Color } from 'three';
import { Kind } from './data.js';

// A buffer of line segments in the order of the moves.
class Segments {
  constructor(positions, colours) {
    this.positions = positions;
    this.count = positions.length / 6;
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    this.geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
  }

  // How far each point is along its segment, for dashes.
  measure() {
    const p = this.positions, out = new Float32Array(2 * this.count);
    for (let i = 0; i < this.count; ++i) {
      const k = 6 * i;
      out[2 * i + 1] = Math.hypot(p[k + 3] - p[k], p[k + 4] - p[k + 1], p[k + 5] - p[k + 2]);
    }
    this.geometry.setAttribute('lineDistance', new BufferAttribute(out, 1));
    return this;
  }
}

// All segments of the moves that `holds` picks.
class AllSegments extends Segments {
  constructor(path, holds, colourOf) {
    const before = new Uint32Array(path.moves + 1);
    for (let i = 0; i < path.moves; ++i) before[i + 1] = before[i] + (holds(i) ? path.segments[i] : 0);
    const positions = new Float32Array(6 * before[path.moves]), colours = new Uint8Array(positions.length);
    for (let i = 0, to = 0; i < path.moves; ++i) {
      if (before[i + 1] === before[i]) continue;
      const colour = colourOf(i);
      for (let from = 3 * path.first[i]; to < 6 * before[i + 1]; from += 3)
        for (let j = 0; j < 6; ++j, ++to) {
          positions[to] = path.xyz[from + j];
          colours[to] = colour[j % 3];
        }
    }
    super(positions, colours);
    this.before = before;
    this.colours = colours;
  }

  // How many segments lie before a move.
  behind(move) { return this.before[move]; }
  moveOf(segment) { return lastNotAbove(this.before, segment, this.before.length - 2); }
}

// Fewer segments that look much the same while the view turns: each goes to the first point that is further away than
// `reach`, which grows until there are few enough.
class CoarseSegments extends Segments {
  constructor(all, reach, most) {
    let kept;
    do {
      kept = pick(all, reach);
      reach *= 1.6;
    } while (kept.length > 2 * most);
    const positions = new Float32Array(3 * kept.length), colours = new Uint8Array(positions.length);
    kept.forEach((vertex, i) => {
      positions.set(all.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
      colours.set(all.colours.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
    });
    super(positions, colours);
    this.all = all;
    this.ends = Uint32Array.from({ length: this.count }, (_, i) => kept[2 * i + 1] >> 1);
  }

  behind(move) {
    const wanted = this.all.behind(move);
    return wanted > 0 && this.count ? lastNotAbove(this.ends, wanted - 1, this.count - 1) + (this.ends[0] < wanted ? 1 : 0) : 0;
  }
}

// The vertices of a coarse path, two for each segment.
const pick = ({ positions: p, colours: c, count }, reach) => {
  const kept = [], limit = reach * reach;
  const isApart = (a, b) => p[3 * a] !== p[3 * b] || p[3 * a + 1] !== p[3 * b + 1] || p[3 * a + 2] !== p[3 * b + 2];
  const isOther = (a, b) => c[3 * a] !== c[3 * b] || c[3 * a + 1] !== c[3 * b + 1] || c[3 * a + 2] !== c[3 * b + 2];
  let begin = 0;
  for (let i = 0; i < count; ++i) {
    const end = 2 * i + 1, next = end + 1;
    const isLast = i + 1 === count || isApart(end, next) || isOther(end, next);
    const x = p[3 * end] - p[3 * begin], y = p[3 * end + 1] - p[3 * begin + 1], z = p[3 * end + 2] - p[3 * begin + 2];
    if (!isLast && x * x + y * y + z * z < limit) continue;
    kept.push(begin, end);
    begin = next;
  }
  return kept;
};

// The last place up to `high` whose value is not above the wanted one.
const lastNotAbove = (values, wanted, high) => {
  let low = 0;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= wanted) low = middle; else high = middle - 1;
  }
  return low;
};

const bytesOf = (colour) => {
  const c = new Color(colour);
  return [c.r, c.g, c.b].map((part) => Math.round(255 * part));
};

// `look`: which tools are shown, and the colours of the page.
export const linesOf = (path, look) => {
  const isShown = (i) => look.shows(path.tool(i));
  const tools = path.tools.map((tool) => bytesOf(tool.colour[look.isDark ? 1 : 0]));
  const apart = bytesOf(look.colour('--apart')), rapid = bytesOf(look.colour('--rapid'));
  const isFeed = (i) => path.kind(i) === Kind.feed || path.kind(i) === Kind.arc;
  const feeds = new AllSegments(path, (i) => isFeed(i) && isShown(i), (i) => path.differs(i) ? apart : tools[path.tool(i)]);
  const rapids = new AllSegments(path, (i) => path.kind(i) === Kind.rapid && isShown(i), (i) => path.differs(i) ? apart : rapid);
  return { feeds, rapids: rapids.measure() };
};

// The same with at most so many segments.
export const coarseLinesOf = ({ feeds, rapids }, size, most) => ({
  feeds: new CoarseSegments(feeds, size / 600, most), rapids: new CoarseSegments(rapids, size / 600, most).measure(),
});

// The segments of some moves, for what is lit up; at most `most`.
export const positionsOf = (path, moves, most) => {
  const out = [];
  for (const move of moves) {
    for (let k = 0; k < path.segments[move] && out.length < 6 * most; ++k) {
      const from = 3 * (path.first[move] + k);
      out.push(...path.xyz.subarray(from, from + 6));
    }
  }
  return out;
};
