// What only a server with tricks can show: exact bytes, a slow line, a job that dies, a gateway that goes away.

import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {after, afterEach, beforeEach, test} from 'node:test';
import {pixelsToRgba} from '../../web/picture/lz4.js';
import {pngDecode} from '../../web/picture/png.js';
import {canvasPixels, closeBrowser, openPage, stageBox, until, viewOf, waitForRest, waitForState} from './harness.js';
import {frame, frameEnd, tile} from './mock/messages.js';
import {MockServer, TIMES} from './mock/server.js';

let server, page;
const viewer = () => server.viewers[0];
const lastView = () => viewer().views.at(-1);

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

async function open(options, fragment = '', state = 'ready') {
  page = await openPage(server.url + fragment, options);
  await waitForState(page, state);
  if (state === 'ready') await waitForRest(page);
}

const statusText = () => page.locator('#status').innerText();

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
  server = await new MockServer().start(port);
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
  server = await new MockServer().start(port);
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
  server = await new MockServer().start(port);
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
  server = await new MockServer({token: 'another'}).start(port);
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
  page = await openPage(server.url);
  await waitForState(page, 'lost');
  assert.match(await statusText(), /as many viewers as it takes/);
});

const openSurfaces = async () => {
  await open({viewport: {width: 1000, height: 900}});
  await page.locator('#panel').locator('summary', {hasText: 'Surface'}).click();
  return page.locator('#panel');
};
const lastCuts = () => viewer().asked.at(-1)?.cuts;

test('what is shared is asked for by Change, one at a time, and a refusal is shown and taken back', async () => {
  const panel = await openSurfaces();
  await panel.getByLabel('Colour by').selectOption('U:mag');
  await until(() => viewer().asked.at(-1)?.colorBy === 'U:mag', 'a Change');
  for (const [place, [kind, expected]] of [['Slice', 'slice:0,0,0:1,0,0'], ['Isosurface', 'isosurface:p=0.375'], ['Boundary', 'boundary']].entries()) {
    await panel.getByRole('group', {name: 'Add'}).getByRole('button', {name: kind}).click();
    await until(() => lastCuts()?.[place + 1] === expected, `${expected}, found ${JSON.stringify(viewer().asked.at(-1))}`);
    await panel.locator('.surface').nth(place + 1).waitFor();
  }
  assert.equal(await panel.getByRole('switch', {name: 'ball.vtp'}).isChecked(), true, 'the surface stays');
  const position = panel.getByRole('textbox', {name: 'Position'});
  await position.fill('0.5');
  await position.press('Enter');
  await until(() => lastCuts()?.[1] === 'slice:0.5,0,0:1,0,0', 'a slice elsewhere');
  await panel.getByRole('switch', {name: 'Slice x = 0.5'}).waitFor();
  await panel.getByRole('button', {name: 'Take Boundary away'}).click();
  await until(() => lastCuts()?.[3] === null, 'the boundary goes');
  await panel.getByLabel('Vectors').selectOption('wallShearStress');
  await until(() => viewer().asked.at(-1).vectors === 'wallShearStress', 'other vectors');
  server.refuse = () => 'slice:0.7,0,0:1,0,0: it does not meet the field.';
  await position.fill('0.7');
  await position.press('Tab');
  await page.getByText('does not meet the field').waitFor();
  await until(async () => await position.inputValue() === '0.5', 'the position as it was');
});

test('a scene that moves takes a camera at home along without another view, until a person moves it', async () => {
  await open();
  const views = viewer().views.length, before = await canvasPixels(page), {view} = lastView();
  assert.ok(lastView().home > 1, 'the stage is higher than wide');
  server.movedBy = [0.5, 0, 0];
  server.setScene({surface: 'slice:0.5,0,0:1,0,0'});
  await until(() => viewer().lastPicture.frame > 1 && viewer().shown.includes(viewer().lastPicture.frame), 'the picture of it');
  await new Promise((resolve) => setTimeout(resolve, 300));
  assert.equal(viewer().views.length, views);
  assert.equal(await viewOf(page), view);
  assert.ok(!(await canvasPixels(page)).rgba.equals(before.rgba), 'the ball stands elsewhere in its view');
  await page.locator('#stage').press('ArrowLeft');
  await waitForRest(page, view);
  assert.equal(lastView().home, undefined);
  assert.ok(Math.abs(lastView().camera.focal[0] - 0.5) < 1e-9, 'it went along');
});

test('where the camera stays although the scene has another view, no picture from there is shown', async () => {
  await open();
  await page.evaluate(() => {
    window.shownViews = [];
    new MutationObserver(() => window.shownViews.push(document.documentElement.dataset.view)).observe(document.documentElement, {attributeFilter: ['data-frame']});
  });
  const {view, camera} = lastView();
  server.movedBy = [0.5, 0, 0];
  server.setScene({cuts: {1: 'slice:0.5,0,0:1,0,0'}});
  await waitForRest(page, view);
  assert.equal(lastView().home, undefined);
  assert.deepEqual(lastView().camera, camera);
  assert.deepEqual([...new Set(await page.evaluate(() => window.shownViews))], [String(lastView().view)]);
  await until(() => viewer().shown.length === viewer().server.nextFrame, 'Shown of what was not shown, too');
});

for (const viewport of [{width: 1280, height: 800}, {width: 375, height: 740}])
  test(`the cross of axes stands beside a legend in its corner, and goes back: ${viewport.width} pixels wide`, async () => {
    await open({viewport});
    const inCorner = await page.locator('#axes svg').boundingBox(), stage = await stageBox(page);
    const legendOf = (width, height) => [0.02, 0.55, 0.22, 0.43].map((part, i) => Math.round(part * [width, height][i % 2]));
    server.legend = legendOf;
    const first = lastView().view;
    await page.locator('#stage').press('ArrowLeft');
    await waitForRest(page, first);
    const beside = await page.locator('#axes svg').boundingBox(), [x, , width] = legendOf(stage.width, stage.height);
    assert.ok(beside.x >= stage.x + x + width - 1, `${beside.x} beside ${stage.x + x + width}`);
    assert.ok(beside.x + beside.width <= stage.x + stage.width);
    assert.equal(beside.y, inCorner.y);
    server.legend = (width, height) => [0.8 * width, 0.1 * height, 0.15 * width, 0.4 * height];
    const {view} = lastView();
    await page.locator('#stage').press('ArrowLeft');
    await waitForRest(page, view);
    assert.deepEqual(await page.locator('#axes svg').boundingBox(), inCorner);
  });

test('the picture shows by a ring that the keyboard is its', async () => {
  await open();
  await page.locator('#help-button').focus();
  const ring = () => page.evaluate(() => {
    const {content, borderTopWidth, zIndex} = getComputedStyle(document.getElementById('stage'), '::after');
    return content !== 'none' && parseFloat(borderTopWidth) >= 2 && Number(zIndex) > 50;  // Over the picture and the axes.
  });
  assert.equal(await ring(), false);
  for (let i = 0; i < 20 && await page.evaluate(() => document.activeElement.id) !== 'stage'; ++i) await page.keyboard.press('Tab');
  assert.equal(await ring(), true);
});

test('while somebody is followed the page shows no axes, which would be its own', async () => {
  await open();
  const other = await openPage(server.url);
  await waitForRest(other);
  const areAxesHidden = () => page.evaluate(() => document.getElementById('axes').hidden);
  assert.equal(await areAxesHidden(), false);
  await page.getByRole('button', {name: '2 viewers'}).click();
  await page.getByRole('menuitemradio', {name: /Viewer 2/}).click();
  await until(areAxesHidden, 'no axes');
  await page.getByRole('button', {name: 'Own view'}).click();
  await until(async () => !await areAxesHidden(), 'the own axes');
  await other.context().close();
});

test('a slice that the server was started with is the one that the slider moves, along an oblique normal, too', async () => {
  server.given = ['ball.vtp', 'slice:0,0,0.25:0,0,1', 'slice:0.3,0.3,0.1:0.6,0.8,0', 'rod.vtp'];
  const panel = await openSurfaces(), positions = panel.getByRole('textbox', {name: 'Position'});
  assert.deepEqual([await positions.nth(0).inputValue(), await positions.nth(1).inputValue()], ['0.25', '0.42']);
  await positions.nth(0).fill('0.75');
  await positions.nth(0).press('Tab');
  await until(() => lastCuts()?.[1] === 'slice:0,0,0.75:0,0,1', 'the first');
  await positions.nth(1).fill('0.92');
  await positions.nth(1).press('Tab');
  await until(() => lastCuts()?.[2] === 'slice:0.6,0.7,0.1:0.6,0.8,0', `the other, found ${JSON.stringify(lastCuts())}`);
  assert.equal(await panel.getByRole('button', {name: /^Take .* away$/}).count(), 0, 'what it was started with stays');
});

test('hidden surfaces stay hidden beside a new slice, and the link says which', async () => {
  server.given = ['ball.vtp', 'a & b#1=ü.vtp'];
  const panel = await openSurfaces();
  await panel.getByRole('switch', {name: 'a & b#1=ü.vtp'}).click();
  await until(() => viewer().asked.at(-1)?.shown?.join() === 'true,false', 'hidden');
  await panel.getByRole('group', {name: 'Add'}).getByRole('button', {name: 'Slice'}).click();
  await panel.getByRole('switch', {name: 'Slice x = 0'}).waitFor();
  assert.equal(await panel.getByRole('switch', {name: 'a & b#1=ü.vtp'}).isChecked(), false);
  await until(() => page.url().includes('cut.2=slice'), 'the address');
  const link = page.url().split('#')[1];
  server.surfaces = null;
  server.setScene({});
  await until(async () => await panel.getByRole('switch', {name: 'a & b#1=ü.vtp'}).isChecked(), 'all as given');
  await until(() => !page.url().includes('cut.2=slice'), 'its address');
  await page.evaluate((fragment) => { location.hash = fragment; }, link);
  await until(() => viewer().asked.at(-1)?.shown?.join() === 'true,false,true', 'as the link says');
  await panel.getByRole('switch', {name: 'ball.vtp'}).click();
  await panel.getByRole('switch', {name: 'Slice x = 0'}).click();
  await panel.getByText('All surfaces are hidden').waitFor();
  await panel.getByRole('button', {name: 'Show all'}).click();
  await until(() => viewer().asked.at(-1)?.shown?.join() === 'true,true,true', 'all shown');
});

test('an isosurface of an array with an unknown range is asked for once its value is typed', async () => {
  server.withRanges = false;
  const panel = await openSurfaces(), value = panel.getByRole('textbox', {name: 'Value'});
  const asked = () => viewer().asked.map(({cuts}) => cuts?.[1]);
  const addIsosurface = () => panel.getByRole('group', {name: 'Add'}).getByRole('button', {name: 'Isosurface'}).click();
  await addIsosurface();
  await panel.getByText('range of this array is not known').waitFor();
  assert.deepEqual([await value.inputValue(), await panel.getByRole('slider', {name: 'Value'}).count()], ['', 0]);
  await panel.getByLabel('Array').selectOption('k');
  assert.deepEqual(asked(), []);
  await panel.getByRole('button', {name: 'Take Isosurface away'}).click();
  assert.deepEqual([asked(), await value.count()], [[], 0]);
  await addIsosurface();
  server.refuse = () => 'isosurface:p=9: no such value.';
  await value.fill('9');
  await value.press('Tab');
  await page.getByText('no such value').waitFor();
  assert.equal(await value.inputValue(), '9');
  server.refuse = () => null;
  await value.fill('0.5');
  await value.press('Tab');
  await panel.getByRole('switch', {name: 'Isosurface p = 0.5'}).waitFor();
  assert.deepEqual(asked(), ['isosurface:p=9', 'isosurface:p=0.5']);
});

test('a colour range goes out with the view, and ends with its array', async () => {
  await open({viewport: {width: 1000, height: 1200}});
  const lowest = page.getByRole('textbox', {name: 'Lowest'});
  await lowest.fill('-2');
  await lowest.press('Enter');
  await until(() => lastView().shading.colorRange?.[0] === -2, 'the range');
  assert.deepEqual(lastView().shading.colorRange, [-2, 1.25]);
  await page.locator('#panel').getByRole('radiogroup', {name: 'Colour map'}).locator('input[value=coolwarm]').click({force: true});
  await until(() => lastView().shading.colorMap === 'coolwarm', 'the map');
  await page.getByLabel('Colour by').selectOption('U:mag');
  await until(() => lastView().shading.colorRange === undefined, 'the range of the other array');
});

test('what lies outside the range shows in the colours that the server draws it in', async () => {
  const outside = () => Promise.all(['Below', 'Above', 'No number'].map((label) => page.getByLabel(label, {exact: true}).inputValue()));
  await open({viewport: {width: 1000, height: 1200}});
  assert.deepEqual(await outside(), ['#440154', '#fde725', '#999999']);
  await page.locator('#panel').getByRole('radiogroup', {name: 'Colour map'}).locator('input[value=coolwarm]').click({force: true});
  assert.deepEqual(await outside(), ['#3b4cc0', '#b40426', '#999999']);
  await page.getByLabel('Above', {exact: true}).fill('#00ff00');
  assert.deepEqual(await outside(), ['#3b4cc0', '#00ff00', '#999999']);
  await until(() => lastView().shading.aboveColor === '00ff00', 'the colour above');
  await page.getByRole('button', {name: 'Reset Above', exact: true}).click();
  assert.deepEqual(await outside(), ['#3b4cc0', '#b40426', '#999999']);
});

test('no tool is cut off, however narrow the window is beside the panel', async () => {
  server.withTimes = true;
  await open({viewport: {width: 1280, height: 600}});
  const other = await openPage(server.url);  // The button of the viewers is there as well.
  await page.locator('#viewers-button').waitFor();
  for (const width of [1280, 950, 900, 860, 800, 760, 720, 719, 600, 480, 420, 390, 360, 320]) {
    await page.setViewportSize({width, height: 600});
    const cut = await page.evaluate(() => ['header', 'times'].flatMap((id) => {
      const {left, right} = document.getElementById(id).getBoundingClientRect();
      const shown = [...document.querySelectorAll(`#${id} :is(h1, button, input, output, span, select)`)].filter((one) => one.checkVisibility());
      return shown.filter((one) => one.getBoundingClientRect().left < left || one.getBoundingClientRect().right > right).map((one) => one.id || one.tagName);
    }));
    assert.deepEqual(cut, [], `at ${width}`);
  }
  await other.context().close();
});

test('time plays by its pace from step to step, pauses, steps and scrubs', async () => {
  server.withTimes = true;
  await open();
  const asked = () => viewer().asked.map(({time}) => time);
  const startMs = Date.now();
  await page.getByRole('button', {name: 'Play', exact: true}).click();
  await until(() => asked().includes(TIMES[4]), 'four steps');
  const seconds = (Date.now() - startMs) / 1000;
  await page.getByRole('button', {name: 'Pause', exact: true}).click();
  assert.deepEqual(asked().filter((time) => TIMES.includes(time)).slice(0, 4), TIMES.slice(1, 5), 'no step is left out');
  assert.ok(asked().indexOf(TIMES[4]) > 4, 'there are pictures between them');
  assert.ok(seconds > 1, `4 steps in ${seconds} s are more than 3 a second`);
  await until(() => !lastView().moving, 'rest');
  await page.waitForTimeout(300);
  const now = asked().at(-1);
  await page.getByRole('button', {name: 'Next step'}).click();
  await until(() => asked().at(-1) === TIMES.find((time) => time > now), 'the next step');
  await page.waitForTimeout(200);
  await page.getByRole('slider', {name: 'Time'}).fill('0.95');
  await until(() => asked().at(-1) === 0.95, 'the time scrubbed to');
  await page.getByRole('slider', {name: 'Time'}).press('ArrowRight');
  await until(() => asked().at(-1) === 1, 'the last step');
  assert.match(await page.locator('#times').innerText(), /t = 1/);
});

test('following another viewer shows its pictures, and one\'s own move ends it', async () => {
  await open();
  const other = await openPage(server.url, {viewport: {width: 700, height: 500}});
  await waitForRest(other);
  await page.getByRole('button', {name: '2 viewers'}).click();
  await page.getByRole('menuitemradio', {name: /Viewer 2/}).click();
  await page.getByText('Following Viewer 2').waitFor();
  const count = viewer().views.length;
  await other.focus('#stage');
  await other.keyboard.press('ArrowUp');
  await until(async () => {
    const theirs = server.viewers[1].lastPicture;
    return theirs.view > 1 && Number(await page.evaluate(() => document.documentElement.dataset.frame)) === theirs.frame;
  }, 'the other\'s picture');
  assert.equal(viewer().views.length, count);
  await page.keyboard.press('Escape');
  await page.focus('#stage');
  await page.keyboard.press('ArrowUp');
  await until(() => viewer().views.length > count, 'an own view');
  assert.ok(!await page.locator('#following').isVisible());
  await other.context().close();
});

test('a link to another scene changes it at once when alone, and asks when others look on', async () => {
  await open({}, '#surface=boundary');
  await until(() => viewer().asked.at(-1)?.surface === 'boundary', 'the change');
  const other = await openPage(`${server.url}#surface=isosurface:p%3D0.5`);
  await waitForRest(other);
  assert.equal(server.viewers[1].asked.length, 0);
  await other.getByRole('button', {name: 'Change for all'}).click();
  await until(() => server.viewers[1].asked.at(-1)?.surface === 'isosurface:p=0.5', 'the change for all');
  await other.context().close();
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
