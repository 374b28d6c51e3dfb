// The whole view as a URL's fragment, readable: #position=…&focal=…&up=…&fov=…&lic.steps=…&shading.blend=…&vectors=…
// Of several surfaces it has those cut out of the field (cut.2=slice:…), and the names of those that are hidden.

import {isAcceptable, valueFromText} from './options.js';
import {isCut, namesOf, specsOf, surfacesOf, timeOf} from './surface_spec.js';

const COORDINATES = ['position', 'focal', 'up'];
const SHARED = ['surface', 'vectors', 'colorBy', 'time'];
const CUT = /^cut\.(\d{1,3})$/;

/// The fragment for what `model` shows. The camera is left out where it is the scene's own.
export function fragmentOf(model) {
  const parts = new URLSearchParams(), {camera, scene} = model;
  if (camera && !model.isHome) {
    for (const key of COORDINATES) parts.set(key, camera[key].join(','));
    parts.set('fov', camera.fov);
  }
  for (const group of ['lic', 'shading'])
    for (const [key, value] of Object.entries(model.changed[group])) parts.set(`${group}.${key}`, Array.isArray(value) ? value.join(',') : value);
  if (scene) {
    const {cuts, hidden, ...shared} = sharedOf(scene);
    for (const [place, spec] of cuts ?? []) parts.set(`cut.${place}`, spec);
    if (hidden?.length === 0) parts.set('hidden', '');
    for (const name of hidden ?? []) parts.append('hidden', name);
    for (const key of SHARED) if (shared[key] !== undefined && shared[key] !== '') parts.set(key, shared[key]);
  }
  return parts.toString().replaceAll('%2C', ',').replaceAll('%3A', ':');
}

/// The parts of a Scene that all viewers share: {vectors, colorBy, time} under the names of Change; and {surface} of
/// one surface, {cuts: [[place, spec], …], hidden: [name, …]} of several.
export function sharedOf(scene) {
  const isSeries = (scene.choices?.times ?? []).length > 1, surfaces = surfacesOf(scene.scene), specs = specsOf(scene.scene);
  const which = surfaces.length < 2 ? {surface: scene.surface} : {
    cuts: [...specs.entries()].filter(([, spec]) => isCut(spec)),
    hidden: namesOf(specs).filter((name, i) => surfaces[i].shown === false),
  };
  return {...which, vectors: scene.scene?.field?.vectors ?? '', colorBy: scene.scene?.shading?.colorBy ?? '',
          time: isSeries ? timeOf(scene) : undefined};
}

/// {camera or null, changed, shared} of a fragment. What the server would not take, by the scene's `options`, is left
/// out: a link is somebody else's text.
export function parseFragment(fragment, options) {
  const parts = new URLSearchParams(fragment.replace(/^#/, '')), changed = {lic: {}, shading: {}}, shared = {};
  const read = (group, key, text) => {
    const value = text === null ? null : valueFromText(options[group][key], text);
    return isAcceptable(options, group, key, value) ? value : null;
  };
  const [position, focal, up] = COORDINATES.map((key) => read('camera', key, parts.get(key))), fov = read('camera', 'fov', parts.get('fov'));
  const isView = position && focal && up && fov !== null && position.some((x, i) => x !== focal[i]) && up.some((x) => x !== 0);
  for (const group of ['lic', 'shading'])
    for (const key of Object.keys(options[group])) {
      const value = read(group, key, parts.get(`${group}.${key}`));
      if (value !== null) changed[group][key] = value;
    }
  for (const key of SHARED) if (parts.has(key)) shared[key] = key === 'time' ? Number(parts.get(key)) : parts.get(key);
  if (!Number.isFinite(shared.time)) delete shared.time;
  const cuts = [...parts].filter(([key, spec]) => CUT.test(key) && isCut(spec)).map(([key, spec]) => [Number(CUT.exec(key)[1]), spec]);
  if (parts.has('hidden') || cuts.length > 0) {
    shared.cuts = cuts.sort(([a], [b]) => a - b);
    shared.hidden = parts.getAll('hidden').filter((name) => name !== '');
  }
  return {camera: isView ? {position, focal, up, fov} : null, changed, shared};
}

// What makes the scene's cuts those of a link: {place: spec, or null for one that has to go}. What the server was
// started with stays what it is, so there only cuts move. Added surfaces stand behind it, in the link's order.
function cutsToMake({given = 1}, specs, cuts) {
  const wanted = new Map(cuts.filter(([place]) => place < given && isCut(specs[place])));
  cuts.filter(([place]) => place >= given).forEach(([, spec], i) => wanted.set(given + i, spec));
  for (let place = given; place < specs.length; ++place) if (!wanted.has(place)) wanted.set(place, null);
  return Object.fromEntries([...wanted].filter(([place, spec]) => specs[place] !== spec));
}

function surfacesToMake(scene, {cuts, hidden}) {
  const specs = specsOf(scene.scene), make = cutsToMake(scene, specs, cuts);
  const after = surfacesOf(scene.scene).map(({spec, shown}) => ({spec, shown: shown !== false}));
  for (const [place, spec] of Object.entries(make)) after[place] = {shown: true, ...after[place], spec};
  const kept = after.filter(({spec}) => spec !== null), names = namesOf(kept.map(({spec}) => spec));
  const shown = names.map((name) => !hidden.includes(name)), isSame = kept.every((one, i) => one.shown === shown[i]);
  return {...(Object.keys(make).length > 0 ? {cuts: make} : {}), ...(isSame || names.length < 2 ? {} : {shown})};
}

/// The Change that makes of the scene what a link's `shared` says, or null where there is nothing to change. Arrays that
/// the scene does not have are left out.
export function differenceTo(scene, {cuts, hidden, ...shared}) {
  const now = sharedOf(scene), missing = missingIn(scene, shared);
  const change = Object.fromEntries(Object.entries(shared).filter(([key, value]) => now[key] !== value && !missing.includes(value)));
  if (change.surface === scene.surface) delete change.surface;
  if (cuts) Object.assign(change, surfacesToMake(scene, {cuts, hidden}));
  return Object.keys(change).length > 0 ? change : null;
}

/// The names of a link's arrays that the scene does not have.
export function missingIn(scene, {vectors, colorBy}) {
  const lacks = (name, choices) => Boolean(name) && choices !== undefined && !choices.includes(name);
  return [lacks(vectors, scene.choices?.vectors) ? vectors : '', lacks(colorBy, scene.choices?.colorBy) ? colorBy : ''].filter(Boolean);
}
