// Seams that the program proposes.
import { objText, pointAt } from '../mesh.js';
import { cutsOf, dartsFile, dartsWords, linesOf, panelsWords, seamsFile } from '../project.js';
import { loosened } from './simplify.js';
import { errorOf } from '../words.js';

/** @typedef {import('../app.js').App} App */
/** @typedef {import('../engine.js').LaidPiece} LaidPiece */

const pieceFile = 'piece.obj'; // that darts are proposed for

/**
 * The file that a run of the program writes, as a text; empty where it writes none.
 * @param {App} app
 * @param {string[]} words
 * @param {string} file
 */
async function written(app, words, file) {
  await app.jobs.remove(file);
  const run = await app.jobs.call('run', words);
  const [made] = await app.jobs.call('files', file);
  return { run, text: made ? new TextDecoder().decode(made[1]) : '' };
}

/**
 * Lines that divide the model into panels, in the place of all that there are.
 * @param {App} app
 * @param {string} rms limit of strain
 */
export async function proposePanels(app, rms) {
  await app.interrupt();
  await app.job(async () => {
    const { run, text } = await written(app, panelsWords(app.project, rms), seamsFile);
    if (text === '') throw new Error(errorOf(run.err));
    const lines = linesOf(text);
    app.say(`${lines.length} seams proposed`);
    app.change({ lines, names: {}, without: [], notches: [] });
  });
}

/**
 * Darts of some pieces, beside the lines that there are.
 * @param {App} app
 * @param {string} strain limit
 * @param {LaidPiece[]} pieces as they are in space
 */
export async function proposeDarts(app, strain, pieces) {
  await app.interrupt();
  await app.job(async () => {
    const darts = [];
    for (const { positions, triangles } of pieces) {
      await app.jobs.write(pieceFile, new TextEncoder().encode(objText(positions, triangles)));
      const { run, text } = await written(app, dartsWords(app.project, pieceFile, strain), dartsFile);
      await app.jobs.remove(pieceFile);
      if (run.code !== 0) throw new Error(errorOf(run.err));
      darts.push(...cutsOf(text).map((cut) => loosened(cut.map((v) => pointAt(positions, v)), positions)));
    }
    app.say(darts.length > 0 ? `Darts proposed: ${darts.length}` : 'No dart makes this better');
    if (darts.length > 0) app.change({ lines: [...app.project.lines, ...darts] });
  });
}
