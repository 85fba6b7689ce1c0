// Star colour: from the catalogue's colour index to linear sRGB.
//
// temperatureOf(bv)            kelvin from B-V (Ballesteros 2012)
// blackbodyColor(temperature)  linear sRGB of luminance 1, none below zero
//
// Planck's law, summed over the CIE 1931 observer in the fits of Wyman, Sloan and Shirley 2013.

export function temperatureOf(bv) {
  const x = 0.92 * Math.min(2.2, Math.max(-0.4, bv));
  return 4600 * (1 / (x + 1.7) + 1 / (x + 0.62));
}

const lobe =
  (nm, height, center, below, above) => height * Math.exp(-0.5 * ((nm - center) * (nm < center ? below : above)) ** 2);
const observer = (nm) => [
  lobe(nm, 0.362, 442, 0.0624, 0.0374) + lobe(nm, 1.056, 599.8, 0.0264, 0.0323) - lobe(nm, 0.065, 501.1, 0.049, 0.0382),
  lobe(nm, 0.821, 568.8, 0.0213, 0.0247) + lobe(nm, 0.286, 530.9, 0.0613, 0.0322),
  lobe(nm, 1.217, 437, 0.0845, 0.0278) + lobe(nm, 0.681, 459, 0.0385, 0.0725),
];

export function blackbodyColor(temperature) {
  let X = 0, Y = 0, Z = 0;
  for (let nm = 380; nm <= 780; nm += 5) {
    const radiance = Math.pow(nm / 560, -5) / (Math.exp(14387768.8 / (nm * temperature)) - 1);
    const [x, y, z] = observer(nm);
    X += radiance * x; Y += radiance * y; Z += radiance * z;
  }
  return [
    3.2406 * X - 1.5372 * Y - 0.4986 * Z,
    -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
    0.0557 * X - 0.204 * Y + 1.057 * Z,
  ].map((c) => Math.max(0, c / Y));
}
