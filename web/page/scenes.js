// The list of scenes: what the folder's index tells, and the one in place.

/**
 * @param index Promise of [{ name, title, description }, …]
 * @param load called with the name that the user chose; a Promise that fails where it cannot be loaded
 * @returns { show(name), names() → Promise of all names }
 */
export function sceneChooser(select, index, load) {
  let current = null;

  const show = (name) => {
    current = name;
    if (![...select.options].some((option) => option.value === name)) select.append(new Option(name, name));
    select.value = name;
  };

  index.then((scenes) => {
    select.replaceChildren(
      ...scenes.map(({ name, title, description }) => {
        const option = new Option(title.split(':')[0], name); // "Lite: sun, planets …"
        option.title = [title, description].filter(Boolean).join('\n');
        return option;
      }),
    );
    if (current) show(current);
  });

  select.onchange = async () => {
    await load(select.value).catch(() => show(current));
    select.blur(); // keys go to the view again
  };

  return { show, names: async () => (await index).map(({ name }) => name) };
}
