// What a person wants of the scene, on its way to the server. Timers are the test's.
import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';

import {Changes} from '../../../web/net/changes.js';
import {FakeTimers} from './fake_timers.js';
import {sceneMessage} from '../mock/server.js';

let timers, sent, changes, nowMs;
const realPerformance = globalThis.performance;
beforeEach(() => {
  timers = new FakeTimers();
  nowMs = 1000;
  Object.defineProperty(globalThis, 'performance', {value: {now: () => nowMs}, configurable: true});
  sent = [];
  changes = new Changes((change) => sent.push(change));
});
afterEach(() => {
  timers.restore();
  Object.defineProperty(globalThis, 'performance', {value: realPerformance, configurable: true});
});

function pass(ms) {
  nowMs += ms;
  timers.tick(ms);
}

test('one change is on its way at a time; of those that wait only the newest is sent', () => {
  changes.request({time: 0.1}, true);
  changes.request({time: 0.2}, true);
  changes.request({time: 0.3, colorBy: 'p'}, true);
  assert.deepEqual(sent, [{change: 1, moving: true, time: 0.1}]);
  changes.answered(1);
  assert.deepEqual(sent[1], {change: 2, moving: true, time: 0.3, colorBy: 'p'});
  changes.answered(2);
  assert.equal(sent.length, 2);
  assert.equal(changes.isBusy, false);
});

test('a newer wish takes the place of one that waits at the server', () => {
  changes.request({surface: 'slice:0,0,0:1,0,0'});
  pass(200);
  changes.request({surface: 'boundary'});
  assert.equal(sent.length, 1);
  pass(100);
  assert.deepEqual(sent[1], {change: 2, moving: false, surface: 'boundary'});
  changes.answered(1);
  assert.equal(changes.wish('surface'), 'boundary', 'it is not answered by the answer to another');
  changes.answered(2);
  assert.equal(changes.wish('surface'), undefined);
});

test('wishes about surfaces that are not sent end when one is taken away, others do not', () => {
  changes.request({time: 0.1});
  changes.request({cuts: {2: 'slice:1,0,0:1,0,0'}, shown: [true, false, true], colorBy: 'p'}, true);
  changes.placesCountAnew();
  changes.answered(1);
  assert.deepEqual(sent.slice(1), [{change: 2, moving: true, colorBy: 'p'}]);
});

test('what waits for a surface to go is not asked for where that is refused', () => {
  changes.request({cuts: {2: null}});
  changes.request({cuts: {2: 'slice:1,0,0:1,0,0'}});
  changes.refused();
  changes.answered(1);
  assert.equal(sent.length, 1);
  assert.equal(changes.isBusy, false);
});

test('the scene rests when no more wishes follow, and while something plays it does not', () => {
  changes.request({time: 0.1}, true);
  changes.answered(1);
  pass(200);
  assert.deepEqual(sent.at(-1), {change: 2, moving: false});
  changes.answered(2);
  changes.hold('time');
  changes.request({time: 0.2}, true);
  changes.answered(3);
  pass(5000);
  assert.equal(sent.at(-1).moving, true);
  changes.release('time');
  assert.deepEqual(sent.at(-1), {change: 4, moving: false});
});

test('a key that is held moves the scene, a single press does not', () => {
  changes.request({time: 0.1});
  assert.equal(sent.at(-1).moving, false);
  changes.answered(1);
  pass(30);
  changes.request({time: 0.2});
  assert.equal(sent.at(-1).moving, true);
  changes.answered(2);
  pass(200);
  assert.equal(sent.at(-1).moving, false);
});

test('controls show what is wanted until it is there or refused', () => {
  const scene = sceneMessage();
  changes.request({surface: 'boundary', colorBy: 'U:mag', steer: {speed: 2}});
  const shown = changes.laidOver(scene);
  assert.deepEqual([shown.surface, shown.scene.shading.colorBy, shown.scene.field.vectors], ['boundary', 'U:mag', 'U']);
  assert.equal(changes.wish('steer:speed'), 2);
  changes.answered(1);
  assert.equal(changes.laidOver(scene), scene);
});

test('without a connection nothing waits', () => {
  changes = new Changes(() => false);
  changes.request({time: 0.1});
  assert.equal(changes.isBusy, false);
});

test('one answer to several changes ends the waiting for all of them', () => {
  changes.request({time: 0.1});
  pass(300);
  changes.request({time: 0.2});
  assert.equal(sent.length, 2);
  changes.answered(2);
  pass(1000);
  changes.request({time: 0.3});
  assert.equal(changes.waitedMs, 0, 'the oldest that waits is the newest');
  pass(40);
  assert.equal(changes.waitedMs, 40);
});

test('what waits until a surface has been taken away is asked for once', () => {
  changes.request({cuts: {1: null}});
  changes.request({cuts: {0: 'slice:0,0,0:1,0,0'}});
  assert.deepEqual(sent, [{change: 1, moving: false, cuts: {1: null}}]);
  changes.answered(1);
  assert.deepEqual(sent.at(-1).cuts, {0: 'slice:0,0,0:1,0,0'});
  pass(1000);
  for (const number of [2, 3, 4]) changes.answered(number);
  assert.equal(sent.filter((change) => 'cuts' in change).length, 2);
  assert.equal(changes.isBusy, false);
});
