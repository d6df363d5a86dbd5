// A project: what was asked for and drawn on a model, as its file keeps it and as words of the program.

/** @typedef {[number, number, number]} Point in the coordinates of the model's file */

/**
 * A seam line. Between the points of a `shortest` one seams run the shortest way over the surface; a `drawn` one
 * is laid on the surface as it is.
 * @typedef {object} Line
 * @property {'shortest' | 'drawn'} kind
 * @property {Point[]} points two or more; a closed line ends in its first point
 */

/**
 * Immutable: each change makes a new one.
 * @typedef {object} Project
 * @property {string} model name of its file
 * @property {string} hash SHA-256 of the file, hexadecimal
 * @property {string} unit '' where the file says it
 * @property {Line[]} lines
 * @property {Record<string, string>} names other names of pieces, by those that the program gives
 * @property {string[]} without pieces that are left out, by the program's names
 * @property {string} material '' for none
 * @property {string} strain limit of strain, as "5%"; '' for none
 * @property {string} allowance as "10mm"; '' for none
 * @property {string} paper of the pages to print; '' for none
 * @property {string} symmetric `auto` where lines are mirrored left and right; a plane as `x=0` where the half of the
 *   surface with the lines is taken for both; '' where neither
 * @property {Point[]} notches on seams
 * @property {ModelFile[]} parts the other files of a product of several ones, behind that of `model`
 * @property {string} grain direction of the grain on the model, as "0,0,1"; '' for none
 */

/** @typedef {{model: string, hash: string}} ModelFile a file's name, and its SHA-256 */

export const units = ['mm', 'cm', 'dm', 'm', 'in'];
const version = 1;
const kind = 'planish project';

/**
 * @param {string} model
 * @param {string} hash
 * @returns {Project}
 */
export function newProject(model, hash) {
  return {
    model,
    hash,
    unit: '',
    lines: [],
    names: {},
    without: [],
    material: '',
    strain: '',
    allowance: '',
    paper: '',
    symmetric: '',
    notches: [],
    parts: [],
    grain: '',
  };
}

/**
 * The files of its model.
 * @param {Project} project
 * @returns {ModelFile[]}
 */
export function modelFiles({ model, hash, parts }) {
  return [{ model, hash }, ...parts];
}

/** @param {Project} project */
export function projectText(project) {
  return `${JSON.stringify({ kind, version, ...project }, null, 1)}\n`;
}

/**
 * @param {unknown} value
 * @returns {value is Point}
 */
function isPoint(value) {
  return Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
}

/**
 * @param {unknown} value
 * @returns {Line}
 */
function lineOf(value) {
  const { kind: how, points } = /** @type {Partial<Line>} */ (value ?? {});
  if ((how !== 'shortest' && how !== 'drawn') || !Array.isArray(points) || points.length < 2 || !points.every(isPoint)) {
    throw new Error('a line of the project file is not one');
  }
  return { kind: how, points };
}

/**
 * Reads a project file, which may come from anywhere.
 * @param {string} text
 * @returns {Project}
 * @throws {Error} with words for the user
 */
export function readProject(text) {
  let packed;
  try {
    packed = JSON.parse(text);
  } catch {
    throw new Error('this is no project file: it is not JSON');
  }
  if (packed?.kind !== kind) throw new Error('this is no project file');
  if (packed.version !== version) {
    throw new Error(`this project file has version ${String(packed.version).slice(0, 20)}; this page reads version 1`);
  }
  const project = newProject('', '');
  for (const key of /** @type {const} */ (['model', 'hash', 'unit', 'material', 'strain', 'allowance', 'paper'])) {
    if (typeof packed[key] !== 'string') throw new Error(`the project file has no ${key}`);
    project[key] = packed[key];
  }
  if (project.unit !== '' && !units.includes(project.unit)) throw new Error('the project file has no known unit');
  if (!Array.isArray(packed.lines) || !Array.isArray(packed.without)) throw new Error('the project file lacks lists');
  project.lines = packed.lines.map(lineOf);
  project.without = packed.without.map(String);
  // These came later.
  project.grain = String(packed.grain ?? '');
  if (!/^(|[-+.\de]+,[-+.\de]+,[-+.\de]+)$/.test(project.grain)) throw new Error('the project file has no such grain');
  if (packed.parts !== undefined && !Array.isArray(packed.parts)) throw new Error('the project file lacks lists');
  project.parts = (packed.parts ?? []).map((/** @type {any} */ part) => ({
    model: String(part?.model ?? ''),
    hash: String(part?.hash ?? ''),
  }));
  project.symmetric = String(packed.symmetric ?? '');
  if (!/^(|auto|[xyz]=[-+.\de]+)$/.test(project.symmetric)) throw new Error('the project file has no such plane');
  if (packed.notches !== undefined) {
    if (!Array.isArray(packed.notches) || !packed.notches.every(isPoint)) {
      throw new Error('a notch of the project file is not one');
    }
    project.notches = packed.notches;
  }
  project.names = Object.fromEntries(Object.entries(packed.names ?? {}).map(([key, name]) => [key, String(name)]));
  if ([...Object.values(project.names), ...project.without].some((name) => /\p{Cc}/u.test(name))) {
    throw new Error('a name in the project file has control characters');
  }
  return project;
}

/** The files that lines of the kind `drawn` and notches go to. */
export const seamsFile = 'seams.obj';
export const notchesFile = 'notches.obj';
/** That proposed darts come in. */
export const dartsFile = 'darts.txt';

/**
 * Lines over a model as an .obj has them.
 * @param {Line[]} lines
 */
export function drawnText(lines) {
  const rows = [];
  let count = 0;
  for (const { points } of lines) {
    for (const point of points) rows.push(`v ${point.join(' ')}`);
    rows.push(`l ${points.map((_, i) => count + i + 1).join(' ')}`);
    count += points.length;
  }
  return `${rows.join('\n')}\n`;
}

/**
 * Points over a model as an .obj has them.
 * @param {Point[]} points
 */
function pointsText(points) {
  return `${points.map((point) => `v ${point.join(' ')}\n`).join('')}p ${points.map((_, i) => i + 1).join(' ')}\n`;
}

/**
 * The files that the words of a project name, beside its model.
 * @param {Project} project
 * @returns {[string, string][]} name and text
 */
export function filesOf({ lines, notches }) {
  const drawn = lines.filter(({ kind: how }) => how === 'drawn');
  /** @type {[string, string][]} */
  const files = drawn.length > 0 ? [[seamsFile, drawnText(drawn)]] : [];
  if (notches.length > 0) files.push([notchesFile, pointsText(notches)]);
  return files;
}

/**
 * The lines (`l`) of an .obj.
 * @param {string} text
 * @returns {Line[]}
 */
export function linesOf(text) {
  /** @type {Point[]} */
  const vertices = [];
  /** @type {Line[]} */
  const lines = [];
  for (const row of text.split('\n')) {
    const [word, ...rest] = row.trim().split(/\s+/);
    if (word === 'v') vertices.push(/** @type {Point} */ (rest.slice(0, 3).map(Number)));
    if (word === 'l') lines.push({ kind: 'drawn', points: rest.map((i) => vertices[Number(i) - 1]) });
  }
  return lines;
}

/**
 * What is asked of the model in all verbs.
 * @param {Project} project
 */
function modelWords({ model, parts, unit }) {
  const product = parts.length > 0 ? [...parts.map((part) => part.model), '--product'] : [];
  return [model, ...product, ...(unit ? ['--unit', unit] : [])];
}

/**
 * What limits the stretch of the pattern.
 * @param {Project} project
 */
function limitWords({ material, strain }) {
  return [...(material ? ['--material', material] : []), ...(strain ? ['--max-strain', strain] : [])];
}

/**
 * A line of the kind `shortest` as `--cut` takes it.
 * @param {Line} line
 */
export function lineWord({ points }) {
  return `line ${points.map((point) => point.join(',')).join(' ')}`;
}

/**
 * How the surface is cut.
 * @param {Project} project
 */
function cutWords({ lines, symmetric }) {
  return [
    ...lines.filter(({ kind: how }) => how === 'shortest').flatMap((line) => ['--cut', lineWord(line)]),
    ...(lines.some(({ kind: how }) => how === 'drawn') ? ['--cut', seamsFile] : []),
    ...(symmetric ? ['--symmetric', symmetric] : []),
    ...(symmetric && symmetric !== 'auto' ? ['--mirror-surface'] : []),
  ];
}

/**
 * The command line of the program that cuts as a project says, and no more.
 * @param {Project} project
 */
export function sketchWords(project) {
  const others = project.parts.map(({ model }) => model);
  return ['flatten', project.model, ...others, ...cutWords(project)];
}

/**
 * The command line of the program that gives the pattern of a project. Lines of the kind `drawn` are in `seamsFile`.
 * @param {Project} project
 * @param {string} folder where it is written
 * @returns {string[]}
 */
export function flattenWords(project, folder) {
  const { names, without, allowance, paper, notches, grain } = project;
  const renamed = Object.entries(names)
    .filter(([old, name]) => name !== '' && name !== old)
    .map(([old, name]) => `${old}=${name}`);
  return [
    'flatten',
    ...modelWords(project),
    ...cutWords(project),
    ...limitWords(project),
    ...(renamed.length > 0 ? ['--rename', renamed.join(',')] : []),
    ...(without.length > 0 ? ['--without', without.join(',')] : []),
    ...(allowance ? ['--allowance', allowance] : []),
    ...(paper ? ['--paper', paper] : []),
    ...(notches.length > 0 ? ['--seam-notches', notchesFile] : []),
    ...(grain ? ['--grain', grain] : []),
    '--formats',
    'svg,dxf,pdf,plt',
    '--textured',
    '-o',
    folder,
  ];
}

/**
 * The command line that proposes seams.
 * @param {Project} project
 * @param {string} rms limit of the rms strain, as "2%"; where the project has no limit of its own
 */
export function panelsWords(project, rms) {
  const limit = limitWords(project);
  return ['panels', ...modelWords(project), ...(limit.length > 0 ? limit : ['--max-rms-strain', rms]), '-o', seamsFile];
}

/**
 * The command line that proposes darts.
 * @param {Project} project
 * @param {string} model file that is to get them
 * @param {string} strain limit, as "5%"; where the project has none of its own
 */
export function dartsWords(project, model, strain) {
  const limit = limitWords(project);
  const words = modelWords({ ...project, model, parts: [] });
  return ['suggest-cuts', ...words, ...(limit.length > 0 ? limit : ['--max-strain', strain]), '-o', dartsFile];
}

/**
 * The cuts of such a file, by the numbers of vertices.
 * @param {string} text
 * @returns {number[][]}
 */
export function cutsOf(text) {
  return text
    .split('\n')
    .map((row) => row.replace(/#.*/, '').trim())
    .filter((row) => row !== '')
    .map((row) => row.split(/[\s,]+/).map(Number));
}

/**
 * Words as a shell takes them.
 * @param {string[]} words
 */
export function shellText(words) {
  const plain = /^[\w@%+=:,./-]+$/;
  return ['planish', ...words]
    .map((word) => (plain.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`))
    .join(' ');
}

/** Projects that can be gone back to and forth. */
export class History {
  /** @param {Project} project */
  constructor(project) {
    this.now = project;
    /** @type {Project[]} */
    this.past = [];
    /** @type {Project[]} */
    this.future = [];
  }

  /** @param {Project} project */
  push(project) {
    this.past.push(this.now);
    this.now = project;
    this.future = [];
  }

  /** @returns {boolean} whether there was anything to undo */
  undo() {
    const last = this.past.pop();
    if (!last) return false;
    this.future.push(this.now);
    this.now = last;
    return true;
  }

  /** @returns {boolean} whether there was anything to do again */
  redo() {
    const next = this.future.pop();
    if (!next) return false;
    this.past.push(this.now);
    this.now = next;
    return true;
  }
}
