// What styles alone cannot know: how high the line that steers is, and that the page has moved below its picture.

export function watchLayout(scene) {
  const top = document.getElementById('top');
  const observer = new ResizeObserver(() => {
    document.documentElement.style.setProperty('--top', `${top.offsetHeight}px`);
    scene.resize();
  });
  for (const id of ['top', 'app']) observer.observe(document.getElementById(id));
}
