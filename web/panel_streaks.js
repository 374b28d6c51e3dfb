// The panel's part about the line integral convolution.

import {seedField, segments, slider, toggle} from './controls.js';
import {isAcceptable} from './options.js';

export function streaksPart({model, phase}) {
  const rules = (key) => ({
    onInput: (value, isMoving) => model.setOption('lic', key, value, isMoving),
    onReset: () => model.resetOption('lic', key),
    accepts: (value) => isAcceptable('lic', key, value),
  });
  const rows = {
    method: segments({label: 'Method', choices: [['hierarchical', 'Hierarchical'], ['direct', 'Direct'], ['none', 'None']], ...rules('method')}),
    integrator: segments({label: 'Integrator', choices: [['euler', 'Euler'], ['rk2', 'RK2'], ['rk4', 'RK4']], ...rules('integrator')}),
    steps: slider({label: 'Steps each way', min: 1, max: 1024, step: 1, scale: 'log', ...rules('steps')}),
    stepPx: slider({label: 'Step', unit: 'px', min: 0.1, max: 8, scale: 'log', digits: 2, ...rules('stepPx')}),
    noiseScale: slider({label: 'Noise', unit: 'texels/px', min: 0.05, max: 8, scale: 'log', digits: 2, ...rules('noiseScale')}),
    normalize: toggle({label: 'Same length everywhere', ...rules('normalize')}),
    kernel: segments({label: 'Kernel', choices: [['box', 'Box'], ['hann', 'Hann']], ...rules('kernel')}),
    phaseRad: slider({label: 'Phase', unit: 'rad', min: 0, max: 2 * Math.PI, ...rules('phaseRad')}),
    seed: seedField({label: 'Seed', most: 9999, ...rules('seed')}),
  };
  const animate = toggle({label: 'Let it flow', onInput: (isOn) => phase.run(isOn)});
  const speed = slider({label: 'Speed', unit: 'turns/s', min: 0.05, max: 2, scale: 'log', digits: 2,
                        accepts: (value) => value > 0 && value <= 20, onInput: (value) => phase.setSpeed(value)});

  function update() {
    const {lic} = model.options, isOn = lic.method !== 'none';
    for (const [key, row] of Object.entries(rows)) row.set(lic[key], key in model.changed.lic);
    for (const [key, row] of Object.entries(rows)) if (key !== 'method') row.show(isOn);
    rows.integrator.show(lic.method === 'direct');
    rows.phaseRad.show(isOn && lic.kernel === 'hann' && !phase.isRunning);
    animate.show(isOn);
    animate.set(phase.isRunning);
    speed.show(isOn && phase.isRunning);
    speed.set(phase.speed);
  }
  const {method, integrator, steps, stepPx, noiseScale, normalize, kernel, phaseRad, seed} = rows;
  const order = [method, integrator, steps, stepPx, noiseScale, normalize, kernel, animate, speed, phaseRad, seed];
  return {title: 'Streaks', elements: order.map((row) => row.element), update};
}
