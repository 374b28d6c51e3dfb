// The page has no ranges, choices or defaults of its own: what the scene says about its options is what the page keeps
// to. The document is a stand-in, as much of one as the panel's controls use.

import assert from 'node:assert/strict';
import {readFileSync, readdirSync} from 'node:fs';
import {beforeEach, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {Changes} from '../../../web/net/changes.js';
import {parseFragment} from '../../../web/view/link.js';
import {Model} from '../../../web/view/model.js';
import {isAcceptable} from '../../../web/view/options.js';
import {OPTIONS} from '../mock/options.js';
import {textScaleFor} from '../../../web/picture/stage.js';
import {sceneMessage} from '../mock/server.js';

class Element {
  children = [];
  attributes = {};
  listeners = {};
  style = {setProperty() {}};
  classList = {add() {}};
  value = '';
  constructor(tag) { this.tag = tag; }
  setAttribute(name, value) { this.attributes[name] = value; }
  removeAttribute(name) { delete this.attributes[name]; }
  append(...children) {
    for (const child of children) if (child instanceof Element) child.parentElement = this;
    this.children.push(...children);
  }
  replaceChildren(...children) {
    this.children = [];
    this.append(...children);
  }
  addEventListener(name, run) { this.listeners[name] = run; }
  get all() { return [this, ...this.children.flatMap((child) => child instanceof Element ? child.all : [])]; }
  querySelectorAll(tag) { return this.all.filter((one) => one.tag === tag); }
  get text() { return this.children.map((child) => child instanceof Element ? child.text : String(child)).join(''); }
}
globalThis.document = {createElement: (tag) => new Element(tag), createElementNS: (space, tag) => new Element(tag), activeElement: null};
const {streaksPart} = await import('../../../web/panel/streaks.js');
const {colorPart} = await import('../../../web/panel/color.js');
const {figurePart} = await import('../../../web/panel/figure.js');
const {viewPart} = await import('../../../web/panel/view.js');

let model, parts;
const elements = () => parts.flatMap((part) => part.elements);
const row = (label) => elements().find((element) => element.all.some((one) => ['label', 'span'].includes(one.tag) && one.text === label));
const number = (label) => row(label).all.find((one) => one.attributes.class === 'number');

function type(label, text) {
  const box = number(label);
  box.value = text;
  box.listeners.change();
  return box.attributes['aria-invalid'] !== 'true';
}
function slide(label, part) {
  const slider = row(label).all.find((one) => one.attributes.type === 'range');
  slider.value = part;
  slider.listeners.input();
  slider.listeners.change();
}

beforeEach(() => {
  model = new Model();
  model.setAspect(1);
  model.setScene(sceneMessage());
  const page = {model, flowing: {speed: 1}, changes: new Changes(() => true), actions: {}};
  parts = [streaksPart(page), colorPart(page), figurePart(page), viewPart(page)];
  for (const part of parts) part.update();
});

const SLIDERS = [['Steps each way', 'lic', 'steps'], ['Step', 'lic', 'step'], ['Noise', 'lic', 'noiseScale'], ['Phase', 'lic', 'phase'],
                 ['Contrast of streaks', 'shading', 'contrast'], ['Strength of streaks', 'shading', 'blend'], ['Text size', 'shading', 'textScale'], ['Field of view', 'camera', 'fov']];

for (const [label, group, key] of SLIDERS)
  test(`${label}: a slider from end to end of what is usual, and typed numbers up to the ends of the range`, () => {
    const rule = OPTIONS[group][key], value = () => group === 'camera' ? model.camera[key] : model.options[group][key];
    const lowest = rule.least ?? rule.above + 0.001, small = rule.kind === 'whole' ? 1 : 0.001;
    for (const [part, end] of [[0, rule.usual[0]], [1, rule.usual[1]]]) {
      slide(label, part);
      assert.equal(value(), end);
    }
    for (const [text, isFine] of [[rule.most, true], [rule.most + small, false], [lowest, true], [(rule.least ?? rule.above) - small, false], ['', false]]) {
      assert.equal(type(label, String(text)), isFine, `${label} ${text}`);
      if (isFine) assert.equal(value(), text);
    }
    assert.equal(isAcceptable(OPTIONS, group, key, rule.above ?? rule.least), rule.above === undefined, 'the lower end itself');
  });

test('a seed is drawn from what is usual', () => {
  const another = row('Seed').all.find((one) => one.text === 'Another'), seeds = new Set();
  for (let i = 0; i < 300; ++i) {
    another.listeners.click();
    seeds.add(model.options.lic.seed);
  }
  assert.deepEqual([...seeds].sort(), [1, 2, 3, 4, 5, 6, 7, 8, 9]);
  assert.ok(type('Seed', '1000') && !type('Seed', '1001'));
});

test('choices are those of the scene, and another scene may have others', () => {
  const choices = (label) => row(label).all.filter((one) => one.attributes.type === 'radio').map((one) => one.attributes.value);
  assert.deepEqual(choices('Integrator'), ['euler', 'rk2', 'rk4']);
  const message = structuredClone(sceneMessage());
  message.options.lic.integrator.names = ['rk4', 'rk8'];
  message.options.lic.steps.usual = [7, 70];
  model.setScene(message);
  for (const part of parts) part.update();
  assert.deepEqual(choices('Integrator'), ['rk4', 'rk8']);
  slide('Steps each way', 1);
  assert.equal(model.options.lic.steps, 70);
});

test('defaults are those that came with the scene, where the scene itself does not say', () => {
  const message = structuredClone(sceneMessage());
  message.scene = {surface: {spec: 'ball.vtp'}};
  message.options.lic.steps.default = 33;
  message.options.shading.background.default = '112233';
  model.setScene(message);
  assert.equal(model.options.lic.steps, 33);
  assert.equal(model.background, '112233');
  model.pageBackground = '000000';
  assert.equal(model.background, '000000', 'the page\'s own in the place of the default');
});

test('a link is judged by the ranges of the scene', () => {
  const camera = 'position=1,2,3&focal=0,0,0&up=0,0,1&fov=';
  for (const [fragment, isFine] of [['lic.steps=300', true], ['lic.steps=301', false], ['lic.step=0', false], ['lic.noiseScale=0.4', false],
                                    ['shading.contrast=2', true], ['shading.contrast=2.1', false], ['shading.colormap=jet', false]]) {
    const {changed} = parseFragment(fragment, OPTIONS);
    assert.equal(Object.keys({...changed.lic, ...changed.shading}).length, isFine ? 1 : 0, fragment);
  }
  assert.equal(parseFragment(`${camera}90`, OPTIONS).camera.fov, 90);
  for (const fragment of [`${camera}91`, `${camera}9`, camera, 'position=1,2,3&focal=0,0,0&up=0,0,2e9&fov=30', 'position=1,2,&focal=0,0,0&up=0,0,1&fov=30'])
    assert.equal(parseFragment(fragment, OPTIONS).camera, null, fragment);
});

const choose = (label, value) => row(label).all.find((one) => one.attributes.type === 'radio' && one.attributes.value === value).listeners.change();
const box = (label) => row(label).all.find((one) => ['text', 'color', 'checkbox'].includes(one.attributes.type));

test('scales: bands are as many as the scene takes, and a logarithm begins above 0', () => {
  choose('Scale', 'bands');
  assert.equal(model.options.shading.colorScale, 'bands:10');
  for (const part of parts) part.update();
  const count = box('Scale');
  for (const [text, isFine] of [['16', true], ['17', false], ['1', false], ['x', false], ['', false]]) {
    count.value = text;
    count.listeners.change();
    assert.equal(count.attributes['aria-invalid'], String(!isFine), text);
  }
  assert.equal(model.options.shading.colorScale, 'bands:16');
  model.setOption('shading', 'colorRange', [-0.5, 1]);
  choose('Scale', 'log');
  assert.equal(model.changed.shading.colorRange, undefined, 'a range from below 0 has no logarithm');
  for (const part of parts) part.update();
  assert.equal(number('Lowest').value, '0.00125', 'a thousandth of the highest value');
  assert.ok(type('Highest', '1') && !type('Lowest', '0') && type('Lowest', '0.5'));
  assert.deepEqual(model.options.shading.colorRange, [0.5, 1]);
});

test('texts, colours and switches of the figure', () => {
  for (const [label, key, value] of [['Title', 'title', 'Größe <b>'], ['Legend', 'legend', 'p [Pa]']]) {
    box(label).value = value;
    box(label).listeners.change();
    assert.equal(model.options.shading[key], value);
  }
  box('Below').value = '#0000ff';
  box('Below').listeners.change();
  assert.equal(model.options.shading.belowColor, '0000ff');
  box('Axes').checked = true;
  box('Axes').listeners.change();
  assert.equal(model.options.shading.axes, true);
  assert.ok(type('None below', '2') && !type('None below', '-1'));
  assert.equal(model.options.lic.maskBelow, 2);
});

test('a phone with three pixels for each of the page\'s asks for text as large as where there is one', () => {
  const stage = (width, height, ratio) => ({width: width * ratio, height: height * ratio, cssWidth: width, cssHeight: height});
  // What the renderer does, as it says itself: the page has it as well.
  const panel = readFileSync(new URL('../../../src/render/overlay/text_size.cpp', import.meta.url), 'utf8');
  const [, least, base, perPx] = panel.match(/double textSize\(.*\)\n{\n +return std::max\(([\d.]+), ([\d.]+) \+ ([\d.]+) \* std::min\(width, height\)\);\n}/)
    ?.map(Number) ?? assert.fail('textSize() in text_size.cpp is another formula: so must be that in web/picture/stage.js, and this');
  const textPx = ({width, height}) => Math.max(least, base + perPx * Math.min(width, height));
  for (const [width, height, ratio] of [[390, 700, 3], [390, 700, 2], [1000, 800, 2], [1280, 720, 1.5]]) {
    const onPage = textScaleFor(stage(width, height, ratio)) * textPx(stage(width, height, ratio)) / ratio;
    assert.ok(Math.abs(onPage - textPx({width, height})) < 0.1, `${width}x${height} at ${ratio}: ${onPage} px`);
  }
  assert.equal(textScaleFor(stage(1000, 800, 1)), 1);
  assert.equal(textScaleFor({width: 2048, height: 1024, cssWidth: 4096, cssHeight: 2048}), 1, 'a picture that is stretched');
});

test('the size of text that is sent is the chosen one times the screen\'s, within the range', () => {
  assert.equal(model.viewGroups(false).shading.textScale, undefined, 'the scene\'s own');
  model.screenTextScale = 1.5;
  assert.equal(model.viewGroups(false).shading.textScale, 1.5);
  assert.equal(model.viewGroups(true).shading.textScale, 1.5, 'it does not change while the picture moves');
  model.setOption('shading', 'textScale', 1.2);
  assert.ok(Math.abs(model.viewGroups(false).shading.textScale - 1.8) < 1e-9);
  model.setOption('shading', 'textScale', OPTIONS.shading.textScale.most);
  assert.equal(model.viewGroups(false).shading.textScale, OPTIONS.shading.textScale.most);
  assert.equal(model.options.shading.textScale, OPTIONS.shading.textScale.most, 'the panel and links have the chosen one');
});

test('a link with such options is judged, too', () => {
  for (const [fragment, isFine] of [['shading.colorScale=bands:4', true], ['shading.colorScale=bands:40', false], ['shading.nanColor=ff00ff', true],
                                    ['shading.nanColor=transparent', false], ['shading.title=A%20title', true], ['shading.title=two%0Alines', false],
                                    ['shading.colormap=vik', true], ['shading.colormap=%2Fetc%2Fmap.json', false], ['lic.maskBelow=-1', false]]) {
    const {changed} = parseFragment(fragment, OPTIONS);
    assert.equal(Object.keys({...changed.lic, ...changed.shading}).length, isFine ? 1 : 0, fragment);
  }
});

// What no test above presses: no file of the panel gives a control numbers for an option.
test('no row of the panel has ends of its own but the speed of the animation', () => {
  const folder = fileURLToPath(new URL('../../../web/panel/', import.meta.url));
  for (const file of readdirSync(folder).filter((name) => name.endsWith('.js') && name !== 'controls.js'))
    for (const line of readFileSync(folder + file, 'utf8').split('\n'))
      if (/\b(min|max|least|most)\b\s*[:=]\s*-?[\d.]/.test(line) && !line.includes("label: 'Speed'") && !/label: '(Position|Value|Spacing)'/.test(line))
        assert.fail(`${file}: ${line.trim()}`);
});
