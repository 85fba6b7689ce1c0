// A scene as the text of its file: one line for each light, material, definition and object; short numbers.
const rounded = (key, value) => (typeof value === 'number' ? Number(value.toPrecision(7)) : value);

export const line = (value) =>
  JSON.stringify(value, rounded).replace(/"((?:[^"\\]|\\.)*)":/g, '"$1": ').replace(/,(?=["[{\d-])/g, ', ');

function listed(value, key) {
  if (Array.isArray(value) && ['lights', 'objects'].includes(key))
    return `[\n${value.map((one) => `    ${line(one)}`).join(',\n')}\n  ]`;
  if (['materials', 'definitions'].includes(key))
    return `{\n${Object.entries(value)
      .map(([name, one]) => `    ${JSON.stringify(name)}: ${line(one)}`)
      .join(',\n')}\n  }`;
  return line(value);
}

export const sceneText = (scene) =>
  `{\n${Object.entries({ $schema: 'scene.schema.json', ...scene })
    .map(([key, value]) => `  ${JSON.stringify(key)}: ${listed(value, key)}`)
    .join(',\n')}\n}\n`;
