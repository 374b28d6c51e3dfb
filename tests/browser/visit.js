// One visit to the page for each test of a file that imports this: the server that they all use, and the page that is open.
// It knows nothing of the server but the protocol, so tests run against the mock and against `aeolic serve` (servers.js).

import assert from 'node:assert/strict';
import {after, afterEach, before} from 'node:test';
import {anglesOf} from '../../web/view/camera.js';
import {closeBrowser, openPage, recordSent, stageBox, until, viewOf, waitForRest, waitForState} from './harness.js';
import {startServer} from './servers.js';

export let server, page, sent;
before(async () => { server = await startServer(); });
after(async () => {
  await closeBrowser();
  await server.stop();
});
afterEach(async () => {
  const faults = page?.faults ?? [];
  await page?.context().close();
  page = null;
  assert.deepEqual(faults, [], 'the browser found faults in the page');
});

/// A page without an address yet.
export async function openEmpty(options) {
  page = await openPage(null, options);
}

export async function open(options, fragment = '') {
  await openEmpty(options);
  sent = recordSent(page);
  await page.goto(server.url + fragment);
  await waitForState(page, 'ready');
  await waitForRest(page);
}

export const angles = (camera) => anglesOf(camera, [0, 0, 1]);
export const distance = ({position, focal}) => Math.hypot(...position.map((x, i) => x - focal[i]));

// Does something and returns the View at rest that it led to, once its picture is on screen.
export async function restAfter(action) {
  const before = await viewOf(page);
  await action();
  await waitForRest(page, before);
  await until(() => sent.lastView().moving === false, 'a View at rest');
  await waitForRest(page, sent.lastView().view - 1);
  return sent.lastView();
}

export async function middle() {
  const box = await stageBox(page);
  return [box.x + box.width / 2, box.y + box.height / 2];
}
