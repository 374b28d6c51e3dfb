// One viewer of the mock server. The newest view wins; one frame is drawn ahead of what is shown.

import {filterRows, jpegEncode, lz4Encode, pngEncode} from './codecs.js';
import * as messages from './messages.js';
import {drawSphere} from './picture.js';

const CODEC = {raw: 0, jpeg: 1, png: 2, lz4: 3};
const RANKS = 4;

function encode(codec, pixels, width, rows, bpp) {
  switch (codec) {
    case 'raw': return pixels;
    case 'jpeg': return jpegEncode(pixels, width, rows);
    case 'png': return pngEncode(pixels, width, rows, bpp, (row) => row % 5);
    default: return lz4Encode(filterRows(pixels, width, rows, bpp));
  }
}

const fromHome = ({position, focal, ...rest}, farness) => ({...rest, focal, position: position.map((x, i) => focal[i] + (x - focal[i]) * farness)});

export class Viewer {
  views = [];     // Every View that came.
  shown = [];     // Every Shown.
  picks = [];     // Every Pick.
  asked = [];     // Every Change but those that only say that the scene rests.
  hello = null;
  following = 0;
  lastPicture = null;  // {frame, view, width, height, pixels, bytesPerPixel} that was sent last.
  faults = [];
  #waiting = null;
  #ahead = 0;     // Frames sent and not shown.
  #isDrawing = false;

  constructor(server, number, connection) {
    this.server = server;
    this.number = number;
    this.connection = connection;
    connection.on('message', (bytes) => {
      try {
        this.#receive(messages.parseFromViewer(bytes));
      } catch (error) {
        this.faults.push(error.message);
        connection.close(1002);
      }
    });
  }

  get stateJson() {
    return {...this.server.state, viewers: this.server.viewers.map((one) => ({viewer: one.number, name: one.hello?.name ?? ''}))};
  }

  sendState() {
    if (this.hello) this.connection.send(messages.state(this.stateJson));
  }

  /// The last view is drawn again, as one of motion while the scene moves.
  sendScene() {
    if (!this.hello) return;
    this.connection.send(messages.scene(this.server.scene));
    this.#waiting ??= this.views.at(-1) ?? null;
    this.#draw();
  }

  notice(level, message, change = false) {
    this.connection.send(messages.notice({level, message, change}));
  }

  #receive({type, json, number}) {
    if (type === 1) return this.#greet(json);
    if (!this.hello) throw new Error('no Hello first');
    if (type === 2) {
      if (json.shading?.colorBy !== undefined) throw new Error('shading.colorBy in a View');
      this.views.push(json);
      this.following = 0;
      this.#waiting = json;
      this.server.emit('view', this, json);
    } else if (type === 3) {
      this.shown.push(number);
      this.#ahead = Math.max(0, this.#ahead - 1);
    } else if (type === 4) {
      const {change, moving, ...wishes} = json;
      if (Object.keys(wishes).length > 0) this.asked.push(json);
      this.server.emit('change', this, json);
      const refusal = this.server.refuse(json);
      const answer = () => this.connection.send(messages.changed(change));
      if (refusal) {
        this.notice('error', refusal, true);
        return answer();
      }
      setTimeout(() => {
        this.server.isSceneMoving = moving;
        if (Object.keys(wishes).length > 0 || !moving) this.server.setScene(wishes);
        answer();
      }, 5);
    } else if (type === 5) {
      this.following = number;
    } else if (type === 6) {
      this.server.emit('start', this);
    } else if (type === 7) {
      this.picks.push(json);
      this.connection.send(messages.picked({view: json.view, place: this.server.placeAt(json)}));
    }
    this.#draw();
  }

  #greet(hello) {
    this.hello = hello;
    const limits = {largestSide: 4096, viewsPerSecond: 120};
    this.connection.send(messages.welcome({protocol: 1, version: '0.1.0', viewer: this.number, codecs: ['jpeg', 'lz4', 'png'], limits, state: this.stateJson}));
    if (this.server.state.state !== 'loading') this.sendScene();
    this.server.setState({});
  }

  async #draw() {
    const {server} = this;
    if (this.#isDrawing || !this.#waiting || server.isMute || server.state.state !== 'ready' || this.#ahead >= 2) return;
    this.#isDrawing = true;
    const view = this.#waiting;
    this.#waiting = null;
    if (server.drawMs > 0) await new Promise((resolve) => setTimeout(resolve, server.drawMs));
    const start = performance.now();
    if (server.state.state === 'ready') this.#sendFrame(view);
    // Who uses this server has the same thread. Large pictures without end would take all of it, and the test would stand.
    await new Promise((resolve) => setTimeout(resolve, Math.min(500, performance.now() - start)));
    this.#isDrawing = false;
    this.#draw();
  }

  #sendFrame(view) {
    const {server} = this, isMoving = view.moving || server.isSceneMoving;
    const start = performance.now(), scale = isMoving ? server.scaleMoving : 1;
    const width = Math.max(1, Math.floor(view.width / scale)), height = Math.max(1, Math.floor(view.height / scale));
    const {scene} = server.scene, lic = {...scene.lic, ...view.lic}, shading = {...scene.shading, ...view.shading};
    const {pixels, bytesPerPixel} = drawSphere({width, height, camera: view.home ? fromHome(server.scene.view, view.home) : view.camera, lic, shading, time: server.changes.time ?? 0});
    const drawnMs = performance.now(), frame = ++server.nextFrame, wanted = isMoving ? server.movingCodec : server.restCodec;
    const codec = wanted === 'jpeg' && bytesPerPixel === 4 ? 'lz4' : wanted, ranks = [];
    const receivers = [this, ...server.viewers.filter((one) => one.following === this.number)];
    const send = (message) => receivers.forEach((one) => one.connection.send(message));
    send(messages.frame({frame, viewer: this.number, view: view.view, width, height, askedWidth: view.width, lossless: !isMoving}));
    let bytes = 0;
    for (let rank = RANKS - 1; rank >= 0; --rank) {  // The last stripe first: the order must not matter.
      const firstRow = Math.floor(height * rank / RANKS), rows = Math.floor(height * (rank + 1) / RANKS) - firstRow;
      if (rows === 0) continue;
      const stripe = pixels.subarray(firstRow * width * bytesPerPixel, (firstRow + rows) * width * bytesPerPixel);
      const encoded = encode(codec, stripe, width, rows, bytesPerPixel);
      bytes += encoded.length;
      ranks.unshift({rank, firstRow, rows, busyMs: (drawnMs - start) * [0.7, 1, 0.93, 0.55][rank]});
      send(messages.tile({frame, firstRow, rows, width, rank, codec: CODEC[codec], bytesPerPixel, encoded}));
    }
    const totalMs = drawnMs - start;
    send(messages.frameEnd(frame, {totalMs, stagesMs: {project: totalMs * 0.22, composite: totalMs * 0.04, convolve: totalMs * 0.55, shade: totalMs * 0.19},
                                   encodeMs: performance.now() - drawnMs, bytes, ranks, legend: server.legend(width, height)}));
    for (const one of receivers) ++one.#ahead;
    this.lastPicture = {frame, view: view.view, width, height, pixels, bytesPerPixel};
  }
}
