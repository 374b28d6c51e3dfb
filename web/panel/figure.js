// The panel's part about legend, texts and axes around the surface.

import {slider, textField, toggle} from './controls.js';
import {OptionRows} from './option_rows.js';

export function figurePart({model}) {
  const shading = new OptionRows(model, 'shading');
  const title = shading.add('title', textField, {label: 'Title'});
  const legend = shading.add('legend', textField, {label: 'Legend'});
  const scalarBar = shading.add('scalarBar', toggle, {label: 'Scalar bar'});
  const axes = shading.add('axes', toggle, {label: 'Axes'});
  const timeStamp = shading.add('timeStamp', toggle, {label: 'Time'});
  const textScale = shading.add('textScale', slider, {label: 'Text size', digits: 3});

  function update() {
    shading.update();
    const isColored = model.colorBy !== '';
    legend.setPlaceholder(model.scene?.colorName ?? '');
    for (const row of [legend, scalarBar]) row.show(isColored);
    timeStamp.show((model.scene?.choices?.times ?? []).length > 0);
  }
  return {title: 'Figure', elements: [title, legend, scalarBar, axes, timeStamp, textScale].map((row) => row.element), update};
}
