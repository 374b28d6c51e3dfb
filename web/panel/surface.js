// The panel's part about the surface that is shown. A change is a change for all viewers.

import {segments, select, slider, toggle} from './controls.js';
import {h} from '../page/dom.js';
import {parseSpec, shortName, specOf, specText} from '../view/surface_spec.js';

const NAMES = {original: 'As given', slice: 'Slice', isosurface: 'Isosurface', boundary: 'Boundary'};
const AXES = ['x', 'y', 'z'];

// The axis (0, 1, 2) that a slice's normal lies along, or -1.
const axisOf = (normal) => normal.findIndex((x, i) => x !== 0 && normal.every((other, k) => k === i || other === 0));

export function surfacePart({model, changes}) {
  let shown = {kind: 'original'}, choices = null;
  let draft = null;  // {array, value, over}: an isosurface that is not there yet, while the scene shows `over`.
  const ask = (spec, isMoving = false) => changes.request({surface: specText(spec)}, isMoving);
  const bounds = () => model.scene?.choices?.bounds ?? model.allBounds;
  const middle = () => bounds()[0].map((lo, i) => (lo + bounds()[1][i]) / 2);
  const isosurfaces = () => choices?.isosurface ?? [];

  function start(kind) {
    const hadDraft = draft !== null, sceneKind = parseSpec(specOf(model.scene)).kind;
    draft = null;
    if (hadDraft && kind === sceneKind) return update();
    if (kind === 'slice') return ask({kind, origin: middle(), normal: [1, 0, 0]});
    if (kind !== 'isosurface') return ask({kind});
    startIso(isosurfaces().find(({range}) => range) ?? isosurfaces()[0]);
  }
  // In the middle of the array's values; a person has to say where if the server has not looked for them.
  function startIso({array, range}) {
    if (range) return ask({kind: 'isosurface', array, value: rounded((range[0] + range[1]) / 2, range)});
    draft = {array, value: NaN, over: specOf(model.scene)};
    update();
  }
  const rounded = (value, [lo, hi]) => Number(value.toFixed(Math.max(0, Math.min(12, 3 - Math.floor(Math.log10(hi - lo || 1))))));

  const kind = segments({label: 'Surface', className: 'wrap', onInput: start});
  const axis = segments({label: 'Across', choices: AXES.map((name) => [name, name]), onInput: (name) => {
    const normal = [0, 0, 0];
    normal[AXES.indexOf(name)] = 1;
    ask({...shown, origin: middle(), normal});
  }});
  const position = slider({label: 'Position', min: 0, max: 1, digits: 4, onInput: (value, isMoving) => {
    const origin = [...shown.origin];
    origin[axisOf(shown.normal)] = value;
    ask({...shown, origin}, isMoving);
  }});
  const isoOf = (name) => isosurfaces().find((one) => one.array === name);
  const array = select({label: 'Array', onInput: (name) => startIso(isoOf(name))});
  const value = slider({label: 'Value', min: 0, max: 1, digits: 4, onInput: (number, isMoving) => {
    if (draft) draft.value = number;
    ask({...shown, value: number}, isMoving);
  }});
  const rangeless = h('p', {class: 'hint'}, 'The range of this array is not known. Type a value to cut at.');
  const list = h('div', {class: 'switches'});
  let listed = '', switches = [];
  const vectors = select({label: 'Vectors', onInput: (name) => changes.request({vectors: name})});
  const shared = h('p', {class: 'hint'}, 'Surface, vectors, what is coloured by and time are shared by all viewers.');

  // A switch for each of several surfaces.
  const ofSurfaces = () => changes.laidOver(model.scene).scene?.surfaces ?? [];
  function updateList() {
    const names = ofSurfaces().map(({spec}) => shortName(spec));
    if (names.join('\n') !== listed) {
      listed = names.join('\n');
      switches = names.length < 2 ? [] : names.map((label, i) => toggle({label, onInput: (on) =>
        changes.request({shown: ofSurfaces().map((one, k) => (k === i ? on : one.shown !== false))})}));
      list.replaceChildren(...switches.map((row) => row.element));
    }
    switches.forEach((row, i) => row.set(ofSurfaces()[i].shown !== false));
  }

  function updateChoices() {
    if (choices === model.scene.choices) return;
    choices = model.scene.choices ?? {};
    const canBeShown = (name) => name !== 'isosurface' || isosurfaces().length > 0;
    kind.setChoices((choices.surfaces ?? []).filter(canBeShown).map((name) => [name, NAMES[name] ?? name]));
    array.setChoices(isosurfaces().map((one) => [one.array, one.array]));
    vectors.setChoices((choices.vectors ?? []).map((name) => [name, name]));
  }

  function update() {
    if (!model.scene) return;
    updateChoices();
    updateList();
    if (draft?.over !== specOf(model.scene)) draft = null;
    const scene = changes.laidOver(model.scene);
    shown = draft ? {kind: 'isosurface', ...draft} : parseSpec(specOf(scene));
    kind.set(shown.kind);
    kind.show((choices.surfaces ?? []).length > 1);
    const isSlice = shown.kind === 'slice', along = isSlice ? axisOf(shown.normal) : -1, isIso = shown.kind === 'isosurface';
    axis.show(isSlice);
    axis.set(AXES[along] ?? '');
    position.show(along >= 0);
    if (along >= 0) {
      position.setRange(bounds()[0][along], bounds()[1][along]);
      position.set(shown.origin[along]);
    }
    array.show(isIso && isosurfaces().length > 1);
    value.show(isIso);
    rangeless.hidden = draft === null;
    if (isIso) {
      array.set(shown.array);
      value.setRange(...isoOf(shown.array)?.range ?? [0, 0]);
      value.set(shown.value);
    }
    vectors.show((choices.vectors ?? []).length > 1);
    vectors.set(scene.scene?.field?.vectors || choices.vectors?.[0] || '');  // If none is named, the file's first vectors are shown.
  }
  return {title: 'Surface', update, elements: [kind.element, list, ...[axis, position, array, value].map((row) => row.element), rangeless, vectors.element, shared]};
}
