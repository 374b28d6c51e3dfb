// The options that the mock server's scenes come with. The ranges are narrower than those of `aeolic serve`: a page
// that knew ranges of its own would not keep to them.

const number = (initial, from, most, usual = [from, most]) => ({kind: 'number', least: from, most, usual, default: initial});
const whole = (initial, least, most, usual) => ({kind: 'whole', least, most, usual, default: initial});
const name = (initial, ...names) => ({kind: 'name', names, default: initial});
const opaque = {kind: 'opaque', default: ''}, text = {kind: 'text', default: ''}, isOff = {kind: 'switch', default: false};
const isOn = {kind: 'switch', default: true};
const point = {kind: 'numbers', least: -1e9, most: 1e9, usual: [-1e9, 1e9], count: 3, default: null};

export const COLOR_MAPS = ['viridis', 'turbo', 'coolwarm', 'gray', 'plasma', 'inferno', 'magma', 'cividis', 'twilight', 'RdBu', 'vik'];

export const OPTIONS = {
  lic: {method: name('hierarchical', 'none', 'direct', 'hierarchical'), style: name('dense', 'dense', 'oriented'), integrator: name('rk2', 'euler', 'rk2', 'rk4'),
        steps: whole(128, 2, 300, [4, 200]), step: {kind: 'number', above: 0, most: 3, usual: [0.5, 3], default: 1},
        kernel: name('box', 'box', 'hann'), streaks: name('even', 'plain', 'even'), phase: number(0, -100, 100, [0, 6]), flow: name('off', 'off', 'loop'), normalize: isOn,
        magnitude: name('none', 'none', 'contrast', 'length'),
        noiseScale: number(1, 0.5, 4), maskBelow: {kind: 'number', least: 0, default: 0}, seed: whole(1, 0, 1000, [1, 9])},
  shading: {colormap: name('viridis', ...COLOR_MAPS), colorRange: {kind: 'numbers', count: 2, default: null}, scalarBar: isOn,
            colorScale: {...name('linear', 'linear', 'log'), pattern: '^bands:([2-9]|1[0-6])$'}, nanColor: opaque, belowColor: opaque,
            aboveColor: opaque, legend: text, title: text, axes: isOff, timeStamp: isOff, textScale: number(1, 0.5, 3),
            contrast: number(1, 0, 2), blend: number(0.8, 0, 1), background: {kind: 'color', default: 'ffffff'}, lighting: isOn, antialias: isOn, occlusion: isOff,
            overlay: {...name('none', 'none', 'streamlines', 'topology', 'separation', 'edges', 'outline'),
                      pattern: '^(topology|edges|outline|streamlines(:[0-9.]+)?)(,(topology|edges|outline|streamlines(:[0-9.]+)?))*$'}, persistence: number(0.01, 0, 1, [0, 0.2])},
  camera: {fov: number(30, 10, 90, [20, 60]), position: point, focal: point, up: point},
};
