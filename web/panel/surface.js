// The panel's part about the surfaces that are shown. A change is a change for all viewers.

import {button, select, toggle} from './controls.js';
import {cutRows, middleOf, middleValue} from './cut.js';
import {h} from '../page/dom.js';
import {icon} from '../page/icons.js';
import {namesOf, parseSpec, specText, surfacesOf} from '../view/surface_spec.js';

const NAMES = {slice: 'Slice', isosurface: 'Isosurface', boundary: 'Boundary'};

export function surfacePart({model, changes}) {
  const bounds = () => model.scene.choices?.bounds ?? model.allBounds;
  const isosurfaces = () => model.scene.choices?.isosurface ?? [];
  const given = () => model.scene.given ?? 1;
  const isCutPossible = (kind) => (model.scene.choices?.surfaces ?? []).includes(kind);
  let draft = null;  // An isosurface whose value is not chosen yet, behind the scene's surfaces.
  let blocks = [], made = '', over = 0;  // `over`: how many surfaces the scene had.

  const wanted = () => changes.laidOver(model.scene).scene;
  const ofScene = () => surfacesOf(wanted());
  const countThere = () => surfacesOf(model.scene.scene).length;  // Without wished surfaces, which may be refused.
  const setCut = (place, cut, isMoving = false) => changes.request({cuts: {[place]: cut && specText(cut)}}, isMoving);
  const show = (isOn) => changes.request({shown: ofScene().map(isOn)});

  function add(kind) {
    const place = ofScene().length;
    if (kind === 'slice') {
      const [lo, hi] = bounds(), normal = [0, 0, 0];
      normal[Math.max(0, hi.findIndex((x, i) => x > lo[i]))] = 1;
      return setCut(place, {kind, origin: middleOf(bounds()), normal});
    }
    if (kind === 'boundary') return setCut(place, {kind});
    const {array, range} = isosurfaces().find((one) => one.range) ?? isosurfaces()[0];
    if (range) return setCut(place, {kind, array, value: middleValue(range)});
    draft = {kind, array, value: NaN};
    update();
  }

  function remove(place) {
    const isDraft = place >= ofScene().length;
    draft = null;
    if (!isDraft) setCut(place, null);
    update();
  }

  // One surface: its name, a switch where there are several, and the rows of a cut.
  function makeBlock(place, kind) {
    const row = toggle({label: '', onInput: (isOn) => show((one, i) => (i === place ? isOn : one.shown !== false))});
    const away = h('button', {type: 'button', class: 'reset', title: 'Take it away'}, icon('close'));
    away.addEventListener('click', () => remove(place));
    row.element.insertBefore(away, row.element.lastChild);
    const cut = cutRows({bounds, isosurfaces, ask(next, isMoving) {
      if (draft && place >= countThere()) draft = next;
      if (next.kind !== 'isosurface' || !Number.isNaN(next.value)) setCut(place, next, isMoving);
      else if (place < ofScene().length) update();
    }});
    const rows = kind === 'original' ? null : h('div', {class: 'cut'}, ...cut.elements);
    return {element: h('div', {class: 'surface'}, row.element, rows), update({name, spec, shown, isAlone}) {
      const [label] = row.element.querySelectorAll('label'), box = row.element.querySelector('input');
      label.textContent = name;
      label.title = spec;
      row.set(shown !== false);
      box.hidden = isAlone || spec === '';
      away.hidden = place < given();
      away.setAttribute('aria-label', `Take ${name} away`);
      if (!rows) return;
      rows.hidden = shown === false;
      cut.update(spec === '' ? draft : parseSpec(spec));
    }};
  }

  const list = h('div', {class: 'surfaces'});
  const adders = Object.entries(NAMES).map(([kind, label]) => [kind, button({label, iconName: 'add', className: 'small', onClick: () => add(kind)})]);
  const adding = h('div', {class: 'row tall', role: 'group', 'aria-label': 'Add'}, h('span', {class: 'label'}, 'Add'),
                   h('div', {class: 'adders'}, ...adders.map(([, {element}]) => element)));
  const nothing = h('p', {class: 'hint'}, 'All surfaces are hidden.');
  const showAll = button({label: 'Show all', className: 'wide', onClick: () => show(() => true)});
  const vectors = select({label: 'Vectors', onInput: (name) => changes.request({vectors: name})});
  const shared = h('p', {class: 'hint'}, 'Surfaces, vectors, colouring and time are shared by all viewers.');
  let choices = null;

  function updateList() {
    const surfaces = ofScene();
    if (countThere() !== over) draft = null;  // It is there now, or something else stands in its place.
    over = countThere();
    const names = namesOf(surfaces.map(({spec}) => spec));
    const all = surfaces.map(({spec, shown}, i) => ({name: names[i], spec, shown, isAlone: surfaces.length < 2}));
    if (draft && surfaces.length === over) all.push({name: 'Isosurface', spec: '', shown: true});
    const kinds = all.map(({spec}) => (spec === '' ? 'isosurface' : parseSpec(spec).kind));
    if (kinds.join() !== made) {
      made = kinds.join();
      blocks = kinds.map((kind, place) => makeBlock(place, kind));
      list.replaceChildren(...blocks.map(({element}) => element));
    }
    blocks.forEach((block, i) => block.update(all[i]));
    const areHidden = surfaces.filter(({shown}) => shown === false).length;
    nothing.hidden = areHidden < surfaces.length || surfaces.length < 2;
    showAll.show(areHidden > 0 && surfaces.length > 1);
  }

  function updateAdders() {
    const [lo, hi] = bounds(), isFlat = lo.some((x, i) => x === hi[i]);  // A cut of a flat surface would be a line.
    const canAdd = {slice: !isFlat, isosurface: !isFlat && isosurfaces().length > 0, boundary: true};
    for (const [kind, row] of adders) row.show(isCutPossible(kind) && canAdd[kind]);
    adding.hidden = adders.every(([, {element}]) => element.hidden) || draft !== null;
  }

  function update() {
    if (!model.scene) return;
    if (choices !== model.scene.choices) {
      choices = model.scene.choices ?? {};
      vectors.setChoices((choices.vectors ?? []).map((name) => [name, name]));
    }
    updateList();
    updateAdders();
    vectors.show((choices.vectors ?? []).length > 1);
    vectors.set(wanted()?.field?.vectors || choices.vectors?.[0] || '');  // If none is named, the file's first vectors are shown.
  }
  return {title: 'Surface', update, elements: [list, nothing, showAll.element, adding, vectors.element, shared]};
}
