// What lies over the surface: the option's text, "none" or a list as "streamlines:16,topology", in parts.

export const USUAL_SPACING = 24;  // Pixels, as the server takes where the list has none.

/// {streamlines: spacing in pixels or 0, topology, edges, outline}
export function readOverlays(text) {
  const parts = new Set((text ?? 'none').split(','));
  const lines = [...parts].find((part) => /^streamlines(:|$)/.test(part));
  return {streamlines: lines ? Number(lines.split(':')[1] ?? USUAL_SPACING) : 0,
          topology: parts.has('topology'), edges: parts.has('edges'), outline: parts.has('outline')};
}

export function overlaysText({streamlines, topology, edges, outline}) {
  const lines = streamlines === USUAL_SPACING ? 'streamlines' : streamlines > 0 ? `streamlines:${streamlines}` : '';
  return [edges && 'edges', outline && 'outline', lines, topology && 'topology'].filter(Boolean).join(',') || 'none';
}
