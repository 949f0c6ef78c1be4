// What lies outside of a picture: an arrow at its edge that points to it, with how far it is.

import { text } from './canvas.js';

// `at` is where it would be, from a middle that shows as far as `reach` [px]; `said` are the places
// of such words in this picture, which are kept apart.
export function pointTo(pen, [cx, cy], reach, [x, y], colour, rem, words, said) {
  const far = Math.hypot(x - cx, y - cy);
  const [dx, dy] = [(x - cx) / far, (y - cy) / far];
  const [tx, ty] = [cx + dx * reach, cy + dy * reach];
  const [bx, by] = [tx - dx * rem * 0.9, ty - dy * rem * 0.9];
  pen.fillStyle = colour;
  pen.beginPath();
  pen.moveTo(tx, ty);
  pen.lineTo(bx - dy * rem * 0.5, by + dx * rem * 0.5);
  pen.lineTo(bx + dy * rem * 0.5, by - dx * rem * 0.5);
  pen.closePath();
  pen.fill();
  if (!words) return;
  const place = [bx - dx * rem * 1.6, by - dy * rem * 0.9];
  while (said.some(([u, v]) => Math.abs(u - place[0]) < 3 * rem && Math.abs(v - place[1]) < rem)) place[1] += rem;
  said.push(place);
  text(pen, words, ...place, colour, 'center');
}
