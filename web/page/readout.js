// The read-out: frames per second and the settings that matter most, in the page's corner and in its title.

const numericsText = ({ measured, holds }) => (!measured ? 'not measured' : holds ? 'exact' : 'NOT exact');

const rateText = (fps) => (fps <= 0 ? '–' : fps < 9.95 ? fps.toFixed(1) : String(Math.round(fps)));

/** Shows how things stand; `settings` is a Map of key → text, `scale` the picture's resolution over the canvas'. */
export function showReadout({ title, fps, settings, scale, width, height }) {
  const traced = [width, height].map((length) => Math.max(1, Math.round(length * scale))).join(' × ');
  const parts = [`depth ${settings.get('depth')}`, `shadows ${settings.get('shadows')}`, traced];
  if (settings.get('pause') === 'on') parts.push('paused');
  document.title = title;
  document.getElementById('fps').textContent = rateText(fps);
  document.getElementById('state').textContent = parts.map((part) => ` · ${part}`).join('');
}

/** Adds how exact the numbers are; the details lie under the pointer. */
export function showNumerics(numerics) {
  const element = document.getElementById('numerics');
  element.textContent = ` · numerics ${numericsText(numerics)}`;
  element.title = numerics.summary;
  element.classList.toggle('wrong', numerics.measured && !numerics.holds);
}
