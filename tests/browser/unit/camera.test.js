import assert from 'node:assert/strict';
import {test} from 'node:test';
import * as camera from '../../../web/view/camera.js';
import {cross, dot, length, sub} from '../../../web/view/vec3.js';

const Z = [0, 0, 1], Y = [0, 1, 0];
const front = {position: [0, -4, 0], focal: [0, 0, 0], up: Z, fov: 30};

function near(actual, expected, tolerance = 1e-12) {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= tolerance, `found ${actual}, expected ${expected}`));
}
const anglesOf = (view, vertical = Z) => {
  const {azimuthDeg, elevationDeg, rollDeg, distance} = camera.anglesOf(view, vertical);
  return [azimuthDeg, elevationDeg, rollDeg, distance];
};

test('azimuth 0 looks along +y with x to the right', () => {
  near(anglesOf(front), [0, 0, 0, 4]);
  near(camera.axesOf(front).right, [1, 0, 0]);
});

test('azimuth 90 looks from +x, elevation 90 from +z: as on the command line', () => {
  near(camera.cameraFrom({azimuthDeg: 90, elevationDeg: 0, rollDeg: 0, distance: 2}, front, Z).position, [2, 0, 0]);
  const top = camera.cameraFrom({azimuthDeg: 0, elevationDeg: 90, rollDeg: 0, distance: 2}, front, Z);
  near(top.position, [0, 0, 2]);
  near(top.up, [0, 1, 0]);
});

for (const vertical of [Z, Y, [1, 0, 0], [0, -1, 0], [0, 0, -1]])
  for (const angles of [[30, 20, 0], [-100, -50, 40], [10, 90, 0], [170, -90, 0], [-179, 0, -170]])
    test(`angles ${angles} about ${vertical} come back`, () => {
      const [azimuthDeg, elevationDeg, rollDeg] = angles;
      near(anglesOf(camera.cameraFrom({azimuthDeg, elevationDeg, rollDeg, distance: 3}, front, vertical), vertical), [...angles, 3], 1e-9);
    });

test('turning right by 90 degrees goes from -y to +x and keeps up', () => {
  const turned = camera.orbit(front, 90, 0, Z);
  near(turned.position, [4, 0, 0]);
  near(turned.up, Z);
});

test('turning stops over the poles, and goes on from there', () => {
  const top = camera.orbit(front, 0, 300, Z);
  near(top.position, [0, 0, 4]);
  near(camera.orbit(top, 0, -90, Z).position, front.position);
  const {right, up, forward} = camera.axesOf(top);
  near([length(right), dot(right, up), dot(up, forward)], [1, 0, 0]);
});

test('many small turns neither drift away nor lose the roll', () => {
  let view = camera.roll(front, 20);
  for (let i = 0; i < 3600; ++i) view = camera.orbit(view, Math.sin(i), Math.cos(i), Z);
  assert.ok(Math.abs(camera.distanceOf(view) - 4) < 1e-9);
  assert.ok(Math.abs(anglesOf(view)[2] - 20) < 1e-6);
});

test('a drag follows the screen where the picture is rolled', () => {
  // Rolled by 90 degrees the screen's right is the world's up.
  near(camera.orbit(camera.roll(front, 90), 90, 0, Z).position, [0, 0, 4], 1e-9);
});

test('rolling turns up only', () => {
  const rolled = camera.roll(front, 90);
  near(rolled.up, [-1, 0, 0]);
  near(rolled.position, front.position);
});

test('panning by the height of the picture moves by what the picture shows', () => {
  const height = 2 * 4 * Math.tan(15 * Math.PI / 180);
  const moved = camera.pan(front, 500, 0, 500);
  near(moved.focal, [-height, 0, 0]);
  near(moved.position, [-height, -4, 0]);
  near(camera.pan(front, 0, 250, 500).focal, [0, 0, height / 2]);
});

test('coming closer halves the distance, and what is under the pointer stays there', () => {
  near(camera.dolly(front, 2).position, [0, -2, 0]);
  const closer = camera.dolly(front, 2, 100, 50, 500);
  const worldAt = (view, x, y) => {
    const {right, up} = camera.axesOf(view), px = 2 * camera.distanceOf(view) * Math.tan(15 * Math.PI / 180) / 500;
    return view.focal.map((value, i) => value + x * px * right[i] - y * px * up[i]);
  };
  near(worldAt(closer, 100, 50), worldAt(front, 100, 50));
});

test('a narrow picture is fitted from farther away, a wide one not', () => {
  assert.equal(camera.fitDistance(4, 30, 2), camera.fitDistance(4, 30, 1));
  const radius = 4 * Math.sin(15 * Math.PI / 180), halfWidth = Math.atan(0.5 * Math.tan(15 * Math.PI / 180));
  assert.ok(Math.abs(camera.fitDistance(4, 30, 0.5) - radius / Math.sin(halfWidth)) < 1e-12);
});

for (const [name, position] of [['+x', [4, 0, 0]], ['-x', [-4, 0, 0]], ['+y', [0, 4, 0]], ['-y', [0, -4, 0]], ['+z', [0, 0, 4]], ['-z', [0, 0, -4]]])
  for (const vertical of [Z, Y])
    test(`the view ${name} looks from there with ${vertical} upright`, () => {
      const view = camera.axisView(name, front, vertical);
      near(view.position, position, 1e-9);
      assert.ok(length(cross(view.up, sub(view.focal, view.position))) > 1);
      if (Math.abs(dot(position, vertical)) < 1) near(view.up, vertical, 1e-9);
    });

test('the upright axis is found from a view whose up leans back', () => {
  near(camera.verticalOf(camera.cameraFrom({azimuthDeg: 30, elevationDeg: 20, rollDeg: 0, distance: 3}, front, Z)), Z);
  near(camera.verticalOf(camera.cameraFrom({azimuthDeg: 30, elevationDeg: 20, rollDeg: 0, distance: 3}, front, Y)), Y);
  near(camera.verticalOf(camera.roll(camera.cameraFrom({azimuthDeg: 30, elevationDeg: 20, rollDeg: 0, distance: 3}, front, Z), 33)), Z);
});
