// Takes tiles straight from the ranks, where the server offers it. A connection that fails costs speed only: the
// gateway then relays that rank's tiles.

export class DirectTiles {
  #sockets = new Set();
  #onMessage;

  constructor(onMessage) {
    this.#onMessage = onMessage;
  }

  /// `offers` are those of an Offer. Every start of the render job brings a new one.
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
        continue;  // A browser refuses ws: for a page that came by https:, for example.
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
