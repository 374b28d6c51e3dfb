// The panel's rows for one surface that is cut out of the field: where a slice lies, or at which value an isosurface.

import {segments, select, slider} from './controls.js';
import {h} from '../page/dom.js';
import {axisOf} from '../view/surface_spec.js';
import {add, dot, normalize, scale} from '../view/vec3.js';

const AXES = ['x', 'y', 'z'];
const PRECISION = 1e-6;  // Of the data's extent: what a slice's origin is rounded to.

/// `value` to as many digits as tell apart the PRECISION of the range from `lo` to `hi`.
export function roundedIn(value, lo, hi) {
  const places = Math.ceil(-Math.log10(PRECISION * (hi - lo || 1)));
  return Number(value.toFixed(Math.max(0, Math.min(15, places))));
}

/// The middle of bounds, in numbers that a person can read.
export const middleOf = ([lo, hi]) => lo.map((x, i) => roundedIn((x + hi[i]) / 2, x, hi[i]));

/// A slice along another axis through what `slice` goes through, or through the middle where that is not within the bounds.
export function turnedTo(axis, {origin}, [lo, hi]) {
  const middle = middleOf([lo, hi]), normal = [0, 0, 0];
  normal[axis] = 1;
  return {kind: 'slice', origin: origin.map((x, i) => (x > lo[i] && x < hi[i] ? x : middle[i])), normal};
}

/// Where a slice lies, as a number of [least, most] in bounds: the coordinate of its axis, or how far along its normal.
export function placeOfSlice({origin, normal}, [lo, hi]) {
  const axis = axisOf(normal);
  if (axis >= 0) return {value: origin[axis], least: lo[axis], most: hi[axis]};
  const along = normalize(normal), corner = (end) => along.reduce((sum, x, i) => sum + x * (x > 0 === end ? hi[i] : lo[i]), 0);
  return {value: dot(origin, along), least: corner(false), most: corner(true)};
}

/// The slice moved to that place; its normal stays.
export function movedSlice(slice, value, bounds) {
  const {origin, normal} = slice, axis = axisOf(normal);
  if (axis >= 0) return {...slice, origin: origin.map((x, i) => (i === axis ? value : x))};
  const along = normalize(normal), moved = add(origin, scale(along, value - dot(origin, along)));
  return {...slice, origin: moved.map((x, i) => roundedIn(x, bounds[0][i], bounds[1][i]))};
}

/// In the middle of an array's values.
export const middleValue = ([lo, hi]) => Number(((lo + hi) / 2).toFixed(Math.max(0, Math.min(12, 3 - Math.floor(Math.log10(hi - lo || 1))))));

/// {elements, update(cut)}. `bounds()` are the field's, `isosurfaces()` the arrays with their ranges. ask(cut, isMoving)
/// wants the cut elsewhere; one whose value is NaN is not to be asked for yet.
export function cutRows({bounds, isosurfaces, ask}) {
  let cut = {};
  const want = (next, isMoving = false) => {
    cut = next;
    ask(next, isMoving);
    show();
  };
  const axis = segments({label: 'Across', choices: AXES.map((name) => [name, name]),
                         onInput: (name) => want(turnedTo(AXES.indexOf(name), cut, bounds()))});
  const position = slider({label: 'Position', digits: 4, onInput: (value, isMoving) => want(movedSlice(cut, value, bounds()), isMoving)});
  const direction = h('p', {class: 'hint'});
  const rangeOf = (name) => isosurfaces().find((one) => one.array === name)?.range;
  const array = select({label: 'Array', onInput: (name) => want({...cut, array: name, value: rangeOf(name) ? middleValue(rangeOf(name)) : NaN})});
  const value = slider({label: 'Value', digits: 4, onInput: (number, isMoving) => want({...cut, value: number}, isMoving)});
  const rangeless = h('p', {class: 'hint'}, 'The range of this array is not known. Type a value to cut at.');
  let listed = '';

  function show() {
    const isSlice = cut.kind === 'slice', isIso = cut.kind === 'isosurface';
    for (const row of [axis, position]) row.show(isSlice);
    const along = isSlice ? axisOf(cut.normal) : -1;
    direction.hidden = !isSlice || along >= 0;
    if (isSlice) {
      const {value: at, least, most} = placeOfSlice(cut, bounds());
      axis.set(AXES[along] ?? '');
      position.setRange(least, most);
      position.set(at);
      direction.textContent = `Across ${cut.normal.map((x) => Number(x.toPrecision(4))).join(', ')}; its position is counted in that direction.`;
    }
    const names = isosurfaces().map((one) => one.array);
    if (isIso && !names.includes(cut.array)) names.push(cut.array);
    if (names.join('\n') !== listed) array.setChoices(names.map((name) => [name, name]));
    listed = names.join('\n');
    array.show(isIso && names.length > 1);
    value.show(isIso);
    rangeless.hidden = !isIso || !Number.isNaN(cut.value);
    if (!isIso) return;
    array.set(cut.array);
    value.setRange(...rangeOf(cut.array) ?? [0, 0]);
    value.set(cut.value);
  }

  return {elements: [axis.element, position.element, direction, array.element, value.element, rangeless], update(next) {
    cut = next;
    show();
  }};
}
