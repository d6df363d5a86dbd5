// Drawing seams: the line that is being drawn, the one that is chosen, and the ways of all over the surface.
import { Ended } from '../engine.js';
import { proposeDarts, proposePanels } from './proposals.js';
import { loosened } from './simplify.js';

/** @typedef {import('../app.js').App} App */
/** @typedef {import('../project.js').Line} Line */
/** @typedef {import('../project.js').Point} Point */

const nearly = 0.03; // of the diagonal: how far from symmetric a model may be whose one half is taken for both

export class Seams {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** Points of the line that is being drawn; null where none is. @type {Point[] | null} */
    this.draft = null;
    this.chosen = -1;
    /** A line as it is while one of its points is dragged. @type {Line | null} */
    this.dragged = null;
    /** Ways over the surface, by the points they go through. @type {Map<string, Float64Array>} */
    this.paths = new Map();
    this.isTracing = false;
    /** What the lines still lack to cut. */
    this.hint = '';
    /** Null where it is not known. @type {import('../engine.js').Symmetry | null} */
    this.symmetry = null;
  }

  listener() {
    return {
      draw: () => (this.draft ? this.finish() : this.start()),
      propose: (/** @type {string} */ rms) => void proposePanels(this.app, rms),
      proposeDarts: (/** @type {string} */ strain) => this.proposeDarts(strain, this.app.picture.pieces),
      mirror: (/** @type {boolean} */ isOn) => void this.mirror(isOn),
      notch: () => this.app.notches.toggle(),
      grain: () => this.app.grain.toggle(),
      choose: (/** @type {number} */ line) => this.choose(line === this.chosen ? -1 : line),
      remove: (/** @type {number} */ line) => this.removeLine(line),
      loosen: (/** @type {number} */ line) => this.loosen(line),
    };
  }

  /**
   * @param {string} strain limit
   * @param {import('../engine.js').LaidPiece[]} pieces
   */
  proposeDarts(strain, pieces) {
    void proposeDarts(this.app, strain, pieces);
  }

  reset() {
    this.draft = null;
    this.chosen = -1;
    this.dragged = null;
    this.hint = '';
    this.symmetry = null;
    this.paths.clear();
  }

  /** The project with its lines as they are shown right now. */
  asShown() {
    return { ...this.app.project, lines: this.linesShown() };
  }

  get lines() {
    return this.app.project.lines;
  }

  start() {
    this.draft = [];
    this.app.notches.isOn = false;
    this.app.grain.isOn = false;
    this.chosen = -1;
    this.show();
    this.app.stage?.view.canvas.focus({ preventScroll: true });
    // On a phone the model may be above, and the hint is below it.
    this.app.frame.place.scrollIntoView({ block: 'nearest' });
    this.app.say('Tap or click points on the model; the last one twice to end the line.');
  }

  /** Ends the line that is being drawn; of two points or more it becomes a seam. */
  finish() {
    const points = this.draft;
    this.draft = null;
    if (points && points.length > 1) {
      this.chosen = this.lines.length;
      this.app.change({ lines: [...this.lines, { kind: 'shortest', points }] });
    } else {
      this.show();
    }
  }

  /**
   * @param {Point | null} place on the surface
   * @param {number} line that is there, or -1
   */
  click(place, line) {
    if (!this.draft) {
      this.choose(line);
      return;
    }
    if (place) this.add(place);
  }

  /** @param {Point} place */
  add(place) {
    if (!this.draft) return;
    const same = this.draft.findIndex((point) => String(point) === String(place));
    if (same >= 0 && same === this.draft.length - 1) {
      this.finish();
      return;
    }
    this.draft = [...this.draft, place];
    // Back at its start the line is closed.
    if (same === 0 && this.draft.length > 3) this.finish();
    else this.show();
  }

  /** @param {number} line -1 for none */
  choose(line) {
    this.chosen = line;
    this.show();
  }

  /** @param {number} line */
  removeLine(line) {
    this.chosen = -1;
    this.app.change({ lines: this.lines.filter((_, i) => i !== line) });
  }

  /** @param {number} line */
  loosen(line) {
    const surface = this.app.surface;
    if (!surface) return;
    const loose = loosened(this.lines[line].points, surface.positions);
    this.chosen = line;
    this.app.change({ lines: this.lines.map((one, i) => (i === line ? loose : one)) });
  }

  /**
   * @param {number} index
   * @param {Point} place
   * @param {boolean} isDone
   */
  movePoint(index, place, isDone) {
    const line = this.lines[this.chosen];
    if (!line) return;
    const last = line.points.length - 1;
    const isClosed = last > 1 && String(line.points[0]) === String(line.points[last]);
    const points = line.points.map((point, i) => (i === index || (isClosed && index === 0 && i === last) ? place : point));
    const moved = { ...line, points };
    if (!isDone) {
      this.app.supersede();
      this.dragged = moved;
      this.show();
      this.app.live.ask(this.asShown());
      return;
    }
    this.dragged = null;
    if (String(points) === String(line.points)) this.app.refresh();
    else this.app.change({ lines: this.lines.map((one, i) => (i === this.chosen ? moved : one)) });
  }

  /** @param {number} index */
  removePoint(index) {
    const line = this.lines[this.chosen];
    if (!line) return;
    const points = line.points.filter((_, i) => i !== index);
    if (points.length < 2) this.removeLine(this.chosen);
    else this.app.change({ lines: this.lines.map((one, i) => (i === this.chosen ? { ...line, points } : one)) });
  }

  /** @param {boolean} isOn whether lines are mirrored in the plane of symmetry */
  async mirror(isOn) {
    try {
      if (isOn) this.symmetry ??= await this.app.pen.call('findPlane');
      this.app.change({ symmetric: isOn && this.symmetry ? planeWord(this.symmetry) : '' });
    } catch (error) {
      this.show();
      this.app.fail(error);
    }
  }

  /** The mirror images of lines, where there are any. @param {{path: ArrayLike<number>}[]} shown */
  images(shown) {
    const plane = this.symmetry?.plane;
    return plane && this.app.project.symmetric ? shown.map(({ path }) => mirrored(path, plane)) : [];
  }

  /** @returns {boolean} whether a point of the line that is being drawn was taken back */
  undo() {
    if (!this.draft) return false;
    if (this.draft.length === 0) this.draft = null;
    else this.draft = this.draft.slice(0, -1);
    this.show();
    return true;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const { target } = event;
    const isOnModel = target === this.app.stage?.view.canvas || target === document.body;
    if (event.key === 'Escape') {
      this.draft = null;
      this.choose(-1);
    } else if (this.draft && isOnModel && event.key === 'Enter') {
      event.preventDefault();
      this.finish();
    } else if (this.draft && isOnModel && event.key === ' ') {
      event.preventDefault();
      const place = this.app.stage?.middle();
      if (place) this.add(place);
    } else if (isOnModel && event.key === 'Delete' && this.chosen >= 0) {
      this.removeLine(this.chosen);
    }
  }

  /**
   * Those of the project, with changes that are not done yet.
   * @returns {Line[]}
   */
  linesShown() {
    return this.lines.map((line, i) => (i === this.chosen && this.dragged ? this.dragged : line));
  }

  /** Lines as they are shown, and the one being drawn. */
  shown() {
    const lines = this.linesShown();
    /** @type {Line[]} */
    const all = this.draft?.length ? [...lines, { kind: 'shortest', points: this.draft }] : lines;
    return all.map((line) => ({
      line,
      points: line.points,
      canMove: line.kind === 'shortest',
      path: this.pathOf(line) ?? line.points.flat(),
    }));
  }

  /** @param {Line} line */
  pathOf({ kind, points }) {
    if (kind === 'drawn' || points.length < 2) return Float64Array.from(points.flat());
    return this.paths.get(String(points)) ?? null;
  }

  show() {
    const { app } = this;
    const shown = this.shown();
    app.stage?.draws(this.draft !== null);
    app.stage?.showLines(shown, this.draft?.length ? shown.length - 1 : this.chosen, this.images(shown));
    const { draw, hint } = app.frame.seamPart;
    draw.setAttribute('aria-pressed', String(this.draft !== null));
    draw.textContent = this.draft ? 'Finish the line' : 'Draw a line';
    hint.textContent = this.draft
      ? 'Click points on the model; Enter or a second click on the last point ends the line. By keys: turn the model ' +
        'with the arrows, Space sets a point under the cross.'
      : app.project.parts.length > 0
        ? 'The parts of a product take no lines: open one of them alone to cut it.'
        : this.hint || (this.chosen >= 0 ? 'Drag the points of the line, or take one away with Delete.' : '');
    app.notches.show();
    app.grain.show();
    app.frame.seamPart.show(app.project, this.chosen, (i) => this.lengthText(i));
    void this.trace();
  }

  /** @param {number} i */
  lengthText(i) {
    const path = this.pathOf(this.lines[i]);
    if (!path) return '';
    let length = 0;
    for (let k = 3; k < path.length; k += 3) {
      length += Math.hypot(path[k] - path[k - 3], path[k + 1] - path[k - 2], path[k + 2] - path[k - 1]);
    }
    return `${Number(length.toPrecision(3))} ${this.app.project.unit}`;
  }

  /** Finds the ways of lines that have none yet; one after the other, the newest first. */
  async trace() {
    if (this.isTracing) return;
    if (this.app.project.symmetric && !this.symmetry) {
      this.isTracing = true;
      this.symmetry = await this.app.pen.call('findPlane').catch(() => null);
      this.isTracing = false;
      if (this.symmetry) this.show();
      return;
    }
    const missing = this.shown().find(({ line }) => !this.pathOf(line));
    if (!missing) return;
    this.isTracing = true;
    try {
      const { points } = missing;
      this.paths.set(String(points), await this.app.pen.call('lineThrough', points.flat()));
    } catch (error) {
      this.paths.set(String(missing.points), Float64Array.from(missing.points.flat()));
      if (!(error instanceof Ended)) this.app.fail(error);
    }
    this.isTracing = false;
    this.show();
  }
}

/**
 * @param {ArrayLike<number>} path x, y, z of its points
 * @param {Float64Array} plane x, y, z of its normal, of length 1, and its offset
 */
function mirrored(path, [x, y, z, offset]) {
  const image = new Float64Array(path.length);
  for (let i = 0; i < path.length; i += 3) {
    const twice = 2 * (path[i] * x + path[i + 1] * y + path[i + 2] * z - offset);
    image.set([path[i] - twice * x, path[i + 1] - twice * y, path[i + 2] - twice * z], i);
  }
  return image;
}

/**
 * What a project says of symmetry: nothing more where the model is symmetric; else the plane, where that is one of x,
 * y or z, and the model is nearly symmetric.
 * @param {import('../engine.js').Symmetry} symmetry
 */
function planeWord({ plane, share, isSymmetric }) {
  if (isSymmetric) return 'auto';
  const axis = [0, 1, 2].find((k) => Math.abs(plane[k]) > 1 - 1e-9);
  if (axis === undefined || share > nearly) {
    throw new Error(`The model is not symmetric: mirrored, it is up to ${(100 * share).toPrecision(2)} % of its size away.`);
  }
  return `${'xyz'[axis]}=${Number((plane[3] / plane[axis]).toPrecision(8))}`;
}
