// Words as they may stand in HTML, in an attribute, too.

export function escape(words) {
  const span = document.createElement('span');
  span.textContent = words;
  return span.innerHTML.replaceAll('"', '&quot;');
}
