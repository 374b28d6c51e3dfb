// The place that the picture fills: its size in device pixels, and where a frame stands on the screen.

import {Emitter} from '../page/emitter.js';

const QUIET_MS = 120;  // A window that is being dragged asks for one picture, not for sixty a second.
const MOST_PIXELS = 3840 * 2160;

// As src/render/overlay/text_size.cpp has it: the size of text in a picture, by its shorter side.
const usualTextPx = (side) => Math.max(10, 5 + 0.0125 * side);

/// How much larger than usual text has to be in a picture of `size`, so that on the page it is as large as where a pixel
/// of the picture is one of the page's. `size`: the stage's.
export function textScaleFor({width, height, cssWidth, cssHeight}) {
  const wantedPx = width / cssWidth * usualTextPx(Math.min(cssWidth, cssHeight));
  return Math.max(1, Number((wantedPx / usualTextPx(Math.min(width, height))).toFixed(2)));
}

/// Events: `resize` when the size asked for changed.
export class Stage extends Emitter {
  size = null;  // {width, height}: pixels to ask for; {cssWidth, cssHeight}: what they cover on the page.
  #element;
  #canvas;
  #largestSide = Infinity;  // Welcome tells it.
  #timer = 0;
  #placed = null;

  constructor(element, canvas) {
    super();
    this.#element = element;
    this.#canvas = canvas;
    new ResizeObserver(() => {
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#measure(), this.size ? QUIET_MS : 0);
    }).observe(element);
    this.#watchPixelRatio();
  }

  setLargestSide(px) {
    this.#largestSide = px;
    if (this.size) this.#measure();
  }

  // The ratio changes when the page is zoomed, or moved to another screen.
  #watchPixelRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', () => {
      this.#measure();
      this.#watchPixelRatio();
    }, {once: true});
  }

  #measure() {
    const box = this.#element.getBoundingClientRect();
    if (box.width < 1 || box.height < 1) return;
    const exact = {width: Math.max(1, Math.floor(box.width * devicePixelRatio)),
                   height: Math.max(1, Math.floor(box.height * devicePixelRatio))};
    const shrink = Math.min(1, this.#largestSide / Math.max(exact.width, exact.height),
                            Math.sqrt(MOST_PIXELS / (exact.width * exact.height)));
    const size = {width: Math.max(1, Math.floor(exact.width * shrink)), height: Math.max(1, Math.floor(exact.height * shrink)),
                  cssWidth: exact.width / devicePixelRatio, cssHeight: exact.height / devicePixelRatio};
    if (this.size && Object.keys(size).every((key) => size[key] === this.size[key])) return;
    this.size = size;
    this.emit('resize');
  }

  /// Puts the canvas where `frame` belongs. `asked` is the size that was asked for, or null for somebody else's view,
  /// which is fitted in.
  place(frame, asked) {
    const {style} = this.#canvas, box = this.#element.getBoundingClientRect();
    let {cssWidth, cssHeight} = asked ?? {};
    if (!asked) {
      const fit = Math.min(box.width / frame.width, box.height / frame.height);
      cssWidth = frame.width * fit;
      cssHeight = frame.height * fit;
    }
    // The canvas begins at a whole device pixel. Otherwise each exact pixel would be smeared over two.
    const snap = (css) => Math.round(css * devicePixelRatio) / devicePixelRatio;
    style.width = `${cssWidth}px`;
    style.height = `${cssHeight}px`;
    style.left = `${snap((box.width - cssWidth) / 2)}px`;
    style.top = `${snap((box.height - cssHeight) / 2)}px`;
    style.imageRendering = asked && frame.width === asked.width ? 'pixelated' : 'auto';
    this.#placed = {left: parseFloat(style.left), top: parseFloat(style.top), scale: cssWidth / frame.width};
  }

  /// Where a box of the frame that was placed last, [x, y, width, height] in its pixels, stands on the stage, by the page's.
  placeOf([x, y, width, height]) {
    const {left, top, scale} = this.#placed;
    return {left: left + x * scale, top: top + y * scale, right: left + (x + width) * scale, bottom: top + (y + height) * scale};
  }
}
