// Opens what the app works on: models, projects, reports and samples.
import { likelyUnit } from './mesh.js';
import { History, modelFiles, newProject, readProject } from './project.js';
import { greetOpener, opened, readReport } from './reports.js';
import { errorOf, fileName, hashOf, titleOf } from './words.js';

/** @typedef {import('./app.js').App} App */
/** @typedef {import('./engine.js').Surface} Surface */
/** @typedef {import('./keeping.js').ModelBytes} ModelBytes */
/** @typedef {import('./project.js').Project} Project */

export class Opening {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** A project whose model is not open yet. @type {Project | null} */
    this.awaited = null;
  }

  /** Offers what earlier tabs left, and takes what a report that opened this page hands over. */
  async begin() {
    const { keeping, frame } = this.app;
    const canKeep = await keeping.open();
    const works = (await keeping.earlier()).map(({ files, time, project }) => ({
      text: `${titleOf(files.map(({ name }) => name))}, ${new Date(time).toLocaleString()}`,
      open: () => void this.tried(() => this.goOn(files, project)),
    }));
    frame.keepingPart.show(canKeep, keeping.isWanted, works);
    greetOpener((report) => void this.tried(() => this.report(report)));
  }

  /** @param {() => Promise<void>} work */
  async tried(work) {
    try {
      await work();
    } catch (error) {
      this.app.fail(error);
    }
  }

  /**
   * @param {ModelBytes[]} files
   * @param {string} project
   */
  async goOn(files, project) {
    this.awaited = readProject(project);
    await this.model(files);
  }

  /**
   * Takes files that were dropped or chosen: a report, a project, and one model or the parts of a product.
   * @param {File[]} files
   */
  async take(files) {
    await this.tried(async () => {
      const textOf = async (/** @type {File} */ file) => new TextDecoder().decode(await file.arrayBuffer());
      const [projects, reports] = ['.json', '.html'].map((ending) =>
        files.filter(({ name }) => name.toLowerCase().endsWith(ending)),
      );
      const models = files.filter((file) => !projects.includes(file) && !reports.includes(file));
      if (projects.length > 1 || reports.length > 1) throw new Error('drop one project or report at a time');
      if (reports.length > 0) await this.report(readReport(await textOf(reports[0])));
      const project = projects.length > 0 ? readProject(await textOf(projects[0])) : null;
      if (models.length > 0) {
        this.awaited = project ?? this.awaited;
        await this.model(await Promise.all(models.map(bytesOf)));
      } else if (project) {
        this.project(project);
      }
    });
  }

  /** @param {string} name */
  async sample(name) {
    const { app } = this;
    await this.tried(async () => {
      await app.interrupt();
      app.say('Making the sample');
      const file = `${name}.obj`;
      const run = await app.jobs.call('run', ['sample', name, '--vertices', '1500', '-o', file]);
      if (run.code !== 0) throw new Error(errorOf(run.err));
      const [[, bytes]] = await app.jobs.call('files', file);
      await this.model([{ name: file, bytes }]);
    });
  }

  /** @param {import('./reports.js').HandedOver} handed */
  async report(handed) {
    const { name, bytes, options, asked, words } = opened(handed);
    await this.model([{ name, bytes }], options);
    this.awaited = asked;
    this.app.note(words);
  }

  /**
   * @param {ModelBytes[]} given the file of a model, or those of the parts of a product
   * @param {Partial<Project>} [options] to begin with
   */
  async model(given, options = {}) {
    const { app } = this;
    const files = [...given].sort((a, b) => (a.name < b.name ? -1 : 1));
    const names = files.map(({ name }) => name);
    if (new Set(names).size < names.length) throw new Error('two of these files have one name');
    await app.interrupt();
    app.frame.alert.hidden = true;
    app.say(`Reading ${titleOf(names)}`);
    const hashes = await Promise.all(files.map(({ bytes }) => hashOf(bytes)));
    for (const { name, bytes } of files) await app.pen.write(name, bytes.slice());
    /** @type {Surface} */
    const surface = await app.pen.call('openSurface', names);
    for (const engine of [app.jobs, app.pen]) {
      for (const other of [...engine.files.keys()].filter((file) => !names.includes(file))) await engine.remove(other);
    }
    void app.live.open(files).then(() => app.live.ask(app.seams.asShown()), () => {});
    for (const { name, bytes } of files) await app.jobs.write(name, bytes.slice());
    app.keeping.files = files;
    const [first, ...parts] = names.map((model, i) => ({ model, hash: hashes[i] }));
    const unit = surface.unit || likelyUnit(surface.positions);
    const fresh = { ...newProject(first.model, first.hash), parts, unit, ...options };
    const { awaited } = this;
    this.awaited = null;
    const asked = awaited && onFiles(awaited, modelFiles(fresh));
    app.begin(surface, new History(asked ?? fresh));
    if (awaited?.model === first.model && !asked) {
      app.note(`The project that was dropped is of another ${first.model}, where its lines would lie elsewhere.`);
    }
  }

  /** @param {Project} project */
  project(project) {
    const { app } = this;
    const asked = app.surface && onFiles(project, modelFiles(app.project));
    if (asked) {
      app.commit(asked);
      return;
    }
    this.awaited = project;
    const other = app.surface && app.project.model === project.model ? '; another file of that name is open' : '';
    app.note(`This project is of ${titleOf(modelFiles(project).map(({ model }) => model))}${other}. Drop that now.`);
  }
}

/**
 * @param {File} file
 * @returns {Promise<ModelBytes>}
 */
async function bytesOf(file) {
  return { name: fileName(file.name), bytes: new Uint8Array(await file.arrayBuffer()) };
}

/**
 * The project with the names that its files have here; null where these are others.
 * @param {Project} project
 * @param {import('./project.js').ModelFile[]} here
 * @returns {Project | null}
 */
function onFiles(project, here) {
  const wanted = modelFiles(project);
  const files = wanted.flatMap(({ hash }) => here.find((file) => file.hash === hash) ?? []);
  if (files.length < wanted.length || here.length !== wanted.length) return null;
  return { ...project, ...files[0], parts: files.slice(1) };
}
