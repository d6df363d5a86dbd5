// Keeps the work of each tab in the browser's own storage, so that nothing is lost where the page is closed.
import { projectText } from './project.js';

/** @typedef {import('./project.js').Project} Project */
/** @typedef {{name: string, bytes: Uint8Array<ArrayBuffer>}} ModelBytes a file of a model */
/** @typedef {{tab: string, time: number, files: ModelBytes[], project: string}} Kept */

const most = 4; // works that are kept, the last ones
const store = 'works';
const choice = 'planish-keeps'; // in localStorage: whether the user wants it
const wait = 500; // ms after a change

/** @param {IDBRequest} request */
function answer(request) {
  return new Promise((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
  });
}

export class Keeping {
  constructor() {
    /** Two tabs do not write over each other. */
    this.tab = crypto.getRandomValues(new Uint32Array(2)).join('-');
    /** @type {IDBDatabase | null} */
    this.base = null;
    /** None until a model is open. @type {ModelBytes[]} */
    this.files = [];
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
  }

  get isWanted() {
    try {
      return localStorage.getItem(choice) !== 'no';
    } catch {
      return false;
    }
  }

  /** @returns {Promise<boolean>} whether the browser lets the page keep anything */
  async open() {
    try {
      const request = indexedDB.open('planish', 1);
      request.onupgradeneeded = () => request.result.createObjectStore(store, { keyPath: 'tab' });
      this.base = await answer(request);
    } catch {
      this.base = null;
    }
    return this.base !== null;
  }

  /** @param {IDBTransactionMode} mode */
  works(mode) {
    if (!this.base) throw new Error('the browser keeps nothing');
    return this.base.transaction(store, mode).objectStore(store);
  }

  /** What earlier tabs left, the newest first. @returns {Promise<Kept[]>} */
  async earlier() {
    if (!this.base || !this.isWanted) return [];
    try {
      const all = /** @type {Kept[]} */ (await answer(this.works('readonly').getAll()));
      return all.filter(({ tab, files }) => tab !== this.tab && files).sort((a, b) => b.time - a.time);
    } catch {
      return [];
    }
  }

  /** Keeps the project soon, as it is then the last time. @param {Project} project */
  keep(project) {
    clearTimeout(this.timer);
    const { files } = this;
    if (!this.base || !this.isWanted || files.length === 0) return;
    this.timer = setTimeout(() => void this.write({ files, project: projectText(project) }), wait);
  }

  /** @param {{files: ModelBytes[], project: string}} work */
  async write(work) {
    try {
      await answer(this.works('readwrite').put({ ...work, tab: this.tab, time: Date.now() }));
      const old = (await this.earlier()).slice(most - 1);
      for (const { tab } of old) await answer(this.works('readwrite').delete(tab));
    } catch {
      this.base = null; // full, or refused: the page works without
    }
  }

  /** @param {boolean} isOn off: what was kept is deleted too */
  async want(isOn) {
    try {
      localStorage.setItem(choice, isOn ? 'yes' : 'no');
      if (!isOn) await answer(this.works('readwrite').clear());
    } catch {
      // Where nothing can be kept there is nothing to delete.
    }
  }
}
