// Pictures on their way. Tiles are drawn when they come, each frame into a canvas of its own that nobody sees. The
// newest complete frame is put on the screen, and only then does the server hear that it is shown.

import {CODEC_NAMES} from '../net/protocol.js';
import {decodeTile} from './decode.js';
import {Emitter} from '../page/emitter.js';

const LOST_AFTER_MS = 3000;  // Rows that a rank sends itself may come after the frame's end, but not this long after it.
const MOST_PENDING = 4;  // The server draws one frame ahead. It should not have sent more than this.

/// Events: `complete` (frame) when all of it is here; `drawn` (frame) when it is in the canvas, `shown` when on screen;
/// `broken` (frame, message). A frame: {frame, viewer, view, width, height, askedWidth, lossless, stats, bytes, codecs,
/// tiles, pixels}; `pixels`: exact RGBA, of lossless frames.
export class Frames extends Emitter {
  #canvas;
  #context;
  #decode;
  #spare = [];
  #pending = new Map();
  #ready = null;
  #lastSeen = 0;  // The newest frame that is shown or never will be.
  hasDirect = () => false;

  get canvas() {
    return this.#canvas;
  }

  /// Takes boxes [x0, y0, x1, y1] of pixels out of the picture on the screen, for what lies over it.
  clear(boxes) {
    for (const [x0, y0, x1, y1] of boxes) this.#context.clearRect(x0, y0, x1 - x0, y1 - y0);
  }

  /// Puts a picture of the same size back on the screen.
  put(image) {
    this.#context.putImageData(image, 0, 0);
  }

  constructor(canvas, decode = decodeTile) {
    super();
    this.#canvas = canvas;
    this.#context = canvas.getContext('2d');
    this.#decode = decode;
  }

  begin(info) {
    if (info.frame <= this.#lastSeen) return;
    const back = this.#spare.pop() ?? document.createElement('canvas');
    back.width = info.width;  // Also clears it.
    back.height = info.height;
    const pixels = info.lossless ? new Uint8ClampedArray(info.width * info.height * 4) : null;
    this.#pending.set(info.frame, {...info, back, context: back.getContext('2d'), pixels, bytes: 0, tiles: 0, rowsDone: 0,
                                   decoding: 0, codecs: new Set(), stats: null, fault: null, lateTimer: 0});
    // The oldest is nearest to being shown. Without it newer ones could push out each other forever.
    if (this.#pending.size > MOST_PENDING) this.#drop([...this.#pending.keys()].sort((a, b) => a - b)[1]);
  }

  async tile(tile) {
    const frame = this.#pending.get(tile.frame);
    if (!frame || frame.fault) return;
    const {firstRow, rows, width} = tile;
    frame.bytes += tile.encoded.length;
    frame.codecs.add(CODEC_NAMES[tile.codec]);
    ++frame.tiles;
    ++frame.decoding;
    try {
      if (width !== frame.width || firstRow + rows > frame.height) throw new RangeError('tile does not fit its picture');
      const {rgba, bitmap} = await this.#decode(tile);
      if (bitmap) {
        frame.context.drawImage(bitmap, 0, firstRow);
        bitmap.close();
      } else {
        frame.context.putImageData(new ImageData(rgba, width, rows), 0, firstRow);
      }
      if (frame.pixels && rgba) frame.pixels.set(rgba, firstRow * width * 4);
      else frame.pixels = null;
      frame.rowsDone += rows;
    } catch (error) {
      frame.fault = error.message;
    }
    --frame.decoding;
    this.#finish(frame);
  }

  end(number, stats) {
    const frame = this.#pending.get(number);
    if (!frame) return;
    frame.stats = stats;
    // Frames end in their order: the server has given up older ones that have not ended.
    for (const [older, {stats: ended}] of [...this.#pending]) if (older < number && !ended) this.#drop(older);
    this.#finish(frame);
  }

  /// The connection ended. What is not complete will never be.
  abandon() {
    for (const number of [...this.#pending.keys()]) this.#drop(number);
    if (this.#ready) this.#recycle(this.#ready);
    this.#ready = null;
    this.#lastSeen = 0;  // Another server counts anew.
  }

  #finish(frame) {
    if (!frame.stats || frame.decoding > 0 || this.#pending.get(frame.frame) !== frame) return;
    clearTimeout(frame.lateTimer);
    if (frame.rowsDone < frame.height && !frame.fault && this.hasDirect()) {
      frame.lateTimer = setTimeout(() => this.#giveUp(frame), LOST_AFTER_MS);
      return;
    }
    if (frame.rowsDone < frame.height && !frame.fault) frame.fault = 'rows are missing';
    this.#pending.delete(frame.frame);
    this.emit('complete', frame);
    if (frame.fault) {
      this.#recycle(frame);
      this.#lastSeen = Math.max(this.#lastSeen, frame.frame);
      return this.emit('broken', frame, frame.fault);
    }
    if (frame.frame <= this.#lastSeen || (this.#ready && this.#ready.frame > frame.frame)) return this.#recycle(frame);
    if (this.#ready) this.#recycle(this.#ready);
    else requestAnimationFrame(() => this.#show());
    this.#ready = frame;
  }

  // The frame's rows were lost, perhaps with a connection to a rank. Nobody sends them again.
  #giveUp(frame) {
    frame.fault = 'rows are missing';
    this.#finish(frame);
  }

  #show() {
    const frame = this.#ready, canvas = this.#canvas;
    this.#ready = null;
    if (!frame) return;
    if (canvas.width !== frame.width || canvas.height !== frame.height) {
      canvas.width = frame.width;
      canvas.height = frame.height;
    } else {
      this.#context.clearRect(0, 0, frame.width, frame.height);  // Through a transparent picture the last one would be seen.
    }
    this.#context.drawImage(frame.back, 0, 0);
    this.#recycle(frame);
    this.#lastSeen = frame.frame;
    for (const number of [...this.#pending.keys()]) if (number < frame.frame) this.#drop(number);
    this.emit('drawn', frame);
    // A task after the animation frame's callbacks runs when the browser has painted.
    setTimeout(() => this.emit('shown', frame));
  }

  #drop(number) {
    const frame = this.#pending.get(number);
    clearTimeout(frame.lateTimer);
    this.#pending.delete(number);
    this.#recycle(frame);
  }

  #recycle(frame) {
    if (frame.back && frame.decoding === 0 && this.#spare.length < 3) this.#spare.push(frame.back);
    frame.back = null;
  }
}
