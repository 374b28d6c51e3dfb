// The page as a person uses it: its picture, its panel, links, files, and how it is got in (visit.js).

import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';
import {pixelsToRgba} from '../../web/picture/lz4.js';
import {pngDecode} from '../../web/picture/png.js';
import {OPTIONS} from './mock/options.js';
import {canvasPixels, stageBox, until, waitForState} from './harness.js';
import {open, openEmpty, page, restAfter, sent, server} from './visit.js';

test('loads: a picture of the stage\'s size, exact, and the Hello first', async () => {
  await open();
  const box = await stageBox(page), {width, height} = await canvasPixels(page);
  assert.deepEqual([width, height], [Math.floor(box.width), Math.floor(box.height)]);
  assert.deepEqual(sent[0].json.codecs, ['jpeg', 'png', 'lz4']);
  const view = sent.lastView();
  assert.equal(view.moving, false);
  assert.deepEqual([view.width, view.height], [width, height]);
});

test('every control has a name, and every id is there once', async () => {
  await open();
  await page.evaluate(() => document.querySelectorAll('details').forEach((part) => { part.open = true; }));
  const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, select, a, [tabindex]')].filter((element) => {
    const labels = [...element.labels ?? []].map((label) => label.textContent).join('');
    return !(element.getAttribute('aria-label') || element.textContent.trim() || labels.trim());
  }).map((element) => element.outerHTML));
  assert.deepEqual(nameless, []);
  const ids = await page.evaluate(() => [...document.querySelectorAll('[id]')].map((element) => element.id));
  assert.equal(new Set(ids).size, ids.length);
});

test('two screen pixels for each of the page\'s: the picture is of the screen\'s', async () => {
  await open({deviceScaleFactor: 2, viewport: {width: 500, height: 400}});
  const box = await stageBox(page), {width, height} = await canvasPixels(page);
  assert.deepEqual([width, height], [box.width * 2, box.height * 2]);
  const style = await page.locator('#picture').evaluate(({style}) => [style.width, style.height, style.imageRendering]);
  assert.deepEqual(style, [`${box.width}px`, `${box.height}px`, 'pixelated']);
});

test('text in the picture is as large on the page with two screen pixels for each of its as with one', async () => {
  await open({deviceScaleFactor: 1, viewport: {width: 390, height: 844}});
  assert.equal(sent.lastView().shading.textScale, undefined);
  await page.context().close();
  await open({deviceScaleFactor: 3, viewport: {width: 390, height: 844}});
  const {textScale} = sent.lastView().shading, {width, height} = await canvasPixels(page);
  assert.ok(textScale > 1.3, `found ${textScale}`);
  assert.ok(Math.abs(textScale * (5 + 0.0125 * Math.min(width, height)) / 3 - 10) < 0.1);
});

// [label, group, key, how to set it, what must be sent]
const NUMBERS = [['Steps each way', 'lic', 'steps', 33], ['Step', 'lic', 'step', 0.5], ['Noise', 'lic', 'noiseScale', 2.5], ['Seed', 'lic', 'seed', 7],
                 ['Contrast of streaks', 'shading', 'contrast', 1.5], ['Strength of streaks', 'shading', 'blend', 0.25]];
const CHOICES = [['Method', 'direct', 'lic', 'method'], ['Integrator', 'rk4', 'lic', 'integrator'], ['Method', 'hierarchical', 'lic', 'method'],
                 ['Kernel', 'hann', 'lic', 'kernel'], ['Style', 'oriented', 'lic', 'style'], ['Style', 'dense', 'lic', 'style']];
// [label, group, key, what its click sends]
const SWITCHES = [['Same length everywhere', 'lic', 'normalize', false], ['Light', 'shading', 'lighting', false],
                  ['Smooth edges', 'shading', 'antialias', false], ['Darker hollows', 'shading', 'occlusion', true]];

test('every option changes what is sent, alone, and goes back', async () => {
  await open({viewport: {width: 1000, height: 500}});
  const panel = page.locator('#panel');
  for (const [label, group, key, value] of NUMBERS) {
    const view = await restAfter(() => panel.getByRole('textbox', {name: label, exact: true}).fill(String(value)).then(() => page.keyboard.press('Tab')));
    assert.deepEqual(view[group], {[key]: value}, label);
    const back = await restAfter(() => panel.getByRole('button', {name: `Reset ${label}`, exact: true}).click());
    assert.deepEqual(back[group], {}, label);
  }
  for (const [label, group, key, value] of SWITCHES) {
    const view = await restAfter(() => panel.getByRole('switch', {name: label, exact: true}).click());
    assert.deepEqual(view[group], {[key]: value}, label);
    await restAfter(() => panel.getByRole('button', {name: `Reset ${label}`, exact: true}).click());
  }
  for (const [label, value, group, key] of CHOICES) {
    const view = await restAfter(() => panel.getByRole('radiogroup', {name: label, exact: true}).locator(`input[value=${value}]`).click({force: true}));
    assert.equal(view[group][key] ?? OPTIONS[group][key].default, value, label);
  }
  const exact = await restAfter(() => panel.getByRole('switch', {name: 'Exact at rest', exact: true}).click());
  assert.equal(exact.lic.method, 'direct');
  const quick = await restAfter(() => panel.getByRole('switch', {name: 'Exact at rest', exact: true}).click());
  assert.equal(quick.lic.method, 'hierarchical');
  const phase = await restAfter(() => panel.getByRole('textbox', {name: 'Phase', exact: true}).fill('1.25').then(() => page.keyboard.press('Tab')));
  assert.equal(phase.lic.phase, 1.25);
  const black = await restAfter(() => panel.getByRole('radiogroup', {name: 'Background'}).locator('input[value="000000"]').click({force: true}));
  assert.equal(black.shading.background, '000000');
  await page.getByText('View', {exact: true}).click();
  const fov = await restAfter(() => panel.getByRole('textbox', {name: 'Field of view', exact: true}).fill('45').then(() => page.keyboard.press('Tab')));
  assert.equal(fov.camera.fov, 45);
  const reset = await restAfter(() => panel.getByRole('button', {name: 'Reset all options'}).click());
  assert.deepEqual([reset.lic, reset.shading], [{}, {}]);
});

test('a slider sends moving views while it is dragged and one at rest after', async () => {
  await open();
  const slider = page.getByRole('slider', {name: 'Strength of streaks'});
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox(), y = box.y + box.height / 2, count = sent.views().length;
  const view = await restAfter(async () => {
    await page.mouse.move(box.x + 0.8 * box.width, y);
    await page.mouse.down();
    for (let i = 0; i < 8; ++i) {
      await page.mouse.move(box.x + (0.8 - 0.05 * i) * box.width, y);
      await page.waitForTimeout(30);
    }
    await page.mouse.up();
  });
  assert.ok(view.shading.blend > 0.3 && view.shading.blend < 0.6, `blend ${view.shading.blend}`);
  assert.ok(sent.views().slice(count).filter(({moving}) => moving).length >= 2);
});

test('a number that the server would refuse is marked and not sent', async () => {
  await open();
  const count = sent.views().length, box = page.getByRole('textbox', {name: 'Steps each way', exact: true});
  for (const text of ['0', '1.5', 'many', '']) {
    await box.fill(text);
    await box.press('Enter');
    await page.waitForTimeout(100);
    assert.equal(await box.getAttribute('aria-invalid'), 'true', text);
  }
  assert.equal(sent.views().length, count);
  await box.press('Escape');
  assert.equal(await box.inputValue(), '128');
});

test('a window of another size asks for another picture, once', async () => {
  await open();
  const count = sent.views().length;
  const view = await restAfter(() => page.setViewportSize({width: 1000, height: 500}));
  const box = await stageBox(page);
  assert.deepEqual([view.width, view.height], [box.width, box.height]);
  const {width, height} = await canvasPixels(page);
  assert.deepEqual([width, height], [view.width, view.height]);
  assert.ok(sent.views().length - count <= 2);
});

test('closing the panel gives its place to the picture', async () => {
  await open();
  const view = await restAfter(() => page.keyboard.press('p'));
  assert.equal(view.width, 900);
  assert.ok(!await page.locator('#panel').isVisible());
});

test('a link brings the same view back, pixel for pixel', async () => {
  await open();
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.focus('#stage');
  await restAfter(() => page.keyboard.press('ArrowRight'));
  await restAfter(() => page.getByRole('textbox', {name: 'Steps each way', exact: true}).fill('40').then(() => page.keyboard.press('Tab')));
  const view = sent.lastView(), pixels = await canvasPixels(page);
  await page.getByRole('button', {name: 'Copy link'}).click();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(link, page.url());
  await page.context().close();
  await open({}, link.slice(link.indexOf('#')));
  const again = sent.lastView();
  assert.deepEqual([again.camera, again.lic, again.shading], [view.camera, view.lic, view.shading]);
  assert.ok((await canvasPixels(page)).rgba.equals(pixels.rgba), 'the pictures differ');
});

async function saved(button) {
  await page.getByRole('button', {name: 'Save', exact: true}).click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(button).click()]);
  return {name: download.suggestedFilename(), content: await readFile(await download.path())};
}

test('the saved scene is the view', async () => {
  await open();
  await page.focus('#stage');
  await restAfter(() => page.keyboard.press('ArrowUp'));
  const {name, content} = await saved('#save-scene'), scene = JSON.parse(content), view = sent.lastView();
  assert.match(name, /^aeolic-\d{8}-\d{6}\.json$/);
  assert.deepEqual(scene.camera, view.camera);
  assert.deepEqual(scene.output, {width: view.width, height: view.height});
  assert.ok(scene.surface.spec.length > 0 && scene.version === 1);
});

test('the saved picture is what the canvas holds', async () => {
  await open();
  const {name, content} = await saved('#save-picture'), png = await pngDecode(new Uint8Array(content)), canvas = await canvasPixels(page);
  assert.match(name, /^aeolic-\d{8}-\d{6}\.png$/);
  assert.deepEqual([png.width, png.height], [canvas.width, canvas.height]);
  assert.ok(canvas.rgba.equals(Buffer.from(pixelsToRgba(png.pixels, png.width, png.height, png.bytesPerPixel))));
});

test('a dark page asks for a dark background, and the switch goes back', async () => {
  await open({colorScheme: 'dark'});
  assert.equal(sent.lastView().shading.background, '11161a');
  const view = await restAfter(() => page.getByRole('button', {name: 'Light colours'}).click());
  assert.deepEqual(view.shading, {});
});

test('statistics tell the size, and whose rows are whose', async () => {
  await open();
  await page.getByRole('button', {name: 'Statistics'}).click();
  const {width, height} = await canvasPixels(page);
  assert.match(await page.locator('#stats').innerText(), new RegExp(`${width} × ${height}, exact`));
  const isWhole = () => page.evaluate((height) => {  // At once: a new frame replaces the stripes.
    const heights = [...document.querySelectorAll('.stripe')].map((stripe) => stripe.getBoundingClientRect().height);
    return heights.length >= 1 && Math.abs(heights.reduce((a, b) => a + b) - height) < 2;
  }, height);
  await until(isWhole, 'stripes as high as the picture');
});

test('the help opens by its key and closes by Escape', async () => {
  await open();
  await page.focus('#stage');
  await page.keyboard.press('?');
  assert.ok(await page.locator('#help').isVisible());
  await page.keyboard.press('Escape');
  assert.ok(!await page.locator('#help').isVisible());
});

test('on a phone the panel is a sheet below a picture that stays in sight', async () => {
  await open({viewport: {width: 390, height: 844}, isMobile: true, hasTouch: true, deviceScaleFactor: 2});
  assert.ok(!await page.locator('#panel').isVisible());
  await restAfter(() => page.getByRole('button', {name: 'Panel', exact: true}).tap());
  const stage = await stageBox(page), panel = await page.locator('#panel').boundingBox();
  assert.ok(stage.height > 200 && panel.y >= stage.y + stage.height - 1 && panel.width === 390);
});

test('the token leaves the address, which keeps its view, and no script can read the cookie', async () => {
  await open({}, '#lic.steps=40');
  assert.ok(!page.url().includes('token'), page.url());
  assert.match(page.url(), /lic\.steps=40/);
  assert.equal(sent.lastView().lic.steps, 40);
  assert.equal(await page.evaluate(() => document.cookie), '');
  const [cookie] = await page.context().cookies(), token = new URL(server.url).searchParams.get('token');
  assert.deepEqual([cookie.httpOnly, cookie.sameSite, cookie.path], [true, 'Strict', '/']);
  assert.notEqual(cookie.value, token);
  await page.reload();
  await waitForState(page, 'ready');
});

test('a wrong token opens nothing and tells nothing', async () => {
  const url = new URL(server.url);
  url.searchParams.set('token', 'wrong');
  for (const path of ['', 'main.js', 'style.css', 'status', 'stream', 'nothing']) {
    const answer = await fetch(new URL(path + url.search, url));
    assert.equal(answer.status, 401, path);
    assert.equal(await answer.text(), '', path);
  }
});

test('an address without the right token opens a page that says what to do', async () => {
  await openEmpty();
  const answer = await page.goto(server.url.replace(/token=.*/, 'token=of-an-earlier-start'));
  assert.equal(answer.status(), 401);
  await page.getByText('Open the whole address that the server printed').waitFor();
  const {background, text} = await page.evaluate(() => {
    const {backgroundColor, color} = getComputedStyle(document.body);
    return {background: backgroundColor, text: color};
  });
  assert.deepEqual([background, text], ['rgb(255, 255, 255)', 'rgb(22, 33, 42)'], 'its style is let in');
});
