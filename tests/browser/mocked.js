// A page that looks at the mock server: one of each for every test, which ends with whatever the page got wrong.

import assert from 'node:assert/strict';
import {after, afterEach, beforeEach} from 'node:test';
import {closeBrowser, openPage, waitForRest, waitForState} from './harness.js';
import {MockServer} from './mock/server.js';

export let server, page;
export const viewer = () => server.viewers[0];
export const lastView = () => viewer().views.at(-1);
export const statusText = () => page.locator('#status').innerText();

beforeEach(async () => { server = await new MockServer().start(); });
after(closeBrowser);
afterEach(async () => {
  const faults = page?.faults ?? [], broken = server.viewers.flatMap((one) => one.faults);
  await page?.context().close();
  page = null;
  await server.stop();
  assert.deepEqual(faults, [], 'the browser found faults in the page');
  assert.deepEqual(broken, [], 'the page broke the protocol');
});

/** Opens the page. `state`: the one to wait for; null: none. */
export async function open(options, fragment = '', state = 'ready') {
  page = await openPage(server.url + fragment, options);
  if (state) await waitForState(page, state);
  if (state === 'ready') await waitForRest(page);
}

/** Another server takes the place of the one that was stopped. */
export async function startAgain(port, options) {
  server = await new MockServer(options).start(port);
}
