// The path in three dimensions. It is drawn when something has changed, and not otherwise.
import {
  BufferAttribute, BufferGeometry, Color, CylinderGeometry, DirectionalLight, Group, HemisphereLight,
  LineBasicMaterial, LineDashedMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from './OrbitControls.js';
import { LineMaterial } from './LineMaterial.js';
import { LineSegments2 } from './LineSegments2.js';
import { LineSegmentsGeometry } from './LineSegmentsGeometry.js';
import { coarseLinesOf, linesOf, positionsOf } from './lines.js';

const directions = { iso: [1, -1, 0.85], top: [0, -1e-4, 1], front: [0, -1, 0], right: [1, 0, 0] };
const mostLit = 5000;
// What a processor without a graphics card draws thirty times a second, and what any graphics card does.
const mostInSoftware = 9000, mostInHardware = 3000000;
const up = new Vector3(0, 0, 1);

// 1, 2 or 5 times a power of ten.
const roundLength = (length) => {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * (length / power >= 5 ? 5 : length / power >= 2 ? 2 : 1);
};

// A pair of objects: what is done, and pale what lies ahead.
class DrawnLines {
  constructor(segments, material, palerMaterial) {
    this.segments = segments;
    this.done = this.#add(material, 1);
    this.ahead = this.#add(palerMaterial, 0);
    this.drawnTo = 0;
  }

  #add(material, order) {
    const geometry = new BufferGeometry(), { attributes } = this.segments.geometry;
    for (const name of Object.keys(attributes)) geometry.setAttribute(name, attributes[name]);
    const object = new LineSegments(geometry, material);
    object.frustumCulled = false;
    object.renderOrder = order;
    return object;
  }

  // Everything before `move`; or only what has been added since the last time.
  set(move, isShown, showsAhead, isMore) {
    const behind = this.segments.behind(move), from = isMore ? Math.min(this.drawnTo, behind) : 0;
    this.done.geometry.setDrawRange(2 * from, 2 * (behind - from));
    this.done.visible = isShown && behind > from;
    this.ahead.geometry.setDrawRange(2 * behind, 2 * (this.segments.count - behind));
    this.ahead.visible = isShown && showsAhead && !isMore && this.segments.count > behind;
    this.drawnTo = behind;
  }
  hide() { this.done.visible = this.ahead.visible = false; }
  dispose() {
    this.done.removeFromParent();
    this.ahead.removeFromParent();
    this.done.geometry.dispose();
    this.ahead.geometry.dispose();
  }
}

// One path with its lines, and in a scene above it the tool and what is lit up.
class PathScene {
  constructor(path, look, mostCoarse) {
    this.path = path;
    this.look = look;
    this.mostCoarse = mostCoarse;
    this.scene = new Scene();
    this.above = new Scene();
    this.part = new Group();
    this.partAbove = new Group();
    for (const part of [this.part, this.partAbove]) part.matrixAutoUpdate = false;
    this.scene.add(this.part);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(1, -1, 2);
    this.above.add(this.partAbove, new HemisphereLight(0xffffff, 0x556070, 2.4), sun);
    const { low, high } = path;
    this.low = low;
    this.high = high;
    this.size = Math.max(Math.hypot(...high.map((value, i) => value - low[i])), 1e-3);
    this.#addGrid();
    this.#addTool();
    this.lit = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: 4 }));
    this.lit.visible = false;
    this.lit.frustumCulled = false;
    this.partAbove.add(this.lit);
    this.#makeMaterials();
    this.rebuild();
  }

  #makeMaterials() {
    const pale = { transparent: true, opacity: 0.2, depthWrite: false };
    const dashes = { dashSize: this.size / 120, gapSize: this.size / 150, vertexColors: true };
    this.materials = {
      feeds: [new LineBasicMaterial({ vertexColors: true }), new LineBasicMaterial({ vertexColors: true, ...pale })],
      rapids: [new LineDashedMaterial(dashes), new LineDashedMaterial({ ...dashes, ...pale })],
    };
  }

  // After another choice of tools, or of colours.
  rebuild() {
    for (const drawn of [...Object.values(this.fine ?? {}), ...Object.values(this.coarse ?? {})]) drawn.dispose();
    this.fine = this.#draw(linesOf(this.path, this.look));
    this.coarse = null;
    this.lit.material.color = new Color(this.look.colour('--lit'));
    this.grid.material.color = new Color(this.look.colour('--grid'));
    this.tool.children.forEach((mesh) => { mesh.material.color = new Color(this.look.colour('--tool')); });
    this.setTime(this.time ?? Infinity);
  }

  #draw(lines) {
    const out = {};
    for (const name of ['feeds', 'rapids']) {
      out[name] = new DrawnLines(lines[name], ...this.materials[name]);
      this.part.add(out[name].done, out[name].ahead);
    }
    return out;
  }

  get isHeavy() { return this.fine.feeds.segments.count + this.fine.rapids.segments.count > this.mostCoarse; }

  #addGrid() {
    const step = roundLength(this.size / 12), points = [], z = this.low[2];
    const middle = this.path.origin;
    const below = (i) => Math.floor((this.low[i] + middle[i]) / step - 0.6) * step - middle[i];
    const above = (i) => Math.ceil((this.high[i] + middle[i]) / step + 0.6) * step - middle[i];
    const [left, right, front, back] = [below(0), above(0), below(1), above(1)];
    for (let x = left; x <= right + step / 2; x += step) points.push(x, front, z, x, back, z);
    for (let y = front; y <= back + step / 2; y += step) points.push(left, y, z, right, y, z);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    this.grid = new LineSegments(geometry, new LineBasicMaterial());
    this.grid.renderOrder = -1;
    this.grid.material.depthWrite = false;
    this.part.add(this.grid);
  }

  // A cylinder above its tip, along Z; the shank is thinner and paler.
  #addTool() {
    this.tool = new Group();
    const add = (radiusTop, radius, from, to, opacity) => {
      const geometry = new CylinderGeometry(radiusTop, radius, to - from, 28).rotateX(Math.PI / 2).translate(0, 0, (from + to) / 2);
      this.tool.add(new Mesh(geometry, new MeshLambertMaterial({ transparent: true, opacity })));
    };
    add(1, 1, 0.35, 3, 0.85);
    add(1, 0.3, 0, 0.35, 0.95);
    add(0.72, 0.72, 3, 8, 0.45);
    this.tool.visible = false;
    this.partAbove.add(this.tool);
  }

  // Everything up to this time is done.
  setTime(time) {
    this.time = time;
    const { path } = this, place = this.place = path.placeAt(Math.min(time, path.totalSeconds));
    this.doneTo = !place || time >= path.totalSeconds ? path.moves : place.move + 1;
    this.#placeTool(place);
    this.#turn(place);
  }

  // Prepares the lines for drawing. `way`: 'all', 'coarse', or 'more': what has been done since the last time.
  prepare(way) {
    if (way === 'coarse' && !this.coarse) {
      const { feeds, rapids } = this.fine;
      this.coarse = this.#draw(coarseLinesOf({ feeds: feeds.segments, rapids: rapids.segments }, this.size, this.mostCoarse / 2));
    }
    const [used, other] = way === 'coarse' ? [this.coarse, this.fine] : [this.fine, this.coarse];
    other?.feeds.hide();
    other?.rapids.hide();
    used.feeds.set(this.doneTo, true, this.look.showsAhead, way === 'more');
    used.rapids.set(this.doneTo, this.look.showsRapids, this.look.showsAhead, way === 'more');
    this.grid.visible = way !== 'more';
  }

  #placeTool(place) {
    this.tool.visible = place !== null;
    if (!place) return;
    const known = this.path.tools[this.path.tool(place.move)].radius;
    const radius = Math.min(known > 0 ? known : this.size / 70, this.size / 4);
    this.tool.position.set(...place.at);
    this.tool.scale.set(radius, radius, Math.max(radius, this.size / 60));
    this.tool.quaternion.setFromUnitVectors(up, new Vector3(...place.axis).normalize());
  }

  // The tables turn the part: outer · zero · inner, about the middle of the path.
  #turn(place) {
    const kinematics = this.path.kinematics;
    const matrix = this.part.matrix.identity();
    this.turns = Boolean(kinematics && this.look.turnsPart && place);
    if (this.turns) {
      const middle = new Vector3(...this.path.origin);
      const about = (table) => {
        const point = new Vector3(...table.point), angle = place.angles[table.axis] * Math.PI / 180;
        const turn = new Matrix4().makeRotationAxis(new Vector3(...table.direction), angle);
        return new Matrix4().makeTranslation(point).multiply(turn).multiply(new Matrix4().makeTranslation(point.negate()));
      };
      const [outer, inner] = kinematics.tables;
      matrix.makeTranslation(middle.clone().negate());
      if (outer) matrix.multiply(about(outer));
      matrix.multiply(new Matrix4().fromArray(kinematics.zero));
      if (inner) matrix.multiply(about(inner));
      matrix.multiply(new Matrix4().makeTranslation(middle));
    }
    this.partAbove.matrix.copy(matrix);
    this.part.matrixWorldNeedsUpdate = this.partAbove.matrixWorldNeedsUpdate = true;
  }

  light(moves) {
    const positions = positionsOf(this.path, moves, mostLit);
    this.lit.visible = positions.length > 0;
    if (!this.lit.visible) return;
    this.lit.geometry.dispose();
    this.lit.geometry = new LineSegmentsGeometry().setPositions(positions);
  }

  // The nearest move to a spot of the canvas, of those that are drawn; `toSpot` maps a point to the canvas.
  pick(toSpot, spot, reach) {
    let best = { distance: reach, depth: Infinity, move: -1 };
    for (const name of this.look.showsRapids ? ['feeds', 'rapids'] : ['feeds']) {
      const { segments } = this.fine[name];
      const p = segments.positions, a = [0, 0, 0], b = [0, 0, 0];
      const count = segments.behind(this.doneTo);
      for (let i = 0; i < count; ++i) {
        toSpot(p, 6 * i, a);
        toSpot(p, 6 * i + 3, b);
        if (a[2] > 1 || b[2] > 1) continue;
        const x = b[0] - a[0], y = b[1] - a[1], length = x * x + y * y;
        const part = length > 0 ? Math.max(0, Math.min(1, ((spot[0] - a[0]) * x + (spot[1] - a[1]) * y) / length)) : 0;
        const distance = Math.hypot(a[0] + part * x - spot[0], a[1] + part * y - spot[1]);
        const depth = a[2] + (b[2] - a[2]) * part;
        if (distance < best.distance - 1 || (distance < best.distance + 1 && depth < best.depth))
          best = { distance: Math.min(distance, best.distance), depth, segment: i, segments };
      }
    }
    if (best.segments) best.move = best.segments.moveOf(best.segment);
    return best;
  }
}

// Whether a processor draws, without a graphics card.
const isSoftware = (renderer) => {
  const gl = renderer.getContext(), names = gl.getExtension('WEBGL_debug_renderer_info');
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
};

export class Stage {
  // `above`: a canvas over the other, for the tool and what is lit up. The lines below stay as they are while those move.
  constructor(canvas, above, paths, looks) {
    this.canvas = canvas;
    this.look = looks[0];
    const isSmall = paths.reduce((sum, path) => sum + path.points, 0) < 2 * mostInSoftware;
    this.renderer = new WebGLRenderer({ canvas, antialias: isSmall, preserveDrawingBuffer: true });
    const drawsInSoftware = isSoftware(this.renderer);
    this.rendererAbove = new WebGLRenderer({ canvas: above, antialias: isSmall || !drawsInSoftware, alpha: true });
    this.renderer.autoClear = this.rendererAbove.autoClear = false;
    this.camera = new PerspectiveCamera(26, 1, 0.1, 1000);
    this.camera.up.copy(up);
    const most = (drawsInSoftware ? mostInSoftware : mostInHardware) / paths.length;
    this.paths = paths.map((path, i) => new PathScene(path, looks[i], most));
    this.size = Math.max(...this.paths.map((path) => path.size));
    this.controls = new OrbitControls(this.camera, above);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.#isMoving());
    this.afterRender = () => {};
    this.frames = 0;
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.#resize();
    this.show('iso');
  }

  // While the view moves, coarse lines are enough; a moment later all of them are drawn.
  #isMoving() {
    clearTimeout(this.settles);
    this.moves = true;
    this.settles = setTimeout(() => {
      this.moves = false;
      this.request('all');
    }, 200);
    this.request('all');
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    for (const renderer of [this.renderer, this.rendererAbove]) {
      renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
      renderer.setSize(width, height, false);
    }
    this.camera.aspect = width / this.paths.length / height;
    if (this.shown) this.show(this.shown);
    this.request('all');
  }

  show(name) {
    this.shown = name;
    const tangent = Math.tan(this.camera.fov * Math.PI / 360);
    const direction = new Vector3(...directions[name]).normalize();
    const middle = new Vector3(...[0, 1, 2].map((i) =>
      (Math.min(...this.paths.map((path) => path.low[i])) + Math.max(...this.paths.map((path) => path.high[i]))) / 2));
    this.controls.target.copy(middle);
    this.camera.position.copy(direction);
    this.camera.lookAt(0, 0, 0);
    this.camera.updateMatrixWorld();
    const turn = this.camera.quaternion.clone().invert();
    // How far away the corners of the path fill the view, and no more.
    let distance = 0;
    for (const { low, high } of this.paths)
      for (let corner = 0; corner < 8; ++corner) {
        const p = new Vector3(...low.map((value, i) => (corner >> i & 1 ? high[i] : value))).sub(middle).applyQuaternion(turn);
        distance = Math.max(distance, Math.abs(p.x) / (tangent * this.camera.aspect) + p.z, Math.abs(p.y) / tangent + p.z);
      }
    distance = 1.15 * Math.max(distance, this.size / 10);
    this.camera.position.copy(direction).multiplyScalar(distance).add(middle);
    this.camera.near = this.size / 200;
    this.camera.far = 60 * this.size;
    this.controls.minDistance = this.size / 1000;
    this.controls.maxDistance = 20 * this.size;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.#isMoving();
  }

  // `what`: 'all', 'more' (of the path is done, and nothing else has changed) or 'above'.
  request(what) {
    const order = ['above', 'more', 'all'];
    if (!this.wanted || order.indexOf(what) > order.indexOf(this.wanted)) this.wanted = what;
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.render();
    });
  }

  // At once, what has been requested.
  render() {
    const wanted = this.wanted ?? 'above';
    this.wanted = null;
    if (!this.canvas.clientWidth || !this.canvas.clientHeight) return;
    if (wanted !== 'above') this.#renderLines(wanted);
    this.rendererAbove.setClearColor(0, 0);
    this.#renderSides(this.rendererAbove, (path) => path.above, true);
    this.canvas.dataset.frames = ++this.frames;
    this.afterRender();
  }

  #renderLines(wanted) {
    this.renderer.setClearColor(this.look.colour('--scene'));
    for (const path of this.paths) path.prepare(wanted === 'all' && this.moves && path.isHeavy ? 'coarse' : wanted);
    this.#renderSides(this.renderer, (path) => path.scene, wanted === 'all');
  }

  #renderSides(renderer, sceneOf, clears) {
    const { clientWidth: width, clientHeight: height } = this.canvas, count = this.paths.length;
    renderer.setScissorTest(count > 1);
    this.paths.forEach((path, i) => {
      const left = Math.round(i * width / count), right = Math.round((i + 1) * width / count);
      renderer.setViewport(left, 0, right - left, height);
      renderer.setScissor(left, 0, right - left, height);
      if (clears) renderer.clear();
      renderer.render(sceneOf(path), this.camera);
    });
  }

  // Going on in time only adds to what is drawn; going back, or turning the part, draws it anew.
  setTimes(times) {
    const before = this.paths.map((path) => path.doneTo);
    this.paths.forEach((path, i) => path.setTime(times[i]));
    const goesOn = this.paths.every((path, i) => path.doneTo >= before[i] && !path.turns);
    if (!goesOn) this.#isMoving();
    else this.request(this.moves ? 'all' : 'more');
  }
  rebuild() {
    this.paths.forEach((path) => path.rebuild());
    this.request('all');
  }
  light(movesOfPaths) {
    this.paths.forEach((path, i) => path.light(movesOfPaths[i] ?? []));
    this.request('above');
  }

  // From coordinates of a path to the canvas, in px, with the depth.
  #mapping(index) {
    const { clientWidth, clientHeight: height } = this.canvas, width = clientWidth / this.paths.length;
    this.camera.updateMatrixWorld();
    const part = this.paths[index].part;
    const m = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse)
      .multiply(part.matrix).elements;
    return (p, i, out) => {
      const x = p[i], y = p[i + 1], z = p[i + 2], w = m[3] * x + m[7] * y + m[11] * z + m[15];
      out[0] = index * width + (0.5 + 0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12]) / w) * width;
      out[1] = (0.5 - 0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * height;
      out[2] = w > 0 ? (m[2] * x + m[6] * y + m[10] * z + m[14]) / w : 2;
      return out;
    };
  }

  pick(x, y) {
    const index = Math.min(this.paths.length - 1, Math.floor(x / (this.canvas.clientWidth / this.paths.length)));
    const { move } = this.paths[index].pick(this.#mapping(index), [x, y], 12);
    return move < 0 ? null : { path: index, move };
  }

  // Where the middle of a move is on the canvas.
  spotOf(index, move) {
    const path = this.paths[index].path;
    const at = 3 * (path.first[move] + (path.segments[move] >> 1)), p = path.xyz;
    const k = path.segments[move] === 1 ? [0, 1, 2].map((i) => (p[at + i] + p[at + 3 + i]) / 2) : [0, 1, 2].map((i) => p[at + i]);
    return this.#mapping(index)(k, 0, [0, 0, 0]);
  }

  // Where the tip of the tool is in the machine, and the direction of the tool there.
  tipInMachine(index) {
    const { path, place, partAbove } = this.paths[index];
    return new Vector3(...place.at).applyMatrix4(partAbove.matrix).add(new Vector3(...path.origin)).toArray();
  }
  toolInMachine(index) {
    const { place, partAbove } = this.paths[index];
    return new Vector3(...place.axis).transformDirection(partAbove.matrix).toArray();
  }

  // The directions of X Y Z on the canvas.
  compass() {
    const turn = this.camera.quaternion.clone().invert();
    return [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => new Vector3(...axis).applyQuaternion(turn).toArray());
  }
}
