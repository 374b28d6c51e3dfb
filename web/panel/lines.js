// The panel's part about lines over the surface.

import {slider, toggle} from './controls.js';
import {OptionRows} from './option_rows.js';
import {USUAL_SPACING, overlaysText, readOverlays} from '../view/overlays.js';

export function linesPart({model}) {
  const shading = new OptionRows(model, 'shading');
  const asked = () => readOverlays(model.options.shading.overlay);
  const ofScene = () => readOverlays(model.scene?.scene?.shading?.overlay);  // What a reset brings back.
  function change(part, isMoving = false) {
    const text = overlaysText({...asked(), ...part});
    if (text === overlaysText(ofScene()) && !isMoving) model.resetOption('shading', 'overlay');
    else model.setOption('shading', 'overlay', text, isMoving);
  }
  let spacing = USUAL_SPACING;  // The last one, while there are no streamlines.
  const usual = () => ofScene().streamlines || USUAL_SPACING;
  const switches = [['streamlines', 'Streamlines'], ['topology', 'Topology'], ['separation', 'Open separation'], ['outline', 'Outline'], ['edges', 'Mesh edges']].map(([key, label]) => {
    const turn = (isOn) => change({[key]: key === 'streamlines' ? (isOn ? spacing : 0) : isOn});
    return {key, row: toggle({label, onInput: turn, onReset: () => change({[key]: ofScene()[key]})})};
  });
  const apart = slider({label: 'Spacing', unit: 'px', min: 8, max: 80, digits: 2, accepts: (px) => px >= 4 && px <= 1000,
                        onInput: (px, isMoving) => change({streamlines: isMoving ? Math.round(px) : px}, isMoving),
                        onReset: () => change({streamlines: usual()})});
  const persistence = shading.add('persistence', slider, {label: 'Persistence', digits: 2});

  function update() {
    shading.update();
    const now = asked();
    if (now.streamlines > 0) spacing = now.streamlines;
    for (const {key, row} of switches) row.set(now[key] > 0, now[key] > 0 !== ofScene()[key] > 0);
    apart.set(spacing, now.streamlines > 0 && spacing !== usual());
    apart.show(now.streamlines > 0);
    persistence.show(now.topology || now.separation);
  }
  const [streamlines, ...others] = switches.map(({row}) => row);
  return {title: 'Lines', elements: [streamlines, apart, ...others, persistence].map((row) => row.element), update};
}
