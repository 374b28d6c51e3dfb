// Tiles straight from the ranks, where the server offers it. A connection that fails makes no difference but speed:
// the gateway then relays that rank's tiles.

export class DirectTiles {
  #sockets = new Set();
  #onMessage;

  constructor(onMessage) {
    this.#onMessage = onMessage;
  }

  /// `offers`: those of an Offer, which comes anew with every start of the render job.
  connect(offers) {
    this.close();
    for (const {host, port, token} of offers ?? []) {
      let socket;
      try {
        const name = host.includes(':') ? `[${host}]` : host;
        const address = new URL(`ws://${name || location.hostname}:${port}/tiles`);
        address.searchParams.set('token', token);
        socket = new WebSocket(address);
      } catch {
        continue;  // E.g. ws: from a page that came by https:, which browsers refuse.
      }
      socket.binaryType = 'arraybuffer';
      socket.onopen = () => this.#sockets.add(socket);
      socket.onclose = () => this.#sockets.delete(socket);
      socket.onmessage = ({data}) => this.#onMessage(data);
    }
  }

  get count() {
    return this.#sockets.size;
  }

  close() {
    for (const socket of this.#sockets) socket.close();
    this.#sockets.clear();
  }
}
