// Which moment comes next while time plays.

const SHORTEST_S = 1 / 60;  // Something moves with every picture.

/// The moment that is shown `seconds` after `now`, at so many steps a second: between two steps what the server makes of
/// both. No step is left out: where pictures take longer, each shows the next one. Behind the last comes the first.
export function nextMoment(times, now, seconds, stepsPerSecond) {
  const last = times.at(-1), at = times.findLastIndex((time) => time <= now), next = times[at + 1];
  if (now >= last) return times[0];
  const moved = now + (next - times[at]) * Math.max(SHORTEST_S, seconds) * stepsPerSecond;
  return moved < next ? Number(moved.toPrecision(12)) : next;
}
