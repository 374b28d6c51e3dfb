// When views are sent. Time is the test's own, and an animation frame comes every 16 ms.
import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';

import {Pacer} from '../../../web/net/pacer.js';
import {FakeTimers} from './fake_timers.js';

let timers, nowMs, sent, pacer;
const realPerformance = globalThis.performance;

beforeEach(() => {
  timers = new FakeTimers();
  nowMs = 1000;
  Object.defineProperty(globalThis, 'performance', {value: {now: () => nowMs}, configurable: true});
  globalThis.requestAnimationFrame = (call) => setTimeout(() => call(nowMs), 16);
  sent = [];
  pacer = new Pacer((isMoving) => sent.push(isMoving ? 'moving' : 'rest'));
});
afterEach(() => {
  timers.restore();
  Object.defineProperty(globalThis, 'performance', {value: realPerformance, configurable: true});
});

function pass(ms) {
  for (let i = 0; i < ms; ++i) {
    ++nowMs;
    timers.tick(1);
  }
}

// The view changes in every millisecond.
function drag(ms) {
  for (let i = 0; i < ms; ++i) {
    pacer.touch();
    pass(1);
  }
}

test('a third moving view waits for the answer to one of two', () => {
  drag(400);
  assert.deepEqual(sent, ['moving', 'moving']);
  assert.equal(pacer.answered(1), 1016);
  drag(400);
  assert.equal(sent.length, 3);
  pacer.answered(3);  // And all before it.
  drag(400);
  assert.equal(sent.length, 5);
});

test('the view at rest waits for nobody', () => {
  drag(100);
  pass(149);
  assert.deepEqual(sent, ['moving', 'moving']);
  pass(20);
  assert.deepEqual(sent, ['moving', 'moving', 'rest']);
  pass(1000);
  assert.equal(sent.length, 3);
});

test('while something goes on by itself there is no rest', () => {
  pacer.hold('phase');
  pacer.touch();
  pass(400);
  pacer.settle();
  pass(400);
  assert.deepEqual(sent, ['moving', 'moving']);
  pacer.release('another');
  pass(400);
  assert.equal(sent.length, 2);
  pacer.release('phase');
  pass(20);
  assert.deepEqual(sent, ['moving', 'moving', 'rest']);
});

test('views keep the distance that the server asks for', () => {
  pacer.shortestPauseMs = 100;
  for (let i = 0; i < 500; ++i) {
    drag(1);
    pacer.answered(sent.length);
  }
  assert.ok(sent.length >= 4 && sent.length <= 5, `${sent.length}`);
});

test('views that nobody answers are given up', () => {
  drag(5010);
  assert.equal(sent.length, 2);
  drag(50);
  assert.equal(sent.length, 4);
});
