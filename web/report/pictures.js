// Pictures of rows: each beside its reference and their difference, made so bright that it can be seen.

import { element } from './elements.js';

const mostFactor = 128;

/** Finds the picture of a row (an object by column key) of a table. */
export function picturesOf(results, table) {
  const keys = table.columns.slice(0, table.keys ?? 0).map(({ key }) => key);
  const pictures = (results.pictures ?? []).filter((picture) => picture.table === table.name);
  const byRow = new Map(pictures.map((picture) => [JSON.stringify(picture.row), picture]));
  return {
    all: pictures,
    images: results.images ?? [],
    of: (row) => byRow.get(JSON.stringify(keys.map((key) => row[key]))),
  };
}

async function pixelsOf(address) {
  const image = element('img', { src: address });
  await image.decode();
  const canvas = element('canvas', { width: image.naturalWidth, height: image.naturalHeight });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** The greatest power of two with which all but a thousandth of the differences stay below white. */
function factorFor(differences) {
  const sorted = Uint8Array.from(differences).sort();
  const most = sorted[Math.floor(0.999 * (sorted.length - 1))] || sorted.at(-1);
  return most ? Math.min(mostFactor, 2 ** Math.floor(Math.log2(255 / most))) : 1;
}

/** Draws |a − b|, magnified, into the canvas; answers what to say of it. */
async function drawDifference(canvas, a, b) {
  const [from, to] = await Promise.all([pixelsOf(a), pixelsOf(b)]);
  Object.assign(canvas, { width: from.width, height: from.height });
  if (from.width !== to.width || from.height !== to.height) return 'of another size';
  const differences = from.data.map((value, i) => Math.abs(value - to.data[i]));
  const factor = factorFor(differences);
  const most = differences.reduce((a, b) => Math.max(a, b), 0);
  const pixels = new ImageData(
    differences.map((value, i) => (i % 4 === 3 ? 255 : Math.min(255, factor * value))),
    from.width,
  );
  canvas.getContext('2d').putImageData(pixels, 0, 0);
  return most ? `difference × ${factor}, at most ${most} of 255` : 'no difference';
}

/** The difference as a figure; it says what it is once it is drawn. */
function differenceOf(picture, images) {
  const canvas = element('canvas', {
    role: 'img',
    ariaLabel: `Difference: ${picture.title} and ${picture.reference.title}`,
  });
  const words = element('figcaption', { textContent: 'difference' });
  drawDifference(canvas, images[picture.image], images[picture.reference.image]).then(
    (text) => {
      words.textContent = text;
    },
    () => {
      words.textContent = 'a picture cannot be read';
    },
  );
  return element('figure', {}, canvas, words);
}

const shownImage = (address, title) =>
  element('figure', {}, element('img', { src: address, alt: title }), element('figcaption', { textContent: title }));

/** Picture, reference and difference side by side; only the picture where it is held against nothing. */
export function tripleOf(picture, images) {
  const parts = [shownImage(images[picture.image], picture.title)];
  if (picture.reference)
    parts.push(shownImage(images[picture.reference.image], picture.reference.title), differenceOf(picture, images));
  return element('div', { className: 'triple' }, ...parts);
}

/** Opens the three over the page. */
export function openPicture(picture, images) {
  const close = element('button', { type: 'button', className: 'close', textContent: '×', ariaLabel: 'Close' });
  const dialog = element(
    'dialog',
    { className: 'pictures', ariaLabel: picture.title },
    close,
    tripleOf(picture, images),
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close()); // the backdrop
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}

/** Shows the three in a corner while a pointer rests on what they are of; nothing where `picture` is undefined. */
export function peekAt(picture, images) {
  const shown = document.querySelector('.peek');
  if (shown?.picture === picture) return;
  shown?.remove();
  if (picture)
    document.body.append(
      Object.assign(element('aside', { className: 'peek' }, tripleOf(picture, images)), { picture }),
    );
}

/** All pictures of a table, under each reference those that are held against it. */
export function galleryOf(pictures, heading) {
  const groups = new Map();
  const references = new Set(pictures.all.map(({ reference }) => reference?.image));
  for (const picture of pictures.all) {
    if (!picture.reference && references.has(picture.image)) continue; // stands there as what others are held against
    const of = picture.reference ? `${picture.reference.image} ${picture.reference.title}` : '';
    groups.set(of, [...(groups.get(of) ?? []), picture]);
  }
  const cardOf = (picture) => {
    const open = element(
      'button',
      { type: 'button', title: 'Show it beside its reference' },
      shownImage(pictures.images[picture.image], picture.title),
    );
    open.addEventListener('click', () => openPicture(picture, pictures.images));
    return element('li', {}, open, ...(picture.reference ? [differenceOf(picture, pictures.images)] : []));
  };
  const lists = [...groups.values()].map((group) => {
    const { reference } = group[0];
    const head = reference
      ? [
          element(
            'li',
            { className: 'reference' },
            shownImage(pictures.images[reference.image], `held against: ${reference.title}`),
          ),
        ]
      : [];
    return element('ul', {}, ...head, ...group.map(cardOf));
  });
  const note =
    'Below a picture: how its channels differ from those of the picture it is held against, ' +
    'times what is written there.';
  return element(
    'section',
    { className: 'gallery' },
    element(heading, { textContent: 'Pictures' }),
    element('p', { className: 'note', textContent: note }),
    ...lists,
  );
}
