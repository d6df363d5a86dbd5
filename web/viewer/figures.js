// What a pattern maker calls the figures of a vertex, and how they are written.

/**
 * What is measured at vertices, by states of the patch.
 * @typedef {object} Figure
 * @property {string} id as in `words` below
 * @property {string} map the name of its colour map
 * @property {number} limit |value| at which colours end, above 0
 * @property {(Float32Array | null)[]} values of each state one for each vertex, NaN where nothing is
 *   measured; null where the state has none
 * @property {number} [asked] the limit of strain, where the figure is what is used up of it and there
 *   is one for both ways
 * @property {import('./color_scale.js').Color} [beyond] the colour of what is beyond the limit
 */

/**
 * How a figure is named and written.
 * @typedef {object} Words
 * @property {string} name
 * @property {string} term the paper's
 * @property {boolean} isSigned whether colours go both ways from 0
 * @property {boolean} [isFixed] whether the scale cannot be made finer or coarser
 * @property {(value: number, unit: string) => string} text what a value reads
 * @property {(limit: number, unit: string, asked: number) => string[]} [ends] what the scale's low
 *   end, middle and high end read; a figure without stands in the table alone
 * @property {string} [further] what is beyond an end, if not "or more"
 * @property {string} [worst] which figure has the worst place, where it is another one
 */

/** @typedef {Figure & Words} NamedFigure */

const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** @param {number} power */
function powerOfTen(power) {
  const digits = [...String(Math.abs(power))].map((digit) => superscripts[Number(digit)]).join('');
  return `10${power < 0 ? '⁻' : ''}${digits}`;
}

/**
 * A number with a true minus; with a power of ten where it is out of the usual range.
 * @param {number} value
 * @param {number} digits significant ones
 */
export function written(value, digits = 3) {
  if (value === 0) return '0';
  const [mantissa, exponent] = Math.abs(value).toExponential(digits - 1).split('e');
  const power = Number(exponent);
  const sign = value < 0 ? '−' : '';
  if (power < -4 || power >= 6) return `${sign}${mantissa} × ${powerOfTen(power)}`;
  return sign + Math.abs(value).toFixed(Math.max(0, digits - 1 - power));
}

/**
 * @param {number} value
 * @param {number} [digits]
 */
function signed(value, digits) {
  return (value > 0 ? '+' : '') + written(value, digits);
}

const flatEnough = 1e-4; // radians, as the program counts
const unstretched = 1e-6;

/** @param {number} value radians */
function defectText(value) {
  const kind = Math.abs(value) <= flatEnough ? 'flat' : value > 0 ? 'dome' : 'saddle';
  return `${signed(value)} rad, ${kind}`;
}

/**
 * @param {number} value one over the square of a length
 * @param {string} unit
 */
function curvatureText(value, unit) {
  const size = Math.abs(value);
  if (!(size > 0)) return 'flat';
  return `ball of radius ${written(1 / Math.sqrt(size), 2)} ${unit}`;
}

/**
 * @param {number} value one over a length
 * @param {string} unit
 */
function bendText(value, unit) {
  if (!(value > 0)) return 'flat';
  return `as a cylinder of radius ${written(1 / value, 2)} ${unit}`;
}

/** @param {number} value 0.01 for one percent longer */
function strainText(value) {
  if (Math.abs(value) < unstretched) return 'none';
  return `${signed(100 * value, 2)} %, ${value > 0 ? 'longer' : 'shorter'}`;
}

/**
 * @param {number} value a length, positive to the side of the normal
 * @param {string} unit
 */
function offsetText(value, unit) {
  if (value === 0) return `0 ${unit}`;
  return `${signed(value, 2)} ${unit}, ${value > 0 ? 'outwards' : 'inwards'}`;
}

/** @param {number} limit */
function strainEnds(limit) {
  const end = `${written(100 * limit, 1)} %`;
  return [`shorter −${end}`, '0 keeps its length', `longer +${end}`];
}

/** Values are of 32 bits, and what keeps a limit exactly must not seem to be beyond it. */
export const rounding = 1e-6;

/** @param {number} share */
function percent(share) {
  return `${Number((100 * share).toPrecision(6))} %`;
}

/** @param {number} value share of the limit that is used up */
function limitText(value) {
  return `${written(100 * value, 2)} %${value > 1 + rounding ? ', beyond the limit' : ''}`;
}

/** @type {Record<string, Words>} */
const words = {
  limit_used: {
    name: 'Limit used up',
    term: '|strain of an edge| over its limit',
    isSigned: false,
    isFixed: true,
    text: limitText,
    ends: (_, __, asked) => ['0', '50 % used up', asked > 0 ? `100 %, limit of ${percent(asked)}` : '100 %, the limit'],
  },
  defect: {
    name: 'Dome or saddle',
    term: 'angle defect',
    isSigned: true,
    text: defectText,
    ends: (limit) => [`saddle −${written(limit, 1)} rad`, '0 lies flat', `dome +${written(limit, 1)} rad`],
  },
  curvature: {
    name: 'Curvature',
    term: '|K|, Eq. 1',
    isSigned: false,
    text: curvatureText,
    ends: (limit, unit) => ['0 flat', '', `ball of ${written(1 / Math.sqrt(limit), 2)} ${unit} radius`],
    further: 'or less',
  },
  bent: {
    name: 'Bent',
    term: 'curvature across edges',
    isSigned: false,
    text: bendText,
    ends: (limit, unit) => ['0 flat', '', `radius ${written(1 / limit, 2)} ${unit}`],
    further: 'or less',
  },
  offset: {
    name: 'Offset',
    term: 'move along the normal of the design',
    isSigned: true,
    text: offsetText,
    ends: (limit, unit) => [
      `inwards −${written(limit, 2)} ${unit}`,
      '0 where it was',
      `outwards +${written(limit, 2)} ${unit}`,
    ],
  },
  deviation: {
    name: 'Moved',
    term: 'deviation',
    isSigned: false,
    text: (value, unit) => `${written(value, 2)} ${unit}`,
    ends: (limit, unit) => ['0 stayed', '', `${written(limit, 1)} ${unit}`],
  },
  strain: {
    name: 'Stretch',
    term: 'strain of the pattern',
    isSigned: true,
    text: strainText,
    ends: strainEnds,
    worst: 'edge_strain',
  },
  edge_strain: {
    name: 'Largest stretch',
    term: 'strain of an edge',
    isSigned: true,
    text: strainText,
  },
  longest: {
    name: 'Longest way',
    term: 'larger principal stretch, minus 1',
    isSigned: true,
    text: strainText,
    ends: strainEnds,
  },
  shortest: {
    name: 'Shortest way',
    term: 'smaller principal stretch, minus 1',
    isSigned: true,
    text: strainText,
    ends: strainEnds,
  },
};

/** In which order figures stand; those that are not named follow. */
const order = ['offset', 'limit_used', 'strain', 'deviation', 'bent', 'defect', 'curvature'];

/**
 * Figures that have values in some state, with their words.
 * @param {Iterable<Figure>} figures
 * @returns {NamedFigure[]}
 */
export function namedFigures(figures) {
  const place = (/** @type {Figure} */ { id }) => (order.includes(id) ? order.indexOf(id) : order.length);
  return [...figures]
    .filter((figure) => figure.values.some((values) => values !== null))
    .sort((a, b) => place(a) - place(b))
    .map((figure) => ({ ...figure, ...words[figure.id] }));
}

/** Whether a figure says what became of a place: it belongs to the result, and none to the design. */
export const isOfMove = (/** @type {{id: string}} */ { id }) => id === 'deviation' || id === 'offset';

/**
 * What the scale's low end, middle and high end read; where more lies beyond the ends, they say so.
 * @param {NamedFigure} figure
 * @param {number} limit |value| at which its colours end now
 * @param {string} unit
 */
export function labelsOf(figure, limit, unit) {
  const [low, middle, high] = figure.ends?.(limit, unit, figure.asked ?? 0) ?? ['', '', ''];
  if (figure.isFixed) return [low, middle, high];
  const largest = Math.max(...figure.values.map((values) => (values ? Math.abs(values[worstOf(values)]) : 0)));
  if (!(largest > limit * 1.000001)) return [low, middle, high];
  const further = ` ${figure.further ?? 'or more'}`;
  return [figure.isSigned ? low + further : low, middle, high + further];
}

/**
 * The figure of one vertex in words; what is not measured on the edge says so.
 * @param {Pick<Words, 'text'>} figure
 * @param {Float32Array | null} values of the state that is asked for
 * @param {number} vertex
 * @param {string} unit
 */
export function textOf(figure, values, vertex, unit) {
  if (!values) return '–';
  const value = values[vertex];
  return Number.isNaN(value) ? 'edge' : figure.text(value, unit);
}

/**
 * The vertex where |value| is largest; the first if there is no value.
 * @param {Float32Array} values
 */
export function worstOf(values) {
  let worst = 0;
  let largest = -1;
  values.forEach((value, vertex) => {
    if (Math.abs(value) > largest) {
      largest = Math.abs(value);
      worst = vertex;
    }
  });
  return worst;
}
