// Parts of the page that need no browser.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {reasonOf} from '../../../web/net/connection.js';
import {differenceTo, fragmentOf, parseFragment} from '../../../web/view/link.js';
import {Model} from '../../../web/view/model.js';
import {sceneFile} from '../../../web/picture/save.js';
import {inPageWords} from '../../../web/page/words.js';
import {statusOf} from '../../../web/page/status.js';
import {colorsOutside} from '../../../web/panel/colormaps.js';
import {parseSpec, specText} from '../../../web/view/surface_spec.js';
import {sceneMessage} from '../mock/server.js';

function modelOf(changes) {
  const model = new Model();
  model.setAspect(1);
  model.setScene(sceneMessage(changes));
  return model;
}

test('an untouched view sends the scene\'s own numbers and no options', () => {
  const model = modelOf();
  assert.deepEqual(model.viewGroups(false), {camera: sceneMessage().view, lic: {}, shading: {}});
});

test('a link brings back the very same numbers', () => {
  const model = modelOf({surface: 'isosurface:p=0.2', time: 0.3});
  model.setCamera({position: [1 / 3, -2.5e-7, 3], focal: [0.1, 0.2, 0.3], up: [0, Math.SQRT1_2, Math.SQRT1_2], fov: 42.5}, false);
  model.setOption('lic', 'steps', 77);
  model.setOption('lic', 'normalize', false);
  model.setOption('shading', 'colorRange', [-0.25, 1e-9]);
  model.setOption('shading', 'background', 'transparent');
  const {camera, changed, shared} = parseFragment(`#${fragmentOf(model)}`, model.rules);
  assert.deepEqual(camera, model.camera);
  assert.deepEqual(changed, model.changed);
  assert.deepEqual(shared, {surface: 'isosurface:p=0.2', vectors: 'U', colorBy: 'p', time: 0.3});
  assert.equal(differenceTo(model.scene, shared), null);
  assert.deepEqual(differenceTo(sceneMessage(), shared), {surface: 'isosurface:p=0.2', time: 0.3});
});

test('a link with nonsense in it is taken as far as it makes sense', () => {
  const {camera, changed, shared} = parseFragment('#position=1,2&focal=a&lic.steps=1e9&lic.kernel=hann&shading.blend=2&shading.background=red&lic.seed=-1&time=soon&lic.normalize=1&x=y', sceneMessage().options);
  assert.equal(camera, null);
  assert.deepEqual(changed, {lic: {kernel: 'hann'}, shading: {}});
  assert.deepEqual(shared, {});
});

test('a range belongs to the array it was chosen for', () => {
  const model = modelOf();
  model.setOption('shading', 'colorRange', [0, 1]);
  model.setScene(sceneMessage({time: 0.1}));
  assert.deepEqual(model.changed.shading.colorRange, [0, 1]);
  model.setScene(sceneMessage({colorBy: 'U:mag'}));
  assert.equal(model.changed.shading.colorRange, undefined);
});

test('a camera stays for another step of the scene, and goes for another scene', () => {
  const model = modelOf(), camera = {position: [0, -9, 0], focal: [0, 0, 0], up: [0, 0, 1], fov: 30};
  model.setCamera(camera, false);
  model.setScene(sceneMessage({time: 0.1}));
  assert.deepEqual(model.camera, camera);
  model.setScene({...sceneMessage(), bounds: [[1000, 0, 0], [1001, 1, 1]], view: {...sceneMessage().view, focal: [1000.5, 0.5, 0.5]}});
  assert.deepEqual(model.camera.focal, [1000.5, 0.5, 0.5]);
});

test('a dark page has a dark picture, but only where the scene does not say', () => {
  const model = modelOf();
  model.pageBackground = '11161a';
  assert.equal(model.viewGroups(false).shading.background, '11161a');
  const own = sceneMessage();
  own.scene.shading.background = '336699';
  model.setScene(own);
  assert.deepEqual(model.viewGroups(false).shading, {});
  model.setOption('shading', 'background', 'ffffff');
  assert.equal(model.viewGroups(false).shading.background, 'ffffff');
});

test('a scene file has an absolute camera, what was changed, and the picture\'s size', () => {
  const model = modelOf();
  model.setOption('lic', 'steps', 64);
  const file = sceneFile(model, {width: 640, height: 480, cssWidth: 640, cssHeight: 480});
  assert.deepEqual(file.output, {width: 640, height: 480});
  assert.deepEqual(file.camera, sceneMessage().view);
  assert.equal(file.lic.steps, 64);
  assert.equal(file.lic.noiseScale, 1);
  assert.equal(file.version, 1);
  assert.equal(file.surface.spec, 'ball.vtp');
});

test('surfaces as text and back', () => {
  for (const spec of ['original', 'boundary', 'slice:0.1,-2,1e-7:0,0,1', 'isosurface:a=b=0.25']) assert.equal(specText(parseSpec(spec)), spec);
  assert.deepEqual(parseSpec('isosurface:a=b=0.25'), {kind: 'isosurface', array: 'a=b', value: 0.25});
  assert.deepEqual(parseSpec('slice:1,2:0,0,1'), {kind: 'original'});
});

test('what a person is told', () => {
  const kind = (session, hasPicture = true) => statusOf({link: 'open', lost: null, state: {state: 'ready'}, ...session}, hasPicture, 0).kind;
  assert.equal(kind({}), 'ready');
  assert.equal(kind({}, false), 'drawing');
  assert.equal(kind({link: 'denied'}), 'denied');
  assert.equal(kind({state: {state: 'loading', what: 'x', fraction: 0.5}}), 'loading');
  const barAt = (fraction) => statusOf({link: 'open', state: {state: 'loading', fraction}}, false, 0).fraction;
  assert.deepEqual([barAt(0.5), barAt(1), barAt(0), barAt(undefined)], [0.5, null, null, null], 'what is read is not all');
  const lost = statusOf({link: 'lost', lost: {reason: 'The server stopped.', retryAtMs: 2500}, state: null}, true, 0);
  assert.equal(lost.text, 'The server stopped. Trying again in 3 s.');
  assert.ok(lost.isDimmed && lost.canRetry);
  const failed = statusOf({link: 'open', lost: null, state: {state: 'failed', message: 'given up'}}, true, 0);
  assert.ok(failed.canStart && !failed.canRetry);
  assert.equal(failed.text, 'given up');
});

test('a close code is told in words, with the reason that came with it', () => {
  assert.equal(reasonOf(1001, 'the server stops'), 'The server stopped.');
  assert.equal(reasonOf(1002, 'no Hello first'), 'Server and page do not speak the same protocol (no Hello first). Reload the page.');
  assert.equal(reasonOf(1008, 'too slow'), 'The server ended the connection: too slow.');
  assert.equal(reasonOf(1008), 'The server ended the connection.');
  assert.equal(reasonOf(1006), '');
});

test('outside the range a map has its own ends, unless its file has colours for that', () => {
  const choices = {colorStops: {'a.json': ['000001', '000002', '000003']}, colorsOutside: {'a.json': {nanColor: 'ff00ff', belowColor: '0000ff'}}};
  assert.deepEqual(colorsOutside('gray', choices), {belowColor: '000000', aboveColor: 'ffffff', nanColor: '999999'});
  assert.deepEqual(colorsOutside('a.json', choices), {belowColor: '0000ff', aboveColor: '000003', nanColor: 'ff00ff'});
});

test('what the server says is told in the words of the page\'s controls', () => {
  assert.equal(inPageWords('the picture has no room for the title: a larger --size or a smaller --text-scale may give it'),
               'the picture has no room for the title: a larger window or a smaller Text size (under Figure) may give it');
  assert.equal(inPageWords('no streaks show: the longest vector is 2, and --mask-below 3'),
               'no streaks show: the longest vector is 2, and None below (under Streaks) is 3');
  assert.equal(inPageWords('as --color-scale log needs it'), 'as the scale Log needs it');
  assert.equal(inPageWords('--sizes, and --offset'), '--sizes, and --offset', 'what the page has no control for');
});
