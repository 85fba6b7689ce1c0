// Scenes of Bézier surfaces: the Utah teapot, and a goblet whose circles are exact.

/** A glaze over a colour. */
const glazed = (color) => ({
  ambient: color.map((c) => 0.16 * c),
  diffuse: color.map((c) => 0.8 * c),
  specular: 0.5,
  shininess: 250,
  coat: { ior: 1.52 },
});
const gold = { specular: 0.6, shininess: 120, conductor: { n: [0.17, 0.35, 1.5], k: [3.1, 2.7, 1.9] } };
const silver = { specular: 0.6, shininess: 120, conductor: { n: [0.14, 0.16, 0.13], k: [4.1, 2.3, 3.1] } };
const tiles = (light, dark, scale) => ({
  ambient: 0.16,
  diffuse: 0.75,
  checker: { colors: [light, dark], scale },
  coat: { ior: 1.35 },
});

/** Newell's teapot, whose data has z up. */
export function teapot() {
  return {
    scene: {
      title: 'The Utah teapot: 32 patches, glazed',
      description: "Martin Newell's teapot of 1975 with Frank Crow's bottom, met by rays as the patches that it is.",
      camera: { eye: [3.4, 4.6, 8.4], target: [0.15, 1.25, 0], fov: 38 },
      background: { gradient: { top: [0.75, 0.82, 0.95], bottom: [0.42, 0.36, 0.32] } },
      lights: [
        { sphere: { center: [-5, 9, 6], radius: 1.2 }, color: [0.95, 0.9, 0.82] },
        { sphere: { center: [7, 6, 4], radius: 1.5 }, color: [0.25, 0.28, 0.34] },
      ],
      materials: {
        glaze: glazed([0.1, 0.3, 0.42]),
        floor: tiles([0.82, 0.78, 0.7], [0.52, 0.42, 0.34], 1.5),
        gold,
      },
      objects: [
        {
          group: { of: [{ surface: { file: 'teapot.bpt' } }], rotate: [-90, 0, 0] },
          material: 'glaze',
        },
        { plane: { point: [0, 0, 0], normal: [0, 1, 0] }, material: 'floor' },
        { sphere: { center: [3.1, 0.45, 2.2], radius: 0.45 }, material: 'gold' },
      ],
    },
  };
}

// Half a profile, from the middle of the foot's underside to that of the bowl, as cubic curves of radius and height.
const PROFILE = [
  [[0, 0], [0.4, 0], [0.8, 0], [1.15, 0]],
  [[1.15, 0], [1.3, 0], [1.3, 0.1], [1.12, 0.13]],
  [[1.12, 0.13], [0.7, 0.2], [0.16, 0.25], [0.14, 0.7]],
  [[0.14, 0.7], [0.13, 0.925], [0.34, 1], [0.34, 1.15]],
  [[0.34, 1.15], [0.34, 1.3], [0.13, 1.375], [0.14, 1.6]],
  [[0.14, 1.6], [0.16, 2.05], [0.94, 2.05], [1.15, 2.9]],
  [[1.15, 2.9], [1.26, 3.345], [1.16, 3.8], [1.08, 4.2]],
  [[1.08, 4.2], [1.065, 4.275], [1.005, 4.265], [1.02, 4.19]],
  [[1.02, 4.19], [1.098, 3.8], [1.2, 3.35], [1.09, 2.91]],
  [[1.09, 2.91], [0.92, 2.23], [0.4, 2.14], [0, 2.14]],
];

/** A quarter circle as a rational cubic, {across, along, weight}: that of degree 2, weights 1, √½, 1, raised by one. */
function quarter() {
  const w = 2 * Math.SQRT1_2;
  return [
    [1, 0, 1],
    [1, w / (1 + w), (1 + w) / 3],
    [w / (1 + w), 1, (1 + w) / 3],
    [0, 1, 1],
  ];
}

/** A profile turned about the y axis, as a BPT file of rational patches. */
function turned(profile) {
  const number = (x) => String(Number(x.toPrecision(12)) + 0);
  const lines = [String(4 * profile.length)];
  for (const curve of profile)
    for (let turn = 0; turn < 4; ++turn) {
      const [c, s] = [[1, 0], [0, 1], [-1, 0], [0, -1]][turn];
      lines.push('3 3');
      for (const [across, along, weight] of quarter())
        for (const [radius, height] of curve) {
          const [x, z] = [c * across - s * along, s * across + c * along];
          lines.push([radius * x, height, radius * z, weight].map(number).join(' '));
        }
    }
  return `${lines.join('\n')}\n`;
}

/** A goblet of gold, and one of silver lying beside it. */
export function goblet() {
  return {
    files: { 'goblet.bpt': turned(PROFILE) },
    scene: {
      title: 'Rational patches: goblets, whose circles are exact',
      description: 'Forty rational Bézier patches turned about an axis, drawn twice: a group and an affine map.',
      camera: { eye: [3.2, 4.6, 11], target: [1.1, 1.6, 0], fov: 36 },
      background: { gradient: { top: [0.55, 0.68, 0.9], bottom: [0.5, 0.4, 0.3] } },
      lights: [
        { sphere: { center: [-4, 9, 6], radius: 1 }, color: [0.9, 0.86, 0.78] },
        { sphere: { center: [8, 5, 3], radius: 1.5 }, color: [0.3, 0.32, 0.38] },
      ],
      materials: {
        gold,
        silver,
        floor: tiles([0.75, 0.72, 0.66], [0.3, 0.14, 0.12], 1.25),
        pearl: glazed([0.75, 0.7, 0.66]),
      },
      definitions: { goblet: { surface: { file: 'goblet.bpt' } } },
      objects: [
        { instance: { of: 'goblet', translate: [-1.1, 0, 0] }, material: 'gold' },
        {
          instance: { of: 'goblet', scale: [0.75, 0.75, 0.75], rotate: [0, 0, -85.9], translate: [1.35, 0.966, 0.9] },
          material: 'silver',
        },
        { plane: { point: [0, 0, 0], normal: [0, 1, 0] }, material: 'floor' },
        { sphere: { center: [0.4, 0.3, 2.2], radius: 0.3 }, material: 'pearl' },
        { sphere: { center: [1.05, 0.22, 2.6], radius: 0.22 }, material: 'pearl' },
        { sphere: { center: [-0.5, 0.2, 2.4], radius: 0.2 }, material: 'pearl' },
      ],
    },
  };
}
