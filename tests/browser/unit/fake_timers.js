// Timers that go by a clock of their own. Node has such since version 20 only.

const real = {setTimeout: globalThis.setTimeout, clearTimeout: globalThis.clearTimeout};

export class FakeTimers {
  #now = 0;
  #next = 1;
  #waiting = new Map();

  constructor() {
    globalThis.setTimeout = (call, ms = 0, ...rest) => {
      this.#waiting.set(this.#next, {at: this.#now + ms, call: () => call(...rest)});
      return this.#next++;
    };
    globalThis.clearTimeout = (id) => this.#waiting.delete(id);
  }

  /// Lets `ms` milliseconds go by: calls what is due, in its order.
  tick(ms) {
    const end = this.#now + ms;
    for (;;) {
      const [first] = [...this.#waiting].filter(([, {at}]) => at <= end).sort(([, a], [, b]) => a.at - b.at);
      if (!first) break;
      this.#waiting.delete(first[0]);
      this.#now = first[1].at;
      first[1].call();
    }
    this.#now = end;
  }

  restore() {
    Object.assign(globalThis, real);
  }
}
