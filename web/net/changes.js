// Changes of the scene that all viewers share. One is on its way at a time; of those that wait, the newest wishes
// count.

const GIVE_UP_MS = 60000;

export class Changes {
  #send;
  #waiting = {};
  #sentMs = null;

  /// send(change) sends the message Change.
  constructor(send) {
    this.#send = send;
  }

  get isBusy() {
    return this.#sentMs !== null && performance.now() - this.#sentMs < GIVE_UP_MS;
  }

  request(change) {
    const steer = change.steer && {steer: {...this.#waiting.steer, ...change.steer}};
    Object.assign(this.#waiting, change, steer);
    this.#next();
  }

  /// A Scene or a refusal came.
  answered() {
    this.#sentMs = null;
    this.#next();
  }

  /// The connection ended.
  forget() {
    this.#sentMs = null;
    this.#waiting = {};
  }

  #next() {
    if (this.isBusy || Object.keys(this.#waiting).length === 0) return;
    const change = this.#waiting;
    this.#waiting = {};
    this.#sentMs = performance.now();
    this.#send(change);
  }
}
