// Several surfaces: their names, what a link says of them, where slices lie, and when the camera stays.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {differenceTo, fragmentOf, missingIn, parseFragment, sharedOf} from '../../../web/view/link.js';
import {Model} from '../../../web/view/model.js';
import {namesOf, shortName} from '../../../web/view/surface_spec.js';
import {changedSurfaces, sceneMessage} from '../mock/server.js';

const GIVEN = ['/data/case:walls', 'slice:0,0,0.25:0,0,1', '/data/case:röd & blå #1=x', '/other/case:walls'];

const shownOf = (specs, hidden = []) => specs.map((spec, i) => ({spec, shown: !hidden.includes(i)}));
const messageOf = (surfaces, given = GIVEN) => sceneMessage({}, given, surfaces);

function modelOf(message) {
  const model = new Model();
  model.setAspect(1);
  model.setScene(message);
  return model;
}

const linkOf = (message) => parseFragment(`#${fragmentOf(modelOf(message))}`, message.options).shared;

test('names of surfaces differ, and have no digits that nobody reads', () => {
  assert.deepEqual(namesOf(GIVEN), ['case:walls', 'Slice z = 0.25', 'case:röd & blå #1=x', 'case:walls (2)']);
  assert.equal(shortName('slice:0.8500000000000001,0,0:1,0,0'), 'Slice x = 0.85');
  assert.equal(shortName('slice:0.30000000000000004,1,2:1,1,0'), 'Slice through 0.3, 1, 2');
  assert.equal(shortName('slice:1000000.25,0,0:1,0,0'), 'Slice x = 1000000.25');
  assert.equal(shortName('isosurface:p=0.30000000000000004'), 'Isosurface p = 0.3');
});

test('a link has what is hidden and where cuts are, and brings them back', () => {
  const moved = shownOf([GIVEN[0], 'slice:0,0,0.75:0,0,1', GIVEN[2], GIVEN[3], 'slice:0.5,0,0:1,0,0'], [2, 3]);
  const shared = linkOf(messageOf(moved));
  assert.deepEqual(shared.hidden, ['case:röd & blå #1=x', 'case:walls (2)']);
  assert.equal(differenceTo(messageOf(moved), shared), null);
  const change = differenceTo(messageOf(shownOf(GIVEN)), shared);
  assert.deepEqual(change, {cuts: {1: 'slice:0,0,0.75:0,0,1', 4: 'slice:0.5,0,0:1,0,0'}, shown: [true, true, false, false, true]});
  assert.deepEqual(changedSurfaces(shownOf(GIVEN), GIVEN, change), moved);
});

test('a link to a scene with nothing hidden shows what is hidden, and takes away what was added', () => {
  const shared = linkOf(messageOf(shownOf(GIVEN)));
  assert.deepEqual(shared.hidden, []);
  const now = shownOf([...GIVEN, 'boundary'], [0]), change = differenceTo(messageOf(now), shared);
  assert.deepEqual(change, {cuts: {4: null}, shown: [true, true, true, true]});
  assert.deepEqual(changedSurfaces(now, GIVEN, change), shownOf(GIVEN));
});

test('a link where all is hidden hides all', () => {
  const shared = linkOf(messageOf(shownOf(GIVEN, [0, 1, 2, 3])));
  assert.deepEqual(differenceTo(messageOf(shownOf(GIVEN)), shared), {shown: [false, false, false, false]});
});

test('a link to another scene changes what both have, and says what is missing', () => {
  const shared = {...linkOf(messageOf(shownOf([...GIVEN, 'slice:1,0,0:1,0,0'], [2]))), vectors: 'velocity', colorBy: 'p'};
  const other = sceneMessage({}, ['car.vtp']);
  assert.deepEqual(differenceTo(other, shared), {cuts: {1: 'slice:0,0,0.25:0,0,1', 2: 'slice:1,0,0:1,0,0'}});
  assert.deepEqual(missingIn(other, shared), ['velocity']);
  assert.deepEqual(parseFragment('#cut.0=/etc/passwd&cut.x=boundary&cut.1=slice:1', other.options).shared, {});
});

test('a slice beside the only surface is one more, and a link to that surface alone takes it away', () => {
  const alone = sceneMessage({}), sliced = sceneMessage({cuts: {1: 'slice:0,0,0:1,0,0'}});
  assert.deepEqual(sharedOf(sliced).cuts, [[1, 'slice:0,0,0:1,0,0']]);
  assert.deepEqual(differenceTo(alone, linkOf(sliced)), {cuts: {1: 'slice:0,0,0:1,0,0'}});
  assert.deepEqual(differenceTo(sliced, linkOf(alone)), {surface: 'original'});
});

test('the camera stays where surfaces come and go, and the first view fits those that are shown', () => {
  const whole = messageOf(shownOf(GIVEN)), model = modelOf(whole), {camera} = model;
  const small = {...messageOf(shownOf(GIVEN, [0])), bounds: [[0, 0, 0], [0.1, 0.1, 0.1]], radius: 0.09,
                 view: {...whole.view, focal: [0.05, 0.05, 0.05]}};
  model.setScene(small);
  assert.deepEqual(model.camera, camera);
  assert.equal(model.isHome, false, 'a link has to have the camera now');
  model.home();
  assert.deepEqual(model.camera.focal, [0.05, 0.05, 0.05]);
});

test('a camera of another scene that has nothing before it is told from one that has', () => {
  const model = modelOf(sceneMessage()), at = (position, focal) => ({position, focal, up: [0, 0, 1], fov: 30});
  assert.ok(model.sees(at([0, -4, 0], [0, 0, 0])));
  assert.ok(model.sees(at([0, 0, 0], [0, 1, 0])), 'from within');
  assert.ok(!model.sees(at([0, -4, 0], [0, -8, 0])), 'behind');
  assert.ok(!model.sees(at([5000, -4, 0], [5000, 0, 0])), 'beside');
  assert.ok(!model.sees(at([0, -40000, 0], [0, 0, 0])), 'a dot');
});

test('slices may lie in all that was seen so far, until another scene comes', () => {
  const within = (bounds) => ({...sceneMessage(), bounds}), model = modelOf(within([[-1, -1, -1], [1, 1, 1]]));
  model.setScene(within([[0, -2, -1], [1, 0, 2]]));
  assert.deepEqual(model.allBounds, [[-1, -2, -1], [1, 1, 2]]);
  model.setScene(within([[100, 100, 100], [101, 101, 101]]));
  assert.deepEqual(model.allBounds, [[100, 100, 100], [101, 101, 101]]);
});
