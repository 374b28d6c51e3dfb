// The page's icons: lines on a grid of 20 x 20, drawn for this page.

const PATHS = {
  home: 'M3.5 9.5 10 4l6.5 5.5M5.5 8.5V16h9V8.5',
  stats: 'M3.5 16.5h13M5.5 13.5v-3M10 13.5v-8M14.5 13.5v-5',
  link: 'M8.5 11.5a3 3 0 0 0 4.3 0l2.6-2.6a3 3 0 0 0-4.3-4.3l-1 1M11.5 8.5a3 3 0 0 0-4.3 0l-2.6 2.6a3 3 0 0 0 4.3 4.3l1-1',
  save: 'M10 3.5v9M6.5 9.5 10 13l3.5-3.5M4 16.5h12',
  sun: 'M10 6.7a3.3 3.3 0 1 0 0 6.6 3.3 3.3 0 0 0 0-6.6M10 2.5v1.3M10 16.2v1.3M2.5 10h1.3M16.2 10h1.3M4.7 4.7l.9.9M14.4 14.4l.9.9M4.7 15.3l.9-.9M14.4 5.6l.9-.9',
  moon: 'M16 11.6A6.3 6.3 0 0 1 8.4 4a6.3 6.3 0 1 0 7.6 7.6',
  help: 'M7.7 7.6a2.4 2.4 0 1 1 3.5 2.1c-.8.4-1.2.9-1.2 1.8M10 14.6v.1',
  fullscreen: 'M4 7.5V4h3.5M12.5 4H16v3.5M16 12.5V16h-3.5M7.5 16H4v-3.5',
  panel: 'M4 6.5h7M15 6.5h1M4 13.5h1M9 13.5h7M13 4.7a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6M7 11.7a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6',
  people: 'M8 4.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5M3.5 16c0-2.5 1.8-4 4.5-4s4.5 1.5 4.5 4M13 5a2.2 2.2 0 0 1 0 4.2M14.3 12.4c1.5.5 2.2 1.8 2.2 3.6',
  play: 'M7 4.8v10.4l8-5.2z',
  pause: 'M7.2 5v10M12.8 5v10',
  previous: 'M14 5v10l-7-5zM5.5 5v10',
  next: 'M6 5v10l7-5zM14.5 5v10',
  undo: 'M5 8h6.5a3.5 3.5 0 0 1 0 7H8M7.5 5 4.5 8l3 3',
  add: 'M10 4.5v11M4.5 10h11',
  close: 'M5.5 5.5l9 9M14.5 5.5l-9 9',
  eye: 'M2.5 10S5.3 5 10 5s7.5 5 7.5 5-2.8 5-7.5 5-7.5-5-7.5-5M10 7.8a2.2 2.2 0 1 0 0 4.4 2.2 2.2 0 0 0 0-4.4',
  picture: 'M3.5 4.5h13v11h-13zM3.5 13l4-4 3.5 3.5L13 10.5l3.5 3M13 7.3v.1',
  scene: 'M6 3.5h5.5L15 7v9.5H6zM11.5 3.5V7H15M8 11h5M8 13.7h3.5',
};

const SVG = 'http://www.w3.org/2000/svg';

export function icon(name) {
  const svg = document.createElementNS(SVG, 'svg'), path = document.createElementNS(SVG, 'path');
  svg.setAttribute('viewBox', '0 0 20 20');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  path.setAttribute('d', PATHS[name]);
  svg.append(path);
  return svg;
}

export function setIcon(element, name) {
  element.querySelector('.icon')?.remove();
  element.prepend(icon(name));
}
