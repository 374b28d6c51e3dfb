// What only a server with tricks can show: exact bytes, a slow line, a job that dies, a gateway that goes away.

import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';
import {pixelsToRgba} from '../../web/picture/lz4.js';
import {pngDecode} from '../../web/picture/png.js';
import {canvasPixels, stageBox, until, viewOf, waitForRest, waitForState} from './harness.js';
import {frame, frameEnd, tile} from './mock/messages.js';
import {lastView, open, page, server, startAgain, statusText, viewer} from './mocked.js';

async function savedPicture() {
  await page.getByRole('button', {name: 'Save', exact: true}).click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#save-picture').click()]);
  const png = await pngDecode(new Uint8Array(await readFile(await download.path())));
  return {...png, rgba: Buffer.from(pixelsToRgba(png.pixels, png.width, png.height, png.bytesPerPixel))};
}

const sentRgba = ({pixels, width, height, bytesPerPixel}) => Buffer.from(pixelsToRgba(pixels, width, height, bytesPerPixel));

for (const codec of ['lz4', 'png', 'raw'])
  test(`a picture at rest by ${codec} is the server's bytes, on the screen and in the file`, async () => {
    server.restCodec = codec;
    await open({colorScheme: 'dark'});
    const canvas = await canvasPixels(page), sent = viewer().lastPicture;
    assert.deepEqual([canvas.width, canvas.height], [sent.width, sent.height]);
    assert.ok(canvas.rgba.equals(sentRgba(sent)), 'the canvas differs');
    assert.ok((await savedPicture()).rgba.equals(sentRgba(sent)), 'the file differs');
  });

for (const codec of ['lz4', 'png'])
  test(`a transparent picture by ${codec} keeps its colours under half clear pixels in the file`, async () => {
    server.restCodec = codec;
    await open({}, '#shading.background=transparent');
    await until(() => viewer().lastPicture.bytesPerPixel === 4, 'a transparent picture');
    await waitForRest(page, lastView().view - 1);
    assert.ok((await savedPicture()).rgba.equals(sentRgba(viewer().lastPicture)));
    assert.ok(await page.locator('#stage.transparent').isVisible());
  });

test('a smaller moving picture is shown at full size, a picture saved while moving waits for rest', async () => {
  await open();
  server.drawMs = 60;
  const {x, y, width, height} = await stageBox(page);
  await page.evaluate(() => {  // Looks by itself: soon the picture is at rest.
    const root = document.documentElement, {style} = document.getElementById('picture');
    new MutationObserver(() => {
      if (root.dataset.lossless !== 'false') return;
      window.firstMoving ??= [document.getElementById('picture').width, style.width, style.height, style.left];
    }).observe(root, {attributeFilter: ['data-lossless', 'data-frame']});
  });
  await page.mouse.move(x + 200, y + 200);
  await page.mouse.down();
  let shown = null;  // The server may still pause after its first picture, and then draws the newest view alone.
  for (let i = 0; i < 200 && !shown; ++i) {
    await page.mouse.move(x + 240 + i, y + 210);
    shown = await page.evaluate(() => window.firstMoving ?? null);
  }
  assert.deepEqual(shown, [Math.floor(width / 2), `${width}px`, `${height}px`, '0px']);
  const [download] = await Promise.all([page.waitForEvent('download'), page.evaluate(() => document.getElementById('save-picture').click())]);
  const png = await pngDecode(new Uint8Array(await readFile(await download.path())));
  assert.equal(png.width, width);
  await page.mouse.up();
});

test('Shown follows every picture, and only once it is on the screen', async () => {
  await open();
  await until(() => viewer().shown.includes(viewer().lastPicture.frame), 'Shown of the last picture');
  assert.equal(await page.evaluate(() => Number(document.documentElement.dataset.frame)), viewer().shown.at(-1));
});

test('a slow server never has more than two views to answer, and ends with the newest', async () => {
  await open();
  server.drawMs = 250;
  const {x, y} = await stageBox(page), count = viewer().views.length;
  await page.mouse.move(x + 100, y + 300);
  await page.mouse.down();
  const startMs = performance.now();
  let most = 0;
  server.on('view', (one) => { most = Math.max(most, one.views.filter(({view, moving}) => moving && view > one.lastPicture.view).length); });
  for (let i = 0; i < 40; ++i) {
    await page.mouse.move(x + 100 + 5 * i, y + 300);
    await page.waitForTimeout(25);
  }
  const pictures = (performance.now() - startMs) / server.drawMs;  // Four pictures, or more where the browser is slow.
  await page.mouse.up();
  await until(() => !lastView().moving, 'a view at rest');
  await waitForRest(page, lastView().view - 1);
  const moving = viewer().views.slice(count).filter((view) => view.moving).length;
  assert.ok(moving >= 2 && moving <= 2 * pictures + 2, `${moving} moving views in the time of ${pictures} pictures`);
  assert.ok(most <= 2, `${most} moving views without an answer`);  // A view at rest replaces them.
});

test('a lost connection comes back with the same view', async () => {
  await open({}, '#lic.steps=20');
  await page.focus('#stage');
  await page.keyboard.press('ArrowRight');
  await waitForRest(page, await viewOf(page));
  await until(() => !lastView().moving, 'rest');
  const {camera, lic} = lastView(), {port} = server;
  await server.stop();
  await waitForState(page, 'lost');
  assert.match(await statusText(), /Connection lost.*Trying again/s);
  assert.ok(await page.locator('body.dimmed').isVisible());
  await page.waitForTimeout(1500);
  await startAgain(port);
  await waitForState(page, 'ready');
  await until(() => viewer()?.views.length > 0, 'a view');
  assert.deepEqual([lastView().camera, lastView().lic], [camera, lic]);
  await until(() => viewer().lastPicture && viewer().shown.includes(viewer().lastPicture.frame), 'its picture');
});

test('why the server ended the connection is told until it is there again', async () => {
  await open();
  let attempts = 0;
  page.on('websocket', () => { ++attempts; });
  const {port} = server;
  viewer().connection.close(1008, 'too slow');
  await server.stop();
  await until(() => attempts >= 2, 'two attempts');
  await page.waitForFunction(() => document.getElementById('retry').checkVisibility());
  assert.match(await statusText(), /Connection lost\s+The server ended the connection: too slow\. Trying again/);
  await startAgain(port);
  await waitForState(page, 'ready');
  server.cut();
  await waitForState(page, 'lost');
  assert.doesNotMatch(await statusText(), /too slow/);
});

test('"Try now" does not wait', async () => {
  await open();
  const {port} = server;
  await server.stop();
  await waitForState(page, 'lost');
  await page.waitForTimeout(4000);  // The pauses between attempts have grown by now.
  await startAgain(port);
  await until(async () => {
    await page.getByRole('button', {name: 'Try now'}).click({timeout: 500}).catch(() => {});
    return page.evaluate(() => document.documentElement.dataset.state === 'ready');
  }, 'the connection', 3000);
});

test('a gateway that comes back with another token is told apart from one that is away', async () => {
  await open();
  const {port} = server;
  await server.stop();
  await waitForState(page, 'lost');
  await startAgain(port, {token: 'another'});
  await waitForState(page, 'denied', 20000);
  assert.match(await statusText(), /token/);
});

test('a job that restarts leaves the last picture, dimmed, with a notice, and the view comes back', async () => {
  await open();
  const before = await canvasPixels(page), {camera} = lastView();
  server.setState({state: 'restarting', message: 'Rank 2 died (signal 9). Next try in 2 s.', restarts: 1});
  await waitForState(page, 'restarting');
  assert.match(await statusText(), /Restarting.*Rank 2 died/s);
  assert.ok((await canvasPixels(page)).rgba.equals(before.rgba));
  const count = viewer().views.length;
  server.setState({state: 'ready', message: ''});
  await waitForState(page, 'ready');
  await until(() => viewer().views.length > count, 'a view');
  assert.deepEqual(lastView().camera, camera);
  await waitForRest(page, lastView().view - 1);
  assert.ok(!await page.locator('#status').isVisible());
});

test('what is dragged while the job restarts is drawn when it is back', async () => {
  await open();
  server.setState({state: 'restarting', message: ''});
  await page.focus('#stage');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowLeft');
  await page.waitForTimeout(400);
  server.setState({state: 'ready'});
  await waitForRest(page, lastView().view - 1);
  assert.equal(viewer().lastPicture.view, lastView().view);
});

test('loading shows what is done and how far; failing says why', async () => {
  server.state = {...server.state, state: 'loading', what: 'Reading U', fraction: 0.4};
  await open({}, '', 'loading');
  await page.locator('#status').waitFor();
  assert.match(await statusText(), /Loading.*Reading U/s);
  assert.equal(await page.locator('#progress').evaluate((bar) => bar.value), 0.4);
  server.setState({state: 'failed', message: 'It ended five times within a minute; the last line was: out of memory.'});
  await waitForState(page, 'failed');
  assert.match(await statusText(), /out of memory/);
  server.on('start', () => server.setState({state: 'loading', what: 'starting the renderer', fraction: 0}));
  await page.locator('#start-again').click();
  await waitForState(page, 'loading');
  await page.locator('#start-again').waitFor({state: 'hidden'});
  server.setState({state: 'ready'});
  server.setScene({});
  await waitForState(page, 'ready');
  await waitForRest(page);
});

test('a full server is said to be full', async () => {
  server.on('viewer', ({connection}) => connection.close(1013));
  await open({}, '', null);
  await waitForState(page, 'lost');
  assert.match(await statusText(), /as many viewers as it takes/);
});

function sendBroken(number, {crc, rows = 2}) {
  const {connection, number: viewerNumber} = viewer(), encoded = Buffer.from([0x60, 1, 2, 3, 4, 5, 6]);
  connection.send(frame({frame: number, viewer: viewerNumber, view: 0, width: 1, height: 2, askedWidth: 1, lossless: true}));
  connection.send(tile({frame: number, firstRow: 0, rows, width: 1, rank: 0, codec: 3, bytesPerPixel: 3, encoded, ...(crc === undefined ? {} : {crc})}));
  connection.send(frameEnd(number, {totalMs: 1, stagesMs: {}, ranks: []}));
}

test('a damaged picture is not shown but counts as shown, and is asked for again', async () => {
  await open();
  const before = await canvasPixels(page), count = viewer().views.length, number = server.nextFrame += 10;
  sendBroken(number, {crc: 1});
  await until(() => viewer().shown.includes(number), 'Shown');
  await until(() => viewer().views.length > count, 'another view');
  await waitForRest(page, lastView().view - 1);
  assert.ok((await canvasPixels(page)).rgba.equals(before.rgba));
});

test('a tile that does not fit its picture, and rows that are missing, are refused alike', async () => {
  await open();
  for (const rows of [3, 1]) {
    server.isMute = true;
    const number = server.nextFrame += 10;
    sendBroken(number, {rows});
    await until(() => viewer().shown.includes(number), `Shown with ${rows} rows`);
  }
  assert.notEqual((await canvasPixels(page)).width, 1);
});

test('what is not this protocol ends the connection, and it is made again', async () => {
  await open();
  const first = viewer();
  page.faults.length = 0;
  first.connection.send(Buffer.from('this is not a message'));
  await until(() => server.viewers.length === 1 && viewer() !== first && viewer().views.length > 0, 'another connection');
  await waitForState(page, 'ready');
  assert.equal(page.faults.length, 1);
  assert.match(page.faults.pop(), /magic/);
});
