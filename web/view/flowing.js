// Lets the streaks flow while nothing else moves. The server draws a few pictures of one cycle, and then has nothing to do:
// a player draws those between them, at the screen's rate, also while the server is away. Whatever changes the picture
// ends that, and the next cycle is asked for when the view is at rest again.

import {playerFor} from '../picture/cycle_player.js';
import {FLOW_PICTURES} from './model.js';

const LONGEST_STEP_S = 0.1;  // After a pause (a hidden tab) the flow goes on where it was.

export class Flowing {
  speed = 0.5;  // Turns of the cycle a second.
  isPlaying = false;  // The cycle is here.
  #page;
  #canvas;
  #makePlayer;
  #player = null;
  #pictures = [];
  #asked = 0;      // The view whose picture is the next of the cycle; 0: none is asked for.
  #lastTaken = 0;  // The newest view that gave one.
  #isRedrawn = false;  // The scene is another since the last View, whose picture comes once more.
  #isCleared = false;  // The picture below has holes where streaks flow.
  #turns = 0;
  #lastMs = 0;

  /// `canvas` lies over the picture's own.
  constructor(page, canvas, makePlayer = playerFor) {
    this.#page = page;
    this.#canvas = canvas;
    this.#makePlayer = makePlayer;
    const {model, frames, stage, session} = page, again = () => this.#startAgain();
    model.on('camera', again).on('options', again).on('through', again).on('scene', () => {
      this.#startAgain();
      this.#isRedrawn = true;
    });
    stage.on('resize', again);
    session.on('following', (viewer) => viewer !== 0 && again()).on('sent', (isMoving, view) => this.#sent(isMoving, view));
    frames.on('drawn', (frame) => this.#drawn(frame)).on('shown', (frame) => this.#take(frame));
  }

  get isRunning() {
    return this.#page.model.flows;
  }

  setSpeed(turnsPerSecond) {
    this.speed = turnsPerSecond;
  }

  run(isRunning) {
    if (isRunning !== this.isRunning) this.#page.model.setFlows(isRunning);
  }

  #startAgain() {
    if (this.#isCleared) this.#page.frames.put(this.#pictures.at(-1));
    if (this.isPlaying) this.#player.clear();
    this.#pictures = [];
    this.#asked = 0;
    this.#isCleared = this.isPlaying = false;
    this.#canvas.hidden = true;
    this.#page.model.flowStep = 0;
  }

  #sent(isMoving, view) {
    if (isMoving || this.isPlaying) this.#startAgain();  // What is asked for at rest while they flow is another first one.
    if (!isMoving && this.isRunning) this.#asked = view;
    this.#isRedrawn = false;
  }

  #drawn(frame) {
    this.#isCleared = false;
    if (frame.lossless || this.#pictures.length === 0) return;  // One of a move before may come late.
    this.#startAgain();
    this.#isRedrawn = true;  // The scene moves, and the last view comes once more when it rests.
  }

  #take(frame) {
    const {model, session} = this.#page, isOwn = frame.viewer === session.welcome?.viewer;
    if (!this.isRunning || !isOwn || !frame.lossless || session.following !== 0) return;
    if (frame.view <= this.#lastTaken || this.#isRedrawn) {  // It was drawn again: the data are others.
      this.#startAgain();
      this.#lastTaken = Math.max(frame.view, this.#lastTaken);
      return session.pacer.settle();
    }
    if (frame.view !== this.#asked || !frame.pixels) return;
    this.#asked = 0;
    this.#lastTaken = frame.view;
    const first = this.#pictures[0];
    if (first && (first.width !== frame.width || first.height !== frame.height)) return this.#startAgain();
    this.#pictures.push(new ImageData(frame.pixels, frame.width, frame.height));
    if (this.#pictures.length === FLOW_PICTURES) return this.#play();
    model.flowStep = this.#pictures.length;
    session.pacer.settle();
  }

  #play() {
    const {model, frames} = this.#page;
    try {
      this.#player ??= this.#makePlayer(this.#canvas);
      const boxes = this.#player.setPictures(this.#pictures);
      this.#isCleared = model.background === 'transparent';
      if (this.#isCleared) frames.clear(boxes);  // One would see through what flows.
    } catch (error) {
      model.setFlows(false);
      return this.#page.tell(`The streaks cannot flow here: ${error.message}.`);
    }
    this.#place();
    this.#canvas.hidden = false;
    this.isPlaying = true;
    model.flowStep = 0;
    this.#turns = (FLOW_PICTURES - 1) / FLOW_PICTURES;  // The picture that is on the screen.
    this.#lastMs = performance.now();
    this.#player.draw(this.#turns);
    requestAnimationFrame((nowMs) => this.#step(nowMs));
  }

  // Over the same pixels of the picture.
  #place() {
    const {canvas} = this.#page.frames, [x0, y0, x1, y1] = this.#player.bounds, {style} = this.#canvas;
    const px = (name) => parseFloat(canvas.style[name]), scaleX = px('width') / canvas.width, scaleY = px('height') / canvas.height;
    style.left = `${px('left') + x0 * scaleX}px`;
    style.top = `${px('top') + y0 * scaleY}px`;
    style.width = `${(x1 - x0) * scaleX}px`;
    style.height = `${(y1 - y0) * scaleY}px`;
    style.imageRendering = canvas.style.imageRendering;
  }

  #step(nowMs) {
    if (!this.isPlaying) return;
    this.#turns = (this.#turns + this.speed * Math.max(0, Math.min(LONGEST_STEP_S, (nowMs - this.#lastMs) / 1000))) % 1;
    this.#lastMs = nowMs;
    this.#player.draw(this.#turns);
    requestAnimationFrame((next) => this.#step(next));
  }
}
