// What this viewer wants of the scene that all viewers share, until the server has answered it. One change is on its way;
// of those that wait, the newest wishes count. A change that was asked for and is not answered yet is a wish: controls
// show it, so that they never jump back to the earlier value.

import {Emitter} from '../page/emitter.js';
import {surfacesOf} from '../view/surface_spec.js';

const REST_AFTER_MS = 150;     // As the pacer: after this time without another wish the scene may be drawn at rest.
const REPLACED_AFTER_MS = 250; // A change that is unanswered for so long waits. What is newer takes its place there.

const IN_PARTS = ['cuts', 'steer'];  // Changes of several things, each of which is a wish of its own.

// What a scene has in the place of its surfaces: cuts moved, added or (null) taken away, and the switches.
function surfacesWith(surfaces, cuts, switches, scene) {
  if (cuts.length === 0 && !(switches && scene?.surfaces)) return {};
  const switched = (list) => list.map((one, i) => (switches?.length === list.length ? {...one, shown: switches[i]} : {...one}));
  const all = switched(surfaces);
  for (const [place, spec] of cuts) if (spec !== null) all[place] = {...all[place], spec};
  const left = all.filter((_, i) => !cuts.some(([place, spec]) => spec === null && Number(place) === i));
  const shown = left.length === surfaces.length ? left : switched(left);  // Earlier switches, or those of new surfaces.
  return shown.length === 1 && !scene?.surfaces ? {surface: shown[0]} : {surfaces: shown};
}

/// Events: `changed` when there are other wishes.
export class Changes extends Emitter {
  #send;
  #wishes = new Map();  // name -> {value, number}; number null: not sent yet. Names: surface, …, cuts:PLACE, steer:CONTROL.
  #number = 0;          // Of the change that was sent last.
  #answered = 0;
  #sentMs = new Map();  // number -> when it was sent, of those that are not answered.
  #isMoving = false;
  #isRestDue = false;
  #askedMs = -Infinity;
  #holds = new Set();
  #later = [];          // Requests about surfaces that wait until one has been taken away: places count anew then.
  #restTimer = 0;
  #sendTimer = 0;

  /// send(change) sends the message Change. It returns false where there is no connection.
  constructor(send) {
    super();
    this.#send = send;
  }

  /// Whether something was asked for that is not answered.
  get isBusy() {
    return this.#wishes.size > 0;
  }

  /// For how long the oldest change has been waiting for its answer.
  get waitedMs() {
    const [sentMs] = this.#sentMs.values();
    return this.isBusy && sentMs !== undefined ? performance.now() - sentMs : 0;
  }

  /// What is wanted of `name`, or undefined if that is what the scene shows.
  wish(name) {
    return this.#wishes.get(name)?.value;
  }

  /// What a Scene would be with the wishes: names and switches, no data.
  laidOver(message) {
    if (!message || !this.isBusy) return message;
    const wanted = (name, otherwise) => this.wish(name) ?? otherwise, {scene} = message, switches = this.wish('shown');
    const cuts = Object.entries(this.partsOf('cuts') ?? {});
    return {...message, surface: wanted('surface', message.surface), time: wanted('time', message.time), scene: {
      ...scene, field: {...scene?.field, vectors: wanted('vectors', scene?.field?.vectors)},
      shading: {...scene?.shading, colorBy: wanted('colorBy', scene?.shading?.colorBy)},
      ...surfacesWith(surfacesOf(scene), cuts, switches, scene),
    }};
  }

  /// isMoving: more will follow soon, and pictures may be smaller until then. So it is with wishes in quick succession.
  request(change, isMoving = false) {
    if (this.#isRemoving && ('cuts' in change || 'shown' in change)) {
      this.#later.push([change, isMoving]);
      return;
    }
    const nowMs = performance.now(), wants = Object.entries(change);
    if ('surface' in change)  // Wishes about other surfaces are over.
      for (const name of [...this.#wishes.keys()]) if (name === 'shown' || name.startsWith('cuts:')) this.#wishes.delete(name);
    for (const [name, value] of wants)
      if (IN_PARTS.includes(name)) for (const [part, one] of Object.entries(value)) this.#wishes.set(`${name}:${part}`, {value: one, number: null});
      else this.#wishes.set(name, {value, number: null});
    this.#isMoving = isMoving || nowMs - this.#askedMs < REST_AFTER_MS;
    this.#askedMs = nowMs;
    clearTimeout(this.#restTimer);
    if (this.#isMoving) this.#restTimer = setTimeout(() => this.#rest(), REST_AFTER_MS);
    this.#sendNext();
    this.emit('changed');
  }

  /// An animation goes on by itself: the scene does not rest until release().
  hold(name) {
    this.#holds.add(name);
  }

  release(name) {
    if (this.#holds.delete(name)) this.#rest();
  }

  /// The server has done or refused the changes up to this number.
  answered(number) {
    this.#answered = Math.max(this.#answered, number);
    for (const sent of [...this.#sentMs.keys()]) if (sent <= number) this.#sentMs.delete(sent);
    for (const [name, wish] of [...this.#wishes]) if (wish.number !== null && wish.number <= number) this.#wishes.delete(name);
    if (!this.#isRemoving) for (const [change, isMoving] of this.#later.splice(0)) this.request(change, isMoving);
    this.#sendNext();
    this.emit('changed');
  }

  /// A surface was taken away. Wishes not sent yet meant the places before.
  placesCountAnew() {
    for (const [name, {number}] of [...this.#wishes]) if (number === null && (name === 'shown' || name.startsWith('cuts:'))) this.#wishes.delete(name);
    this.emit('changed');
  }

  /// The server has said that it refuses a change. Wishes for the case that a surface goes may have lost their place.
  refused() {
    this.#later = [];
  }

  /// The connection ended.
  forget() {
    clearTimeout(this.#restTimer);
    clearTimeout(this.#sendTimer);
    this.#wishes.clear();
    this.#later = [];
    this.#sentMs.clear();
    this.#number = this.#answered = 0;
    this.#isMoving = this.#isRestDue = false;
    this.emit('changed');
  }

  get #isRemoving() {
    return [...this.#wishes].some(([name, {value}]) => name.startsWith('cuts:') && value === null);
  }

  /// {PART: value} of wishes such as cuts:PART, or null where there is none.
  partsOf(whole, wishes = [...this.#wishes]) {
    const parts = wishes.filter(([name]) => name.startsWith(`${whole}:`)).map(([name, {value}]) => [name.slice(whole.length + 1), value]);
    return parts.length > 0 ? Object.fromEntries(parts) : null;
  }

  #rest() {
    if (!this.#isMoving || this.#holds.size > 0) return;
    this.#isMoving = false;
    this.#isRestDue = true;
    this.#sendNext();
  }

  #sendNext() {
    clearTimeout(this.#sendTimer);
    const unsent = [...this.#wishes].filter(([, wish]) => wish.number === null);
    if (unsent.length === 0 && !this.#isRestDue) return;
    const waitMs = this.#answered < this.#number && !this.#isRestDue ? REPLACED_AFTER_MS - (performance.now() - this.#sentMs.get(this.#number)) : 0;
    if (waitMs > 0) {
      this.#sendTimer = setTimeout(() => this.#sendNext(), waitMs);
      return;
    }
    const change = {change: ++this.#number, moving: this.#isMoving};
    for (const [name, wish] of unsent) {
      wish.number = this.#number;
      if (!IN_PARTS.some((whole) => name.startsWith(`${whole}:`))) change[name] = wish.value;
    }
    for (const whole of IN_PARTS) {
      const parts = this.partsOf(whole, unsent);
      if (parts) change[whole] = parts;
    }
    this.#isRestDue = false;
    this.#sentMs.set(this.#number, performance.now());
    if (!this.#send(change)) this.forget();
  }
}
