// What the page makes of a scene: its surfaces, cameras, colours, moments, and who else looks at it.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {canvasPixels, openPage, stageBox, until, viewOf, waitForRest} from './harness.js';
import {TIMES} from './mock/server.js';
import {lastView, open, page, server, viewer} from './mocked.js';

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
  await until(() => lastView().shading.colormap === 'coolwarm', 'the map');
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
