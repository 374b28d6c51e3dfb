// How a person moves in the page's picture: by mouse, wheel, fingers, keys and buttons (visit.js).

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {canvasPixels, stageBox} from './harness.js';
import {angles, distance, middle, open, page, restAfter, sent} from './visit.js';

test('a drag to the right turns to the left, in moving views, and ends at rest', async () => {
  await open();
  const start = angles(sent.lastView().camera), [x, y] = await middle(), before = await canvasPixels(page);
  const count = sent.views().length, box = await stageBox(page);
  const view = await restAfter(async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 10; ++i) {
      await page.mouse.move(x + 10 * i, y);
      await page.waitForTimeout(30);
    }
    await page.mouse.up();
  });
  const end = angles(view.camera), expected = 100 * 180 / Math.min(box.width, box.height);
  assert.ok(Math.abs(((start.azimuthDeg - end.azimuthDeg + 540) % 360) - 180 - expected) < 1e-6, `${start.azimuthDeg} to ${end.azimuthDeg}, expected ${expected}`);
  assert.ok(Math.abs(start.elevationDeg - end.elevationDeg) < 1e-6);
  assert.ok(sent.views().slice(count).some(({moving}) => moving));
  assert.ok(!before.rgba.equals((await canvasPixels(page)).rgba), 'the picture stayed the same');
});

test('a drag with shift or the right button moves sideways; with control it rolls', async () => {
  await open();
  const [x, y] = await middle(), first = sent.lastView().camera;
  const dragged = (options) => restAfter(async () => {
    await page.mouse.move(x, y);
    await page.mouse.down(options);
    await page.mouse.move(x + 50, y + 20, {steps: 4});
    await page.mouse.up(options);
  });
  const right = (await dragged({button: 'right'})).camera;
  assert.ok(Math.hypot(...right.focal.map((value, i) => value - first.focal[i])) > 0.01);
  assert.deepEqual(right.up, first.up);
  await page.keyboard.down('Shift');
  const shifted = (await dragged()).camera;
  await page.keyboard.up('Shift');
  assert.notDeepEqual(shifted.focal, right.focal);
  await page.keyboard.down('Control');
  const rolled = (await dragged()).camera;
  await page.keyboard.up('Control');
  assert.deepEqual(rolled.position, shifted.position);
  assert.notDeepEqual(rolled.up, shifted.up);
});

test('the wheel comes closer to what is under the pointer', async () => {
  await open();
  const first = sent.lastView().camera, [x, y] = await middle();
  const view = await restAfter(async () => {
    await page.mouse.move(x + 60, y);
    await page.mouse.wheel(0, -240);
  });
  assert.ok(Math.abs(distance(first) / distance(view.camera) - 1.0015 ** 240) < 1e-9);
  assert.notDeepEqual(view.camera.focal, first.focal);
});

test('two fingers pinch and move, one turns', async () => {
  await open({hasTouch: true, isMobile: true, viewport: {width: 390, height: 844}});
  const [x, y] = await middle(), client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([px, py], id) => ({x: px, y: py, id}))});
  const first = sent.lastView().camera;
  const pinched = await restAfter(async () => {
    await touch('touchStart', [x - 40, y]);
    await touch('touchStart', [x - 40, y], [x + 40, y]);
    for (let i = 1; i <= 4; ++i) await touch('touchMove', [x - 40 - 10 * i, y], [x + 40 + 10 * i, y]);
    await touch('touchEnd');
  });
  assert.ok(Math.abs(distance(first) / distance(pinched.camera) - 2) < 0.02, `${distance(first)} to ${distance(pinched.camera)}`);
  const moved = await restAfter(async () => {
    await touch('touchStart', [x - 40, y], [x + 40, y]);
    for (let i = 1; i <= 4; ++i) await touch('touchMove', [x - 40, y + 10 * i], [x + 40, y + 10 * i]);
    await touch('touchEnd');
  });
  assert.ok(Math.abs(distance(moved.camera) - distance(pinched.camera)) < 1e-6 * distance(moved.camera));
  assert.notDeepEqual(moved.camera.focal, pinched.camera.focal);
  const turned = await restAfter(async () => {
    await touch('touchStart', [x, y]);
    for (let i = 1; i <= 4; ++i) await touch('touchMove', [x + 10 * i, y]);
    await touch('touchEnd');
  });
  assert.ok(angles(turned.camera).azimuthDeg < angles(moved.camera).azimuthDeg);
});

test('keys turn, move, come closer, roll, look along axes and go home', async () => {
  await open();
  await page.focus('#stage');
  const press = async (key) => (await restAfter(() => page.keyboard.press(key))).camera;
  const first = sent.lastView().camera;
  let camera = await press('ArrowRight');
  assert.ok(Math.abs(angles(camera).azimuthDeg - angles(first).azimuthDeg + 5) < 1e-6);
  camera = await press('ArrowDown');
  assert.ok(Math.abs(angles(camera).elevationDeg - angles(first).elevationDeg - 5) < 1e-6);
  assert.notDeepEqual((await press('Shift+ArrowLeft')).focal, first.focal);
  assert.ok(distance(await press('+')) < distance(first));
  assert.ok(Math.abs(Math.abs(angles(await press(']')).rollDeg) - 5) < 1e-6);
  camera = await press('5');
  assert.ok(Math.abs(angles(camera).elevationDeg - 90) < 1e-6);
  camera = await press('3');
  assert.ok(Math.abs(angles(camera).azimuthDeg - 90) < 1e-6 && Math.abs(angles(camera).rollDeg) < 1e-6);
  camera = await press('0');
  assert.deepEqual(camera, first);
});

test('keys typed into a field are not for the picture', async () => {
  await open();
  const count = sent.views().length, seed = page.getByLabel('Seed', {exact: true});
  await seed.fill('5');
  await seed.press('0');
  await seed.press('ArrowLeft');
  await page.waitForTimeout(300);
  assert.equal(sent.views().length, count);
});

test('the cross of axes and the buttons of the panel look along axes', async () => {
  await open();
  const view = await restAfter(() => page.locator('#axes').getByRole('button', {name: 'Look from plus z'}).click());
  assert.ok(Math.abs(angles(view.camera).elevationDeg - 90) < 1e-6);
  const isHidden = () => page.evaluate(() => document.getElementById('axes').hidden);
  const own = page.getByRole('switch', {name: 'Axes'});  // With it the picture has axes of its own in that corner.
  await restAfter(() => own.click());
  assert.equal(await isHidden(), true);
  await restAfter(() => own.click());
  assert.equal(await isHidden(), false);
  await page.getByText('View', {exact: true}).click();
  const side = await restAfter(() => page.locator('#panel').getByRole('button', {name: 'Look from minus y'}).click());
  assert.ok(Math.abs(angles(side.camera).azimuthDeg) < 1e-6);
  await restAfter(() => page.getByRole('button', {name: 'Roll left'}).click());
  await restAfter(() => page.getByRole('button', {name: 'Reset the view'}).last().click());
});
