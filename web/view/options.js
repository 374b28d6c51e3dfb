// The options of a scene that a viewer may change for itself. What they may be, and their defaults, come with the scene
// as `options` (docs/protocol.md): {lic: {steps: {kind: 'whole', least: 1, most: 65536, usual: [1, 1024], default:
// 128}, …}, …}.

const isInRange = ({least = -Infinity, above = -Infinity, most = Infinity}, value) =>
  Number.isFinite(value) && value >= least && (value > above || above === -Infinity) && value <= most;

const ACCEPTS = {
  number: isInRange,
  whole: (rule, value) => Number.isInteger(value) && isInRange(rule, value),
  numbers: (rule, value) => Array.isArray(value) && value.length === rule.count && value.every((x) => isInRange(rule, x)),
  name: ({names, pattern}, value) => names.includes(value) || pattern !== undefined && new RegExp(pattern).test(value),
  switch: (rule, value) => typeof value === 'boolean',
  color: (rule, value) => /^([0-9a-f]{6}|transparent)$/i.test(value),
  opaque: (rule, value) => /^([0-9a-f]{6})?$/i.test(value),
  text: (rule, value) => typeof value === 'string' && !/[\x00-\x1f\x7f]/.test(value),
};

/// Whether the server would take `value`. What a link or a person says is judged by it. `options`: the scene's.
export function isAcceptable(options, group, key, value) {
  const rule = options?.[group]?.[key], accepts = ACCEPTS[rule?.kind];
  if (!accepts?.(rule, value)) return false;
  return key !== 'colorRange' || value[0] < value[1];
}

/// The value that `text` in a link stands for; it need not be acceptable.
export function valueFromText(rule, text) {
  switch (rule.kind) {
    case 'number': case 'whole': return text.trim() === '' ? NaN : Number(text);
    case 'numbers': return text.split(',').map((part) => part.trim() === '' ? NaN : Number(part));
    case 'switch': return text === 'true' ? true : text === 'false' ? false : null;
    default: return text;
  }
}

/// {lic, shading} with every key that has a rule: what this viewer changed, else what the scene says, else the default.
export function effectiveOptions(options, scene, changed) {
  const of = (group) => Object.fromEntries(Object.entries(options?.[group] ?? {}).map(
    ([key, rule]) => [key, changed[group][key] ?? scene?.[group]?.[key] ?? rule.default]));
  return {lic: of('lic'), shading: of('shading')};
}
