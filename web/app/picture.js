// The pieces that are shown, on the model and as a pattern.
import { gradientOf } from '../viewer/color_scale.js';
import { make } from '../viewer/dom.js';
import { colorLimit, joined } from './mesh.js';

/** @typedef {import('./engine.js').LaidPiece} LaidPiece */
/** @typedef {import('./frame.js').Frame} Frame */
/** @typedef {import('./stage.js').Stage} Stage */
/** @typedef {import('../viewer/color_scale.js').Color} Color */

/** Colours of pieces, different for colour-blind eyes as well. @type {Color[]} */
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

/** @param {number} piece */
export function tintOf(piece) {
  return tints[piece % tints.length];
}

export class Picture {
  /**
   * @param {Frame} frame
   * @param {Map<string, Uint8Array>} maps
   */
  constructor(frame, maps) {
    this.frame = frame;
    this.maps = maps;
    /** Null where the browser cannot draw in space. @type {Stage | null} */
    this.stage = null;
    /** @type {LaidPiece[]} */
    this.pieces = [];
    /** The same as one mesh. @type {ReturnType<typeof joined> | null} */
    this.body = null;
    this.by = /** @type {'stretch' | 'pieces'} */ ('stretch');
  }

  /** @param {Stage | null} stage of another model */
  begin(stage) {
    this.stage = stage;
    this.pieces = [];
    this.body = null;
    this.frame.sheet.show([]);
  }

  /** @param {LaidPiece[]} pieces */
  show(pieces) {
    this.pieces = pieces;
    this.body = joined(pieces);
    const { stage, body } = this;
    if (stage && pieces.length > 0) {
      stage.view.replace({
        ...stage.plainPatch,
        positions: [body.positions],
        triangles: body.triangles,
        pieces: { of: body.of, ways: body.ways, colors: pieces.map((_, k) => tintOf(k)), lines: [] },
      });
    }
    this.frame.sheet.show(pieces);
    this.paint();
  }

  /** @param {'stretch' | 'pieces'} by */
  colorBy(by) {
    this.by = by;
    this.paint();
  }

  /** Colours model and pattern. */
  paint() {
    const { body, pieces, stage, by, frame } = this;
    const map = this.maps.get('diverging');
    if (!body || !map) return;
    const limit = colorLimit(pieces.map(({ strain }) => strain));
    frame.sheet.color({ by, map, limit, pieces: pieces.map((_, k) => tintOf(k)) });
    if (by === 'pieces') stage?.view.plain();
    else stage?.view.color({ values: [body.strain], map: 'diverging', limit, isSigned: true });
    const bar = make('div', { className: 'bar' });
    bar.style.background = gradientOf(map);
    const end = `${Number((100 * limit).toPrecision(2))} %`;
    const words = [`shorter −${end}`, '0', `longer +${end}`].map((textContent) => make('span', { textContent }));
    frame.scale.replaceChildren(bar, make('div', { className: 'labels' }, ...words));
    frame.scale.hidden = by === 'pieces';
  }

  /** @param {number} vertex of all pieces, or -1 */
  mark(vertex) {
    if (!this.body) return;
    this.stage?.view.mark(vertex);
    this.frame.sheet.mark(vertex);
  }
}
