// Puts the page together.

import {makeAxes} from './view/axes.js';
import {axisView} from './view/camera.js';
import {byId, h} from './page/dom.js';
import {Flowing} from './view/flowing.js';
import {Frames} from './picture/frames.js';
import {glide} from './view/glide.js';
import {setIcon} from './page/icons.js';
import {HELP, POINTER_HELP, watchKeys} from './view/keys.js';
import {differenceTo, fragmentOf, missingIn, parseFragment} from './view/link.js';
import {Model} from './view/model.js';
import {Overlay} from './page/overlay.js';
import {Place} from './page/place.js';
import {makePanel} from './panel/panel.js';
import {watchPointers} from './view/pointers.js';
import {savePicture, saveScene} from './picture/save.js';
import {Session} from './net/session.js';
import {Stage, textScaleFor} from './picture/stage.js';
import {Status} from './page/status.js';
import {namesOf, specsOf} from './view/surface_spec.js';
import {watchTheme} from './page/theme.js';
import {Times} from './page/times.js';
import {toast} from './page/toast.js';
import {Viewers} from './page/viewers.js';

for (const element of document.querySelectorAll('[data-icon]')) setIcon(element, element.dataset.icon);

const stageElement = byId('stage'), root = document.documentElement;
const model = new Model(), frames = new Frames(byId('picture')), stage = new Stage(stageElement, byId('picture'));
// The server sends a browser on to the address without the token. Where it cannot, the page takes it away.
if (location.search) history.replaceState(null, '', location.pathname + location.hash);
const session = new Session({model, frames, stage});
const page = {model, frames, stage, session, changes: session.changes, tell: (message) => toast(message, 'warning')};
page.flowing = new Flowing(page, byId('flowing'));
page.times = new Times(page);

let picture = null;        // The frame on screen.
let isPictureWanted = false;  // Save it as soon as it is exact.
let linked = location.hash;  // The fragment of a link that was opened and is not looked at yet, or null.

// ---- What the buttons and the keys do

const fly = (target, onArrival) => model.camera && glide(model, target, onArrival);

async function copyLink() {
  const url = `${location.href.split('#')[0]}#${fragmentOf(model)}`;
  history.replaceState(null, '', url);
  try {
    await navigator.clipboard.writeText(url);
    toast('Link copied. It opens in browsers that have opened the address with the token.');
  } catch {
    toast('The link is in the address bar; this browser does not let a page copy it.', 'warning');
  }
}

function wantPicture() {
  if (picture?.pixels) return savePicture(picture);
  isPictureWanted = true;
  page.times.play(false);
  session.pacer.settle();
  toast('The picture is saved when its last pixels are here.');
}

function toggleFullscreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else root.requestFullscreen?.().catch(() => toast('This browser does not show the page on the full screen.', 'warning'));
}

const actions = page.actions = {
  home: () => model.scene && fly(model.homeCamera(), () => model.home()),
  axis: (name) => model.camera && fly(model.keptOutside(axisView(name, model.camera, model.vertical)), (camera) => model.setCamera(camera, false)),
  play: () => page.times.isThere ? page.times.play(!page.times.isPlaying) : page.flowing.run(!page.flowing.isRunning),
  stats: () => overlay.toggle(),
  panel: () => panel.toggle(),
  fullscreen: toggleFullscreen,
  copyLink,
  help: () => byId('help').showModal(),
  tell: () => place.askInMiddle(),
};

const overlay = new Overlay(frames), panel = makePanel(page);
new Status(session, frames);
new Viewers(session);
watchKeys(stageElement, model, actions);
const place = new Place(page, stageElement);
watchPointers(stageElement, model, {onEnd: () => session.pacer.settle(), onClick: (at) => place.askAt(at)});
const {update: updateAxes, keepClearOf: keepAxesClearOf} = makeAxes(byId('axes'), model, actions.axis, () => session.following === 0);
session.on('following', updateAxes);

const buttons = {'home-button': actions.home, 'link-button': copyLink, 'fullscreen-button': toggleFullscreen, 'help-button': actions.help,
                 'save-picture': wantPicture, 'save-scene': () => model.scene && saveScene(model, stage.size)};
for (const [id, run] of Object.entries(buttons))
  byId(id).addEventListener('click', () => {
    byId('save-menu').hidePopover();
    run();
  });
byId('help-close').addEventListener('click', () => byId('help').close());
byId('help-keys').append(...HELP.flatMap(([keys, what]) => [h('dt', {}, ...keys.map((key) => h('kbd', {}, key))), h('dd', {}, what)]));
byId('help-pointers').append(...POINTER_HELP.flatMap(([gesture, what]) => [h('dt', {}, gesture), h('dd', {}, what)]));

// ---- What happens

function applyLink() {
  const {camera, changed, shared} = parseFragment(linked, model.rules);
  linked = null;
  if (camera && model.sees(camera)) model.takeCamera(camera);
  else if (camera) toast('The link looks where this scene has nothing. It stays as it was.', 'warning');
  model.changed = changed;
  model.rangeFor = shared.colorBy ?? model.colorBy;
  model.emit('options', false);
  const change = differenceTo(model.scene, shared), missing = missingIn(model.scene, shared), others = (session.state?.viewers?.length ?? 1) > 1;
  if (missing.length > 0) toast(`The link is of another scene: this one has no ${missing.join(' and no ')}.`, 'warning');
  if (!change) return;
  if (others) toast('The link shows another scene. Others are looking, too.', 'info', {label: 'Change for all', run: () => session.changes.request(change)});
  else session.changes.request(change);
}

const toldWarnings = new Set();  // Every change of the scene, and every picture, brings all of them again.

function tellOnce(warnings) {
  for (const warning of warnings) {
    if (!toldWarnings.has(warning)) toast(warning, 'info');
    toldWarnings.add(warning);
  }
}

function keepInAddress() {
  const fragment = `#${fragmentOf(model)}`;
  if (location.hash !== fragment) history.replaceState(null, '', fragment);  // Browsers refuse it where it comes too often.
}

watchTheme((stageColor) => {
  model.pageBackground = stageColor;
  if (model.scene && session.following === 0) model.emit('options', false);
});
stage.on('resize', () => {
  model.setAspect(stage.size.width / stage.size.height);
  model.screenTextScale = textScaleFor(stage.size);
  updateAxes();
  if (session.following === 0) session.pacer.settle();
});
model.on('warnings', () => tellOnce(model.pictureWarnings)).on('camera', updateAxes).on('options', updateAxes).on('scene', (message) => {
  updateAxes();
  const names = namesOf(specsOf(message.scene));
  document.title = `Aeolic: ${names.join(', ')}`.replace(/: $/, '');
  byId('scene-name').textContent = [...names, message.scene?.field?.vectors].filter(Boolean).join(' · ');
  tellOnce(message.warnings ?? []);
  if (linked !== null) applyLink();
});
frames.on('drawn', (frame) => {
  stage.place(frame, session.askedSize(frame));
  keepAxesClearOf(frame.stats.legend ? stage.placeOf(frame.stats.legend) : null);
  stageElement.classList.toggle('transparent', model.background === 'transparent');
}).on('shown', (frame) => {
  picture = frame;
  if (frame.lossless && session.askedSize(frame)) {
    model.setPictureWarnings(frame.stats.warnings ?? []);
    keepInAddress();  // What is shared may have changed since the view was sent.
  }
  Object.assign(root.dataset, {frame: frame.frame, view: frame.view, lossless: frame.lossless});
  if (frame.lossless && isPictureWanted && frame.pixels) {
    isPictureWanted = false;
    savePicture(frame);
  }
});
session.on('sent', (isMoving) => !isMoving && keepInAddress())
  .on('notice', ({level, message, change}) => {
    toast(message, level);
    if (change) page.times.play(false);
  });
window.addEventListener('hashchange', ({newURL}) => {
  linked = new URL(newURL).hash;  // A picture that came meanwhile may have put its own into the address.
  if (model.scene) applyLink();
});
document.addEventListener('fullscreenchange', () => byId('fullscreen-button').setAttribute('aria-pressed', String(document.fullscreenElement !== null)));

session.start();
