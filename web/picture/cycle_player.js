// What plays streaks that flow on a canvas.

import {GpuPlayer} from './cycle_gpu.js';
import {CyclePainter} from './cycle_painter.js';

const PROCESSORS = /swiftshader|llvmpipe|softpipe|software|basic render/i;  // What draws WebGL without a GPU.

function hasGpu() {
  const gl = document.createElement('canvas').getContext('webgl2', {failIfMajorPerformanceCaveat: true});
  if (!gl) return false;
  const info = gl.getExtension('WEBGL_debug_renderer_info'), name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();  // Browsers keep few at once.
  return !PROCESSORS.test(name);
}

/// A browser that draws WebGL on its processor is faster without it.
export const playerFor = (canvas) => hasGpu() ? new GpuPlayer(canvas) : new CyclePainter(canvas);
