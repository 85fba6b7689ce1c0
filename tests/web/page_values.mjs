// What tests read of the page and set on it, by the names of the settings.

export const get = (page, key) => page.evaluate((name) => window.gnomon.get(name), key);
export const set = (page, key, value) => page.evaluate((name, text) => window.gnomon.set(name, text), key, value);
export const numbers = (text) => text.split(',').map(Number);
export const far = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
/** The setting `eye` is empty while the camera stands where the scene put it: lite puts it here. */
export const eyeOf = async (page) => numbers((await get(page, 'eye')) || '0,0,35');
export const targetOf = async (page) => numbers((await get(page, 'target')) || '0,0,0');
export const goHome = async (page) => {
  await set(page, 'eye', '0,0,35');
  await set(page, 'target', '0,0,0');
};
