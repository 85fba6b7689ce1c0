// Materials that several scenes use.

/** Diffuse, with some of it in the shade. */
export const matte = (color, shade = 0.12) => ({
  ambient: color.map((c) => shade * c),
  diffuse: color.map((c) => 0.85 * c),
});

/** A mirror that reflects so much of each colour when looked at straight: of an index n without absorption. */
export const metal = (color) => ({
  specular: color.map((c) => 0.4 * c),
  shininess: 60,
  conductor: { n: color.map((c) => (1 + Math.sqrt(c)) / (1 - Math.sqrt(c))), k: 0 },
});

export const glossy = (color, coat = 1.5) => ({
  ...matte(color),
  specular: 0.4,
  shininess: 80,
  coat: { ior: coat },
});

export const glass = { specular: 0.6, shininess: 200, dielectric: { ior: 1.5 } };
