// Nine colours of each of Aeolic's colour maps, from the low end to the high end, for the page's swatches. A map that
// is not here is offered by its name alone.

const STOPS = {
  viridis: '440154 472d7b 3b528b 2c728e 21918c 28ae80 5cc863 aadc32 fde725',
  turbo: '30123b 466be3 28bceb 32f298 a4fc3c eecf3a fb8122 d23105 7a0403',
  coolwarm: '3b4cc0 6282ea 8db0fe b9d0f9 dddcdc f5c4ac f49a7b de614d b40426',
  gray: '000000 202020 404040 606060 808080 a0a0a0 bfbfbf dfdfdf ffffff',
  plasma: '0d0887 4c02a1 7e03a8 aa2395 cc4778 e66c5c f89441 fdc328 f0f921',
  inferno: '000004 210c4a 57106e 8a226a bc3754 e45a31 f98c0a f9c932 fcffa4',
  magma: '000004 1d1147 51127c 832681 b73779 e75263 fb8761 fec287 fcfdbf',
  cividis: '00224e 1a386f 434e6c 61656f 7d7c78 9a9376 bbad6d ddc858 fee838',
  twilight: 'e2d9e2 94b4c6 6275ba 592a8e 301436 731d4f b25552 cca288 e2d9e2',
  RdBu: '67001f bb2a34 e58368 fbceb7 f6f7f7 c2ddec 6bacd1 2a71b2 053061',
  vik: '001261 034481 307da6 94bed2 ece5e0 dcac90 c37243 942f06 590008',
};

const MASKED = '999999';

const stopsOf = (name, ofScene = {}) => STOPS[name]?.split(' ') ?? ofScene[name];

/// A CSS gradient, or null. `ofScene`: {name: [RRGGBB, …]} of maps that the scene has out of files.
export function gradientOf(name, ofScene) {
  const stops = stopsOf(name, ofScene);
  return stops ? `linear-gradient(to right, ${stops.map((color) => `#${color}`).join(', ')})` : null;
}

/// Values outside of the range are drawn in these colours unless others are chosen: {belowColor, aboveColor,
/// nanColor}. `choices`: the scene's.
export function colorsOutside(name, {colorStops, colorsOutside: ofFiles} = {}) {
  const stops = stopsOf(name, colorStops) ?? [MASKED];
  return {belowColor: stops[0], aboveColor: stops.at(-1), nanColor: MASKED, ...ofFiles?.[name]};
}
