// A zoom that stays outside the body. The known answers are those of src/description/camera_test.cpp.

import assert from 'node:assert/strict';
import {test} from 'node:test';

import {distanceOf, dolly, orbit} from '../../../web/view/camera.js';
import {Model} from '../../../web/view/model.js';
import {add, length, scale, sub} from '../../../web/view/vec3.js';
import {keptOutside, lensOf} from '../../../web/view/zoom.js';
import {sceneMessage} from '../mock/server.js';

const RAD = Math.PI / 180;
const BODY = {center: [1, 0, 5], radius: 2}, WHOLE = 1.04 * 2 / Math.sin(15 * RAD);
const HOME = {position: [1, -WHOLE, 5], focal: [1, 0, 5], up: [0, 0, 1], fov: 30};

const close = (a, b) => assert.ok(Math.abs(a / b - 1) < 1e-9, `${a} is not ${b}`);
const scaleOf = (camera) => 1 / (distanceOf(camera) * Math.tan(camera.fov / 2 * RAD));
const moved = (camera, before, lensDeg = 30) => keptOutside(camera, before, BODY, lensDeg, 1);
const zoomed = (camera, factor) => moved(dolly(camera, factor), camera);

test('a small zoom comes closer, and is dolly alone', () => {
  assert.deepEqual(zoomed(HOME, 2.5), dolly(HOME, 2.5));
});

test('a large zoom stays outside, and its scale goes on as before', () => {
  for (const factor of [2.6, 2.7, 12, 400, 1e5]) {
    const camera = zoomed(HOME, factor);
    close(scaleOf(camera), factor * scaleOf(HOME));
    assert.ok(distanceOf(camera) >= 3 - 1e-9);
  }
  const at12 = zoomed(HOME, 12);
  close(distanceOf(at12), 3);
  close(at12.fov, 2 * Math.atan(Math.tan(15 * RAD) * WHOLE / 12 / 3) / RAD);
});

test('many turns of the wheel are one, and lead back to the lens and the place that they began at', () => {
  let camera = HOME;
  for (let i = 0; i < 60; ++i) camera = zoomed(camera, 1.15);
  const direct = zoomed(HOME, 1.15 ** 60);
  close(camera.fov, direct.fov);
  for (let i = 0; i < 60; ++i) camera = zoomed(camera, 1 / 1.15);
  close(camera.fov, 30);
  close(distanceOf(camera), WHOLE);
});

test('a turn about a point beside the middle never leads into the body', () => {
  let camera = {...HOME, focal: add(HOME.focal, [0, -1.5, 0]), position: add(HOME.position, [0, -1.5, 0])};
  camera = zoomed(camera, 8);
  const size = scaleOf(camera);
  close(distanceOf(camera), 1.5);
  for (let i = 0; i < 36; ++i) {
    camera = moved(orbit(camera, 10, 0, [0, 0, 1]), camera);
    close(length(sub(camera.position, BODY.center)), 3);
    close(scaleOf(camera), size);
  }
  close(distanceOf(camera), 1.5);
});

test('a zoom to a point behind the body stays before it', () => {
  const behind = {...HOME, focal: [1, 4, 5], position: [1, 4 - WHOLE, 5]};
  for (const factor of [1.2, 2, 50, 1e4]) {
    const camera = zoomed(behind, factor);
    close(distanceOf(camera), 4 + 3);
    close(scaleOf(camera), factor * scaleOf(behind));
  }
});

test('a turn about a point outside brings the body between, and the eye neither into it nor to jump', () => {
  for (const aside of [3.1, 4, 5]) {
    let camera = {...HOME, focal: add(HOME.focal, [aside, 0, 0]), position: add(HOME.position, [aside, 0, 0])};
    camera = zoomed(camera, 8);
    const size = scaleOf(camera), away = Math.min(3, length(sub(camera.position, BODY.center)));
    let farthest = 0;
    for (let i = 0; i < 3600; ++i) {
      const {position} = camera;
      camera = moved(orbit(camera, 0.1, 0, [0, 0, 1]), camera);
      close(scaleOf(camera), size);
      assert.ok(length(sub(camera.position, BODY.center)) > away - 1e-6, `${aside}, ${i}: ${camera.position}`);
      assert.ok(length(sub(camera.position, position)) < 0.3, `${aside}, ${i}: ${position} to ${camera.position}`);
      farthest = Math.max(farthest, distanceOf(camera));
    }
    close(farthest, aside + 3);
  }
});

test('a view from within the body moves freely, and so does one past the body', () => {
  const within = {...HOME, position: [1, -1, 5]};
  assert.deepEqual(zoomed(within, 4), dolly(within, 4));
  const beside = {...HOME, focal: [9, 0, 5], position: [9, -9, 5]};
  assert.deepEqual(zoomed(beside, 400), dolly(beside, 400));
});

test('a wide lens begins nearer than others end, and narrows at once', () => {
  const wide = {...HOME, fov: 120, position: [1, -2.08 / Math.sin(60 * RAD), 5]}, camera = moved(dolly(wide, 2), wide, 120);
  close(distanceOf(camera), distanceOf(wide));
  close(scaleOf(camera), 2 * scaleOf(wide));
});

test('a narrow lens from afar is one, a narrow lens close by is a zoom', () => {
  assert.equal(lensOf({...HOME, fov: 2}, BODY, 30, 1), 2);
  assert.equal(lensOf(zoomed(HOME, 100), BODY, 30, 1), 30);
  assert.equal(lensOf({...HOME, fov: 70}, BODY, 30, 1), 70);
});

test('the page zooms so, as far as the field of view may be narrow', () => {
  const model = new Model();
  model.setAspect(1);
  model.setScene(sceneMessage());
  for (let i = 0; i < 100; ++i) model.moveCamera(dolly(model.camera, 1.15));
  assert.ok(distanceOf(model.camera) >= 1.5 - 1e-9);
  assert.ok(model.camera.fov >= 10 && model.camera.fov < 12, `${model.camera.fov}`);  // The mock's least is 10.
  const {camera} = model;
  model.takeCamera({...camera});
  for (let i = 0; i < 100; ++i) model.moveCamera(dolly(model.camera, 1 / 1.15));
  close(model.camera.fov, 30);
  model.setLens(50, false);
  model.moveCamera(dolly(model.camera, 2));
  assert.equal(model.camera.fov, 50);
});

test('a zoomed scene in a narrow picture has its eye where the command line has it', () => {
  const model = new Model(), message = sceneMessage(), zoom = 20;
  message.scene.camera.zoom = zoom;
  const fov = (aspect) => 2 * Math.atan(Math.tan(15 * RAD) * 1.04 / Math.sin(Math.atan(Math.tan(15 * RAD) * aspect)) / zoom / 1.5) / RAD;
  message.view = {...message.view, position: scale(message.view.position, 1.5 / length(message.view.position)), fov: fov(1)};
  model.setAspect(0.5);
  model.setScene(message);
  close(distanceOf(model.camera), 1.5);
  close(model.camera.fov, fov(0.5));
});
