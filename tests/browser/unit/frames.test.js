// Which frames become pictures, and which are given up. Canvases and their drawing are stand-ins.
import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';

import {FakeTimers} from './fake_timers.js';

const canvas = () => ({width: 0, height: 0, getContext: () => ({drawImage() {}, clearRect() {}})});
globalThis.navigator ??= {};  // Node 20 has none.
globalThis.document = {createElement: canvas};
globalThis.requestAnimationFrame = (show) => setTimeout(show, 16);
const {Frames} = await import('../../../web/picture/frames.js');

let frames, events, timers;
afterEach(() => timers.restore());

beforeEach(() => {
  timers = new FakeTimers();
  frames = new Frames(canvas(), async () => ({bitmap: {close() {}}}));
  frames.hasDirect = () => true;
  events = [];
  for (const name of ['complete', 'shown', 'broken'])
    frames.on(name, (frame, message) => events.push([name, frame.frame, ...(message ? [message] : [])]));
});

const begin = (frame) => frames.begin({frame, viewer: 1, view: frame, width: 8, height: 6, askedWidth: 8, lossless: true});
const tile = (frame, firstRow, rows) => frames.tile({frame, firstRow, rows, width: 8, codec: 1, encoded: new Uint8Array(4)});

test('rows that a rank sends itself may come after the end', async () => {
  begin(1);
  await tile(1, 0, 2);
  frames.end(1, {});
  timers.tick(2900);
  await tile(1, 2, 2);
  timers.tick(2900);
  assert.deepEqual(events, []);
  await tile(1, 4, 2);
  timers.tick(60000);
  assert.deepEqual(events, [['complete', 1], ['shown', 1]]);
});

test('a frame whose rows were lost with a connection is given up', async () => {
  begin(1);
  await tile(1, 0, 2);
  frames.end(1, {});
  timers.tick(2900);
  assert.deepEqual(events, []);
  timers.tick(200);
  assert.deepEqual(events, [['complete', 1], ['broken', 1, 'rows are missing']]);
  await tile(1, 2, 4);  // The frame has been given up.
  timers.tick(60000);
  assert.equal(events.length, 2);
});

test('a newer picture ends the waiting for an older one', async () => {
  begin(1);
  frames.end(1, {});
  begin(2);
  await tile(2, 0, 6);
  frames.end(2, {});
  timers.tick(60000);
  assert.deepEqual(events, [['complete', 2], ['shown', 2]]);
});

test('without connections to ranks the end is the end', async () => {
  frames.hasDirect = () => false;
  begin(1);
  await tile(1, 0, 2);
  frames.end(1, {});
  assert.deepEqual(events, [['complete', 1], ['broken', 1, 'rows are missing']]);
});
