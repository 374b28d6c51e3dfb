// What lies over the surface: the option's text, "none" or a list as "streamlines:16,topology", in parts.

export const USUAL_SPACING = 24;  // Pixels, as the server takes where the list has none.

/// {streamlines: spacing in pixels or 0, topology, separation, edges, outline, through: position or null}
export function readOverlays(text) {
  const parts = new Set((text ?? 'none').split(','));
  const lines = [...parts].find((part) => /^streamlines(:|$)/.test(part)), through = [...parts].find((part) => part.startsWith('through:'));
  return {streamlines: lines ? Number(lines.split(':')[1] ?? USUAL_SPACING) : 0,
          topology: parts.has('topology'), separation: parts.has('separation'), edges: parts.has('edges'), outline: parts.has('outline'),
          through: through ? through.split(':').slice(1).map(Number) : null};
}

export function overlaysText({streamlines, topology, separation, edges, outline, through}) {
  const lines = streamlines === USUAL_SPACING ? 'streamlines' : streamlines > 0 ? `streamlines:${streamlines}` : '';
  return [edges && 'edges', outline && 'outline', lines, separation && 'separation', topology && 'topology', through && `through:${through.join(':')}`].filter(Boolean).join(',') || 'none';
}
