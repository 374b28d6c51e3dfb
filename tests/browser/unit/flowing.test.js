// The flowing streaks: which pictures are asked for, and what is made of them. The session and the frames are stand-ins.

import assert from 'node:assert/strict';
import {beforeEach, test} from 'node:test';

import {cycleWeights, flowingBoxes} from '../../../web/picture/cycle.js';
import {Emitter} from '../../../web/page/emitter.js';
import {Flowing} from '../../../web/view/flowing.js';
import {FLOW_PICTURES, Model} from '../../../web/view/model.js';
import {sceneMessage} from '../mock/server.js';

globalThis.ImageData = class { constructor(data, width, height) { Object.assign(this, {data, width, height}); } };
let ticks = [], nowMs = 0;
globalThis.requestAnimationFrame = (tick) => ticks.push(tick);
performance.now = () => nowMs;

let model, frames, session, stage, flowing, canvas, player, settled, told, view;

class Player {
  bounds = [1, 0, 4, 2];
  drawn = [];
  setPictures(pictures) { this.pictures = pictures; return [[0, 0, 2, 2]]; }
  clear() { this.isClear = true; }
  draw(turns) { this.drawn.push(turns); }
}

beforeEach(() => {
  [ticks, nowMs, settled, told, view] = [[], 1000, 0, [], 0];
  model = new Model();
  model.setAspect(1);
  model.setScene(sceneMessage());
  frames = Object.assign(new Emitter(), {canvas: {width: 4, height: 4, style: {left: '1px', top: '3px', width: '8px', height: '8px', imageRendering: 'auto'}}, cleared: [], clear(boxes) { this.cleared.push(...boxes); },
                                         put(image) { this.back = image.data[0]; }});
  session = Object.assign(new Emitter(), {welcome: {viewer: 1}, following: 0, pacer: {settle() { ++settled; sent(); }}});
  [stage, canvas, player] = [new Emitter(), {style: {}, hidden: true}, new Player()];
  flowing = new Flowing({model, frames, stage, session, tell: (text) => told.push(text)}, canvas, () => player);
});

// A View at rest goes to the server.
const sent = () => session.emit('sent', false, ++view);

// The picture of that view is on the screen.
function shown(of = view, {width = 4, lossless = true, viewer = 1, value = of} = {}) {
  const frame = {view: of, viewer, width, height: 4, lossless, pixels: new Uint8ClampedArray(width * 16).fill(value)};
  frames.emit('drawn', frame);
  frames.emit('shown', frame);
}

const wanted = () => model.viewGroups(false).lic;
const step = () => Math.round(wanted().phase / (2 * Math.PI) * FLOW_PICTURES);

function start() {
  flowing.run(true);
  sent();
}

function fill() {
  for (let i = 0; i < FLOW_PICTURES; ++i) {
    assert.equal(step(), i);
    shown();
  }
}

test('asks for the pictures of a cycle one after the other, then plays them and asks for none', () => {
  start();
  fill();
  assert.equal(settled, FLOW_PICTURES - 1);
  assert.equal(flowing.isPlaying, true);
  assert.equal(canvas.hidden, false);
  assert.deepEqual(canvas.style, {left: '3px', top: '3px', width: '6px', height: '4px', imageRendering: 'auto'});
  assert.deepEqual(player.pictures.map(({data}) => data[0]), [1, 2, 3, 4, 5, 6, 7, 8]);
  assert.deepEqual(frames.cleared, []);
  nowMs += 40;
  ticks.shift()(nowMs);
  nowMs += 60000;  // A hidden tab.
  ticks.shift()(nowMs);
  const [first, second, third] = player.drawn;
  assert.ok(Math.abs(first - 7 / 8) < 1e-9 && Math.abs(second - first - 0.02) < 1e-9 && Math.abs(third - second - 0.05) < 1e-9, `${player.drawn}`);
});

for (const [what, happens] of [
  ['the camera moves', () => model.moveCamera({...model.camera, position: [9, 9, 9]})],
  ['an option changes', () => model.setOption('shading', 'contrast', 0.5)],
  ['the scene changes', () => model.setScene(sceneMessage())],
  ['the window changes', () => stage.emit('resize')],
  ['one follows another viewer', () => { session.following = 3; session.emit('following', 3); }],
  ['a picture in motion comes', () => frames.emit('drawn', {lossless: false})],
  ['another View at rest is sent', () => sent()],
  ['a picture comes again, as data were renewed', () => shown()],
])
  test(`ends where ${what}, and begins again at rest`, () => {
    start();
    fill();
    happens();
    assert.equal(flowing.isPlaying, false);
    assert.equal(canvas.hidden, true);
    const {length} = player.drawn;
    for (const tick of ticks.splice(0)) tick(nowMs += 16);
    assert.equal(player.drawn.length, length, 'nothing is drawn any more');
    session.following = 0;
    sent();
    fill();
    assert.equal(flowing.isPlaying, true);
  });

test('a change on the way throws away what came before it', () => {
  start();
  shown();
  shown();
  model.setOption('lic', 'seed', 7);
  shown();  // It was on its way.
  sent();
  fill();
  assert.equal(player.pictures[0].data[0], view - FLOW_PICTURES + 1);
});

test('a picture that comes again on the way begins the cycle anew, once', () => {
  start();
  shown();
  shown();
  shown(view - 1, {value: 99});
  assert.equal(step(), 0);
  fill();
  assert.ok(player.pictures.every(({data}) => data[0] !== 99));
});

test('pictures from before, with loss, of others, or while one follows are none of the cycle', () => {
  model.setFlows(false);
  sent();
  start();
  shown(1);
  shown(view, {lossless: false});
  sent();
  shown(view, {viewer: 2});
  session.following = 2;
  shown();
  session.following = 0;
  assert.equal(settled, 0);
  fill();
});

test('a picture in motion that comes late does not stop the cycle', () => {
  start();
  model.moveCamera({...model.camera, position: [9, 9, 9]});
  session.emit('sent', true, ++view);
  sent();
  shown(view - 1, {lossless: false});
  fill();
  assert.equal(flowing.isPlaying, true);
});

test('where the scene moved while a cycle was on its way, the picture at rest begins another', () => {
  start();
  shown();
  shown();
  shown(view, {lossless: false});
  shown();
  fill();
  assert.equal(flowing.isPlaying, true);
});

for (const before of [0, 3])
  test(`a scene that changes when ${before} pictures are here: the server draws the last view again, and a cycle follows`, () => {
    start();
    for (let i = 0; i < before; ++i) shown();
    model.setScene(sceneMessage());
    shown();
    fill();
    assert.equal(flowing.isPlaying, true);
  });

test('goes on while the server is away, and begins again when it is back', () => {
  start();
  fill();
  session.emit('following', 0);
  assert.equal(flowing.isPlaying, true);
  model.setScene(sceneMessage());
  assert.equal(flowing.isPlaying, false);
  assert.equal(player.isClear, true);
});

test('below flowing pixels a transparent picture is taken away', () => {
  model.setOption('shading', 'background', 'transparent');
  start();
  fill();
  assert.deepEqual(frames.cleared, [[0, 0, 2, 2]]);
  model.moveCamera({...model.camera, position: [9, 9, 9]});
  assert.equal(frames.back, view, 'the last picture is whole again');
});

test('without WebGL the streaks stand, and a person hears why', () => {
  player.setPictures = () => { throw new Error('this browser has no WebGL 2'); };
  start();
  fill();
  assert.equal(flowing.isRunning, false);
  assert.match(told[0], /no WebGL 2/);
});

test('no streaks do not flow, and the server is not asked; oriented ones do', () => {
  model.setOption('lic', 'flow', 'loop');
  model.setOption('lic', 'method', 'none');
  assert.equal(flowing.isRunning, false);
  assert.equal(wanted().flow, 'off');
  model.resetOption('lic', 'method');
  for (const style of ['oriented', 'dense']) {
    model.setOption('lic', 'style', style);
    assert.equal(wanted().flow, 'loop');
  }
  assert.deepEqual([model.viewGroups(true).lic.flow, model.viewGroups(true).lic.kernel], ['off', 'hann']);
});

test('weights go through every picture, add up to 1, and make waves of up to three turns exactly', () => {
  for (const count of [5, 8]) {
    for (let i = 0; i < count; ++i) cycleWeights(i / count, count).forEach((weight, k) => assert.ok(Math.abs(weight - (i === k)) < 1e-12));
    for (const turns of [0.03, 0.31, 0.77, 1.2]) {
      const weights = cycleWeights(turns, count), wave = (t) => 2 + Math.cos(2 * Math.PI * t) - 3 * Math.sin(2 * 2 * Math.PI * t) + (count > 6 ? Math.cos(3 * 2 * Math.PI * t) : 0);
      const mixed = weights.reduce((sum, weight, i) => sum + weight * wave(i / count), 0);
      assert.ok(Math.abs(mixed - wave(turns)) < 1e-9 && Math.abs(weights.reduce((a, b) => a + b) - 1) < 1e-12);
    }
  }
});

test('boxes cover what differs, and nothing else', () => {
  const width = 70, height = 40, blank = () => new ImageData(new Uint8ClampedArray(width * height * 4), width, height);
  const one = blank(), other = blank();
  assert.deepEqual(flowingBoxes([one, other]), []);
  for (const [x, y] of [[0, 0], [16, 3], [69, 39]]) other.data[4 * (y * width + x) + 1] = 9;
  other.data[4 * (20 * width + 40)] = 2;  // Too little to be seen.
  assert.deepEqual(flowingBoxes([one, other]), [[0, 0, 32, 16], [64, 32, 70, 40]]);
});
