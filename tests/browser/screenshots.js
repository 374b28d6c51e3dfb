// Pictures of the page in every state, at three sizes, light and dark, for people to look at: artefacts/*.png.
//   node screenshots.js [STATE …]

import {mkdir} from 'node:fs/promises';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {closeBrowser, openPage, waitForRest, waitForState} from './harness.js';
import {MockServer} from './mock/server.js';

const OUT = path.join(path.dirname(fileURLToPath(import.meta.url)), 'artefacts');
const SIZES = [[1440, 900], [1024, 768], [390, 844]];

const openPanel = async (page) => {
  if (!await page.locator('#panel').isVisible()) await page.getByRole('button', {name: 'Panel', exact: true}).click();
};
const settle = (page) => page.waitForTimeout(700);

// name -> {before(server), after(page, server)}; `waits` is the state to wait for.
const STATES = {
  ready: {},
  panel: {async after(page) {
    await openPanel(page);
    await settle(page);
  }},
  options: {async after(page) {
    await openPanel(page);
    for (const title of ['Streaks', 'Colour and light', 'Figure']) await page.locator('summary', {hasText: title}).click();
    for (const title of ['Surface', 'View', 'About the scene']) await page.locator('summary', {hasText: title}).click();
    await page.locator('#panel').getByRole('group', {name: 'Add'}).getByRole('button', {name: 'Slice'}).click();
    await settle(page);
  }},
  // Pictures without end: small ones, so that the page and this program, which draws them, have time for anything else.
  animation: {before(server) { server.scaleMoving = 3; }, async after(page) {
    await openPanel(page);
    await page.getByRole('switch', {name: 'Let it flow'}).click();
    await page.getByRole('textbox', {name: 'Steps each way'}).fill('300').then(() => page.keyboard.press('Tab'));
    await settle(page);
  }},
  statistics: {before(server) { server.withTimes = true; }, async after(page) {
    await page.getByRole('button', {name: 'Statistics'}).click();
    await page.focus('#stage');
    for (let i = 0; i < 4; ++i) { await page.keyboard.press('ArrowRight'); await page.waitForTimeout(200); }
    await settle(page);
  }},
  time: {before(server) { server.withTimes = true; }, async after(page) {
    await page.getByRole('slider', {name: 'Time'}).fill('0.4');
    await settle(page);
  }},
  menu: {async after(page) { await page.getByRole('button', {name: 'Save', exact: true}).click(); }},
  help: {async after(page) { await page.getByRole('button', {name: 'Help'}).click(); }},
  notices: {async after(page, server) {
    server.viewers[0].notice('error', 'isosurface:p=9: no such value; expected one from -0.5 to 1.25.', true);
    server.viewers[0].notice('warning', 'Twelve triangles without area were skipped.');
    await page.getByRole('button', {name: 'Copy link'}).click();
    await settle(page);
  }},
  connecting: {before(server) { server.on('viewer', (viewer) => { viewer.sendState = viewer.sendScene = () => {}; viewer.connection.removeAllListeners('message'); }); }, waits: 'connecting'},
  loading: {before(server) { server.state = {...server.state, state: 'loading', what: 'Reading velocity from cavity_1200.vti', fraction: 0.42}; }, waits: 'loading'},
  restarting: {async after(page, server) {
    server.setState({state: 'restarting', message: 'Rank 2 died (signal 9). It starts again in 2 s.'});
    await settle(page);
  }},
  failed: {async after(page, server) {
    server.setState({state: 'failed', message: 'The job ended five times within a minute. Its last words: rank 2 on node 7: out of memory.'});
    await settle(page);
  }},
  lost: {async after(page, server) {
    server.cut();
    server.token = 'x';
    await server.stop();
    await waitForState(page, 'lost');
    await settle(page);
  }},
  denied: {async after(page, server) {
    server.token = 'another';
    server.cut();
    await waitForState(page, 'denied');
    await settle(page);
  }},
  following: {async after(page, server) {
    const other = await openPage(server.url, {viewport: {width: 640, height: 640}});
    await waitForRest(other);
    await page.getByRole('button', {name: '2 viewers'}).click();
    await page.getByRole('menuitemradio', {name: /Viewer 2/}).click();
    await other.focus('#stage');
    await other.keyboard.press('ArrowUp');
    await waitForRest(other, 1);
    await page.bringToFront();
    await settle(page);
    return other;
  }},
};

const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(STATES);
await mkdir(OUT, {recursive: true});
for (const name of wanted)
  for (const [width, height] of SIZES)
    for (const colorScheme of ['light', 'dark']) {
      const {before, after, waits} = STATES[name], server = await new MockServer().start();
      Object.assign(server, {movingCodec: 'lz4', scaleMoving: 1});  // Its JPEG is too coarse to be looked at.
      before?.(server);
      const isPhone = width < 720;
      const page = await openPage(server.url, {viewport: {width, height}, colorScheme, hasTouch: isPhone, isMobile: isPhone, deviceScaleFactor: 1});
      if (waits) await waitForState(page, waits);
      else {
        await waitForState(page, 'ready');
        await waitForRest(page);
      }
      const other = await after?.(page, server);
      if (waits) await settle(page);
      await page.bringToFront();
      await page.screenshot({path: path.join(OUT, `${name}-${width}x${height}-${colorScheme}.png`)});
      if (page.faults.length > 0) console.error(name, page.faults);
      await other?.context().close();
      await page.context().close();
      await server.stop();
    }
await closeBrowser();
console.log(`${wanted.length * SIZES.length * 2} pictures in ${OUT}`);
