// The quick look: with each change the pieces of a coarse copy of the model, until the program has made the pattern.
import { Ended } from './engine.js';
import { filesOf, sketchWords } from './project.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').SketchPieces} SketchPieces */
/** @typedef {import('./project.js').Project} Project */

export class Live {
  /**
   * @param {Engine} engine of its own, so that nothing waits for it and it for nothing
   * @param {(project: Project, sketch: SketchPieces) => void} made
   * @param {(delay: number) => void} seen milliseconds from the change until its pieces were there to see
   */
  constructor(engine, made, seen) {
    this.engine = engine;
    this.made = made;
    this.seen = seen;
    /** @type {{project: Project, at: number} | null} */
    this.asked = null;
    this.isBusy = false;
    this.isOpen = false;
    /** What was sketched last, or need not be any more. */
    this.key = '';
  }

  /** @param {import('./keeping.js').ModelBytes[]} files of the model */
  async open(files) {
    this.isOpen = false;
    this.key = '';
    this.asked = null;
    for (const other of this.engine.files.keys()) await this.engine.remove(other);
    for (const { name, bytes } of files) await this.engine.write(name, bytes.slice());
    await this.engine.call('openSketch', files.map(({ name }) => name));
    this.isOpen = true;
  }

  /** @param {Project} project with lines as they are right now */
  ask(project) {
    this.asked = { project, at: performance.now() };
    void this.run();
  }

  /** @param {Project} project whose pattern the program has made: a sketch would tell less */
  settle(project) {
    this.key = keyOf(project);
  }

  /** One sketch after the other, of the newest wish each. */
  async run() {
    if (this.isBusy || !this.isOpen) return;
    this.isBusy = true;
    while (this.asked) {
      const { project, at } = this.asked;
      this.asked = null;
      const key = keyOf(project);
      if (key === this.key) continue;
      try {
        for (const [name, text] of filesOf(project)) await this.engine.write(name, new TextEncoder().encode(text));
        const sketch = await this.engine.call('sketch', sketchWords(project));
        if (key === this.key || !this.isOpen) continue;
        this.key = key;
        this.made(project, sketch);
        await new Promise((painted) => requestAnimationFrame(() => setTimeout(painted)));
        this.seen(performance.now() - at);
      } catch (error) {
        if (!(error instanceof Ended)) this.key = key; // the pattern itself will tell
      }
    }
    this.isBusy = false;
  }
}

/** @param {Project} project */
function keyOf(project) {
  return [...sketchWords(project), ...filesOf(project).flat()].join('\n');
}
