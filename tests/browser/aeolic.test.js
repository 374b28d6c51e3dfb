// What only the real program can show. The environment names it: AEOLIC=path/to/aeolic.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import {after, afterEach, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {pixelsToRgba} from '../../web/picture/lz4.js';
import {pngDecode} from '../../web/picture/png.js';
import {canvasPixels, closeBrowser, openPage, recordSent, stageBox, until, viewOf, waitForRest, waitForState} from './harness.js';
import {startAeolic} from './servers.js';

const program = process.env.AEOLIC, options = {skip: program ? false : 'AEOLIC names no program'};
const AHMED = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../examples/ahmed');
const SCENE = ['--surface', path.join(AHMED, 'ahmed.vtp'), '--vectors', 'wallShearStress', '--color-by', 'p'];

let server, page, sent, folder;
before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'aeolic-page-'));
  if (program) server = await startAeolic(program, SCENE);
});
after(async () => {
  await closeBrowser();
  await server?.stop();
  await rm(folder, {recursive: true});
});
afterEach(async () => {
  const faults = page?.faults ?? [];
  await page?.context().close();
  page = null;
  assert.deepEqual(faults, []);
});

async function open(fragment = '', pageOptions = {}) {
  page = await openPage(null, pageOptions);
  sent = recordSent(page);
  await page.goto(server.url + fragment);
  await waitForState(page, 'ready');
  await waitForRest(page);
}

async function savedScene() {
  await page.getByRole('button', {name: 'Save', exact: true}).click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#save-scene').click()]);
  return readFile(await download.path());
}

async function rendered(scene) {
  const [from, to] = [path.join(folder, 'scene.json'), path.join(folder, 'picture.png')];
  await writeFile(from, scene);
  execFileSync(program, ['render', from, '-o', to], {stdio: ['ignore', 'ignore', 'inherit']});
  const png = await pngDecode(new Uint8Array(await readFile(to)));
  return {...png, rgba: Buffer.from(pixelsToRgba(png.pixels, png.width, png.height, png.bytesPerPixel))};
}

for (const [name, fragment, pageOptions] of [
  ['as it opens', ''],
  ['turned, with other options, on a dark page', '#position=2.15,-1.1,0.95&focal=0.72,0,0.15&up=0,0,1&fov=25&lic.steps=60&lic.kernel=hann&lic.phase=1&shading.colormap=coolwarm', {colorScheme: 'dark'}],
  ['on a phone', '', {viewport: {width: 390, height: 700}}],
]) test(`the picture ${name} is what aeolic render draws of the saved scene, byte for byte`, options, async () => {
  await open(fragment, pageOptions);
  const canvas = await canvasPixels(page), png = await rendered(await savedScene());
  assert.deepEqual([png.width, png.height], [canvas.width, canvas.height]);
  assert.ok(png.rgba.equals(canvas.rgba), 'the pixels differ');
});

test('a dragged picture comes fluently', options, async (context) => {
  await open('', {viewport: {width: 1128, height: 848}});
  await page.evaluate(() => {
    window.shownMs = [];
    new MutationObserver(() => window.shownMs.push(performance.now())).observe(document.documentElement, {attributeFilter: ['data-frame']});
  });
  const {x, y} = await stageBox(page);
  await page.mouse.move(x + 300, y + 400);
  await page.mouse.down();
  for (let i = 0; i < 120; ++i) {
    await page.mouse.move(x + 300 + 2 * i, y + 400 + 30 * Math.sin(i / 10));
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
  const shownMs = await page.evaluate(() => window.shownMs), seconds = (shownMs.at(-1) - shownMs[0]) / 1000;
  context.diagnostic(`${(shownMs.length / seconds).toFixed(1)} pictures a second at 800 x 800`);
  assert.ok(shownMs.length / seconds > 5, `${shownMs.length} pictures in ${seconds} s`);  // Machines differ, but a slide show is a fault on every one.
});

test('a job that is killed while something is dragged comes back with the view', options, async () => {
  await open();
  const statusUrl = new URL(server.url);
  statusUrl.pathname = '/status';
  const status = async () => (await fetch(statusUrl)).json(), {x, y} = await stageBox(page), {restarts} = await status();
  await page.mouse.move(x + 200, y + 300);
  await page.mouse.down();
  for (let i = 0; i < 30; ++i) {
    await page.mouse.move(x + 200 + 4 * i, y + 300);
    await page.waitForTimeout(20);
    if (i === 15) process.kill((await status()).pids[0], 'SIGKILL');
  }
  await page.mouse.up();
  await until(async () => (await status()).restarts === restarts + 1, 'the restart');
  await waitForState(page, 'ready');
  await until(() => sent.lastView().moving === false, 'rest');
  await waitForRest(page, sent.lastView().view - 1);
  const png = await rendered(await savedScene()), canvas = await canvasPixels(page);
  assert.deepEqual(JSON.parse(await savedScene()).camera, sent.lastView().camera);
  assert.ok(png.rgba.equals(canvas.rgba), 'the pixels differ');
});

test('another array to colour by is drawn, and a surface that is not there is refused in words', options, async () => {
  await open();
  const before = await canvasPixels(page);
  await page.getByLabel('Colour by').selectOption('');
  await until(() => sent.changes().at(-1)?.colorBy === '', 'the change');
  // The view stays, so pictures of the changed scene have its number.
  await until(async () => !before.rgba.equals((await canvasPixels(page)).rgba), 'another picture');
  await page.getByLabel('Colour by').selectOption('p');
  await until(async () => before.rgba.equals((await canvasPixels(page)).rgba), 'the first picture');
  await page.context().close();
  page = await openPage(`${server.url}#surface=isosurface:nothing%3D1`);
  await waitForState(page, 'ready');
  await page.locator('.toast.error').waitFor();
});

// A browser does not send a cookie of SameSite=Strict after a redirect that a page of another site has led to.
test('a link on a page of another site opens the server', options, async () => {
  const other = http.createServer((_, response) => response.setHeader('Content-Type', 'text/html').end(`<a href="${server.url}#lic.steps=40">look</a>`));
  await new Promise((resolve) => other.listen(0, 'localhost', resolve));
  try {
    page = await openPage(`http://localhost:${other.address().port}/`);
    await page.getByText('look').click();
    await waitForState(page, 'ready');
    assert.match(page.url(), /^http:\/\/127\.0\.0\.1:\d+\/#.*lic\.steps=40/);
    await page.reload();
    await waitForState(page, 'ready');
  } finally {
    other.closeAllConnections();
    other.close();
  }
});

test('several surfaces have a switch each, and what is shown is what aeolic render draws of the saved scene', options, async () => {
  const several = await startAeolic(program, ['--surface', 'teapot', '--surface', 'wave', '--field', 'abc', '--context', 'torus']);
  try {
    page = await openPage(several.url);
    sent = recordSent(page);
    await page.reload();
    await waitForState(page, 'ready');
    await waitForRest(page);
    await page.locator('summary', {hasText: /^Surface$/}).click();
    const all = await canvasPixels(page), torus = page.getByRole('switch', {name: 'torus'});
    assert.equal(await torus.isChecked(), true);
    await torus.click();
    await until(() => sent.changes().at(-1)?.shown?.join() === 'true,true,false', 'the change');
    await until(async () => !all.rgba.equals((await canvasPixels(page)).rgba), 'another picture');
    await waitForRest(page, (await viewOf(page)) - 1);
    const png = await rendered(await savedScene()), canvas = await canvasPixels(page);
    assert.ok(png.rgba.equals(canvas.rgba), 'the pixels differ');
    await page.getByRole('switch', {name: 'torus'}).click();
    await until(async () => all.rgba.equals((await canvasPixels(page)).rgba), 'the first picture');
  } finally {
    await several.stop();
  }
});
