// The options of a scene that a viewer may change for itself: their defaults and ranges, as in Aeolic's scene files.

export const DEFAULTS = Object.freeze({
  lic: Object.freeze({method: 'hierarchical', integrator: 'rk2', steps: 128, stepPx: 1, kernel: 'box', phaseRad: 0,
                      normalize: true, noiseScale: 1, seed: 1}),
  shading: Object.freeze({colorMap: 'viridis', colorRange: null, scalarBar: true, contrast: 1, blend: 0.8,
                          background: 'ffffff', lighting: true}),
});

const oneOf = (...names) => (value) => names.includes(value);
const between = (lo, hi) => (value) => typeof value === 'number' && value >= lo && value <= hi;
const whole = (lo, hi) => (value) => Number.isInteger(value) && value >= lo && value <= hi;
const isSwitch = (value) => typeof value === 'boolean';

const ACCEPTS = {
  lic: {method: oneOf('none', 'direct', 'hierarchical'), integrator: oneOf('euler', 'rk2', 'rk4'), steps: whole(1, 65536),
        stepPx: between(1e-6, 8), kernel: oneOf('box', 'hann'), phaseRad: between(-1e6, 1e6), normalize: isSwitch,
        noiseScale: between(0.01, 16), seed: whole(0, 4294967295)},
  shading: {colorMap: (value) => typeof value === 'string' && /^[\w-]{1,64}$/.test(value),
            colorRange: (value) => Array.isArray(value) && value.length === 2 && value.every(Number.isFinite) && value[0] < value[1],
            scalarBar: isSwitch, contrast: between(0, 10), blend: between(0, 1),
            background: (value) => /^([0-9a-f]{6}|transparent)$/.test(value), lighting: isSwitch},
};

/// Whether the server would take `value`; links and number fields are checked by it.
export function isAcceptable(group, key, value) {
  return ACCEPTS[group]?.[key]?.(value) ?? false;
}

/// {lic, shading} with every key: what the scene says, over the defaults, under what this viewer changed.
export function effectiveOptions(scene, changed) {
  const of = (group) => {
    const known = {...DEFAULTS[group]};
    for (const key of Object.keys(known)) known[key] = changed[group][key] ?? scene?.[group]?.[key] ?? known[key];
    return known;
  };
  return {lic: of('lic'), shading: of('shading')};
}
