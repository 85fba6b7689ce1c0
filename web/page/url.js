// The address bar: what differs from the defaults, so that a link restores scene, camera and settings.

/** Reads the query: { scene, size, values: [[key, text], …] }; scene and size are null where the query has none. */
export function readQuery(search) {
  const values = [...new URLSearchParams(search)];
  const of = (key) => values.find(([name]) => name === key)?.[1] ?? null;
  return { scene: of('scene'), size: of('size'), values: values.filter(([key]) => key !== 'scene') };
}

/**
 * The query for the state as it stands.
 * @param state.changed the tracer's own query: settings that differ from their defaults
 * @param state.scene null where it is the default scene
 * @param state.size `WxH` where the canvas has a fixed size, else null
 * @param state.pausedAtStart whether the page starts paused here by itself
 */
export function writeQuery({ changed, scene, size, paused, pausedAtStart }) {
  const query = new URLSearchParams(changed);
  query.delete('size'); // follows the window, unless it was asked for
  query.delete('pause');
  if (!paused) query.delete('time'); // a running clock would change the link all the time
  const first = [];
  if (scene) first.push(['scene', scene]);
  if (size) first.push(['size', size]);
  const last = paused === pausedAtStart ? [] : [['pause', paused ? 'on' : 'off']];
  // Commas are legal in a query and far easier to read than %2C.
  return new URLSearchParams([...first, ...query, ...last]).toString().replaceAll('%2C', ',');
}

const quietMs = 300;

/** @returns touch(): asks for the address to be written soon; touch.now(): writes it at once */
export function addressBar(query) {
  let timer = 0;
  const now = () => {
    clearTimeout(timer);
    timer = 0;
    const text = query();
    const url = `${location.pathname}${text ? `?${text}` : ''}${location.hash}`;
    if (url !== `${location.pathname}${location.search}${location.hash}`) history.replaceState(null, '', url);
  };
  const touch = () => {
    timer ||= setTimeout(now, quietMs); // browsers limit how often the address may change
  };
  touch.now = now;
  return touch;
}
