// The page: a model, the seams drawn on it, and its pattern.
import { colorOf, gradientOf } from '../viewer/color_scale.js';
import { countText, make } from '../viewer/dom.js';
import { spaceCanvas } from '../viewer/patch_view.js';
import { download } from './downloads.js';
import { Ended } from './engine.js';
import { Frame } from './frame.js';
import { colorLimit, joined, likelyUnit } from './mesh.js';
import {
  History,
  drawnText,
  flattenWords,
  linesOf,
  newProject,
  panelsWords,
  projectText,
  readProject,
  seamsFile,
} from './project.js';
import { Seams } from './seams.js';
import { Stage } from './stage.js';
import { errorOf, fileName, hashOf, stages } from './words.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Outcome} Outcome */
/** @typedef {import('./engine.js').Surface} Surface */
/** @typedef {import('./project.js').Project} Project */
/** @typedef {import('../viewer/color_scale.js').Color} Color */

const out = 'pattern'; // the folder that the program writes into
const much = 50000; // vertices from which on it takes long
const wait = 200; // ms after a change until the pattern is made anew

/** Colours of pieces, told apart by colour-blind eyes as well. @type {Color[]} */
const tints = [
  [120, 170, 219],
  [240, 178, 90],
  [116, 190, 160],
  [214, 140, 186],
  [217, 208, 107],
  [158, 150, 214],
  [222, 140, 120],
  [150, 196, 206],
];

export class App {
  /**
   * @param {HTMLElement} root
   * @param {Engine} jobs runs the program
   * @param {Engine} pen draws lines meanwhile
   */
  constructor(root, jobs, pen) {
    this.jobs = jobs;
    this.pen = pen;
    /** @type {Surface | null} */
    this.surface = null;
    /** @type {Stage | null} */
    this.stage = null;
    this.history = new History(newProject('', ''));
    /** @type {Map<string, Uint8Array>} */
    this.maps = new Map();
    /** @type {Outcome | null} */
    this.outcome = null;
    /** The pieces of the last outcome as one mesh. @type {ReturnType<typeof joined> | null} */
    this.body = null;
    this.colorBy = /** @type {'stretch' | 'pieces'} */ ('stretch');
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    /** @type {Promise<void>} */
    this.running = Promise.resolve();
    this.seams = new Seams(this);
    this.root = root;
    this.frame = new Frame(root, this);
    this.listen(root);
    jobs.onProgress = (progress) => this.showProgress(progress);
    void this.begin();
  }

  get project() {
    return this.history.now;
  }

  async begin() {
    try {
      this.maps.set('diverging', await this.pen.call('colorMap', 'diverging'));
      const { out: text } = await this.jobs.call('run', ['materials', '--json']);
      this.frame.patternPart.offer(JSON.parse(text).materials);
      this.root.dataset.ready = 'yes';
    } catch (error) {
      this.fail(error);
    }
  }

  /** @param {HTMLElement} root */
  listen(root) {
    for (const kind of ['dragenter', 'dragover']) {
      addEventListener(kind, (event) => {
        event.preventDefault();
        root.classList.add('dropping');
      });
    }
    addEventListener('dragleave', () => root.classList.remove('dropping'));
    addEventListener('drop', (event) => {
      event.preventDefault();
      root.classList.remove('dropping');
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
    addEventListener('keydown', (event) => {
      const isText = event.target instanceof HTMLInputElement && event.target.type === 'text';
      if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z' && !isText) {
        event.preventDefault();
        if (event.shiftKey) this.redo();
        else this.undo();
      } else {
        this.seams.key(event);
      }
    });
  }

  /**
   * Takes a file that was dropped or chosen: a model or a project.
   * @param {File} file
   */
  async take(file) {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (file.name.toLowerCase().endsWith('.json')) await this.openProject(new TextDecoder().decode(bytes));
      else await this.openModel(fileName(file.name), bytes);
    } catch (error) {
      this.fail(error);
    }
  }

  /** @param {string} name */
  async openSample(name) {
    try {
      await this.interrupt();
      this.say('Making the sample');
      const file = `${name}.obj`;
      const run = await this.jobs.call('run', ['sample', name, '--vertices', '1500', '-o', file]);
      if (run.code !== 0) throw new Error(errorOf(run.err));
      const [[, bytes]] = await this.jobs.call('files', file);
      await this.openModel(file, bytes);
    } catch (error) {
      this.fail(error);
    }
  }

  /**
   * @param {string} name
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  async openModel(name, bytes) {
    await this.interrupt();
    this.frame.alert.hidden = true;
    this.say(`Reading ${name}`);
    const hash = await hashOf(bytes);
    await this.pen.write(name, bytes.slice());
    /** @type {Surface} */
    const surface = await this.pen.call('openSurface', name);
    for (const other of this.jobs.files.keys()) {
      if (other === name) continue;
      this.jobs.files.delete(other);
      this.pen.files.delete(other);
      await this.pen.call('remove', other);
      await this.jobs.call('remove', other);
    }
    await this.jobs.write(name, bytes);
    this.surface = surface;
    const unit = surface.unit || likelyUnit(surface.positions);
    this.history = new History({ ...newProject(name, hash), unit });
    this.outcome = null;
    this.body = null;
    this.seams.reset();
    this.showModel();
    this.refresh();
  }

  /** @param {string} text */
  async openProject(text) {
    const project = readProject(text);
    if (!this.surface || this.project.hash !== project.hash) {
      if (!this.surface || this.project.model !== project.model) {
        throw new Error(`this project is of the model ${project.model}: drop that first, then the project`);
      }
      throw new Error(`this project is of another ${project.model} than the one that is open`);
    }
    this.commit({ ...project, model: this.project.model });
  }

  showModel() {
    const { surface } = this;
    if (!surface) return;
    this.stage?.dispose();
    this.stage = null;
    const space = spaceCanvas();
    if (space) {
      this.stage = new Stage(space, surface, this.maps, {
        hovered: (vertex) => this.mark(vertex),
        clicked: (place, line) => this.seams.click(place, line),
        moved: (index, place, isDone) => this.seams.movePoint(index, place, isDone),
        removed: (index) => this.seams.removePoint(index),
      });
      this.frame.place.replaceChildren(this.stage.view.root);
      this.stage.view.plain();
    } else {
      const textContent = 'This browser cannot draw in space (no WebGL). Patterns can be made all the same.';
      this.frame.place.replaceChildren(make('p', { className: 'empty', textContent }));
    }
    const count = surface.positions.length / 3;
    this.frame.title.textContent = `${this.project.model} · ${countText(count)} vertices`;
    if (count > much) {
      this.warn(
        `This model has ${countText(count)} vertices: a pattern takes minutes here, and some ` +
          `${Math.ceil(count / 80000)} GB of memory. Cancel ends it at any time.`,
      );
    }
    this.root.dataset.model = this.project.model;
    this.frame.seamPart.root.hidden = false;
    this.frame.patternPart.root.hidden = false;
    this.frame.saveButton.disabled = false;
    this.frame.sheet.show([]);
    this.frame.verdict.textContent = '';
    this.frame.downloads.show(this.project, null, out);
  }

  /** @param {Partial<Project>} change of the project, that can be undone */
  change(change) {
    this.commit({ ...this.project, ...change });
  }

  /** @param {Project} project */
  commit(project) {
    this.history.push(project);
    this.refresh();
  }

  /** @param {{name?: [string, string], without?: [string, boolean]}} change */
  changePiece({ name, without }) {
    if (name) {
      const names = { ...this.project.names };
      if (name[1] === '' || name[1] === name[0]) delete names[name[0]];
      else names[name[0]] = name[1];
      this.change({ names });
    }
    if (without) {
      const others = this.project.without.filter((one) => one !== without[0]);
      this.change({ without: without[1] ? [...others, without[0]] : others });
    }
  }

  undo() {
    if (this.seams.undo()) return;
    if (this.history.undo()) this.refresh();
  }

  redo() {
    if (this.history.redo()) this.refresh();
  }

  save() {
    const name = this.project.model.replace(/\.[^.]*$/, '');
    download(`${name}.planish.json`, new Blob([projectText(this.project)], { type: 'application/json' }));
  }

  /** Shows the project as it is now, and has its pattern made. */
  refresh() {
    const { project, surface } = this;
    this.frame.undoButton.disabled = this.history.past.length === 0;
    this.frame.redoButton.disabled = this.history.future.length === 0;
    if (!surface) return;
    this.frame.unitPart.show(surface.positions, project.unit, surface.unit);
    this.frame.patternPart.show(project);
    this.seams.show();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.make(), wait);
  }

  /** Ends a job that runs, and waits for its end. */
  async interrupt() {
    clearTimeout(this.timer);
    if (this.jobs.isBusy) this.jobs.stop();
    await this.running;
  }

  cancel() {
    clearTimeout(this.timer);
    this.jobs.stop();
    this.say('Cancelled. Any change makes the pattern anew.');
  }

  /** Makes the pattern of the project. */
  async make() {
    await this.interrupt();
    const { project } = this;
    const stem = project.model.replace(/\.[^.]*$/, '');
    await this.job(async () => {
      const drawn = project.lines.filter(({ kind }) => kind === 'drawn');
      if (drawn.length > 0) await this.jobs.write(seamsFile, new TextEncoder().encode(drawnText(drawn)));
      const start = performance.now();
      /** @type {Outcome} */
      const outcome = await this.jobs.call('flatten', flattenWords(project, out), out, stem);
      if (outcome.files.length === 0) throw new Error(errorOf(outcome.err));
      this.outcome = outcome;
      this.showOutcome(project);
      const seconds = (performance.now() - start) / 1000;
      this.say(`Pattern made in ${seconds.toFixed(1)} s`);
      this.root.dataset.made = String(Number(this.root.dataset.made ?? 0) + 1);
    });
  }

  /** @param {string} rms */
  async propose(rms) {
    await this.interrupt();
    await this.job(async () => {
      const run = await this.jobs.call('run', panelsWords(this.project, rms));
      const [file] = await this.jobs.call('files', seamsFile);
      if (!file) throw new Error(errorOf(run.err));
      const lines = linesOf(new TextDecoder().decode(file[1]));
      this.say(`${lines.length} seams proposed`);
      this.change({ lines, names: {}, without: [] });
    });
  }

  /** @param {() => Promise<void>} work */
  async job(work) {
    this.frame.busy.hidden = false;
    this.frame.bar.removeAttribute('value');
    this.frame.alert.hidden = true;
    const all = (async () => {
      try {
        await work();
      } catch (error) {
        if (!(error instanceof Ended)) this.fail(error);
      }
    })();
    this.running = all;
    await all;
    if (this.running === all) this.frame.busy.hidden = true;
  }

  /** @param {Project} project that the outcome is of */
  showOutcome(project) {
    const { outcome } = this;
    if (!outcome) return;
    const { pieces } = outcome;
    this.body = joined(pieces);
    const { stage, body } = this;
    if (stage && pieces.length > 0) {
      stage.view.replace({
        ...stage.plainPatch,
        positions: [body.positions],
        triangles: body.triangles,
        pieces: { of: body.of, ways: body.ways, colors: pieces.map((_, k) => tints[k % tints.length]), lines: [] },
      });
    }
    this.frame.sheet.show(pieces);
    this.paint();
    this.frame.verdict.textContent = this.verdictText();
    this.showPieces(project);
    this.frame.downloads.show(project, outcome, out);
  }

  verdictText() {
    const { outcome } = this;
    if (!outcome) return '';
    if (outcome.report?.verdict) return outcome.report.verdict;
    // Of one piece: the paragraph below its name.
    return (outcome.out.split('\n\n')[1] ?? '').replaceAll('\n', ' ');
  }

  /** @param {Project} project */
  showPieces(project) {
    const { outcome } = this;
    if (!outcome) return;
    const own = new Map(Object.entries(project.names).map(([old, name]) => [name, old]));
    const made = outcome.pieces.map(({ name, figures }, k) => ({
      own: own.get(name) ?? name,
      size: figures?.width ? `${Math.round(figures.width)} × ${Math.round(figures.height)} mm` : '',
      color: colorOf(tints[k % tints.length]),
    }));
    const left = project.without.map((name) => ({ own: name, size: 'left out', color: 'transparent' }));
    this.frame.piecePart.show([...made, ...left], project);
  }

  /** @param {'stretch' | 'pieces'} by */
  showColors(by) {
    this.colorBy = by;
    this.paint();
  }

  /** Colours model and pattern. */
  paint() {
    const { body, outcome, stage } = this;
    const map = this.maps.get('diverging');
    if (!body || !outcome || !map) return;
    const limit = colorLimit(outcome.pieces.map(({ strain }) => strain));
    const pieces = outcome.pieces.map((_, k) => tints[k % tints.length]);
    this.frame.sheet.color({ by: this.colorBy, map, limit, pieces });
    if (this.colorBy === 'pieces') stage?.view.plain();
    else stage?.view.color({ values: [body.strain], map: 'diverging', limit, isSigned: true });
    const bar = make('div', { className: 'bar' });
    bar.style.background = gradientOf(map);
    const end = `${Number((100 * limit).toPrecision(2))} %`;
    const words = [`shorter −${end}`, '0', `longer +${end}`].map((textContent) => make('span', { textContent }));
    this.frame.scale.replaceChildren(bar, make('div', { className: 'labels' }, ...words));
    this.frame.scale.hidden = this.colorBy === 'pieces';
  }

  /** @param {number} vertex of all pieces, or -1 */
  mark(vertex) {
    if (!this.body) return;
    this.stage?.view.mark(vertex);
    this.frame.sheet.mark(vertex);
  }

  /** @param {import('./engine.js').Progress} progress */
  showProgress({ stage, share, subject }) {
    this.frame.bar.value = share;
    this.say(`${stages[stage] ?? stage}${subject ? `: ${subject}` : ''}`);
  }

  /** @param {string} text */
  say(text) {
    this.frame.status.textContent = text;
  }

  /** @param {string} text */
  warn(text) {
    this.frame.alert.textContent = text;
    this.frame.alert.hidden = false;
  }

  /** @param {unknown} error */
  fail(error) {
    this.say('');
    this.warn(error instanceof Error ? error.message : String(error));
  }
}
