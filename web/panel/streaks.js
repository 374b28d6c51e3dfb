// The panel's part about the line integral convolution.

import {seedField, segments, slider, toggle} from './controls.js';
import {OptionRows} from './option_rows.js';
import {isAcceptable} from '../view/options.js';

export function streaksPart({model, flowing}) {
  const lic = new OptionRows(model, 'lic');
  const method = lic.add('method', segments, {label: 'Method', labels: {hierarchical: 'Hierarchical', direct: 'Direct', none: 'None'}});
  const style = lic.add('style', segments, {label: 'Style', labels: {dense: 'Dense', oriented: 'Oriented'}});
  const exact = toggle({label: 'Exact at rest', onInput: (isOn) => model.setExactAtRest(isOn)});
  const integrator = lic.add('integrator', segments, {label: 'Integrator', labels: {euler: 'Euler', rk2: 'RK2', rk4: 'RK4'}});
  const steps = lic.add('steps', slider, {label: 'Steps each way', scale: 'log'});
  const step = lic.add('step', slider, {label: 'Step', unit: 'px', scale: 'log', digits: 2});
  const noiseScale = lic.add('noiseScale', slider, {label: 'Noise', unit: 'texels/px', scale: 'log', digits: 2});
  const normalize = lic.add('normalize', toggle, {label: 'Same length everywhere'});
  const magnitude = lic.add('magnitude', segments, {label: 'Where it is slow', labels: {none: 'As elsewhere', contrast: 'Fainter', length: 'Shorter'}});
  const kernel = lic.add('kernel', segments, {label: 'Kernel', labels: {box: 'Box', hann: 'Hann'}});
  const evenness = lic.add('streaks', segments, {label: 'Streaks', labels: {even: 'Even', plain: 'Plain'}});
  const phaseRad = lic.add('phase', slider, {label: 'Phase', unit: 'rad'});
  // What is shorter than the longest vector may be masked; 0 masks nothing.
  const maskBelow = slider({label: 'None below', digits: 3, accepts: (value) => isAcceptable(model.rules, 'lic', 'maskBelow', value),
                            onInput: (value, isMoving) => model.setOption('lic', 'maskBelow', value, isMoving),
                            onReset: () => model.resetOption('lic', 'maskBelow')});
  const seed = lic.add('seed', seedField, {label: 'Seed'});
  const animate = toggle({label: 'Let it flow', onInput: (isOn) => flowing.run(isOn)});
  const speed = slider({label: 'Speed', unit: 'turns/s', min: 0.05, max: 2, scale: 'log', digits: 2,
                        accepts: (value) => value > 0 && value <= 20, onInput: (value) => flowing.setSpeed(value)});

  function update() {
    lic.update();
    const chosen = model.options.lic, isOn = chosen.method !== 'none';
    const isDense = chosen.style === 'dense';
    for (const row of [style, steps, step, noiseScale, magnitude, evenness, seed]) row.show(isOn);
    normalize.show(isOn && chosen.magnitude !== 'length');
    kernel.show(isOn && isDense && !model.flows);
    animate.show(isOn);
    exact.show(chosen.method === 'hierarchical');
    exact.set(model.isExactAtRest);
    integrator.show(chosen.method === 'direct');
    phaseRad.show(isOn && isDense && chosen.kernel === 'hann' && !model.flows);
    maskBelow.setRange(0, model.scene?.longestVector || 1);
    maskBelow.set(chosen.maskBelow ?? 0, 'maskBelow' in model.changed.lic);
    maskBelow.show(isOn);
    animate.set(model.flows);
    speed.show(model.flows);
    speed.set(flowing.speed);
  }
  const order = [method, style, exact, integrator, steps, step, noiseScale, magnitude, normalize, maskBelow, kernel, evenness, animate, speed, phaseRad, seed];
  return {title: 'Streaks', elements: order.map((row) => row.element), update};
}
