// Plays streaks that flow, where the browser has no GPU. Mixing all pictures of the cycle is slow there. So some pictures
// between them are worked out once, a few rows at each step, and the screen shows a mixture of the two nearest that are
// there. With three for each picture of the cycle a mixture is off by less than 0.01 of a wave's height.

import {around, cycleWeights, flowingBoxes} from './cycle.js';

const MOST_PARTS = 3, MOST_BYTES = 256 << 20;  // Of all together, where more than the cycle's own pictures are made.
const WORK_MS = 6;  // For each picture on the screen.

/// Draws on a canvas that lies over the first picture, as GpuPlayer does.
export class CyclePainter {
  bounds = [0, 0, 1, 1];
  #canvas;
  #context;
  #pictures = [];
  #boxes = [];
  #slots = [];   // Canvases, evenly spread over the cycle; null: not there yet.
  #canGoOn = true;  // There was room for the last one.
  #work = null;     // {slot, image, row}: what is worked out now, from `row` of `bounds` on.

  constructor(canvas) {
    this.#canvas = canvas;
    this.#context = canvas.getContext('2d');
    if (!this.#context) throw new Error('this browser has no canvas');
  }

  /// As GpuPlayer's.
  setPictures(pictures) {
    this.clear();
    this.#pictures = pictures;
    this.#boxes = flowingBoxes(pictures);
    this.bounds = around(this.#boxes);
    const [x0, y0, x1, y1] = this.bounds, [width, height] = [x1 - x0, y1 - y0];
    [this.#canvas.width, this.#canvas.height] = [width, height];
    const parts = Math.min(MOST_PARTS, Math.max(1, Math.floor(MOST_BYTES / (4 * width * height * pictures.length))));
    this.#slots = Array(parts * pictures.length).fill(null);
    pictures.forEach((picture, i) => {
      const {canvas, context} = this.#emptySlot();
      for (const [left, top, right, bottom] of this.#boxes) context.putImageData(picture, -x0, -y0, left, top, right - left, bottom - top);
      this.#slots[parts * i] = canvas;
    });
    return this.#boxes;
  }

  /// Lets go of the pictures at once: browsers clear up canvases late.
  clear() {
    for (const slot of this.#slots) if (slot) slot.width = slot.height = 0;
    this.#pictures = this.#boxes = this.#slots = [];
    this.#work = null;
    this.#canGoOn = true;
  }

  /// Draws the picture at a phase in turns.
  draw(turns) {
    const count = this.#slots.length;
    if (count === 0) return;
    const at = (turns % 1 + 1) % 1 * count;
    this.#workOn(Math.ceil(at) % count);
    let [before, after] = [Math.floor(at), Math.floor(at) + 1];
    while (!this.#slots[before]) --before;  // The first is there always.
    while (!this.#slots[after % count]) ++after;
    const share = (at - before) / (after - before), context = this.#context;
    const lay = (how, alpha, slot) => {
      [context.globalCompositeOperation, context.globalAlpha] = [how, alpha];
      context.drawImage(this.#slots[slot % count], 0, 0);
    };
    lay('copy', 1 - share, before);
    lay('lighter', share, after);
  }

  #emptySlot() {
    const canvas = Object.assign(document.createElement('canvas'), {width: this.#canvas.width, height: this.#canvas.height});
    const context = canvas.getContext('2d');
    if (!context) throw new Error('the browser has no memory for the pictures');
    return {canvas, context};
  }

  // Goes on with the next picture that is missing, from `slot` on.
  #workOn(slot) {
    const count = this.#slots.length;
    if (!this.#canGoOn) return;
    if (!this.#work) {
      let missing = slot;
      while (this.#slots[missing]) if ((missing = (missing + 1) % count) === slot) return;
      this.#work = {slot: missing, image: new ImageData(this.#canvas.width, this.#canvas.height), row: 0};
    }
    const endMs = performance.now() + WORK_MS, {image} = this.#work;
    const weights = cycleWeights(this.#work.slot / count, this.#pictures.length);
    do this.#mixRow(weights, this.#work.row++, image); while (this.#work.row < image.height && performance.now() < endMs);
    if (this.#work.row < image.height) return;
    const {slot: done} = this.#work;
    this.#work = null;
    try {
      const {canvas, context} = this.#emptySlot();
      context.putImageData(image, 0, 0);
      this.#slots[done] = canvas;
    } catch {
      this.#canGoOn = false;  // Those that are there do, too.
    }
  }

  #mixRow(weights, row, {data, width}) {
    const [x0, y0] = this.bounds, y = y0 + row, stride = 4 * this.#pictures[0].width;
    for (const [left, top, right, bottom] of this.#boxes) {
      if (y < top || y >= bottom) continue;
      const from = y * stride + 4 * left, to = 4 * (row * width + left - x0), bytes = 4 * (right - left);
      const sums = new Float32Array(bytes);
      this.#pictures.forEach(({data: picture}, i) => {
        const weight = weights[i];
        for (let k = 0; k < bytes; ++k) sums[k] += weight * picture[from + k];
      });
      data.set(sums, to);  // Clamped and rounded.
    }
  }
}
