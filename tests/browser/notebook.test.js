// Pages in the cells of a notebook: live, from servers in the notebook's own process. The environment names the Python that
// has the module: AEOLIC_PYTHON=/usr/bin/python3, with PYTHONPATH.

import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import http from 'node:http';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {createInterface} from 'node:readline';
import {closeBrowser, openPage, until} from './harness.js';

const python = process.env.AEOLIC_PYTHON, options = {skip: python ? false : 'AEOLIC_PYTHON names no interpreter'};
const KERNEL = path.join(path.dirname(fileURLToPath(import.meta.url)), 'notebook.py');

let kernel, lines, notebook, page, cells;

const tell = (line) => kernel.stdin.write(`${line}\n`);
async function hear() {
  const {value} = await lines.next();
  return JSON.parse(value);
}
async function values() {
  tell('values');
  return hear();
}
const data = (cell, name) => cell.locator('html').evaluate((root, key) => root.dataset[key], name);
const frameOf = async (cell) => Number(await data(cell, 'frame'));
const waitForNewer = (cell, frame, what) => until(async () => await frameOf(cell) > frame && await data(cell, 'lossless') === 'true', what);

before(async () => {
  if (!python) return;
  kernel = spawn(python, [KERNEL], {stdio: ['pipe', 'pipe', 'inherit']});
  lines = createInterface({input: kernel.stdout})[Symbol.asyncIterator]();
  const html = [(await hear()).html, (await hear()).html];
  notebook = http.createServer((request, response) => {
    response.setHeader('Content-Type', 'text/html; charset=utf-8');
    response.end(`<!doctype html><title>Notebook</title><body style="margin:20px">${html.join('<hr>')}</body>`);
  });
  await new Promise((resolve) => notebook.listen(0, '127.0.0.1', resolve));
});
after(async () => {
  await closeBrowser();
  kernel?.kill();
  notebook?.closeAllConnections();
  notebook?.close();
});

// A notebook may be open as localhost or as 127.0.0.1.
for (const host of ['localhost', '127.0.0.1']) test(`cells of a notebook at ${host} show their scenes`, options, async (context) => {
  await page?.context().close();
  page = await openPage(null, {viewport: {width: 1100, height: 1000}});
  const start = performance.now();
  await page.goto(`http://${host}:${notebook.address().port}/`);
  cells = [0, 1].map((i) => page.frameLocator('iframe').nth(i));
  for (const cell of cells) await waitForNewer(cell, 0, 'a picture');
  context.diagnostic(`both had their first picture after ${Math.round(performance.now() - start)} ms`);
});

test('what Python changes is seen', options, async () => {
  let frame = await frameOf(cells[0]);
  tell('set coolwarm 2');
  await waitForNewer(cells[0], frame, 'the picture with other options');
  frame = await frameOf(cells[0]);
  tell('data 2');
  await waitForNewer(cells[0], frame, 'the picture of other data');
});

test('a dragged picture comes fluently', options, async (context) => {
  const box = await page.locator('iframe').first().boundingBox();
  const before = await frameOf(cells[0]), start = performance.now();
  await page.mouse.move(box.x + 200, box.y + 250);
  await page.mouse.down();
  for (let i = 0; i < 100; ++i) {
    await page.mouse.move(box.x + 200 + 3 * i, box.y + 250 + 20 * Math.sin(i / 9));
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  await page.mouse.up();
  const frames = await frameOf(cells[0]) - before, seconds = (performance.now() - start) / 1000;
  context.diagnostic(`${(frames / seconds).toFixed(1)} pictures a second`);
  assert.ok(frames > 5, `${frames} pictures`);
});

test('controls reach Python, and Python is shown on them', options, async () => {
  const cell = cells[0];
  assert.deepEqual(await values(), {speed: 0.5, pause: 0, step: 0});
  assert.ok(await cell.getByText('Solver', {exact: true}).isVisible());
  const speed = cell.getByLabel('speed', {exact: true}).first();
  await speed.fill('1.25');
  await speed.press('Enter');
  await cell.getByRole('switch', {name: 'pause'}).click();
  for (let i = 0; i < 3; ++i) await cell.getByRole('button', {name: 'step'}).click();
  await until(async () => JSON.stringify(await values()) === '{"speed":1.25,"pause":1,"step":3}', 'the values');
  assert.equal(await cells[1].locator('details', {hasText: 'Solver'}).count(), 0);
});

test('a cell whose viewer is closed says so, and the other goes on', options, async () => {
  tell('close 0');
  await until(async () => await data(cells[0], 'state') !== 'ready', 'the end');
  const frame = await frameOf(cells[1]), box = await page.locator('iframe').nth(1).boundingBox();
  await page.mouse.move(box.x + 200, box.y + 150);
  await page.mouse.wheel(0, 200);
  await waitForNewer(cells[1], frame, 'another picture');
});
