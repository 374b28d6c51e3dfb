// What the page says to the server, and when. The connection is a stand-in, and time is the test's own.
import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';

import {Emitter} from '../../../web/page/emitter.js';
import {Model} from '../../../web/view/model.js';
import {Session} from '../../../web/net/session.js';
import {Type, jsonMessage} from '../../../web/net/protocol.js';
import {FakeTimers} from './fake_timers.js';
import {sceneMessage} from '../mock/server.js';

class FakeSocket {
  static OPEN = 1;
  readyState = 1;
  said = [];
  constructor() { FakeSocket.last = this; }
  send(message) { this.said.push(message); }
  close() {}
}

const realPerformance = globalThis.performance;
let timers, nowMs, session, model, server;

// Views that were sent.
const views = () => server.said.filter((message) => message[2] === Type.view)
  .map((message) => JSON.parse(new TextDecoder().decode(message.subarray(8))));
const say = (type, json) => server.onmessage({data: jsonMessage(type, json).buffer});

function pass(ms) {
  for (let i = 0; i < ms; ++i) {
    ++nowMs;
    timers.tick(1);
  }
}

beforeEach(() => {
  timers = new FakeTimers();
  nowMs = 1000;
  Object.defineProperty(globalThis, 'performance', {value: {now: () => nowMs}, configurable: true});
  globalThis.requestAnimationFrame = (call) => setTimeout(() => call(nowMs), 1);
  globalThis.window = {addEventListener() {}};
  globalThis.document = {baseURI: 'http://localhost:8080/'};
  globalThis.WebSocket = FakeSocket;
  model = new Model();
  const frames = new Emitter(), stage = {size: {width: 80, height: 60, cssWidth: 80, cssHeight: 60}, setLargestSide() {}};
  frames.abandon = () => {};
  session = new Session({model, frames, stage});
  session.start();
  server = FakeSocket.last;
  server.onopen();
  say(Type.welcome, {viewer: 1, limits: {viewsPerSecond: 25, largestSide: 4096}, state: {state: 'ready'}});
  say(Type.scene, sceneMessage());
  pass(200);
});
afterEach(() => {
  timers.restore();
  Object.defineProperty(globalThis, 'performance', {value: realPerformance, configurable: true});
});

for (const gone of ['restarting', 'failed'])
  test(`a view sent while the renderer was ${gone} is sent again when it is back`, () => {
    say(Type.state, {state: gone});
    model.setCamera({...model.camera, fov: 20}, false);
    pass(100);
    const before = views().length;
    say(Type.state, {state: 'ready'});
    pass(100);
    assert.equal(views().length, before + 1);
    assert.equal(views().at(-1).camera.fov, 20);
    say(Type.state, {state: 'rendering'});
    say(Type.state, {state: 'ready'});
    pass(100);
    assert.equal(views().length, before + 1);
  });

test('no more views a second are sent than the server takes', () => {
  const before = views().length;
  for (let i = 0; i < 100; ++i) {
    model.setCamera({...model.camera, fov: 20 + i / 100}, false);
    pass(10);
  }
  assert.ok(views().length - before >= 20 && views().length - before <= 26, `${views().length - before}`);
});

test('the sizes of views long past are forgotten', () => {
  for (let i = 0; i < 80; ++i) {
    model.setCamera({...model.camera, fov: 20 + i / 100}, false);
    pass(50);
  }
  const newest = views().at(-1).view;
  assert.equal(newest, views().length);
  assert.deepEqual(session.askedSize({viewer: 1, view: newest})?.width, 80);
  assert.notEqual(session.askedSize({viewer: 1, view: newest - 63}), null);
  assert.equal(session.askedSize({viewer: 1, view: newest - 64}), null);
  assert.equal(session.askedSize({viewer: 2, view: newest}), null);
});
