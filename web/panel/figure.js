// The panel's part about legend, texts and axes around the surface, and about lines over it.

import {segments, slider, textField, toggle} from './controls.js';
import {OptionRows} from './option_rows.js';

export function figurePart({model}) {
  const shading = new OptionRows(model, 'shading');
  const title = shading.add('title', textField, {label: 'Title'});
  const legend = shading.add('legend', textField, {label: 'Legend'});
  const scalarBar = shading.add('scalarBar', toggle, {label: 'Scalar bar'});
  const axes = shading.add('axes', toggle, {label: 'Axes'});
  const timeStamp = shading.add('timeStamp', toggle, {label: 'Time'});
  const textScale = shading.add('textScale', slider, {label: 'Text size', digits: 3});
  const overlay = shading.add('overlay', segments, {label: 'Overlay', labels: {none: 'None', topology: 'Topology'}});
  const persistence = shading.add('persistence', slider, {label: 'Persistence', digits: 2});

  function update() {
    shading.update();
    const isColored = model.colorBy !== '';
    legend.setPlaceholder(model.scene?.colorName ?? '');
    for (const row of [legend, scalarBar]) row.show(isColored);
    persistence.show(model.options.shading.overlay === 'topology');
    timeStamp.show((model.scene?.choices?.times ?? []).length > 0);
  }
  return {title: 'Figure', elements: [title, legend, scalarBar, axes, timeStamp, textScale, overlay, persistence].map((row) => row.element), update};
}
