// What the server says in the words of its command line, in those of the page.

// [a pattern of the server's words, the page's]
const WORDS = [
  [/a larger --size or a smaller --text-scale/g, 'a larger window or a smaller Text size (under Figure)'],
  [/--color-scale log\b/g, 'the scale Log'],
  [/--color-scale\b/g, 'Scale'],
  [/--mask-below (?=[\d.])/g, 'None below (under Streaks) is '],
  [/--mask-below\b/g, 'None below'],
  [/--text-scale\b/g, 'Text size'],
  [/--size\b/g, 'the size of the window'],
  [/--color-by\b/g, 'Colour by'],
  [/--color-range\b/g, 'Lowest and Highest'],
  [/--color-map\b/g, 'Colour map'],
  [/--vectors\b/g, 'Vectors'],
  [/--lic\b/g, 'Method'],
  [/--steps\b/g, 'Steps each way'],
  [/--fov\b/g, 'Field of view'],
  [/--time(?= )/g, 'Time'],
];

/// Options that the page has no control for keep their names: they are given where the server is started.
export function inPageWords(text) {
  return WORDS.reduce((said, [pattern, words]) => said.replace(pattern, words), text);
}
