// The page of a report: turns the still pictures of the patch into a view that can be turned, and
// links it with the pattern.
import { filled, nextScale } from '../viewer/colors.js';
import { unpack } from './data.js';
import { namedFigures, worstOf } from '../viewer/figures.js';
import { Readout, Scale, figureChoice, make } from './panel.js';
import { PatternView, addLayerSwitches } from '../viewer/pattern_view.js';
import { pick } from '../viewer/picking.js';
import { PatchScene } from '../viewer/patch_scene.js';
import { Turning } from '../viewer/turning.js';

class Page {
  constructor(stage, data, canvas, context) {
    this.data = data;
    this.canvas = canvas;
    this.figures = namedFigures(data);
    this.pinned = -1;
    this.hovered = -1;
    this.build(stage);
    this.scene = new PatchScene(canvas, context, data);
    this.turning = new Turning(
      this.canvas,
      this.scene,
      () => this.redraw(true),
      (event) => this.pin(this.vertexAt(event)),
    );
    this.link();
    this.choose(this.figures[0]);
    new ResizeObserver(() => this.fit()).observe(this.view);
    this.fit();
  }

  build(stage) {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    this.canvas.setAttribute(
      'aria-label',
      'Patch in space. Arrow keys turn it, plus and minus zoom, 0 resets.',
    );
    this.slider = make('input', { type: 'range', className: 'split', min: 0, max: 100, step: 1, value: 50 });
    this.slider.setAttribute('aria-label', 'How much is shown as before');
    this.line = make('div', { className: 'split-line' });
    this.spot = make('div', { className: 'spot', hidden: true });
    this.tags = ['before', 'after'].map((name) => make('span', { className: `tag ${name}`, textContent: name }));
    this.view = make('div', { className: 'view' }, this.canvas, this.line, ...this.tags, this.spot, this.slider);
    this.scaleBar = new Scale(this.data.maps, this.data.unit, (step) => this.rescale(step));
    this.readout = new Readout(this.figures, this.data);
    const button = (text, title, action) => {
      const made = make('button', { type: 'button', textContent: text, title });
      made.addEventListener('click', action);
      return made;
    };
    stage.append(
      make(
        'div',
        { className: 'tools' },
        figureChoice(this.figures, (figure) => this.choose(figure)),
        ...this.stateChoice(),
        make(
          'div',
          { className: 'actions' },
          button('Worst place', 'Mark where the figure shown is largest after evolving', () => this.showWorst()),
          button('Reset view', 'Key 0', () => this.turning.reset()),
        ),
      ),
      this.view,
      this.scaleBar.root,
      this.readout.root,
      make('p', {
        className: 'hint',
        textContent: matchMedia('(pointer: coarse)').matches
          ? 'A finger turns it, two move and zoom it; tap to mark a place.'
          : 'Drag to turn, shift and drag to move, click to keep a place marked (Escape lets it go). ' +
            'Wheel zooms after a click into the picture.',
      }),
      ...this.simplified(),
    );
  }

  // Which result stands beside the patch as it came, where there are several.
  stateChoice() {
    const { names } = this.data;
    if (names.length <= 2) return [];
    const select = make('select', {}, ...names.slice(1).map((name, i) => new Option(name, i + 1)));
    select.addEventListener('change', () => {
      this.scene.shown = [0, Number(select.value)];
      this.tags[1].textContent = names[select.value];
      this.choose(this.figure);
      this.showVertex();
    });
    select.value = this.data.shown;
    this.tags[1].textContent = names[this.data.shown];
    return [make('label', { className: 'state' }, 'Method ', select)];
  }

  simplified() {
    const { count, whole } = this.data;
    if (count >= whole) return [];
    const text = (number) => number.toLocaleString('en').replaceAll(',', '\u202f');
    return [
      make('p', {
        className: 'hint simplified',
        textContent:
          `Drawn with ${text(count)} of ${text(whole)} vertices, the worst among them. ` +
          'The figures of each are those of the full mesh.',
      }),
    ];
  }

  link() {
    this.canvas.addEventListener('pointermove', (event) => {
      if (!this.turning.isDragging) this.hover(this.vertexAt(event));
    });
    this.canvas.addEventListener('pointerleave', () => this.hover(-1));
    this.slider.addEventListener('input', () => this.redraw(false));
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.pin(-1);
    });
    const svg = document.querySelector('svg.pattern');
    if (!svg || !this.data.drawn) return;
    this.pattern = new PatternView(
      svg,
      this.data.drawn,
      (vertex) => this.hover(vertex),
      (vertex) => this.pin(vertex),
    );
    addLayerSwitches(svg, document.querySelector('ul.lines'));
  }

  choose(figure) {
    this.figure = figure;
    this.limit = figure.limit;
    this.scene.color(
      figure.values.map((values) => values && filled(values, this.data.triangles)),
      figure.map,
      this.limit,
      figure.isSigned,
      figure.beyond,
    );
    // How far a place moved is shown on both sides.
    if (figure.id === 'deviation') {
      const moved = figure.values[this.scene.shown[1]];
      this.scene.color(figure.values.map((values, i) => (i === 0 ? moved : values)), figure.map, this.limit, false);
    }
    this.scaleBar.show(figure, this.limit);
    this.redraw(false);
  }

  rescale(step) {
    this.limit = nextScale(this.limit, step);
    this.scene.scale(this.limit);
    this.scaleBar.show(this.figure, this.limit);
    this.redraw(false);
  }

  vertexAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    const side = x < this.scene.split * this.scene.width ? 0 : 1;
    return pick(this.places(side), this.data.triangles, x, y);
  }

  // Where the vertices of one side are, kept until the view changes.
  places(side) {
    const state = this.scene.shown[side];
    this.kept ??= new Map();
    if (!this.kept.has(state)) this.kept.set(state, this.scene.projected(state));
    return this.kept.get(state);
  }

  hover(vertex) {
    if (vertex === this.hovered) return;
    this.hovered = vertex;
    this.showVertex();
  }

  pin(vertex) {
    this.pinned = vertex;
    this.showVertex();
  }

  showWorst() {
    const judge = this.figures.find(({ id }) => id === this.figure.worst) ?? this.figure;
    const values = judge.values[this.scene.shown[1]];
    this.pin(values ? worstOf(values) : -1);
  }

  showVertex() {
    const vertex = this.hovered < 0 ? this.pinned : this.hovered;
    this.readout.show(vertex, this.scene.shown);
    this.pattern?.show(vertex);
    this.showSpot();
  }

  // On the side on which the vertex is seen; on a pinned one where both are, after.
  showSpot() {
    const vertex = this.hovered < 0 ? this.pinned : this.hovered;
    const at = this.scene.split * this.scene.width;
    const place = [1, 0]
      .map((side) => ({ side, x: this.places(side)[3 * vertex], y: this.places(side)[3 * vertex + 1] }))
      .find(({ side, x }) => (side === 0 ? x < at : x >= at));
    this.spot.hidden = vertex < 0 || !place;
    if (this.spot.hidden) return;
    this.spot.style.transform = `translate(${place.x}px, ${place.y}px)`;
  }

  fit() {
    const { clientWidth, clientHeight } = this.view;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.scene.resize(clientWidth, clientHeight, Math.min(2, window.devicePixelRatio));
    this.kept = null;
    this.paint();
  }

  // moved: whether the camera did
  redraw(moved) {
    if (moved) this.kept = null;
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.paint();
    });
  }

  paint() {
    if (!this.scene.width) return;
    const share = this.slider.value / 100;
    this.scene.split = share;
    this.view.style.setProperty('--split', `${this.slider.value}%`);
    this.view.classList.toggle('only-after', share < 0.14);
    this.view.classList.toggle('only-before', share > 0.86);
    this.slider.setAttribute('aria-valuetext', `${this.slider.value} % before`);
    this.scene.draw();
    this.showSpot();
    const { dataset } = this.view;
    dataset.ready ??= Math.round(performance.now());
  }
}

const block = document.getElementById('report-data');
const stage = document.getElementById('stage');
if (block && stage) {
  const canvas = make('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
  if (context) {
    document.documentElement.classList.add('live');
    new Page(stage, unpack(JSON.parse(block.textContent)), canvas, context);
  } else {
    stage.append(
      make('p', { className: 'hint', textContent: 'This browser cannot draw in space (no WebGL); here are still pictures.' }),
    );
  }
}
