// The page: a model, the seams drawn on it, and its pattern.
import { colorOf } from '../viewer/color_scale.js';
import { countText, make } from '../viewer/dom.js';
import { spaceCanvas } from '../viewer/patch_view.js';
import { download } from './downloads.js';
import { Ended } from './engine.js';
import { Frame } from './frame.js';
import { Grain } from './drawing/grain.js';
import { Keeping } from './keeping.js';
import { Live } from './live.js';
import { millimetres } from './mesh.js';
import { Notches } from './drawing/notches.js';
import { Opening } from './opening.js';
import { Picture, tintOf } from './picture.js';
import { History, filesOf, flattenWords, modelFiles, newProject, projectText } from './project.js';
import { Seams } from './drawing/seams.js';
import { Stage } from './stage.js';
import { errorOf, lineHint, stages, titleOf } from './words.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Outcome} Outcome */
/** @typedef {import('./engine.js').SketchPieces} SketchPieces */
/** @typedef {import('./engine.js').Surface} Surface */
/** @typedef {import('./project.js').Project} Project */

const out = 'pattern'; // the folder that the program writes into
const much = 50000; // vertices from which on it takes long
const wait = 200; // ms after a change until the pattern is made anew

export class App {
  /**
   * @param {HTMLElement} root
   * @param {Engine} jobs runs the program
   * @param {Engine} pen draws lines meanwhile
   * @param {Engine} sketcher gives the quick look
   */
  constructor(root, jobs, pen, sketcher) {
    this.jobs = jobs;
    this.pen = pen;
    /** @type {Surface | null} */
    this.surface = null;
    this.history = new History(newProject('', ''));
    /** @type {Map<string, Uint8Array>} */
    this.maps = new Map();
    /** @type {Outcome | null} */
    this.outcome = null;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    /** @type {Promise<void>} */
    this.running = Promise.resolve();
    this.keeping = new Keeping();
    this.opening = new Opening(this);
    this.seams = new Seams(this);
    this.notches = new Notches(this);
    this.grain = new Grain(this);
    this.root = root;
    this.frame = new Frame(root, this);
    this.picture = new Picture(this.frame, this.maps);
    this.live = new Live(sketcher, (project, sketch) => this.showSketch(project, sketch), (delay) => {
      Object.assign(root.dataset, { delay: String(delay), seen: root.dataset.sketched });
    });
    this.listen(root);
    jobs.onProgress = (progress) => this.showProgress(progress);
    void this.start();
  }

  get project() {
    return this.history.now;
  }

  get stage() {
    return this.picture.stage;
  }

  async start() {
    try {
      this.maps.set('diverging', await this.pen.call('colorMap', 'diverging'));
      const { out: text } = await this.jobs.call('run', ['materials', '--json']);
      this.frame.patternPart.offer(JSON.parse(text).materials);
      await this.opening.begin();
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
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length > 0) void this.opening.take(files);
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
   * Goes on with another model.
   * @param {Surface} surface
   * @param {History} history
   */
  begin(surface, history) {
    this.surface = surface;
    this.history = history;
    this.outcome = null;
    this.seams.reset();
    this.showModel();
    this.refresh();
  }

  showModel() {
    const { surface } = this;
    if (!surface) return;
    this.stage?.dispose();
    const space = spaceCanvas();
    if (space) {
      const stage = new Stage(space, surface, this.maps, {
        hovered: (vertex) => this.picture.mark(vertex),
        clicked: (place, line) => this.click(place, line),
        unnotched: (index) => this.notches.remove(index),
        moved: (index, place, isDone) => this.seams.movePoint(index, place, isDone),
        removed: (index) => this.seams.removePoint(index),
      });
      this.picture.begin(stage);
      this.frame.place.replaceChildren(stage.view.root);
      stage.view.plain();
    } else {
      this.picture.begin(null);
      const textContent = 'This browser cannot draw in space (no WebGL). Patterns can be made all the same.';
      this.frame.place.replaceChildren(make('p', { className: 'empty', textContent }));
    }
    this.note('');
    const count = surface.positions.length / 3;
    this.frame.title.textContent = `${titleOf(modelFiles(this.project).map(({ model }) => model))} · ${countText(count)} vertices`;
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
    this.frame.verdict.textContent = '';
    this.frame.downloads.show(this.project, null, out);
  }

  /**
   * @param {import('./project.js').Point | null} place on the surface
   * @param {number} line that is there, or -1
   */
  click(place, line) {
    if (this.grain.isOn) this.grain.click(place);
    else if (this.notches.isOn) this.notches.click(place, line);
    else this.seams.click(place, line);
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
    this.live.ask(this.seams.asShown());
    this.frame.downloads.wait();
    this.keeping.keep(project);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.make(), wait);
  }

  /** Ends a job whose result would be of the past. */
  supersede() {
    clearTimeout(this.timer);
    if (!this.frame.busy.hidden) this.jobs.stop();
  }

  /** The same, and waits for its end. */
  async interrupt() {
    this.supersede();
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
      const start = performance.now();
      for (const [name, text] of filesOf(project)) await this.jobs.write(name, new TextEncoder().encode(text));
      /** @type {(of: Project) => Promise<Outcome>} */
      const flattened = (of) => this.jobs.call('flatten', flattenWords(of, out), out, stem);
      let outcome = await flattened(project);
      this.seams.hint = lineHint(project, outcome.err);
      let made = project;
      if (outcome.files.length === 0 && this.seams.hint) {
        made = { ...project, lines: [] };
        outcome = await flattened(made);
      }
      this.seams.show();
      if (outcome.files.length === 0) throw new Error(errorOf(outcome.err));
      this.outcome = outcome;
      this.live.settle(project);
      this.showOutcome(made);
      const seconds = (performance.now() - start) / 1000;
      this.say(`Pattern made in ${seconds.toFixed(1)} s`);
      this.root.dataset.made = String(Number(this.root.dataset.made ?? 0) + 1);
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

  /**
   * @param {Project} project
   * @param {SketchPieces} sketch of it
   */
  showSketch(project, { pieces, hint }) {
    if (pieces.every(({ flat }) => flat.length > 0)) {
      const named = pieces.map((piece) => ({ ...piece, name: project.names[piece.name] ?? piece.name, figures: null }));
      this.picture.show(named);
      this.frame.verdict.textContent = 'A quick look; the pattern follows.';
    }
    this.seams.hint = lineHint(project, hint);
    this.seams.show();
    this.root.dataset.sketched = String(Number(this.root.dataset.sketched ?? 0) + 1);
  }

  /** @param {Project} project that the outcome is of */
  showOutcome(project) {
    const { outcome } = this;
    if (!outcome) return;
    this.picture.show(outcome.pieces);
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
    const mm = millimetres.get(project.unit || this.surface?.unit || 'mm') ?? 1;
    const made = outcome.pieces.map(({ name, figures }, k) => ({
      own: own.get(name) ?? name,
      size: figures?.width ? `${Math.round(mm * figures.width)} × ${Math.round(mm * figures.height)} mm` : '',
      color: colorOf(tintOf(k)),
    }));
    const left = project.without.map((name) => ({ own: name, size: 'left out', color: 'transparent' }));
    this.frame.piecePart.show([...made, ...left], project);
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

  /** @param {string} text that stays until another model is opened; '' for none */
  note(text) {
    this.frame.note.textContent = text;
    this.frame.note.hidden = text === '';
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
