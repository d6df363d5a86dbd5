// The controls beside the model: file, unit, seams, material, pieces.
import { make } from '../viewer/dom.js';
import { sizeText } from './mesh.js';
import { units } from './project.js';

/** @typedef {import('./project.js').Project} Project */

/** What the program makes by formula; `planish sample` says of each what it is. */
export const samples = [
  { name: 'dome', text: 'Dome' },
  { name: 'saddle', text: 'Saddle' },
  { name: 'panel', text: 'Car panel' },
  { name: 'cone', text: 'Cone' },
  { name: 'cylinder', text: 'Cylinder' },
  { name: 'tangent', text: 'Twisted strip' },
];

/**
 * @param {string} text
 * @param {() => void} action
 * @param {Record<string, unknown>} [properties]
 */
export function button(text, action, properties = {}) {
  const made = make('button', { type: 'button', textContent: text, ...properties });
  made.addEventListener('click', action);
  return made;
}

/**
 * A part of the page with its heading.
 * @param {string} title
 * @param {(Node | string)[]} children
 */
export function part(title, ...children) {
  return make('section', {}, make('h2', { textContent: title }), ...children);
}

/**
 * @param {string} text
 * @param {HTMLElement} field
 * @param {string} [hint]
 */
function labelled(text, field, hint = '') {
  return make(
    'label',
    { className: 'field' },
    make('span', { textContent: text }),
    field,
    ...(hint ? [make('small', { textContent: hint })] : []),
  );
}

/** Where a file is dropped or picked. */
export class FilePart {
  /**
   * @param {(files: File[]) => void} opened
   * @param {(sample: string) => void} chosen
   */
  constructor(opened, chosen) {
    const input = make('input', { type: 'file', multiple: true, accept: '.obj,.ply,.stl,.off,.json,.html', className: 'unseen' });
    input.addEventListener('change', () => {
      const files = [...(input.files ?? [])];
      input.value = '';
      if (files.length > 0) opened(files);
    });
    const zone = make(
      'label',
      { className: 'zone' },
      make('b', { textContent: 'Drop a model here' }),
      make('span', { textContent: 'or click to choose: OBJ, PLY, STL, OFF, a project or a report' }),
      input,
    );
    const row = make(
      'div',
      { className: 'samples' },
      ...samples.map(({ name, text }) => button(text, () => chosen(name), { dataset: { sample: name } })),
    );
    this.root = part('Model', zone, make('p', { textContent: 'Or try one of these:' }), row);
  }
}

/** What earlier tabs left, and whether the browser keeps the work. */
export class KeepingPart {
  /** @param {(isOn: boolean) => void} wanted */
  constructor(wanted) {
    this.box = make('input', { type: 'checkbox' });
    this.box.addEventListener('change', () => wanted(this.box.checked));
    this.list = make('div', { className: 'samples' });
    this.root = make(
      'div',
      { className: 'keeping', hidden: true },
      this.list,
      make('label', { className: 'check' }, this.box, 'Keep my work in this browser'),
    );
  }

  /**
   * @param {boolean} canKeep
   * @param {boolean} isWanted
   * @param {{text: string, open: () => void}[]} works
   */
  show(canKeep, isWanted, works) {
    this.root.hidden = !canKeep;
    this.box.checked = isWanted;
    const buttons = works.map(({ text, open }) => button(`Go on with ${text}`, open, { dataset: { work: '' } }));
    this.list.replaceChildren(...buttons);
  }
}

/** The unit, with what the size of the model would be in each. */
export class UnitPart {
  /** @param {(unit: string) => void} chosen */
  constructor(chosen) {
    this.chosen = chosen;
    this.list = make('div', { className: 'units', role: 'radiogroup', ariaLabel: 'Unit of the model' });
    this.root = part('Size', this.list);
    this.root.hidden = true;
  }

  /**
   * @param {Float32Array} positions
   * @param {string} unit that is chosen
   * @param {string} stated by the file, or ''
   */
  show(positions, unit, stated) {
    this.root.hidden = false;
    const rows = units.map((name) => {
      const { size, words } = sizeText(positions, name);
      const radio = make('input', { type: 'radio', name: 'unit', value: name, checked: name === unit });
      radio.addEventListener('change', () => this.chosen(name));
      const note = name === stated ? `${words}; the file says so` : words;
      return make(
        'label',
        {},
        radio,
        make('b', { textContent: name }),
        make('span', { textContent: size }),
        make('small', { textContent: note }),
      );
    });
    const had = this.list.contains(document.activeElement);
    this.list.replaceChildren(...rows);
    if (had) /** @type {HTMLElement | null} */ (this.list.querySelector('input:checked'))?.focus();
  }
}

/**
 * What the part with the seams calls.
 * @typedef {object} SeamListener
 * @property {() => void} draw begins to draw, or ends it
 * @property {(rms: string) => void} propose panels
 * @property {(strain: string) => void} proposeDarts
 * @property {(isOn: boolean) => void} mirror
 * @property {() => void} grain begins to set the grain, ends that, or takes the grain away
 * @property {() => void} notch begins to set notches, or ends it
 * @property {(line: number) => void} choose
 * @property {(line: number) => void} remove
 * @property {(line: number) => void} loosen makes a proposed line one whose points can be moved
 */

/** The seams, and how to draw them. */
export class SeamPart {
  /** @param {SeamListener} listener */
  constructor(listener) {
    this.listener = listener;
    this.draw = button('Draw a line', listener.draw, { className: 'main', ariaPressed: 'false' });
    this.limit = make('select', { ariaLabel: 'How much stretch panels may have' });
    for (const [value, text] of [
      ['1%', '1 %: stiff'],
      ['2%', '2 %'],
      ['5%', '5 %'],
      ['10%', '10 %: stretchy'],
    ]) {
      this.limit.append(new Option(text, value, value === '5%', value === '5%'));
    }
    this.notch = button('Set notches', listener.notch, { ariaPressed: 'false' });
    this.grain = button('Set the grain', listener.grain, { ariaPressed: 'false' });
    this.mirrored = make('input', { type: 'checkbox' });
    this.mirrored.addEventListener('change', () => listener.mirror(this.mirrored.checked));
    this.limitLabel = make('label', {}, 'usual stretch ', this.limit);
    this.panels = button('Propose panels', () => listener.propose(this.limit.value));
    this.darts = button('Propose darts', () => listener.proposeDarts(this.limit.value));
    this.mirrorLabel = make('label', { className: 'check' }, this.mirrored, 'Mirror lines left and right');
    this.hint = make('p', { className: 'hint', role: 'status' });
    this.list = make('ol', { className: 'lines' });
    this.root = part(
      'Seams',
      this.draw,
      this.hint,
      make('div', { className: 'row' }, this.panels, this.darts, this.limitLabel),
      this.mirrorLabel,
      make('div', { className: 'row' }, this.notch, this.grain),
      this.list,
    );
  }

  /**
   * @param {Project} project
   * @param {number} chosen
   * @param {(line: number) => string} lengthOf
   */
  show({ lines, symmetric, parts }, chosen, lengthOf) {
    // The program cuts models of one part only.
    for (const tool of [this.draw, this.panels, this.darts, this.limitLabel, this.mirrorLabel]) tool.hidden = parts.length > 0;
    this.mirrored.checked = symmetric !== '';
    this.notch.hidden = lines.length === 0;
    this.list.replaceChildren(
      ...lines.map((line, i) => {
        const length = lengthOf(i);
        const what = `${line.kind === 'drawn' ? 'proposed' : `${line.points.length} points`}${length && `, ${length}`}`;
        const name = button(`Line ${i + 1}: ${what}`, () => this.listener.choose(i), {
          className: 'name',
          ariaPressed: String(i === chosen),
        });
        const tools = [button('×', () => this.listener.remove(i), { ariaLabel: `Delete line ${i + 1}`, title: 'Delete' })];
        if (line.kind === 'drawn') {
          tools.unshift(button('Edit', () => this.listener.loosen(i), { ariaLabel: `Make line ${i + 1} one to be moved` }));
        }
        return make('li', {}, name, ...tools);
      }),
    );
  }
}

/** Material, allowance and pages. */
export class PatternPart {
  /** @param {(change: Partial<Project>) => void} changed */
  constructor(changed) {
    this.material = make('select');
    this.material.append(new Option('none: my form', ''));
    this.strain = make('input', { type: 'text', inputMode: 'decimal', placeholder: 'none', size: 6 });
    this.allowance = make('input', { type: 'text', inputMode: 'decimal', placeholder: 'none', size: 6 });
    this.paper = make('select');
    for (const [value, text] of [
      ['', 'one large page'],
      ['a4', 'also A4 pages to join'],
      ['a3', 'also A3 pages to join'],
      ['letter', 'also letter pages to join'],
    ]) {
      this.paper.append(new Option(text, value));
    }
    /** @type {[HTMLInputElement | HTMLSelectElement, 'material' | 'strain' | 'allowance' | 'paper'][]} */
    this.fields = [
      [this.material, 'material'],
      [this.strain, 'strain'],
      [this.allowance, 'allowance'],
      [this.paper, 'paper'],
    ];
    for (const [field, key] of this.fields) {
      field.addEventListener('change', () => changed({ [key]: withUnit(field.value.trim(), key) }));
    }
    this.root = part(
      'Material and pattern',
      labelled('Material', this.material, 'With one, the form changes as little as it needs to take it.'),
      labelled('Most stretch', this.strain, 'as 5 %; the form changes as little as that needs'),
      labelled('Allowance', this.allowance, 'beyond the seams, as 10 mm'),
      labelled('Printing', this.paper),
    );
  }

  /** @param {{name: string, use: string}[]} materials */
  offer(materials) {
    for (const { name, use } of materials) this.material.append(new Option(`${name}: ${use}`, name));
  }

  /** @param {Project} project */
  show(project) {
    for (const [field, key] of this.fields) {
      if (field instanceof HTMLSelectElement && ![...field.options].some(({ value }) => value === project[key])) {
        field.append(new Option(project[key], project[key]));
      }
      field.value = project[key];
    }
  }
}

/**
 * A number alone gets the unit that its field is labelled with.
 * @param {string} text
 * @param {string} key
 */
function withUnit(text, key) {
  const compact = text.replaceAll(' ', '').replace(',', '.');
  if (!/^\d*\.?\d+$/.test(compact)) return compact;
  return { strain: `${compact}%`, allowance: `${compact}mm` }[key] ?? compact;
}

/** The pieces by their names; they can be named anew and left out, and get darts. */
export class PiecePart {
  /**
   * @param {(change: {name?: [string, string], without?: [string, boolean]}) => void} changed
   * @param {(piece: number) => void} darted
   */
  constructor(changed, darted) {
    this.changed = changed;
    this.darted = darted;
    this.list = make('ul', { className: 'pieces' });
    this.root = part('Pieces', this.list);
    this.root.hidden = true;
  }

  /**
   * @param {{own: string, size: string, color: string}[]} pieces own names of the program
   * @param {Project} project
   */
  show(pieces, project) {
    this.root.hidden = pieces.length < 2;
    if (this.list.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement) {
      if (document.activeElement.type === 'text') return; // somebody types there
    }
    this.list.replaceChildren(
      ...pieces.map(({ own, size, color }, i) => {
        const isIn = !project.without.includes(own);
        const box = make('input', { type: 'checkbox', checked: isIn, ariaLabel: `Take the piece ${own}` });
        box.addEventListener('change', () => this.changed({ without: [own, !box.checked] }));
        const name = make('input', { type: 'text', value: project.names[own] ?? own, ariaLabel: `Name of ${own}` });
        name.addEventListener('change', () => this.changed({ name: [own, name.value.trim()] }));
        const swatch = make('span', { className: 'swatch' });
        swatch.style.background = color;
        const darts = button('Darts', () => this.darted(i), { ariaLabel: `Propose darts of ${own}`, title: 'Propose darts' });
        darts.hidden = !isIn || project.parts.length > 0;
        return make('li', {}, box, swatch, name, make('small', { textContent: size }), darts);
      }),
    );
  }
}
