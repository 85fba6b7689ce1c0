// Settings by the names people read: the key's words, unless it is short for something.
const spoken = { aov: 'Output', fov: 'Field of view' };

export const label = (key) => spoken[key] ?? key.replaceAll('-', ' ').replace(/^./, (letter) => letter.toUpperCase());
