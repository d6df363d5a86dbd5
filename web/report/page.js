// The page of a report: the patch as a view that can be turned, linked with the pattern, the scale
// and the table of figures.
import { filled, nextScale } from '../viewer/color_scale.js';
import { countText, make } from '../viewer/dom.js';
import { isOfMove, namedFigures, worstOf } from '../viewer/figures.js';
import { PatchView } from '../viewer/patch_view.js';
import { PatternView } from '../viewer/pattern_view.js';
import { addLayerSwitches } from './layers.js';
import { Readout, Scale, arrangementChoice, button, figureChoice, toggle, turningHint } from './panel.js';

/** @typedef {import('../viewer/figures.js').NamedFigure} NamedFigure */
/** @typedef {import('./data.js').ReportData} ReportData */

const heights = { least: 250, most: 440 }; // of the view, pixels

export class Page {
  /**
   * @param {HTMLElement} stage where the view and all around it go
   * @param {ReportData} data
   * @param {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext}} space
   */
  constructor(stage, data, space) {
    this.data = data;
    this.figures = namedFigures(data.figures.values());
    /** The figure that colours the patch; null where its form alone is shown. */
    this.figure = /** @type {NamedFigure | null} */ (null);
    this.limit = 1;
    this.pinned = -1;
    this.hovered = -1;
    const listener = {
      /** @param {number} vertex */
      hovered: (vertex) => this.hover(vertex),
      /** @param {number} vertex */
      clicked: (vertex) => this.pin(vertex),
    };
    this.view = new PatchView(space, data, listener);
    this.view.heights = heights;
    this.view.arrange('beside');
    this.scale = new Scale(data.maps, data.unit, (step) => this.rescale(step));
    this.readout = new Readout(this.figures, data);
    stage.append(
      this.tools(),
      this.view.root,
      figureChoice(this.figures, (figure) => this.choose(figure)),
      this.scale.root,
      this.readout.root,
      turningHint('tap to mark a place', 'click to keep a place marked (Escape lets it go)'),
      ...this.simplified(),
    );
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.pin(-1);
    });
    const svg = /** @type {SVGSVGElement | null} */ (document.querySelector('svg.pattern'));
    const key = document.querySelector('ul.lines');
    this.pattern = svg && data.drawn && new PatternView(svg, data.drawn, listener);
    if (svg && data.drawn && key) addLayerSwitches(svg, key);
    this.choose(null);
    this.view.fit();
  }

  tools() {
    return make(
      'div',
      { className: 'tools' },
      arrangementChoice((arrangement) => this.view.arrange(arrangement)),
      toggle('Zebra stripes', 'As a polished surface mirrors them: where they break, the surface does', (isOn) =>
        this.view.zebra(isOn),
      ),
      ...this.stateChoice(),
      make(
        'div',
        { className: 'actions' },
        button('Worst place', 'Where the figure shown is largest after; for the form, where it went furthest', () =>
          this.showWorst(),
        ),
        button('Reset view', 'Key 0', () => this.view.reset()),
      ),
    );
  }

  // Which result is compared with the input patch, if there are several.
  stateChoice() {
    const { names, shown } = this.data;
    if (names.length <= 2) return [];
    const select = make('select', {}, ...names.slice(1).map((name, i) => new Option(name, String(i + 1))));
    /** @param {number} state */
    const show = (state) => this.view.show(state, names[state]);
    select.addEventListener('change', () => {
      show(Number(select.value));
      this.choose(this.figure);
      this.showVertex();
    });
    select.value = String(shown);
    show(shown);
    return [make('label', { className: 'state' }, 'Method ', select)];
  }

  simplified() {
    const { count, whole } = this.data;
    if (count >= whole) return [];
    return [
      make('p', {
        className: 'hint simplified',
        textContent:
          `Drawn with ${countText(count)} of ${countText(whole)} vertices, the worst among them. ` +
          'The figures of each are those of the full mesh.',
      }),
    ];
  }

  /** @param {NamedFigure | null} figure null for the form alone */
  choose(figure) {
    this.figure = figure;
    this.scale.root.hidden = figure === null;
    if (!figure) {
      this.view.plain();
      return;
    }
    this.limit = figure.limit;
    // How far a place moved is shown on both sides.
    const moved = isOfMove(figure) ? figure.values[this.view.shown[1]] : null;
    const values = figure.values.map((own, state) => (state === 0 && moved) || own);
    this.view.color({ ...figure, values: values.map((some) => some && filled(some, this.data.triangles)) });
    this.scale.show(figure, this.limit);
  }

  /** @param {number} step */
  rescale(step) {
    if (!this.figure) return;
    this.limit = nextScale(this.limit, step);
    this.view.scale(this.limit);
    this.scale.show(this.figure, this.limit);
  }

  /** @param {number} vertex */
  hover(vertex) {
    if (vertex === this.hovered) return;
    this.hovered = vertex;
    this.showVertex();
  }

  /** @param {number} vertex */
  pin(vertex) {
    this.pinned = vertex;
    this.showVertex();
  }

  showWorst() {
    const worst = this.figure ? this.figure.worst : 'deviation';
    const judge = this.figures.find(({ id }) => id === worst) ?? this.figure;
    const values = judge?.values[this.view.shown[1]];
    this.pin(values ? worstOf(values) : -1);
  }

  showVertex() {
    const vertex = this.hovered < 0 ? this.pinned : this.hovered;
    this.readout.show(vertex, this.view.shown);
    this.pattern?.mark(vertex);
    this.view.mark(vertex);
  }
}
