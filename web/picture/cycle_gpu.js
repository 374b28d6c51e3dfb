// Plays streaks that flow, where the browser has a GPU: WebGL mixes all pictures of the cycle, at the screen's rate.

import {around, cycleWeights, flowingBoxes} from './cycle.js';

const VERTEX = `#version 300 es
in vec2 place;
void main() { gl_Position = vec4(place, 0.0, 1.0); }`;

// Without a GPU texture() is faster than texelFetch().
const fragment = (count) => `#version 300 es
precision highp float;
uniform vec2 texel;
uniform vec2 corner;
uniform sampler2D pictures[${count}];
uniform float weights[${count}];
out vec4 color;
void main() {
  vec2 at = (gl_FragCoord.xy + corner) * texel;
  color = vec4(0.0);
${Array.from({length: count}, (_, i) => `  color += weights[${i}] * texture(pictures[${i}], at);`).join('\n')}
}`;

function program(gl, count) {
  const made = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment(count)]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
    gl.deleteShader(shader);  // Once the program goes.
  }
  gl.bindAttribLocation(made, 0, 'place');
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(made) || 'WebGL has no program');
  return made;
}

// Two triangles a box, in WebGL's coordinates, which begin at the bottom, as the textures do.
function cornersOf(boxes, width, height) {
  return new Float32Array(boxes.flatMap(([x0, y0, x1, y1]) => {
    const [left, right] = [x0, x1].map((x) => 2 * x / width - 1), [low, high] = [height - y1, height - y0].map((y) => 2 * y / height - 1);
    return [left, low, right, low, left, high, left, high, right, low, right, high];
  }));
}

/// Draws on a canvas that lies over the first picture: where pictures differ, and elsewhere nothing. The canvas is as large
/// as `bounds`, a box [x0, y0, x1, y1] of the picture's pixels.
export class GpuPlayer {
  bounds = [0, 0, 1, 1];
  #canvas;
  #gl;
  #program = null;  // For #count pictures.
  #count = 0;
  #pictures = [];
  #boxes = [];
  #textures = [];
  #buffer = null;
  #turns = 0;

  /// Throws where the browser has no WebGL 2.
  constructor(canvas) {
    this.#canvas = canvas;
    this.#gl = canvas.getContext('webgl2', {alpha: true, premultipliedAlpha: false, antialias: false, depth: false});
    if (!this.#gl) throw new Error('this browser has no WebGL 2');
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => {
      this.#program = this.#buffer = null;  // They went with the context.
      this.#textures = [];
      if (this.#pictures.length === 0) return;
      this.#upload();
      this.draw(this.#turns);
    });
  }

  /// The pictures of one cycle, in its order: ImageData of one size. Returns the boxes that are drawn: a transparent
  /// picture below would be seen through them. Throws where WebGL has no room for them.
  setPictures(pictures) {
    this.clear();
    this.#pictures = pictures;
    this.#boxes = flowingBoxes(pictures);
    this.bounds = around(this.#boxes);
    if (!this.#gl.isContextLost()) this.#upload();
    return this.#boxes;
  }

  /// Lets go of the pictures, and of what the device has of them.
  clear() {
    for (const texture of this.#textures) this.#gl.deleteTexture(texture);
    this.#pictures = this.#textures = this.#boxes = [];
  }

  #upload() {
    const gl = this.#gl, pictures = this.#pictures, {width, height} = pictures[0];
    if (pictures.length > gl.getParameter(gl.MAX_TEXTURE_IMAGE_UNITS)) throw new Error('WebGL takes fewer pictures at once');
    if (Math.max(width, height) > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error('the picture is larger than WebGL takes');
    const [x0, y0, x1, y1] = this.bounds;
    this.#canvas.width = x1 - x0;
    this.#canvas.height = y1 - y0;
    gl.viewport(-x0, y1 - height, width, height);
    if (!this.#program || this.#count !== pictures.length) {
      gl.deleteProgram(this.#program);
      this.#program = program(gl, pictures.length);
      this.#count = pictures.length;
    }
    gl.useProgram(this.#program);
    const place = (name) => gl.getUniformLocation(this.#program, name);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    this.#textures = pictures.map((picture, i) => {
      const texture = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, picture);
      gl.uniform1i(place(`pictures[${i}]`), i);
      return texture;
    });
    gl.uniform2f(place('texel'), 1 / width, 1 / height);
    gl.uniform2f(place('corner'), x0, height - y1);
    this.#buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    gl.bufferData(gl.ARRAY_BUFFER, cornersOf(this.#boxes, width, height), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw new Error('WebGL has no memory for the pictures');
  }

  /// Draws the picture at a phase in turns.
  draw(turns) {
    const gl = this.#gl;
    this.#turns = turns;
    if (gl.isContextLost() || this.#pictures.length === 0) return;
    gl.uniform1fv(gl.getUniformLocation(this.#program, 'weights'), cycleWeights(turns, this.#pictures.length));
    gl.drawArrays(gl.TRIANGLES, 0, 6 * this.#boxes.length);
  }
}
