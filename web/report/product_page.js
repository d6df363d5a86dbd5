// The page of a product: all pieces as a view that can be turned and taken apart, linked with the list
// of pieces, their tiles and the table of seams.
import { countText, make } from '../viewer/dom.js';
import { PatchView } from '../viewer/patch_view.js';
import { arrangementChoice, button, turningHint, upChoice } from './panel.js';

/** @typedef {import('../viewer/color_scale.js').Color} Color */
/** @typedef {import('./product_data.js').ProductData} ProductData */

const heights = { least: 320, most: 560 }; // of the view, pixels
const farthest = 1; // how many times its own distance from the middle a piece goes

/**
 * A colour of an element as the page has it now.
 * @param {Element | null} element
 * @param {'stroke' | 'backgroundColor'} property
 * @returns {Color}
 */
function colorIn(element, property) {
  const text = element ? getComputedStyle(element)[property] : '';
  const parts = (text.match(/[\d.]+/g) ?? []).map(Number);
  return parts.length < 3 ? [90, 90, 90] : parts.slice(0, 3);
}

export class ProductPage {
  /**
   * @param {HTMLElement} stage where the view and all around it go
   * @param {ProductData} data
   * @param {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext}} space
   */
  constructor(stage, data, space) {
    this.data = data;
    /** Of pieces, -1 for none: kept, under the pointer in the view, under the pointer in the list. */
    this.kept = -1;
    this.pointed = -1;
    this.listed = -1;
    const piece = (/** @type {number} */ vertex) => (vertex < 0 ? -1 : (data.patch.pieces?.of[vertex] ?? -1));
    const listener = {
      /** @param {number} vertex */
      hovered: (vertex) => this.point(piece(vertex)),
      /** @param {number} vertex */
      clicked: (vertex) => this.keep(piece(vertex)),
    };
    this.view = new PatchView(space, data.patch, listener, { what: 'Product', tags: data.names });
    this.view.heights = heights;
    if (data.names.length > 1) this.view.arrange('beside');
    this.view.plain();
    this.name = make('p', { className: 'named', hidden: true });
    this.name.setAttribute('role', 'status');
    this.view.root.append(this.name);
    this.rows = this.buttons();
    stage.append(
      this.tools(),
      this.view.root,
      this.slider(),
      turningHint('tap a piece for its name', 'click a piece to keep it marked (Escape lets it go)'),
      ...this.simplified(),
    );
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.keep(-1);
    });
    const paint = () => this.paint();
    paint();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
    this.view.fit();
  }

  tools() {
    const { names, views } = this.data;
    return make(
      'div',
      { className: 'tools' },
      ...(names.length > 1 ? [arrangementChoice((arrangement) => this.view.arrange(arrangement))] : []),
      upChoice([...views], (view) => this.view.lookFrom(view)),
      make('div', { className: 'actions' }, button('Reset view', 'Key 0', () => this.view.reset())),
    );
  }

  /** Moves the pieces apart. */
  slider() {
    const ariaLabel = 'How far the pieces are apart';
    const slider = make('input', { type: 'range', min: '0', max: '100', step: '1', value: '0', ariaLabel });
    slider.addEventListener('input', () => this.view.moveApart((farthest * Number(slider.value)) / 100));
    return make(
      'label',
      { className: 'apart' },
      make('span', { textContent: 'Together' }),
      slider,
      make('span', { textContent: 'Apart' }),
    );
  }

  simplified() {
    const { count, whole } = this.data;
    if (count >= whole) return [];
    const textContent = `Drawn with ${countText(count)} of ${countText(whole)} vertices.`;
    return [make('p', { className: 'hint simplified', textContent })];
  }

  /** The rows of pieces that are in the picture, as buttons instead of links to their tiles. */
  buttons() {
    return this.data.pieces.map(({ number }, piece) => {
      const link = document.querySelector(`.parts a[href="#piece-${number}"]`);
      const row = make('button', { type: 'button', ariaPressed: 'false' });
      if (!link) return row;
      row.append(...link.childNodes);
      link.replaceWith(row);
      row.addEventListener('click', () => this.keep(piece));
      row.addEventListener('pointerenter', (event) => {
        if (event.pointerType === 'mouse') this.list(piece);
      });
      row.addEventListener('pointerleave', () => this.list(-1));
      return row;
    });
  }

  paint() {
    const lines = this.data.patch.pieces?.lines ?? [];
    const colors = lines.map(({ number }) => colorIn(document.querySelector(`#seam-${number} polyline`), 'stroke'));
    this.view.paintLines(colors, colorIn(document.querySelector('.whole'), 'backgroundColor'));
  }

  /** @param {number} piece under the pointer in the view */
  point(piece) {
    if (piece === this.pointed) return;
    this.pointed = piece;
    this.show();
  }

  /** @param {number} piece under the pointer in the list */
  list(piece) {
    this.listed = piece;
    this.show();
  }

  /** @param {number} piece to be kept; the one that is kept already is let go */
  keep(piece) {
    this.kept = piece === this.kept ? -1 : piece;
    this.show();
  }

  show() {
    const { kept, pointed, listed } = this;
    const asked = listed < 0 ? kept : listed;
    const named = pointed < 0 ? asked : pointed;
    this.view.choose(asked);
    this.rows.forEach((row, piece) => {
      row.ariaPressed = String(piece === kept);
      row.classList.toggle('named', piece === named);
    });
    this.scrollTo(pointed < 0 ? kept : pointed);
    this.mark(kept);
    this.nameOf(named);
  }

  /**
   * Brings the row of a piece into the list, where that is longer than it is high; the page stays.
   * @param {number} piece
   */
  scrollTo(piece) {
    const row = this.rows[piece];
    const list = row?.closest('ol');
    if (!list) return;
    const [inner, outer] = [row.getBoundingClientRect(), list.getBoundingClientRect()];
    if (inner.top < outer.top) list.scrollTop -= outer.top - inner.top;
    if (inner.bottom > outer.bottom) list.scrollTop += inner.bottom - outer.bottom;
  }

  /** @param {number} kept whose tile and seams are marked */
  mark(kept) {
    for (const marked of document.querySelectorAll('.marked')) marked.classList.remove('marked');
    if (kept < 0) return;
    const { number, seams } = this.data.pieces[kept];
    for (const id of [`piece-${number}`, ...seams.map((seam) => `seam-${seam}`)])
      document.getElementById(id)?.classList.add('marked');
  }

  /** @param {number} piece */
  nameOf(piece) {
    this.name.hidden = piece < 0;
    if (piece < 0) return;
    const { name, number, seams } = this.data.pieces[piece];
    const words = seams.length === 0 ? '' : `seam${seams.length > 1 ? 's' : ''} ${seams.join(', ')}`;
    this.name.replaceChildren(
      make('b', { textContent: name }),
      make('span', { textContent: words }),
      make('a', { href: `#piece-${number}`, textContent: 'its pattern' }),
    );
  }
}
