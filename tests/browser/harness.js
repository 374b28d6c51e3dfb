// Chromium for the tests: one browser, a fresh page (with a profile of its own) each time, and helpers to look at it.

import {existsSync} from 'node:fs';
import {chromium} from 'playwright-core';
import {parseFromViewer} from './mock/messages.js';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const ARGUMENTS = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
                   '--disable-component-update', '--disable-sync'];

let browser = null;

export async function openPage(url, options = {}) {
  if (!existsSync(CHROMIUM)) throw new Error(`no ${CHROMIUM}`);
  browser ??= await chromium.launch({executablePath: CHROMIUM, headless: true, args: ARGUMENTS});
  const context = await browser.newContext({viewport: {width: 900, height: 640}, ...options});
  const page = await context.newPage();
  page.faults = [];
  page.on('console', (message) => {
    // A refused or lost connection is written to the console by the browser itself.
    if (message.type() === 'error' && !/WebSocket connection|Failed to load resource|ERR_CONNECTION/.test(message.text())) page.faults.push(message.text());
  });
  page.on('pageerror', (error) => page.faults.push(String(error.stack ?? error)));
  if (url) await page.goto(url);
  return page;
}

export async function closeBrowser() {
  await browser?.close();
  browser = null;
}

/// Waits until the page is in `state` (see web/page/status.js).
export const waitForState = (page, state, timeout = 60000) =>
  page.waitForFunction((wanted) => document.documentElement.dataset.state === wanted, state, {timeout});

/// Waits for a picture at rest, newer than view `after`, and returns its view's number.
export async function waitForRest(page, after = 0, timeout = 60000) {
  await page.waitForFunction((view) => {
    const {dataset} = document.documentElement;
    return dataset.lossless === 'true' && Number(dataset.view) > view;
  }, after, {timeout});
  return viewOf(page);
}

export const viewOf = (page) => page.evaluate(() => Number(document.documentElement.dataset.view ?? 0));

/// What the canvas holds: {width, height, rgba}.
export async function canvasPixels(page) {
  const {width, height, text} = await page.evaluate(() => {
    const canvas = document.getElementById('picture'), {width, height} = canvas;
    const {data} = canvas.getContext('2d').getImageData(0, 0, width, height);
    let text = '';
    for (let i = 0; i < data.length; i += 32768) text += String.fromCharCode(...data.subarray(i, i + 32768));
    return {width, height, text: btoa(text)};
  });
  return {width, height, rgba: Buffer.from(text, 'base64')};
}

export const stageBox = (page) => page.locator('#stage').boundingBox();

export async function until(isTrue, what, timeoutMs = 30000) {
  for (const end = Date.now() + timeoutMs; Date.now() < end;) {
    if (await isTrue()) return;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  throw new Error(`in vain waited for: ${what}`);
}

/// Everything the page sends on its WebSocket from now on: [{type, json or number}]. Call before page.goto.
export function recordSent(page) {
  const sent = [];
  page.on('websocket', (socket) => socket.on('framesent', ({payload}) => sent.push(parseFromViewer(Buffer.from(payload)))));
  sent.views = () => sent.filter(({type}) => type === 2).map(({json}) => json);
  sent.changes = () => sent.filter(({type}) => type === 4).map(({json}) => json);
  sent.lastView = () => sent.views().at(-1);
  return sent;
}
