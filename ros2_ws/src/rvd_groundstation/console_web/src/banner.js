// The words across the scene: of the flight, or of the run that is reviewed.

import { escape } from './escape.js';

export function banner(words, small = '', alarm = false) {
  const element = document.getElementById('banner');
  const html = words ? `${escape(words)}${small ? `<small>${escape(small)}</small>` : ''}` : '';
  if (element.dataset.said !== html) {
    element.dataset.said = html;
    element.innerHTML = html;
  }
  element.classList.toggle('alarm', Boolean(words && alarm));
}
