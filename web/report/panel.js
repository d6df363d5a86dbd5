// What stands around the view of the patch: which figure is shown, its scale, the split, and what
// the figures of a vertex are.
import { colorOf, gradientOf } from '../viewer/color_scale.js';
import { countText, make } from '../viewer/dom.js';
import { isOfMove, labelsOf, textOf } from '../viewer/figures.js';

/** @typedef {import('../viewer/color_scale.js').Color} Color */
/** @typedef {import('../viewer/figures.js').NamedFigure} NamedFigure */

/**
 * One of several things to choose, the first at the start: a row of radio buttons.
 * @template Item
 * @param {string} name of the group
 * @param {string} title what is chosen, for who cannot see it
 * @param {{value: string, text: string, title: string, item: Item}[]} options
 * @param {(item: Item) => void} chosen
 */
function choice(name, title, options, chosen) {
  const group = make('fieldset', { className: `choice ${name}` });
  group.append(make('legend', { className: 'unseen', textContent: title }));
  options.forEach(({ value, text, title: words, item }, index) => {
    const radio = make('input', { type: 'radio', name, value, checked: index === 0 });
    radio.addEventListener('change', () => chosen(item));
    group.append(make('label', { title: words }, radio, make('span', { textContent: text })));
  });
  return group;
}

/**
 * The form alone or a figure that colours it.
 * @param {NamedFigure[]} figures
 * @param {(figure: NamedFigure | null) => void} chosen called with null for the form
 */
export function figureChoice(figures, chosen) {
  /** @type {{value: string, text: string, title: string, item: NamedFigure | null}} */
  const form = { value: 'form', text: 'Form', title: 'No colours: the surface in plain light', item: null };
  const options = figures
    .filter((figure) => figure.ends)
    .map((figure) => ({
      value: figure.id,
      text: figure.name,
      title: `Term of the paper: ${figure.term}`,
      item: figure,
    }));
  return choice('figure', 'Colour by', [form, ...options], chosen);
}

/** @typedef {import('../viewer/patch_scene.js').Arrangement} Arrangement */

/** @type {{value: string, text: string, title: string, item: Arrangement}[]} */
const arrangements = [
  { value: 'beside', text: 'Side by side', title: 'Before and after, each whole', item: 'beside' },
  {
    value: 'overlay',
    text: 'Overlay',
    title: 'The result is solid, the design blue and seen through, with its contour',
    item: 'overlay',
  },
  { value: 'split', text: 'Slider', title: 'One picture: before left of the slider, after right', item: 'split' },
];

/** @param {(arrangement: Arrangement) => void} chosen */
export function arrangementChoice(chosen) {
  return choice('arrangement', 'Show the two forms', arrangements, chosen);
}

/**
 * Which axis of the model points up.
 * @param {[string, import('../viewer/patch_scene.js').Viewpoint][]} views with the names of the axes
 * @param {(view: import('../viewer/patch_scene.js').Viewpoint) => void} chosen
 */
export function upChoice(views, chosen) {
  const options = views.map(([axis, view]) => ({
    value: axis,
    text: `${axis} up`,
    title: `The ${axis} axis of the model points up`,
    item: view,
  }));
  return choice('up', 'Which axis points up', options, chosen);
}

/**
 * @param {string} text
 * @param {string} title
 * @param {() => void} action
 */
export function button(text, title, action) {
  const made = make('button', { type: 'button', textContent: text, title });
  made.addEventListener('click', action);
  return made;
}

/**
 * How to use a view.
 * @param {string} tap what a tap of a finger does
 * @param {string} click what a click does
 */
export function turningHint(tap, click) {
  return make('p', {
    className: 'hint',
    textContent: matchMedia('(pointer: coarse)').matches
      ? `A finger turns it, two move and zoom it; ${tap}.`
      : `Drag to turn, shift and drag to move, ${click}. Wheel zooms after a click into the picture.`,
  });
}

/**
 * A box to tick.
 * @param {string} text
 * @param {string} title
 * @param {(isOn: boolean) => void} changed
 */
export function toggle(text, title, changed) {
  const box = make('input', { type: 'checkbox' });
  box.addEventListener('change', () => changed(box.checked));
  return make('label', { className: 'toggle', title }, box, text);
}

/** The colour scale with buttons that make it finer and coarser. */
export class Scale {
  /**
   * @param {Map<string, Uint8Array>} maps colour maps by name
   * @param {string} unit of lengths
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
   * @param {{unit: string, numbers: Uint32Array}} data unit of lengths; numbers that vertices are known by
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
      before.textContent = isOfMove(figure) ? '–' : text(states[0]);
      after.textContent = text(states[1]);
    }
  }
}
