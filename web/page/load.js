// Loading files beside the page: with progress, and with an error that says which file and why.

const site = new URL('../', import.meta.url); // relative, so that the folder works under any path of any server

const sceneUrl = (name) => new URL(`assets/scenes/${encodeURIComponent(name)}.json`, site);
const imageUrl = (file) => new URL(`assets/textures/${file.split('/').map(encodeURIComponent).join('/')}`, site);

/** Files that an image's name may mean, as native/file/asset_folder.cpp has them: the first that exists is taken. */
const filesNamed = (name) =>
  /\.(png|jpe?g|hdr)$/i.test(name)
    ? [name]
    : ['.png', '.PNG', '.jpg', '.JPG', '.jpeg', '.JPEG'].map((ending) => name + ending);

async function get(url) {
  const name = url.pathname.split('/').slice(-1)[0];
  let response;
  try {
    response = await fetch(url);
  } catch {
    throw new Error(`${name}: the server does not answer; check that it still runs`);
  }
  if (response.ok) return response;
  throw Object.assign(new Error(`${name}: the server does not have it (${response.status})`), {
    status: response.status,
  });
}

/**
 * The response to a GET, whose bytes are counted as they come.
 * @param type media type of the answer, whatever the server calls it
 */
export async function fetchCounted(url, onBytes, type) {
  const response = await get(url);
  // Of the compressed bytes where they are: a hint only.
  const total = Number(response.headers.get('content-length')) || 0;
  let soFar = 0;
  const counter = new TransformStream({
    transform(chunk, out) {
      soFar += chunk.byteLength;
      onBytes(soFar, Math.max(soFar, total));
      out.enqueue(chunk);
    },
  });
  return new Response(response.body.pipeThrough(counter), { headers: { 'Content-Type': type } });
}

/** Text of the scene file. */
export async function fetchScene(name) {
  try {
    return await (await get(sceneUrl(name))).text();
  } catch (error) {
    throw error.status === 404 ? new Error(`there is no scene '${name}'`) : error;
  }
}

/**
 * Gives the tracer the files that a scene names: those from the scenes' folder. Of one that is missing the tracer tells
 * itself, when it takes the scene.
 */
export async function giveFiles(tracer, json) {
  for (const path of tracer.sceneFiles(json)) {
    const url = new URL(`assets/scenes/${path.split('/').map(encodeURIComponent).join('/')}`, site);
    try {
      tracer.giveFile(path, new Uint8Array(await (await get(url)).arrayBuffer()));
    } catch (error) {
      if (error.status !== 404) throw error;
    }
  }
}

/** [{ name, title, description }, …] of all scenes; empty where the list is missing. */
export async function fetchSceneIndex() {
  try {
    return await (await get(new URL('assets/scenes/index.json', site))).json();
  } catch {
    return []; // scenes still load by name
  }
}

/** The bytes of an image file, counted as they come. */
export async function fetchImage(name, onBytes) {
  const files = filesNamed(name);
  for (const file of files) {
    try {
      const response = await fetchCounted(imageUrl(file), onBytes, 'application/octet-stream');
      return new Uint8Array(await response.arrayBuffer());
    } catch (error) {
      if (error.status !== 404) throw error;
    }
  }
  throw new Error(`${name}: the server does not have it as ${files.join(', ')}`);
}

const isJpeg = (bytes) => bytes[0] === 0xff && bytes[1] === 0xd8;

/** The JPEG with its metadata as a comment: browsers would turn the picture as that says, the program does not. */
export function unturned(bytes) {
  const plain = bytes.slice();
  for (let at = 2; plain[at] === 0xff && plain[at + 1] < 0xff && plain[at + 1] !== 0xda; ) {
    if (plain[at + 1] === 0xe1) plain[at + 1] = 0xfe;
    at += 2 + 256 * plain[at + 2] + plain[at + 3];
  }
  return plain;
}

/**
 * Hands an image over: `give(name, bytes, width)` takes a file's bytes, or texels where there is a width. A JPEG is
 * decoded by the browser, once `measure(name, bytes)` has found nothing against it. Answers problems, '' of none.
 */
export async function handImage({ measure, give }, name, bytes) {
  if (!isJpeg(bytes)) return give(name, bytes, 0);
  const problems = measure(name, bytes);
  if (problems) return problems;
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
  const picture = await createImageBitmap(new Blob([unturned(bytes)]), options).catch(() => null);
  if (!picture) return `${name}: cannot be read as a picture (a broken JPEG)`;
  const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
  canvas.drawImage(picture, 0, 0);
  return give(name, canvas.getImageData(0, 0, picture.width, picture.height).data, picture.width);
}
