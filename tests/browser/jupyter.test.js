// The first notebook of examples/notebooks in jupyter-notebook itself (Debian: jupyter-notebook). The environment names the
// Python that has the module: AEOLIC_PYTHON, with PYTHONPATH.

import {spawn, spawnSync} from 'node:child_process';
import {cpSync, mkdtempSync, rmSync} from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {createInterface} from 'node:readline';
import {fileURLToPath} from 'node:url';
import {closeBrowser, openPage, until} from './harness.js';

const EXAMPLES = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../examples');
const python = process.env.AEOLIC_PYTHON;
const has = python && spawnSync(python, ['-c', 'import notebook, ipykernel']).status === 0;
const options = {skip: has ? false : 'AEOLIC_PYTHON names no interpreter that has jupyter-notebook'};
const SET = 10, CLOSE = 11, END = 12;  // Cells of body.ipynb: after show(), set() and close().

let folder, jupyter, address;

async function freePort() {
  const server = net.createServer();
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const {port} = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

before(async () => {
  if (!has) return;
  folder = mkdtempSync(path.join(os.tmpdir(), 'aeolic-jupyter-'));
  for (const part of ['notebooks', 'ahmed']) cpSync(path.join(EXAMPLES, part), path.join(folder, part), {recursive: true});
  jupyter = spawn(python, ['-m', 'notebook', '--no-browser', '--allow-root', '--ip=127.0.0.1', `--port=${await freePort()}`],
                  {cwd: folder, stdio: ['ignore', 'ignore', 'pipe'], env: {...process.env, HOME: folder}});
  address = await new Promise((resolve, reject) => {
    jupyter.once('exit', (code) => reject(new Error(`jupyter-notebook ended with ${code}`)));
    createInterface({input: jupyter.stderr}).on('line', (line) => {
      const found = /http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/.exec(line);
      if (found) resolve(found[0]);
    });
  });
});
after(async () => {
  await closeBrowser();
  jupyter?.removeAllListeners('exit').kill();
  if (folder) rmSync(folder, {recursive: true, force: true});
});

test('the live page comes in the cell, is dragged, and shows what a later cell sets', options, async (context) => {
  const page = await openPage(address.replace('/?', '/notebooks/notebooks/body.ipynb?'), {viewport: {width: 1300, height: 1500}});
  await page.waitForFunction(() => window.Jupyter?.notebook?.kernel?.is_connected?.(), null, {timeout: 60000});
  await page.evaluate((end) => window.Jupyter.notebook.execute_cell_range(0, end), SET);
  const frame = page.locator('iframe').last(), root = page.frameLocator('iframe').last().locator('html');
  await frame.waitFor({timeout: 60000});
  const shown = performance.now();
  await frame.scrollIntoViewIfNeeded();
  const number = async () => Number(await root.evaluate((element) => element.dataset.frame ?? 0));
  const isNewer = (than) => async () => await number() > than && await root.evaluate((element) => element.dataset.lossless === 'true');
  await until(isNewer(0), 'the first picture');
  context.diagnostic(`the first picture came ${Math.round(performance.now() - shown)} ms after the cell`);
  const box = await frame.boundingBox(), before = await number();
  await page.mouse.move(box.x + 300, box.y + 250);
  await page.mouse.down();
  for (let i = 0; i < 40; ++i) {
    await page.mouse.move(box.x + 300 + 4 * i, box.y + 250);
    await page.waitForTimeout(20);
  }
  await page.mouse.up();
  await until(isNewer(before + 2), 'pictures while it is dragged');
  await page.waitForTimeout(500);
  const turned = await number();
  await page.evaluate(([from, to]) => window.Jupyter.notebook.execute_cell_range(from, to), [SET, CLOSE]);
  await until(isNewer(turned), 'the picture with the options of a later cell');
  await page.evaluate(([from, to]) => window.Jupyter.notebook.execute_cell_range(from, to), [CLOSE, END]);
  await until(() => root.evaluate((element) => element.dataset.state !== 'ready'), 'the end');
});
