// A report that is dropped, or that opened the app: the model as it shows it, and what was asked for.
import { hello } from '../report/hand_over.js';
import { bytesOf, cornersOf, positionsOf } from '../report/data.js';
import { objText } from './mesh.js';
import { newProject, readProject } from './project.js';
import { fileName } from './words.js';

/** @typedef {import('./project.js').Project} Project */

/**
 * What a report hands over.
 * @typedef {object} HandedOver
 * @property {string} data the text of its data
 * @property {string} project the address of its project file, which holds it; '' where it has none
 * @property {string} without flags of the run that the project has no place for; '' for none
 * @property {string} title of the page
 */

/**
 * What the text of a report's page hands over. It may come from anywhere: nothing of it is run.
 * @param {string} html
 * @returns {HandedOver}
 */
export function readReport(html) {
  const found = (/** @type {RegExp} */ pattern) => pattern.exec(html)?.[1] ?? '';
  const data = found(/<script type="application\/json" id="report-data">([^<]*)<\/script>/);
  if (data === '') throw new Error('this page holds no model: a report of planish flatten does');
  return {
    data,
    project: found(/<a id="project" href="(data:[^"]*)"/),
    without: found(/<small>(without [^<]*)<\/small><\/p><\/div>/),
    title: found(/<title>([^<]*)<\/title>/),
  };
}

/** @param {string} address of a project file that is in it */
function projectIn(address) {
  const packed = /^data:application\/json;base64,([A-Za-z0-9+/=]*)$/.exec(address)?.[1];
  return packed === undefined ? null : readProject(new TextDecoder().decode(bytesOf(packed)));
}

/**
 * An .obj of what a report draws, each piece a group of its own.
 * @param {any} packed
 */
function objOf(packed) {
  const { names } = packed.states;
  // The design: a product whose form was kept has no other state.
  const positions = positionsOf(packed.states)[names.length > 1 || !packed.pieces ? 0 : names.length - 1];
  const triangles = cornersOf(packed.triangles);
  const groups = new Map();
  let [start, t] = [0, 0];
  for (const { name, vertices } of packed.pieces ?? []) {
    while (3 * t < triangles.length && triangles[3 * t] < start) ++t;
    groups.set(t, String(name).replace(/\p{Cc}/gu, ' '));
    start += vertices;
  }
  return objText(positions, triangles, groups);
}

/**
 * What the app opens of it.
 * @param {HandedOver} report
 */
export function opened({ data, project: address, without, title }) {
  let packed, obj;
  try {
    packed = JSON.parse(data);
    obj = objOf(packed);
  } catch {
    throw new Error('the report is damaged: its model cannot be read');
  }
  const asked = projectIn(address);
  const name = fileName(asked?.model.replace(/\.[^.]*$/, '') ?? title.replace(/ – Planish$/, ''));
  // Lines, names and notches are in the pieces already.
  const { material, strain, allowance, paper, grain } = asked ?? newProject('', '');
  return {
    name: `${name}-report.obj`,
    bytes: new TextEncoder().encode(obj),
    options: { unit: String(packed.unit), material, strain, allowance, paper, grain },
    asked,
    words: wordsOn(packed.vertices < packed.of, asked, without),
  };
}

/**
 * @param {boolean} isSimplified
 * @param {Project | null} asked
 * @param {string} without
 */
function wordsOn(isSimplified, asked, without) {
  const model = isSimplified ? 'simplified, and its places rounded' : 'with places rounded to 1/65,000 of its size';
  return [
    `This is the model as the report shows it: ${model}. Its seams are cut already.`,
    asked ? `For the exact pattern, with lines, names and notches to change, drop ${asked.model} too.` : '',
    without ? `The options came along ${without}.` : '',
  ]
    .filter((words) => words !== '')
    .join(' ');
}

/**
 * Tells the page that opened this one, and takes what it hands over.
 * @param {(report: HandedOver) => void} handed
 */
export function greetOpener(handed) {
  if (!window.opener) return;
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = ({ data }) => {
    const text = (/** @type {string} */ key) => String(data?.[key] ?? '');
    handed({ data: text('data'), project: text('project'), without: text('without'), title: text('title') });
  };
  window.opener.postMessage(hello, '*', [port2]);
}
