// A stand-in for `aeolic serve` that speaks docs/protocol.md, with the tricks that tests need: it can load slowly,
// restart, fail, cut lines, and it remembers everything it was sent.

import {EventEmitter} from 'node:events';
import {readFile} from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {COLOR_MAPS, OPTIONS} from './options.js';
import {Viewer} from './viewer.js';
import {WebSocketConnection} from './websocket.js';

const WEB = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../web');
const TYPES = {'.html': 'text/html; charset=utf-8', '.css': 'text/css; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.svg': 'image/svg+xml'};
const CSP = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self' ws: wss:; worker-src 'self'";

export const TIMES = Array.from({length: 11}, (_, i) => i / 10);

// Azimuth 30, elevation 20 degrees; the unit sphere fits.
const RAD = Math.PI / 180, DISTANCE = 1.04 / Math.sin(15 * RAD);
const [AZ, EL] = [30 * RAD, 20 * RAD];
const HOME = {
  position: [Math.sin(AZ) * Math.cos(EL), -Math.cos(AZ) * Math.cos(EL), Math.sin(EL)].map((x) => x * DISTANCE), focal: [0, 0, 0],
  up: [-Math.sin(AZ) * Math.sin(EL), Math.cos(AZ) * Math.sin(EL), Math.cos(EL)], fov: 30,
};

// The surfaces after a Change, as src/stream/requests.cpp makes them: [{spec, shown}].
export function changedSurfaces(now, given, {surface, cuts = {}, shown}) {
  let list = now.map((one) => ({...one}));
  if (surface !== undefined) {
    list = given.map((spec, i) => ({spec, shown: now[i]?.shown ?? true}));
    if (surface !== 'original') list = given.length > 1 ? [...list, {spec: surface, shown: true}] : [{spec: surface, shown: true}];
  }
  for (const [place, spec] of Object.entries(cuts)) if (spec !== null) list[place] = {shown: true, ...list[place], spec};
  list = list.filter((one, place) => cuts[place] !== null);
  if (shown && shown.length !== list.length) throw new Error(`${shown.length} switches for ${list.length} surfaces`);
  return list.map((one, i) => ({...one, shown: shown?.[i] ?? one.shown}));
}

/// A Scene after `changes`; `given`: the surfaces that the server was started with, `surfaces` those now.
export function sceneMessage(changes = {}, given = ['ball.vtp'], surfaces = changedSurfaces(given.map((spec) => ({spec, shown: true})), given, changes)) {
  const {vectors = 'U', colorBy = 'p', time = 0} = changes, specs = surfaces.map(({spec}) => spec);
  const surface = specs.join() === given.join() ? 'original' : specs.at(-1);
  return {
    scene: {surface: {spec: specs[0], featureAngle: 20}, ...(surfaces.length > 1 ? {surfaces} : {}), field: {spec: 'flow.vti', vectors},
            lic: {method: 'hierarchical', style: 'dense', integrator: 'rk2', steps: 128, step: 1, kernel: 'box', streaks: 'even', phase: 0, flow: 'off', normalize: true, magnitude: 'none', noiseScale: 1, seed: 1},
            shading: {colorBy, colormap: 'viridis', scalarBar: true, contrast: 1, blend: 0.8, background: 'ffffff', lighting: true, antialias: true, occlusion: false},
            time: {moment: time},
            camera: {azimuth: 30, elevation: 20, roll: 0, zoom: 1, fov: 30}},
    bounds: [[-1, -1, -1], [1, 1, 1]],
    view: HOME, distance: DISTANCE, radius: 1, options: OPTIONS,
    colorRange: colorBy ? [-0.5, 1.25] : null, colorName: colorBy,
    choices: {surfaces: ['original', 'slice', 'isosurface', 'boundary'], vectors: ['U', 'wallShearStress'], colorBy: ['p', 'U:mag'],
              colorMaps: COLOR_MAPS,
              isosurface: [{array: 'p', range: [-0.5, 1.25]}, {array: 'k', range: [0, 40]}], times: TIMES},
    surface, given: given.length, warnings: [], backend: 'cpu', device: 'AMD EPYC', ranks: 4, threads: [2, 2, 2, 2], triangles: 25088, loadMs: 812, longestVector: 2.5,
  };
}

/// Events: `viewer` (Viewer), `view` (viewer, json), `change` (viewer, json). `port` 0: any that is free.
export class MockServer extends EventEmitter {
  token;
  state = {state: 'ready', what: '', fraction: 1, message: '', ranks: 4, restarts: 0};
  changes = {};
  given = ['ball.vtp'];
  #surfaces = null;
  viewers = [];
  restCodec = 'lz4';    // For pictures at rest: lz4 | png | raw.
  movingCodec = 'jpeg'; // For moving pictures.
  scaleMoving = 2;      // A moving picture is smaller by this factor.
  drawMs = 0;           // Each picture takes at least this time.
  isMute = false;       // Draws nothing.
  withTimes = false;
  withRanges = true;    // Of the arrays that isosurfaces can be cut at.
  refuse = () => null;  // (change) -> the message of an error Notice, or null.
  isSceneMoving = false;  // A viewer changes the scene and says that more will follow.
  // What a Pick is told.
  placeAt = () => ({position: [0.25, -0.5, 1e-7], depth: 3, normal: [0, 0, 1], triangle: 7, surface: 'bodies/ball.vtp',
                    vectorName: 'U', vector: [3, 0, 4], tangential: [3, 0, 0], scalarName: 'p', scalar: -0.3125});
  legend = () => null;  // (width, height) -> [x, y, width, height] in a picture of that size.
  movedBy = [0, 0, 0];  // The scene, with its bounds and its own view.
  nextFrame = 0;
  nextViewer = 0;
  #http;

  constructor({token = 'secret'} = {}) {
    super();
    this.token = token;
    this.#http = http.createServer((request, response) => this.#get(request, response));
    this.#http.on('upgrade', (request, socket, head) => this.#upgrade(request, socket, head));
  }

  async start(port = 0) {
    await new Promise((resolve, reject) => this.#http.once('error', reject).listen(port, '127.0.0.1', resolve));
    this.port = this.#http.address().port;
    return this;
  }

  get url() {
    return `http://127.0.0.1:${this.port}/?token=${this.token}`;
  }

  get scene() {
    const message = sceneMessage(this.changes, this.given, this.surfaces);
    const moved = (point) => point.map((x, i) => x + this.movedBy[i]);
    message.bounds = message.bounds.map(moved);
    message.view = {...message.view, position: moved(message.view.position), focal: moved(message.view.focal)};
    if (!this.withTimes) message.choices.times = [0];
    if (!this.withRanges) for (const one of message.choices.isosurface) delete one.range;
    return message;
  }

  async stop() {
    this.cut();
    this.#http.closeAllConnections();
    await new Promise((resolve) => this.#http.close(resolve));
  }

  /// Ends all connections without a close frame.
  cut() {
    for (const viewer of [...this.viewers]) viewer.connection.cut();
  }

  setState(state) {
    this.state = {...this.state, ...state};
    for (const viewer of this.viewers) viewer.sendState();
  }

  get surfaces() {
    return this.#surfaces ?? this.given.map((spec) => ({spec, shown: true}));
  }

  set surfaces(list) {
    this.#surfaces = list;
  }

  setScene(changes) {
    this.surfaces = changedSurfaces(this.surfaces, this.given, changes);
    this.changes = {...this.changes, ...changes};
    for (const viewer of this.viewers) viewer.sendScene();
  }

  #isAllowed(request) {
    const url = new URL(request.url, 'http://x'), cookie = /(?:^|; )aeolic=([^;]*)/.exec(request.headers.cookie ?? '')?.[1];
    return (url.searchParams.get('token') ?? cookie?.replace('session-of-', '')) === this.token;
  }

  async #get(request, response) {
    if (!this.#isAllowed(request)) return this.#deny(request, response);
    const {pathname, searchParams} = new URL(request.url, 'http://x'), name = pathname === '/' ? 'index.html' : pathname.slice(1);
    if (name === 'status') return response.writeHead(200, {'Content-Type': 'application/json'}).end(JSON.stringify(this.state));
    if (searchParams.has('token'))
      return response.writeHead(303, {'Location': pathname, 'Set-Cookie': `aeolic=session-of-${this.token}; HttpOnly; SameSite=Strict; Path=/`}).end();
    if (!/^([a-z]+\/)?[a-z0-9_]+\.[a-z]+$/.test(name) || !(path.extname(name) in TYPES)) return response.writeHead(404).end();
    try {
      const content = await readFile(path.join(WEB, name));
      const headers = {'Content-Type': TYPES[path.extname(name)], 'Content-Security-Policy': CSP, 'Cache-Control': 'no-store', 'X-Content-Type-Options': 'nosniff'};
      response.writeHead(200, headers).end(content);
    } catch {
      response.writeHead(404).end();
    }
  }

  async #deny(request, response) {
    if (!/text\/html/.test(request.headers.accept ?? '')) return response.writeHead(401).end();
    const policy = "default-src 'none'; style-src 'unsafe-inline'";
    response.writeHead(401, {'Content-Type': TYPES['.html'], 'Content-Security-Policy': policy}).end(await readFile(path.join(WEB, 'denied.html')));
  }

  #upgrade(request, socket, head) {
    if (!this.#isAllowed(request)) return socket.end('HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\nConnection: close\r\n\r\n');
    const viewer = new Viewer(this, ++this.nextViewer, new WebSocketConnection(request, socket, head));
    this.viewers.push(viewer);
    viewer.connection.on('close', () => {
      this.viewers = this.viewers.filter((one) => one !== viewer);
      this.setState({});
    });
    this.emit('viewer', viewer);
  }
}
