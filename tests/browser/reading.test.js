// How the page's picture is read: streaks that flow, and what is there at a place (visit.js).

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {openPage, stageBox, until, waitForState} from './harness.js';
import {middle, open, page, restAfter, sent, server} from './visit.js';

test('the streaks flow: eight pictures of a cycle are asked for, and then nothing more', async () => {
  await open();
  const count = sent.views().length, isFlowing = () => page.evaluate(() => !document.getElementById('flowing').hidden);
  await page.getByRole('switch', {name: 'Let it flow'}).click();
  await until(isFlowing, 'the cycle');
  const views = sent.views().slice(count), phases = views.map(({lic}) => lic.phase);
  assert.deepEqual(phases.map((phase) => Math.round(phase / (Math.PI / 4))), [0, 1, 2, 3, 4, 5, 6, 7]);
  assert.ok(views.every(({lic, moving}) => lic.flow === 'loop' && !moving));
  await page.waitForTimeout(300);
  assert.equal(sent.views().length, count + 8, 'at rest it costs nothing');
  assert.match(page.url(), /lic\.flow=loop/);

  // While the camera moves there is one phase, and at rest another cycle.
  const before = sent.views().length, [x, y] = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, {steps: 4});
  assert.equal(await isFlowing(), false);
  await page.mouse.up();
  await until(isFlowing, 'the cycle seen from there');
  const moving = sent.views().slice(before).filter((view) => view.moving);
  assert.ok(moving.length > 0 && moving.every(({lic}) => lic.flow === 'off' && lic.kernel === 'hann'));

  await page.getByRole('switch', {name: 'Let it flow'}).click();
  assert.equal(await isFlowing(), false);
  assert.equal(sent.lastView().lic.flow, 'off');
});

test('with a GPU and without, players show what lies between the pictures of a cycle', async () => {
  await open();
  const found = await page.evaluate(async () => {
    const load = (name) => import(new URL(`picture/${name}.js`, document.baseURI));
    const [{GpuPlayer}, {CyclePainter}, {playerFor}] = await Promise.all(['cycle_gpu', 'cycle_painter', 'cycle_player'].map(load));
    const [width, height, flows, count] = [70, 40, 48, 8], wave = (turns) => Math.cos(2 * Math.PI * turns);
    const valueAt = (x, y, turns) => Math.round(128 + (x < flows) * (60 * wave(turns + x / 16) + 10 * wave(2 * turns + y / 8)));
    const picture = (turns) => {
      const image = new ImageData(width, height);
      for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) image.data.set([valueAt(x, y, turns), 255 - valueAt(x, y, turns), 128, 255], 4 * (y * width + x));
      return image;
    };
    const pictures = Array.from({length: count}, (_, i) => picture(i / count)), canvasOf = () => document.createElement('canvas');
    const errorsOf = (player, canvas) => {
      const boxes = player.setPictures(pictures), errors = [];
      for (let i = 0; i < 50; ++i) player.draw(i / 50);  // Until all that is worked out ahead is there.
      for (const turns of [0, 0.03, 0.11, 0.52, 0.97, 3.3]) {
        player.draw(turns);
        const copy = Object.assign(canvasOf(), {width: canvas.width, height: canvas.height}).getContext('2d');
        copy.drawImage(canvas, 0, 0);
        const shown = copy.getImageData(0, 0, canvas.width, canvas.height).data, right = picture(turns).data;
        let most = 0;
        for (let y = 0; y < height; ++y) for (let x = 0; x < flows; ++x) for (let c = 0; c < 4; ++c) most = Math.max(most, Math.abs(shown[4 * (y * canvas.width + x) + c] - right[4 * (y * width + x) + c]));
        errors.push(most);
      }
      return {boxes, errors, size: [canvas.width, canvas.height]};
    };
    const [one, other] = [canvasOf(), canvasOf()];
    return {gpu: errorsOf(new GpuPlayer(one), one), painter: errorsOf(new CyclePainter(other), other), chosen: playerFor(canvasOf()).constructor.name,
            drawsBy: (() => { const gl = canvasOf().getContext('webgl2'), info = gl.getExtension('WEBGL_debug_renderer_info'); return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER); })()};
  });
  for (const [name, most] of [['gpu', 1], ['painter', 3]]) {
    assert.deepEqual(found[name].size, [48, 40], name);
    assert.ok(found[name].errors.every((error) => error <= most), `${name}: ${found[name].errors}`);
  }
  assert.deepEqual(found.gpu.boxes, found.painter.boxes);
  assert.equal(found.chosen, /swiftshader|llvmpipe/i.test(found.drawsBy) ? 'CyclePainter' : 'GpuPlayer', found.drawsBy);
});

test('a click tells what is there, a drag does not, and looking elsewhere closes it', async () => {
  await open();
  const [x, y] = await middle(), box = await stageBox(page), card = page.locator('#place > div');
  await page.mouse.click(x + 20, y - 10);
  await card.waitFor();
  const asked = sent.filter(({type}) => type === 7).at(-1).json, {width, height} = sent.lastView();
  assert.deepEqual([asked.x, asked.y], [Math.floor((x + 20 - box.x) / box.width * width), Math.floor((y - 10 - box.y) / box.height * height)]);
  assert.deepEqual([asked.width, asked.height], [width, height]);
  if (server.mock) {
    const rows = await card.locator('dt').allTextContents(), values = await card.locator('dd').allTextContents();
    assert.deepEqual(rows, ['p', 'U', 'Along surface', 'Position']);
    assert.deepEqual(values, ['-0.3125', '5 (3, 0, 4)', '3 60 %', '0.25, -0.5, 1e-7']);
    assert.equal(await card.locator('h2').textContent(), 'ball.vtp');
  }
  const place = await card.boundingBox();
  assert.ok(place.x >= box.x && place.y >= box.y && place.x + place.width <= box.x + box.width && place.y + place.height <= box.y + box.height);
  await until(() => sent.lastView().shading.overlay?.startsWith('through:'), 'the streamline through the place');
  if (server.mock) assert.equal(sent.lastView().shading.overlay, 'through:0.25:-0.5:1e-7');
  await restAfter(() => page.keyboard.press('Escape'));
  assert.equal(await card.isVisible(), false);
  assert.equal(sent.lastView().shading.overlay, undefined);

  await page.mouse.click(x, y);
  await card.waitFor();
  const picks = sent.filter(({type}) => type === 7).length;
  await restAfter(async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 5, {steps: 3});
    await page.mouse.up();
  });
  assert.equal(await card.isVisible(), false);
  assert.equal(sent.filter(({type}) => type === 7).length, picks);
  assert.ok(sent.lastView().shading.overlay.startsWith('through:'), 'the line stays while one looks around');
});

test('the card of a place near the edges stays inside, and the keyboard asks, too', async () => {
  await open({viewport: {width: 700, height: 500}});
  const box = await stageBox(page), card = page.locator('#place > div');
  if (server.mock)
    for (const [right, down] of [[0.01, 0.01], [0.99, 0.01], [0.99, 0.99], [0.01, 0.99]]) {
      await page.mouse.click(box.x + right * box.width, box.y + down * box.height);
      await card.waitFor();
      const {x, y, width, height} = await card.boundingBox();
      assert.ok(x >= box.x && y >= box.y && x + width <= box.x + box.width && y + height <= box.y + box.height, `at ${right}, ${down}`);
      await page.getByRole('button', {name: 'Close the values'}).click();
      assert.equal(await card.isVisible(), false);
    }
  await page.locator('#stage').focus();
  await page.keyboard.press('Enter');
  await card.waitFor();
});

test('a click beside the surface closes the card, and nobody is asked while another is followed', async () => {
  await open();
  if (!server.mock) return;
  const [x, y] = await middle(), card = page.locator('#place > div');
  await page.mouse.click(x, y);
  await card.waitFor();
  const told = server.mock.placeAt, picks = () => sent.filter(({type}) => type === 7).length;
  await until(() => sent.lastView().shading.overlay !== undefined, 'the line');
  server.mock.placeAt = () => null;
  await page.mouse.click(x + 50, y);
  await until(() => sent.lastView().shading.overlay === undefined, 'the line to go');
  assert.equal(picks(), 2);
  assert.equal(await card.isVisible(), false);
  server.mock.placeAt = told;

  const other = await openPage(server.url);
  try {
    await waitForState(other, 'ready');
    await page.locator('#viewers-button').click();
    await page.locator('#viewers-list button').last().click();
    await page.locator('#following').waitFor();
    await page.mouse.click(x, y);
    await page.waitForTimeout(300);
    assert.equal(picks(), 2);
    assert.equal(await card.isVisible(), false);
  } finally {
    await other.context().close();
  }
});
