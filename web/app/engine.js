// The program in a worker, from the side of the page.

/**
 * What emscripten makes of bindings/wasm.
 * @typedef {object} Module
 * @property {any} FS
 * @property {(words: string[], on_progress: (stage: string, share: number, subject: string) => void) => Run} run
 * @property {(paths: string[]) => Surface | {error: string}} openSurface
 * @property {(places: number[]) => Float64Array | {error: string}} lineThrough
 * @property {(inSpace: string, flat: string) => Laid | {error: string}} readLaid
 * @property {() => Symmetry | {error: string}} findPlane
 * @property {(paths: string[]) => null | {error: string}} openSketch
 * @property {(words: string[]) => SketchPieces | {error: string}} sketch
 * @property {(name: string) => Uint8Array} colorMap red, green and blue from low to high
 */

/** @typedef {{code: number, out: string, err: string}} Run exit code, standard output, messages */
/**
 * @typedef {object} Surface
 * @property {Float32Array} positions x, y, z, model units
 * @property {Uint32Array} triangles
 * @property {number} pieces of the file
 * @property {string} unit that the file states, or ''
 */

/**
 * @typedef {object} Symmetry
 * @property {Float64Array} plane x, y, z of its normal, of length 1, and its offset
 * @property {number} share of the diagonal, that mirrored vertices are away from the model
 * @property {boolean} isSymmetric whether that counts as symmetric
 */

/**
 * @typedef {object} Laid
 * @property {Float32Array} positions x, y, z in space, model units
 * @property {Uint32Array} triangles
 * @property {Float32Array} flat x, y, 0 in the pattern, model units
 * @property {Float32Array} strain of each triangle, above 0 longer in the pattern
 */

/** @typedef {Laid & {name: string, figures: any}} LaidPiece */

/**
 * What a run of `flatten` gave.
 * @typedef {Run & {pieces: LaidPiece[], report: any, files: [string, Uint8Array<ArrayBuffer>][]}} Outcome
 */

/** @typedef {{pieces: (Laid & {name: string})[], hint: string}} SketchPieces `flat` is empty where a piece has no pattern */
/** @typedef {{stage: string, share: number, subject: string}} Progress */

/** A job was ended, by a newer one or by the user. */
export class Ended extends Error {}

/**
 * Unpacks and compiles the program, in a worker of its own.
 * @param {string} url of the script of workers
 * @param {Uint8Array<ArrayBuffer>[]} packed in streams
 * @returns {Promise<WebAssembly.Module>}
 */
export function compiled(url, packed) {
  return new Promise((done, failed) => {
    const worker = new Worker(url);
    worker.addEventListener('error', failed);
    worker.addEventListener('message', ({ data: { result, error } }) => {
      worker.terminate();
      if (error === undefined) done(result);
      else failed(new Error(error));
    });
    worker.postMessage({ id: 0, call: 'compile', values: packed });
  });
}

export class Engine {
  /**
   * @param {string} url of the script of the worker
   * @param {Promise<WebAssembly.Module>} module
   * @param {string} [pageScript] of reports, for an engine that writes them
   */
  constructor(url, module, pageScript = '') {
    this.url = url;
    this.module = module;
    this.pageScript = pageScript;
    /** Files that are written again when the worker is started again. @type {Map<string, Uint8Array>} */
    this.files = new Map();
    this.calls = 0;
    /** @type {Map<number, {done: (value: any) => void, failed: (error: Error) => void}>} */
    this.waiting = new Map();
    /** @type {(progress: Progress) => void} */
    this.onProgress = () => {};
    this.worker = this.start();
  }

  start() {
    const worker = new Worker(this.url);
    worker.addEventListener('message', (event) => this.take(event.data));
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.stop('the program ended unexpectedly; it was started again');
    });
    this.ready = this.module.then((module) => this.post(worker, 'start', [module, this.pageScript]));
    this.ready.catch(() => {});
    for (const [name, bytes] of this.files) void this.call('write', name, bytes).catch(() => {});
    return worker;
  }

  /**
   * @param {Worker} worker
   * @param {string} call
   * @param {any[]} values
   * @returns {Promise<any>}
   */
  post(worker, call, values) {
    const id = ++this.calls;
    return new Promise((done, failed) => {
      this.waiting.set(id, { done, failed });
      worker.postMessage({ id, call, values });
    });
  }

  /**
   * @param {string} call a method of the worker's program
   * @param {any[]} values
   */
  async call(call, ...values) {
    await this.ready;
    return this.post(this.worker, call, values);
  }

  /**
   * @param {string} name
   * @param {Uint8Array} bytes
   */
  write(name, bytes) {
    this.files.set(name, bytes);
    return this.call('write', name, bytes);
  }

  /** @param {string} name of a file */
  remove(name) {
    this.files.delete(name);
    return this.call('remove', name);
  }

  /** @param {{id: number, result?: any, error?: string, progress?: Progress}} message */
  take({ id, result, error, progress }) {
    if (progress) {
      this.onProgress(progress);
      return;
    }
    const call = this.waiting.get(id);
    this.waiting.delete(id);
    if (error === undefined) call?.done(result);
    else call?.failed(new Error(error));
  }

  /**
   * Ends what runs, and starts anew.
   * @param {string} [reason] without, it was asked for
   */
  stop(reason) {
    this.worker.terminate();
    const ended = [...this.waiting.values()];
    this.waiting.clear();
    this.worker = this.start();
    for (const { failed } of ended) failed(reason ? new Error(reason) : new Ended());
  }
}
