// Which frames become pictures, and which are given up. Canvases and their drawing are stand-ins.
import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';

import {FakeTimers} from './fake_timers.js';

// Pixels that tests look at are numbers: where a tile's rows have been put, and what a canvas has been drawn from.
function canvas() {
  const made = {width: 0, height: 0, rows: new Map()};
  const put = (tile, _, y) => { for (let i = 0; i < tile.height; ++i) made.rows.set(y + i, tile.mark + i); };
  made.getContext = () => ({clearRect() {}, putImageData: put,
    drawImage: (from, x, y) => from.rows ? made.rows = new Map(from.rows) : put(from, x, y)});
  return made;
}
globalThis.navigator ??= {};  // Node 20 has none.
globalThis.ImageData = class {
  constructor(rgba, width, height) {
    Object.assign(this, {mark: rgba[0], width, height});
  }
};
globalThis.document = {createElement: canvas};
globalThis.requestAnimationFrame = (show) => setTimeout(show, 16);
const {Frames} = await import('../../../web/picture/frames.js');

let frames, events, timers, screen;
afterEach(() => timers.restore());

beforeEach(() => {
  timers = new FakeTimers();
  screen = canvas();
  // Codec 1 is a JPEG. A tile's rows are marked by their number in its picture.
  frames = new Frames(screen, async ({codec, firstRow, rows, width}) => codec === 1
    ? {bitmap: {mark: firstRow, height: rows, close() {}}} : {rgba: new Uint8ClampedArray(4 * width * rows).fill(firstRow)});
  frames.hasDirect = () => true;
  events = [];
  for (const name of ['complete', 'shown', 'broken'])
    frames.on(name, (frame, message) => events.push([name, frame.frame, ...(message ? [message] : [])]));
});

const begin = (frame) => frames.begin({frame, viewer: 1, view: frame, width: 8, height: 6, askedWidth: 8, lossless: true});
const tile = (frame, firstRow, rows, codec = 1) => frames.tile({frame, firstRow, rows, width: 8, codec, encoded: new Uint8Array(4)});

// A frame of one tile that came whole.
async function whole(frame) {
  begin(frame);
  await tile(frame, 0, 6);
  frames.end(frame, {});
}

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

for (const [codec, name] of [[1, 'JPEG'], [2, 'PNG']])
  test(`tiles by ${name} are put where their rows belong, in whichever order they come`, async () => {
    let pixels;
    frames.on('shown', (frame) => pixels = frame.pixels);
    begin(1);
    await tile(1, 4, 2, codec);
    await tile(1, 0, 3, codec);
    await tile(1, 3, 1, codec);
    frames.end(1, {});
    timers.tick(100);
    assert.deepEqual([...screen.rows].sort(([a], [b]) => a - b), [0, 1, 2, 3, 4, 5].map((row) => [row, row]));
    if (codec !== 1) assert.deepEqual([0, 1, 2, 3, 4, 5].map((row) => pixels[4 * 8 * row]), [0, 0, 0, 3, 4, 4]);
    else assert.equal(pixels, null);
  });

test('what is older than the picture on the screen is not begun', async () => {
  await whole(3);
  timers.tick(100);
  await whole(2);
  await whole(3);
  timers.tick(100);
  assert.deepEqual(events, [['complete', 3], ['shown', 3]]);
});

test('what is older than a broken picture is not begun', async () => {
  frames.hasDirect = () => false;
  begin(3);
  frames.end(3, {});
  await whole(2);
  timers.tick(100);
  assert.deepEqual(events, [['complete', 3], ['broken', 3, 'rows are missing']]);
});

test('another server counts its frames anew', async () => {
  await whole(70);
  timers.tick(100);
  begin(71);
  frames.abandon();
  await whole(1);
  timers.tick(100);
  assert.deepEqual(events, [['complete', 70], ['shown', 70], ['complete', 1], ['shown', 1]]);
});

test('of too many pictures on their way the oldest stays', async () => {
  for (const frame of [1, 2, 3, 4, 5]) begin(frame);
  for (const frame of [1, 2]) {
    await tile(frame, 0, 6);
    frames.end(frame, {});
  }
  timers.tick(100);
  assert.deepEqual(events, [['complete', 1], ['shown', 1]]);
});
