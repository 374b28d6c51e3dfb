// The flowing streaks. Time is a clock of the test's own, and the session only remembers who holds it.

import assert from 'node:assert/strict';
import {beforeEach, test} from 'node:test';

import {Emitter} from '../../../web/page/emitter.js';
import {Model} from '../../../web/view/model.js';
import {Phase} from '../../../web/view/phase.js';
import {sceneMessage} from '../mock/server.js';

let nowMs = 0;
performance.now = () => nowMs;

let model, frames, holders, phase;

// A picture is on the screen `ms` milliseconds after the last event.
function shown(ms) {
  nowMs += ms;
  frames.emit('shown');
}

const phaseRad = () => model.options.lic.phase;
const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-3, `${a} is not ${b}`);

beforeEach(() => {
  nowMs = 5000;
  model = new Model();
  model.setScene(sceneMessage());
  frames = new Emitter();
  holders = new Set();
  const pacer = {hold: (name) => holders.add(name), release: (name) => holders.delete(name)};
  phase = new Phase({model, session: {pacer}, frames});
});

test('half a turn a second, whatever the pictures take', () => {
  phase.run(true);
  let seconds = 0;
  for (const ms of [10, 40, 90, 1, 60]) {
    shown(ms);
    seconds += ms / 1000;
    close(phaseRad(), 2 * Math.PI * 0.5 * seconds);
  }
});

test('another speed counts from the next picture on, and a negative one flows upstream', () => {
  phase.run(true);
  shown(50);
  close(phaseRad(), 2 * Math.PI * 0.5 * 0.05);
  phase.setSpeed(2);
  shown(50);
  close(phaseRad(), 2 * Math.PI * (0.5 + 2) * 0.05);
  phase.setSpeed(-1);
  shown(100);
  close(phaseRad(), 2 * Math.PI * (2.5 * 0.05 - 0.1));
});

test('after a pause the flow goes on where it was', () => {
  phase.run(true);
  shown(20);
  const before = phaseRad();
  shown(60000);
  close(phaseRad() - before, 2 * Math.PI * 0.5 * 0.1);
  phase.run(false);
  nowMs += 60000;
  phase.run(true);
  const stopped = phaseRad();
  shown(10);
  close(phaseRad() - stopped, 2 * Math.PI * 0.5 * 0.01);
});

test('a phase stays within a turn', () => {
  phase.setSpeed(3);
  phase.run(true);
  for (let i = 0; i < 20; ++i) shown(90);
  assert.ok(Math.abs(phaseRad()) < 2 * Math.PI, `${phaseRad()}`);
  close(phaseRad(), 2 * Math.PI * (3 * 20 * 0.09 % 1));
});

test('it needs a Hann kernel, and holds the pacer while it flows', () => {
  const isMoving = [];
  model.on('options', (moving) => isMoving.push(moving));
  phase.run(true);
  assert.equal(model.options.lic.kernel, 'hann');
  assert.deepEqual([...holders], ['phase']);
  shown(10);
  assert.deepEqual(isMoving, [true, true]);
  phase.run(false);
  assert.deepEqual([...holders], []);
  assert.deepEqual(isMoving, [true, true, false]);
  const stopped = phaseRad();
  shown(50);
  assert.equal(phaseRad(), stopped);
});

test('it ends where a person chooses a kernel without phase, or no streaks', () => {
  for (const [key, value] of [['kernel', 'box'], ['method', 'none']]) {
    phase.run(true);
    model.setOption('lic', key, value);
    const before = phaseRad();
    shown(30);
    assert.equal(phase.isRunning, false);
    assert.deepEqual([...holders], []);
    assert.equal(phaseRad(), before);
  }
});
