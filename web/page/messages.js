// What the page says: short notes that go by themselves, problems that stay until closed, and the one message that is
// the end.

const noteSeconds = 2.6;
const mostNotes = 3;

/** @param root element with children .notes (polite live region) and .problems (alerts) */
export function messages(root) {
  const notes = root.querySelector('.notes');
  const problems = root.querySelector('.problems');

  const element = (tag, className, text) => {
    const made = document.createElement(tag);
    made.className = className;
    made.textContent = text;
    return made;
  };

  return {
    /** A change the user made or should know of. */
    note(text, seconds = noteSeconds) {
      // "depth 5" takes the place of "depth 4": a held key must not pile up notes.
      const topic = text.split(' ')[0];
      const same = [...notes.children].find((old) => old.dataset.topic === topic);
      same?.remove();
      const line = element('p', 'note', text);
      line.dataset.topic = topic;
      notes.append(line);
      while (notes.children.length > mostNotes) notes.firstChild.remove();
      setTimeout(() => line.remove(), seconds * 1000);
    },

    /** Something is wrong, the page goes on. */
    problem(text, { id } = {}) {
      if (id) this.clear(id);
      const box = element('div', 'problem', '');
      box.setAttribute('role', 'alert');
      if (id) box.dataset.id = id;
      const lines = element('div', 'lines', text.trim());
      const close = element('button', 'close', '×');
      close.setAttribute('aria-label', 'Close this message');
      close.onclick = () => box.remove();
      box.append(lines, close);
      problems.append(box);
    },

    clear(id) {
      [...problems.children].find((box) => box.dataset.id === id)?.remove();
    },

    /** Nothing can be drawn: the message takes the whole page. */
    fatal(title, text) {
      document.body.classList.add('fatal');
      const box = document.getElementById('splash');
      box.hidden = false;
      box.setAttribute('role', 'alert');
      box.querySelector('h1').textContent = title;
      box.querySelector('p').textContent = text;
    },
  };
}
