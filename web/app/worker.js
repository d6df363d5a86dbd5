// The program, in a worker of its own: one call after the other, each answered by its number.

import { unpacked } from './packing/unpack.js';
import { joined } from './packing/wasm_streams.js';

/** @typedef {import('./engine.js').Module} Module */
/** @typedef {import('./engine.js').LaidPiece} LaidPiece */
/** @typedef {import('./engine.js').Outcome} Outcome */

const folder = '/work';
const pageScriptFile = '/page_script'; // that the program looks for

/**
 * @template Result
 * @param {Result | {error: string}} result
 * @returns {Result}
 */
function checked(result) {
  const { error } = /** @type {{error?: string}} */ (result ?? {});
  if (error !== undefined) throw new Error(error);
  return /** @type {Result} */ (result);
}

class Program {
  /** @param {Module} module */
  constructor(module) {
    this.module = module;
    /** @type {(stage: string, share: number, subject: string) => void} */
    this.on_progress = () => {};
    module.FS.mkdir(folder);
    module.FS.chdir(folder);
  }

  /**
   * @param {string} name
   * @param {Uint8Array} bytes
   */
  write(name, bytes) {
    this.module.FS.writeFile(name, bytes);
  }

  /** @param {string} path */
  remove(path) {
    const { FS } = this.module;
    if (!FS.analyzePath(path).exists) return;
    if (!FS.isDir(FS.stat(path).mode)) {
      FS.unlink(path);
      return;
    }
    for (const name of /** @type {string[]} */ (FS.readdir(path))) {
      if (name !== '.' && name !== '..') this.remove(`${path}/${name}`);
    }
    FS.rmdir(path);
  }

  /**
   * @param {string} path
   * @returns {[string, Uint8Array<ArrayBuffer>][]}
   */
  files(path) {
    const { FS } = this.module;
    if (!FS.analyzePath(path).exists) return [];
    if (!FS.isDir(FS.stat(path).mode)) return [[path, FS.readFile(path)]];
    return /** @type {string[]} */ (FS.readdir(path))
      .filter((name) => name !== '.' && name !== '..')
      .sort()
      .flatMap((name) => this.files(`${path}/${name}`));
  }

  /** @param {string} name */
  colorMap(name) {
    return this.module.colorMap(name);
  }

  /** @param {string[]} words */
  run(words) {
    return this.module.run(words, this.on_progress);
  }

  /** @param {string[]} names */
  openSurface(names) {
    return checked(this.module.openSurface(names));
  }

  /** @param {string[]} names */
  openSketch(names) {
    return checked(this.module.openSketch(names));
  }

  /** @param {string[]} words */
  sketch(words) {
    return checked(this.module.sketch(words));
  }

  findPlane() {
    return checked(this.module.findPlane());
  }

  /** @param {number[]} places */
  lineThrough(places) {
    return checked(this.module.lineThrough(places));
  }

  /**
   * Runs `flatten` and takes what it wrote.
   * @param {string[]} words
   * @param {string} out their folder
   * @param {string} stem of the model's name, for the piece where there is one only
   * @returns {Outcome}
   */
  flatten(words, out, stem) {
    this.remove(out);
    const run = this.run(words);
    const files = this.files(out);
    const text = (/** @type {string} */ name) => {
      const bytes = files.find(([path]) => path === `${out}/${name}`)?.[1];
      return bytes && JSON.parse(new TextDecoder().decode(bytes));
    };
    const product = text('garment.json');
    const single = text('report.json');
    /** @type {{name: string, folder: string, unfold: any}[]} */
    const reports = product?.patches ?? (single ? [{ name: stem, folder: '.', unfold: single.unfold }] : []);
    // Meshes are of the format of the model's file.
    const mesh = (/** @type {string} */ stemOf) =>
      files.map(([path]) => path).find((path) => /\.(obj|ply|off|stl)$/.test(path) && path.slice(0, -4) === stemOf);
    /** @type {LaidPiece[]} */
    const pieces = reports.flatMap(({ name, folder: own, unfold }) => {
      const [processed, flat] = ['processed', 'flat'].map((one) => mesh(inside(out, own, one)));
      return processed && flat ? [{ name, figures: unfold, ...checked(this.module.readLaid(processed, flat)) }] : [];
    });
    this.remove(out);
    return {
      ...run,
      pieces,
      report: product ?? single ?? null,
      files: files.map(([path, bytes]) => [path.slice(out.length + 1), bytes]),
    };
  }
}

/** @param {string[]} parts */
function inside(...parts) {
  return parts.filter((part) => part !== '.').join('/');
}

/** @type {Promise<Program> | null} */
let program = null;

/**
 * @param {WebAssembly.Module} compiled
 * @param {string} pageScript
 * @returns {Promise<Program>}
 */
function started(compiled, pageScript) {
  // @ts-expect-error: emscripten makes it; its script comes before this one
  return globalThis.planishModule({
    /** @type {(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => {}} */
    instantiateWasm: (imports, done) => {
      void WebAssembly.instantiate(compiled, imports).then(done);
      return {};
    },
  }).then((/** @type {Module} */ module) => {
    module.FS.writeFile(pageScriptFile, pageScript);
    return new Program(module);
  });
}

/** @param {{id: number, call: string, values: any[]}} message */
async function answer({ id, call, values }) {
  try {
    if (call === 'compile') {
      postMessage({ id, result: await WebAssembly.compile(joined(values.map(unpacked))) });
      return;
    }
    if (call === 'start') {
      program = started(values[0], values[1]);
      await program;
      postMessage({ id, result: null });
      return;
    }
    if (!program) throw new Error('the program was not started');
    const own = await program;
    own.on_progress = (stage, share, subject) => postMessage({ id, progress: { stage, share, subject } });
    const result = /** @type {any} */ (own)[call](...values);
    postMessage({ id, result }, { transfer: buffersOf(result) });
  } catch (error) {
    postMessage({ id, error: error instanceof Error ? error.message : String(error) });
  }
}

/**
 * The memory of all arrays, which is handed over and not copied.
 * @param {unknown} value
 * @returns {ArrayBuffer[]}
 */
function buffersOf(value) {
  if (ArrayBuffer.isView(value)) return value.buffer instanceof ArrayBuffer ? [value.buffer] : [];
  if (typeof value !== 'object' || value === null) return [];
  return [...new Set(Object.values(value).flatMap(buffersOf))];
}

addEventListener('message', (event) => void answer(event.data));
