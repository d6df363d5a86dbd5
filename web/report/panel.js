// What stands around the view of the patch: which figure is shown, its scale, the split, and what
// the figures of a vertex are.
import { colorOf, gradientOf } from '../viewer/color_scale.js';
import { countText, make } from '../viewer/dom.js';
import { labelsOf, textOf } from '../viewer/figures.js';

/** @typedef {import('../viewer/color_scale.js').Color} Color */
/** @typedef {import('../viewer/figures.js').NamedFigure} NamedFigure */

/**
 * One of several figures to choose: a row of radio buttons.
 * @param {NamedFigure[]} figures
 * @param {(figure: NamedFigure) => void} chosen
 */
export function figureChoice(figures, chosen) {
  const group = make('fieldset', { className: 'choice' });
  group.append(make('legend', { className: 'unseen', textContent: 'Colour by' }));
  figures.filter((figure) => figure.ends).forEach((figure, index) => {
    const button = make('input', {
      type: 'radio',
      name: 'figure',
      value: figure.id,
      checked: index === 0,
    });
    button.addEventListener('change', () => chosen(figure));
    group.append(
      make('label', { title: `Term of the paper: ${figure.term}` }, button, make('span', { textContent: figure.name })),
    );
  });
  return group;
}

/** The colour scale with buttons that make it finer and coarser. */
export class Scale {
  /**
   * @param {Map<string, Uint8Array>} maps colour maps by name
   * @param {string} unit of the model
   * @param {(step: number) => void} stepped called with -1 for finer, 1 for coarser
   */
  constructor(maps, unit, stepped) {
    this.maps = maps;
    this.unit = unit;
    this.bar = make('div', { className: 'bar' });
    this.labels = [0, 1, 2].map(() => make('span'));
    this.beyond = make('span', { textContent: 'beyond' });
    this.row = make('div', { className: 'labels' }, ...this.labels);
    this.finer = make('button', {
      type: 'button',
      textContent: '+',
      title: 'Finer scale: shows smaller differences',
      ariaLabel: 'Finer scale',
    });
    this.coarser = make('button', {
      type: 'button',
      textContent: '−',
      title: 'Coarser scale',
      ariaLabel: 'Coarser scale',
    });
    this.finer.addEventListener('click', () => stepped(-1));
    this.coarser.addEventListener('click', () => stepped(1));
    this.root = make(
      'div',
      { className: 'scale' },
      this.coarser,
      make('div', {}, this.bar, this.row),
      this.finer,
    );
  }

  /**
   * @param {NamedFigure} figure
   * @param {number} limit |value| at which its colours end, above 0
   */
  show(figure, limit) {
    this.bar.style.background = gradientOf(this.maps.get(figure.map) ?? new Uint8Array());
    labelsOf(figure, limit, this.unit).forEach((text, i) => (this.labels[i].textContent = text));
    this.setApart(figure.beyond);
  }

  /**
   * For what is beyond a limit a field of its own, right of the bar.
   * @param {Color} [color]
   */
  setApart(color) {
    this.root.classList.toggle('bounded', color !== undefined);
    this.beyond.remove();
    if (!color) return;
    const field = colorOf(color);
    this.row.append(this.beyond);
    this.bar.style.background =
      `linear-gradient(${field}, ${field}) right / 21% 100% no-repeat, ` +
      `${this.bar.style.backgroundImage} left / 76.92% 100% no-repeat`;
  }
}

/** The figures of one vertex, before and after. */
export class Readout {
  /**
   * @param {NamedFigure[]} figures
   * @param {{unit: string, numbers: Uint32Array}} data unit of the model; numbers that vertices are known by
   */
  constructor(figures, data) {
    this.figures = figures;
    this.data = data;
    this.vertex = make('b', { dataset: { figure: 'vertex' } });
    this.rows = figures.map((figure) => ({
      figure,
      before: make('span', { dataset: { figure: figure.id, state: 'before' } }),
      after: make('span', { dataset: { figure: figure.id, state: 'after' } }),
    }));
    const table = make(
      'table',
      {},
      make(
        'thead',
        {},
        make(
          'tr',
          {},
          make('th', { scope: 'col' }, this.vertex),
          make('th', { scope: 'col', textContent: 'before' }),
          make('th', { scope: 'col', textContent: 'after' }),
        ),
      ),
      make(
        'tbody',
        {},
        ...this.rows.map(({ figure, before, after }) =>
          make(
            'tr',
            {},
            make('th', { scope: 'row', textContent: figure.name }),
            make('td', {}, before),
            make('td', {}, after),
          ),
        ),
      ),
    );
    this.root = make('div', { className: 'readout', role: 'status' }, table);
    this.show(-1, [0, 1]);
  }

  /**
   * @param {number} vertex -1 for none
   * @param {number[]} states the one before, the one after
   */
  show(vertex, states) {
    this.root.classList.toggle('empty', vertex < 0);
    this.vertex.textContent =
      vertex < 0 ? 'Point at a place' : `Vertex ${countText(this.data.numbers[vertex])}`;
    for (const { figure, before, after } of this.rows) {
      /** @param {number} state */
      const text = (state) =>
        vertex < 0 ? '–' : textOf(figure, figure.values[state], vertex, this.data.unit);
      // Where a place was before it moved needs no figure.
      before.textContent = figure.id === 'deviation' ? '–' : text(states[0]);
      after.textContent = text(states[1]);
    }
  }
}
