// What the picture shows at one place: its values on a card beside it, and the streamline through it in the picture.

import {byId, h, numberText} from './dom.js';
import {icon} from './icons.js';

const BESIDE_PX = 12, EDGE_PX = 8;

const lengthOf = (vector) => Math.hypot(...vector);
const vectorText = (vector) => vector.map((part) => numberText(part)).join(', ');

/// [name, value, more] of each row.
function rowsOf({scalarName, scalar, vectorName, vector, tangential, position}) {
  const rows = [];
  if (scalarName) rows.push([scalarName, scalar === null ? 'none' : numberText(scalar, 5)]);
  rows.push([vectorName || 'Vector', vector ? numberText(lengthOf(vector), 5) : 'none', vector && `(${vectorText(vector)})`]);
  if (vector && lengthOf(vector) > 0) {
    const along = lengthOf(tangential);
    rows.push(['Along surface', numberText(along, 5), `${Math.round(100 * along / lengthOf(vector))} %`]);
  }
  rows.push(['Position', vectorText(position)]);
  return rows;
}

export class Place {
  #session;
  #model;
  #stage;
  #element;
  #card;
  #root = byId('place');
  #asked = null;  // {view, x, y}: the newest question, on the stage.

  /// `element`: the stage's.
  constructor({session, model, stage}, element) {
    this.#session = session;
    this.#model = model;
    this.#stage = stage;
    this.#element = element;
    this.#card = this.#root.querySelector('div');
    session.on('picked', (picked) => this.#show(picked)).on('following', () => this.hide()).on('status', () => session.link !== 'open' && this.hide());
    for (const event of ['camera', 'options', 'scene']) model.on(event, () => this.hide());  // The line stays while one looks around.
    stage.on('resize', () => this.hide());
    // The card is no part of the picture that is turned: its text can be marked and copied.
    this.#root.addEventListener('pointerdown', (event) => event.stopPropagation());
    document.addEventListener('keydown', (event) => event.key === 'Escape' && this.#end());
  }

  /// `at`: {x, y} in the window.
  askAt({x, y}) {
    const box = this.#element.getBoundingClientRect();
    this.#ask(x - box.left, y - box.top);
  }

  askInMiddle() {
    const {cssWidth, cssHeight} = this.#stage.size ?? {};
    if (cssWidth) this.#ask(cssWidth / 2, cssHeight / 2);
  }

  #end() {
    this.hide();
    this.#model.setThrough(null);
  }

  hide() {
    this.#asked = null;
    this.#root.hidden = true;
  }

  #ask(x, y) {
    this.hide();
    const {width, height, cssWidth, cssHeight} = this.#stage.size ?? {};
    if (!width) return;
    const pixel = (css, cssSize, size) => Math.min(size - 1, Math.max(0, Math.floor(css / cssSize * size)));
    const view = this.#session.pick(pixel(x, cssWidth, width), pixel(y, cssHeight, height));
    if (view !== null) this.#asked = {view, x, y};
  }

  #show({view, place}) {
    if (view !== this.#asked?.view) return;
    if (!place) return this.#end();
    this.#model.setThrough(place.vector ? place.position : null);
    const close = h('button', {type: 'button', 'aria-label': 'Close the values'}, icon('close'));
    close.addEventListener('click', () => {
      this.#end();
      this.#element.focus({preventScroll: true});
    });
    const rows = rowsOf(place).flatMap(([name, value, more]) => [h('dt', {}, name), h('dd', {}, value, more ? h('small', {}, ` ${more}`) : null)]);
    this.#card.replaceChildren(h('h2', {}, place.surface.split('/').pop()), h('dl', {}, ...rows), close);
    const {x, y} = this.#asked;
    this.#root.hidden = false;
    Object.assign(this.#root.style, {left: `${x}px`, top: `${y}px`});
    this.#keepInside(x, y);
  }

  // To the right of the place and below, or on its other sides where there is no room.
  #keepInside(x, y) {
    const {offsetWidth, offsetHeight} = this.#card, {clientWidth, clientHeight} = this.#element;
    const beside = (at, size, room) => {
      const after = at + BESIDE_PX, before = at - BESIDE_PX - size;
      const wanted = after + size + EDGE_PX <= room ? after : before;
      return Math.max(EDGE_PX, Math.min(room - EDGE_PX - size, wanted)) - at;
    };
    Object.assign(this.#card.style, {left: `${beside(x, offsetWidth, clientWidth)}px`, top: `${beside(y, offsetHeight, clientHeight)}px`});
  }
}
