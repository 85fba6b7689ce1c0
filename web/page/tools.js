// The row of buttons: pause, link, picture, frame rates, full screen, help.

/** Copies text; browsers without the clipboard interface, or on plain http, still know the old way. */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = Object.assign(document.createElement('textarea'), { value: text });
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}

export function toggleFullscreen() {
  if (document.fullscreenElement) return document.exitFullscreen();
  return document.documentElement.requestFullscreen?.().catch(() => {});
}

/**
 * @param actions { pause(), link() → address, picture() → Promise of a PNG data URL, name(), compare(), help(),
 * note(text) }
 */
export function connectTools(actions) {
  const button = (id) => document.getElementById(id);

  button('pause').onclick = actions.pause;
  button('keys').onclick = actions.help;
  button('compare').onclick = actions.compare;
  button('link').onclick = async () => {
    const done = await copy(actions.link());
    actions.note(
      done ? 'Link copied: it brings back scene, camera and settings' : 'The link stands in the address bar',
    );
  };
  button('save').onclick = async () => {
    const link = Object.assign(document.createElement('a'), {
      download: `${actions.name()}.png`,
      href: await actions.picture(),
    });
    link.click();
  };
  button('fullscreen').onclick = toggleFullscreen;
  button('fullscreen').hidden = !document.fullscreenEnabled; // a phone may have none

  return {
    show(settings) {
      button('pause').setAttribute('aria-pressed', String(settings.get('pause') === 'on'));
    },
  };
}
