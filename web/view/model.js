// What this viewer looks at, and how: the one place that knows camera and options. It sends nothing itself.

import {fitDistance, verticalOf} from './camera.js';
import {Emitter} from '../page/emitter.js';
import {effectiveOptions} from './options.js';
import {overlaysText, readOverlays} from './overlays.js';
import {specsOf, surfacesOf} from './surface_spec.js';
import {add, length, scale, sub} from './vec3.js';
import {bodyOf, isInSight, keptOutside, lensOf} from './zoom.js';

const diagonal = ([lo, hi]) => length(sub(hi, lo));

// Which surfaces a Scene shows.
const shownText = ({scene}) => JSON.stringify(surfacesOf(scene).map(({spec, shown}) => [spec, shown !== false]));

const sameView = (a, b) => ['position', 'focal', 'up'].every((key) => a[key].every((x, i) => x === b[key][i])) && a.fov === b.fov;

// Whether a camera for one surface still makes sense for the other.
function isNear(a, b) {
  const apart = length(sub(scale(add(...a), 0.5), scale(add(...b), 0.5))), sizes = [diagonal(a), diagonal(b)];
  return apart < Math.max(...sizes) && Math.max(...sizes) < 8 * Math.max(Math.min(...sizes), 1e-30);
}

/// So many pictures of a cycle the server draws: eight, between which the trigonometric polynomial is right within a few
/// of 255 also where colours are bent most (docs/decisions/0034-flow-loop.md).
export const FLOW_PICTURES = 8;

/// Events: `scene` (message) when one is loaded; `camera` (isMoving); `options` (isMoving); `through`; `warnings`.
/// isMoving: more may follow.
export class Model extends Emitter {
  scene = null;        // The Scene message.
  camera = null;       // {position, focal, up, fov}; null before the first Scene.
  lensDeg = 30;        // The field of view where no zoom narrows it.
  vertical = [0, 0, 1];
  isHome = true;       // The camera is the scene's own.
  aspect = 1;          // Width / height of the stage.
  changed = {lic: {}, shading: {}};
  screenTextScale = 1;    // What text has to be larger by on this screen: see stage.js.
  pageBackground = null;  // RRGGBB where the scene leaves the background to the page.
  isExactAtRest = false;
  through = null;      // The place [x, y, z] whose streamline is drawn, or null.
  flowStep = 0;        // Which picture of the cycle is wanted, where streaks flow.
  rangeFor = '';       // The array that changed.shading.colorRange was chosen for.
  pictureWarnings = [];  // Lines about the newest own picture at rest.
  allBounds = null;    // The bounds of all surfaces seen so far; slices can be anywhere in them.

  get colorBy() {
    return this.scene?.scene?.shading?.colorBy ?? '';
  }

  /// What the options may be, and their defaults: see options.js. Undefined before the first Scene.
  get rules() {
    return this.scene?.options;
  }

  get options() {
    return effectiveOptions(this.rules, this.scene?.scene, this.changed);
  }

  #isDefaultBackground() {
    return !this.scene || this.#sceneBackground() === this.rules.shading.background.default;
  }

  #sceneBackground() {
    return this.scene?.scene?.shading?.background ?? this.rules?.shading.background.default;
  }

  /// The background a person chose, or the scene's, or the page's.
  get background() {
    const ofPage = this.#isDefaultBackground() ? this.pageBackground : null;
    return this.changed.shading.background ?? ofPage ?? this.#sceneBackground();
  }

  #textScaleHere() {
    const {least, most} = this.rules.shading.textScale;
    return Math.min(most, Math.max(least, this.options.shading.textScale * this.screenTextScale));
  }

  /// The groups of a View, with only those options that differ from the scene's. At rest jumps make way for exact
  /// streamlines where the person wants that.
  viewGroups(isMoving) {
    const shading = {...this.changed.shading}, background = this.background;
    if (background !== this.#sceneBackground()) shading.background = background;
    if (this.screenTextScale !== 1) shading.textScale = this.#textScaleHere();
    if (this.through) shading.overlay = overlaysText({...readOverlays(this.options.shading.overlay), through: this.through});
    const isExact = !isMoving && this.isExactAtRest && this.options.lic.method === 'hierarchical';
    return {camera: this.camera, lic: {...this.changed.lic, ...(isExact ? {method: 'direct'} : {}), ...this.#flowOf(isMoving)}, shading};
  }

  /// Whether streaks flow: those that can, where a person or the scene wants it.
  get flows() {
    const {flow, method} = this.options.lic;
    return flow === 'loop' && method !== 'none';
  }

  // A cycle takes the work of three or four pictures. While something moves one picture shows one phase of it.
  #flowOf(isMoving) {
    const {flow, phase} = this.options.lic;
    if (flow !== 'loop') return {};
    if (!this.flows) return {flow: 'off'};
    if (isMoving) return {flow: 'off', kernel: 'hann'};
    return {flow, phase: Number((phase + 2 * Math.PI * this.flowStep / FLOW_PICTURES).toFixed(6))};
  }

  setFlows(isOn) {
    this.setOption('lic', 'flow', isOn ? 'loop' : 'off');
  }

  setScene(message) {
    const before = this.scene;
    this.scene = message;
    this.through = null;  // The flow there is another one.
    const {bounds} = message;
    this.allBounds = this.allBounds && isNear(this.allBounds, bounds)
      ? [0, 1].map((end) => bounds[end].map((x, i) => [Math.min, Math.max][end](x, this.allBounds[end][i]))) : bounds;
    if (before && this.rangeFor !== this.colorBy) delete this.changed.shading.colorRange;
    if (!this.camera || before && this.#isElsewhere(before)) this.#goHome();
    else if (this.isHome) this.isHome = sameView(this.camera, this.homeCamera());
    this.emit('scene', message);
  }

  // Whether the camera has to go to where the scene is now. It stays where surfaces come and go among others, which one
  // wants to see from where one is.
  #isElsewhere(before) {
    const {scene} = this, isOneOfSeveral = [before, scene].some((one) => specsOf(one.scene).length > 1);
    if (isOneOfSeveral && before.scene?.field?.spec === scene.scene?.field?.spec && shownText(before) !== shownText(scene)) return false;
    return this.isHome || !isNear(before.bounds, scene.bounds);
  }

  setCamera(camera, isMoving) {
    this.camera = camera;
    this.isHome = false;
    this.emit('camera', isMoving);
  }

  /// A move of the camera by a person's hand: a zoom stays outside the body.
  moveCamera(camera) {
    this.setCamera(this.keptOutside(camera), true);
  }

  keptOutside(camera) {
    const kept = keptOutside(camera, this.camera, bodyOf(this.scene), this.lensDeg, this.aspect);
    return kept.fov < this.rules.camera.fov.least ? this.camera : kept;
  }

  /// Whether the camera has anything of the scene before it, hidden or cut out of the field, that is not a mere dot.
  sees(camera) {
    const {choices, bounds} = this.scene, boxes = [bounds, choices?.bounds ?? bounds];
    return boxes.some(([lo, hi]) => isInSight(camera, scale(add(lo, hi), 0.5), diagonal([lo, hi]) / 2, this.aspect));
  }

  /// Takes a view that somebody made: a link's.
  takeCamera(camera) {
    this.lensDeg = lensOf(camera, bodyOf(this.scene), this.#sceneLensDeg, this.aspect);
    this.setCamera(camera, false);
  }

  setLens(fovDeg, isMoving) {
    this.lensDeg = fovDeg;
    this.setCamera({...this.camera, fov: fovDeg}, isMoving);
  }

  get #sceneLensDeg() {
    const {camera} = this.scene.scene ?? {};
    return camera?.position ? this.rules.camera.fov.default : camera?.fov ?? this.rules.camera.fov.default;
  }

  // So many times as far from its focal point as the scene's own view, the eye sees all in a picture of this shape.
  get #farness() {
    const {scene} = this.scene;
    return scene?.camera?.position ? 1 : fitDistance(1, this.#sceneLensDeg, this.aspect);  // Someone chose this very view.
  }

  #viewFrom(farness) {
    const {view} = this.scene;
    if (farness === 1) return view;  // With the very numbers of the scene, the picture is the one of `aeolic render`.
    return {...view, position: add(view.focal, scale(sub(view.position, view.focal), farness))};
  }

  /// The camera that shows the scene as it was meant to be seen first.
  homeCamera() {
    const farness = this.#farness, moved = this.#viewFrom(farness);
    return farness === 1 ? moved : keptOutside(moved, moved, bodyOf(this.scene), this.#sceneLensDeg, this.aspect);
  }

  /// Where the camera is the scene's own: so many times as far from the focal point. Else undefined.
  get farnessFromHome() {
    const farness = this.#farness;
    return this.isHome && sameView(this.camera, this.#viewFrom(farness)) ? farness : undefined;
  }

  home() {
    this.#goHome();
    this.emit('camera', false);
  }

  #goHome() {
    this.camera = this.homeCamera();
    this.lensDeg = lensOf(this.camera, bodyOf(this.scene), this.#sceneLensDeg, this.aspect);
    this.vertical = verticalOf(this.camera);
    this.isHome = true;
  }

  setAspect(aspect) {
    this.aspect = aspect;
    if (this.scene && this.isHome) this.#goHome();
  }

  setOption(group, key, value, isMoving = false) {
    this.changed[group][key] = value;
    if (key === 'colorRange') this.rangeFor = this.colorBy;
    this.emit('options', isMoving);
  }

  /// Goes back to what the scene says.
  resetOption(group, key) {
    delete this.changed[group][key];
    this.emit('options', false);
  }

  setPictureWarnings(warnings) {
    if (warnings.join('\n') === this.pictureWarnings.join('\n')) return;
    this.pictureWarnings = warnings;
    this.emit('warnings');
  }

  /// The streamline through a place is drawn; null: none.
  setThrough(place) {
    if (place === this.through) return;
    this.through = place;
    this.emit('through');
  }

  setExactAtRest(isOn) {
    this.isExactAtRest = isOn;
    this.emit('options', false);
  }

  resetOptions() {
    this.changed = {lic: {}, shading: {}};
    this.isExactAtRest = false;
    this.emit('options', false);
  }
}
