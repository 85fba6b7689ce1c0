// The loading bar: the mean of all tasks begun, with the label of the oldest one that is not done.

/** @returns task(label) → { at(fraction), named(label), done() } */
export function progressBar(bar, label) {
  const tasks = new Set();
  let finished = 0;

  const show = () => {
    const open = [...tasks];
    bar.hidden = label.hidden = open.length === 0;
    if (open.length === 0) {
      finished = 0;
      return;
    }
    const sum = open.reduce((total, task) => total + task.fraction, finished);
    bar.value = sum / (open.length + finished);
    label.textContent = open[0].label;
  };

  return (text) => {
    const task = { label: text, fraction: 0 };
    tasks.add(task);
    show();
    return {
      at(fraction) {
        task.fraction = Math.min(fraction, 1);
        show();
      },
      named(text) {
        if (text === task.label) return;
        task.label = text;
        show();
      },
      done() {
        if (tasks.delete(task)) finished += 1;
        show();
      },
    };
  };
}
