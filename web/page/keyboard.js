// The keyboard: browser key events to the key names of the settings table and of Viewer.

const named = {
  ArrowLeft: 'Left',
  ArrowRight: 'Right',
  ArrowUp: 'Up',
  ArrowDown: 'Down',
  ShiftLeft: 'Shift',
  ShiftRight: 'Shift',
};
const moves = ['KeyW', 'KeyA', 'KeyS', 'KeyD'];

/**
 * The name of the key, or null where it is none of ours. Moving keys and digits go by position, so that they lie alike
 * on every layout; letters with a meaning go by what stands on the cap, and the caps of moving keys elsewhere mean
 * nothing.
 */
export function keyName({ code, key }) {
  if (named[code]) return named[code];
  if (/^Digit\d$/.test(code)) return code.slice(5);
  if (moves.includes(code)) return code.slice(3);
  const cap = /^[a-z]$/i.test(key) ? key.toUpperCase() : null;
  if (cap) return moves.includes(`Key${cap}`) ? null : cap;
  if (/^Key[A-Z]$/.test(code)) return code.slice(3); // a layout without Latin letters
  return null;
}

const isTyping = (target) =>
  target instanceof Element && target.closest('input, select, textarea, dialog, [contenteditable]');

/** @param keys { down(name), up(name), releaseAll() } */
export function listenToKeys(keys) {
  const held = new Map(); // by position: the cap's letter may change between down and up, with Shift

  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
    const name = keyName(event);
    if (!name) return;
    if (event.code.startsWith('Arrow')) event.preventDefault(); // no scrolling
    if (event.repeat) return;
    held.set(event.code, name);
    keys.down(name);
  });

  addEventListener('keyup', (event) => {
    const name = held.get(event.code);
    if (!name) return;
    held.delete(event.code);
    keys.up(name);
  });

  const releaseAll = () => {
    held.clear();
    keys.releaseAll();
  };
  addEventListener('blur', releaseAll);
  document.addEventListener('visibilitychange', () => document.hidden && releaseAll());
}
