// The conversation with the server: what each message means for the page, and what the page says.

import {Changes} from './changes.js';
import {Connection} from './connection.js';
import {DirectTiles} from './direct.js';
import {Emitter} from '../page/emitter.js';
import {Pacer} from './pacer.js';
import {Type, emptyMessage, jsonMessage, numberMessage, parseMessage} from './protocol.js';

const HELLO = {codecs: ['jpeg', 'png', 'lz4'], direct: true, name: 'page'};
const KEPT_SIZES = 64;  // So many views are remembered, because frames may still answer them.

// A View as the server draws it: one from home goes along with the scene.
const textOf = (view) => JSON.stringify(view.home ? {...view, camera: null} : view);

/// Events: `status` whenever `link`, `state` or `lost` changed; `notice` ({level, message}); `answered` (latency in
/// ms); `following` (viewer or 0); `picked` ({view, place}).
export class Session extends Emitter {
  link = 'connecting';  // connecting | open | lost | denied
  lost = null;          // {reason, retryAtMs} while lost.
  welcome = null;
  state = null;         // The last State.
  following = 0;
  #model;
  #frames;
  #stage;
  #connection;
  #direct = new DirectTiles((data) => this.#receive(data));
  #lastView = 0;
  #sent = null;         // What the last View of this connection said.
  #sizes = new Map();   // view -> {width, height, cssWidth, cssHeight}
  #unseenUpTo = -1;     // Own views up to this one are from where the camera did not go.
  #unseen = new Map();  // frame -> its header, of such views.
  #brokenInARow = 0;

  constructor({model, frames, stage}) {
    super();
    this.#model = model;
    this.#frames = frames;
    this.#stage = stage;
    this.pacer = new Pacer((isMoving) => this.#sendView(isMoving));
    this.changes = new Changes((change) => this.#connection.send(jsonMessage(Type.change, {...change, ...this.#placesOf(change)})));
    this.#connection = new Connection();
    this.#connection.on('open', () => this.#connection.send(jsonMessage(Type.hello, HELLO)))
      .on('message', (data) => this.#receive(data))
      .on('down', (lost) => this.#down('lost', lost))
      .on('denied', () => this.#down('denied', null));
    model.on('camera', (isMoving) => this.changedView(isMoving)).on('options', (isMoving) => this.changedView(isMoving))
      .on('through', () => this.changedView(false));
    frames.hasDirect = () => this.#direct.count > 0;
    frames.on('complete', (frame) => this.#completed(frame)).on('shown', (frame) => this.#shown(frame))
      .on('broken', (frame, message) => this.#broken(frame, message));
  }

  start() {
    this.#connection.connect();
  }

  retryNow() {
    this.#connection.retryNow();
  }

  /// Asks for another start of a renderer that was given up.
  askForStart() {
    this.#connection.send(emptyMessage(Type.start));
  }

  /// The view changed. The pacer sends it in time.
  changedView(isMoving) {
    if (isMoving) this.pacer.touch();
    else this.pacer.settle();
  }

  /// Follows `viewer`; 0 goes back to the own view.
  follow(viewer) {
    this.following = viewer;
    this.#connection.send(numberMessage(Type.follow, viewer));
    this.emit('following', viewer);
    if (viewer === 0) this.pacer.settle();
  }

  /// The size that was asked for `frame`, if it is an own frame that is not long past.
  askedSize(frame) {
    return frame.viewer === this.welcome?.viewer ? this.#sizes.get(frame.view) ?? null : null;
  }

  #sendView(isMoving) {
    const size = this.#stage.size;
    if (!this.#connection.isOpen || !this.welcome || !this.#model.camera || !size) return null;
    if (this.following !== 0) {
      this.following = 0;  // By the protocol, an own view ends the following.
      this.emit('following', 0);
    }
    const view = ++this.#lastView;
    this.#sizes.set(view, size);
    if (this.#sizes.size > KEPT_SIZES) this.#sizes.delete(this.#sizes.keys().next().value);
    this.#sent = this.#viewOf(isMoving);
    this.#connection.send(jsonMessage(Type.view, {view, ...this.#sent}));
    this.emit('sent', isMoving, view);
    return view;
  }

  /// Asks what the view of now shows at that pixel of the stage. The number of the question comes back with `picked`;
  /// null: nobody can be asked.
  pick(x, y) {
    if (!this.#connection.isOpen || !this.#model.camera || !this.#stage.size || this.following !== 0) return null;
    const view = ++this.#lastView;
    this.#connection.send(jsonMessage(Type.pick, {view, ...this.#viewOf(false), x, y}));
    return view;
  }

  #viewOf(isMoving) {
    const {width, height} = this.#stage.size;
    return {moving: isMoving, width, height, home: this.#model.farnessFromHome, ...this.#model.viewGroups(isMoving)};
  }

  #receive(data) {
    let message;
    try {
      message = parseMessage(data);
    } catch (error) {
      console.error(error);
      return this.#connection.drop(`The server sent what this page does not understand (${error.message}).`);
    }
    switch (message.type) {
      case Type.welcome: return this.#welcomed(message.json);
      case Type.state: return this.#setState(message.json);
      case Type.scene: return this.#sceneLoaded(message.json);
      case Type.frame: return this.#begun(message);
      case Type.tile: return this.#frames.tile(message);
      case Type.frameEnd: return this.#ended(message.frame, message.json);
      case Type.changed: return this.changes.answered(message.change);
      case Type.picked: return this.emit('picked', message.json);
      case Type.offer: return this.#direct.connect(message.json.direct);
      case Type.notice: return this.#noticed(message.json);
    }
  }

  #welcomed(welcome) {
    this.#connection.welcomed();
    this.#frames.abandon();
    this.#unseen.clear();
    this.#sent = null;
    this.pacer.forget();
    this.pacer.shortestPauseMs = 1000 / welcome.limits.viewsPerSecond;
    this.welcome = welcome;
    this.link = 'open';
    this.lost = null;
    this.#stage.setLargestSide(welcome.limits.largestSide);
    this.#direct.close();
    this.#setState(welcome.state ?? {state: 'loading'});
  }

  #setState(state) {
    const before = this.state?.state;
    this.state = state;
    // After a restart the server draws the view it knows. One that was sent while it was gone may be newer.
    if ((before === 'restarting' || before === 'failed') && state.state === 'ready' && this.#model.scene && this.following === 0) {
      this.pacer.forget();
      this.pacer.settle();
    }
    this.emit('status');
  }

  #sceneLoaded(scene) {
    if (this.#model.scene && this.#model.scene.places !== scene.places) this.changes.placesCountAnew();
    this.#model.setScene(scene);
    if (this.following !== 0 || !this.#stage.size) return;
    // The server draws the last View again. It is sent anew where the scene has made another one of it.
    const now = this.#sent && this.#viewOf(this.#sent.moving);
    if (now && textOf(this.#sent) === textOf(now)) return;
    // The server goes home with the scene. Where the camera stays, no picture from there is shown.
    if (this.#sent?.home && !now.home) this.#unseenUpTo = this.#lastView;
    this.changedView(this.changes.isBusy);
  }

  // By which Scene a change counts surfaces. The server refuses it where some have been taken away since then.
  #placesOf(change) {
    return 'cuts' in change || 'shown' in change ? {places: this.#model.scene?.places} : {};
  }

  #begun(frame) {
    if (frame.viewer === this.welcome?.viewer && frame.view <= this.#unseenUpTo) this.#unseen.set(frame.frame, frame);
    else this.#frames.begin(frame);
  }

  #ended(number, stats) {
    const frame = this.#unseen.get(number);
    if (!frame) return this.#frames.end(number, stats);
    for (const one of [...this.#unseen.keys()]) if (one <= number) this.#unseen.delete(one);  // Frames end in their order.
    this.pacer.answered(frame.view);
    this.#shown(frame);
  }

  #noticed(notice) {
    if (notice.level === 'error') this.pacer.forget();
    if (notice.change) this.changes.refused();
    this.emit('notice', notice);
  }

  #completed(frame) {
    if (frame.viewer !== this.welcome?.viewer) return;
    const sentMs = this.pacer.answered(frame.view);
    frame.latencyMs = sentMs === null ? null : performance.now() - sentMs;
  }

  #shown(frame) {
    this.#brokenInARow = 0;
    this.#connection.send(numberMessage(Type.shown, frame.frame));
  }

  #broken(frame, message) {
    this.#connection.send(numberMessage(Type.shown, frame.frame));  // It has to count as shown, or no other frame would follow.
    if (++this.#brokenInARow === 1) this.pacer.settle();
    else this.emit('notice', {level: 'error', message: `A picture could not be decoded: ${message}.`});
  }

  #down(link, lost) {
    this.link = link;
    this.lost = lost;
    this.#direct.close();
    this.changes.forget();
    this.pacer.forget();
    this.following = 0;
    this.emit('following', 0);
    this.emit('status');
  }
}
