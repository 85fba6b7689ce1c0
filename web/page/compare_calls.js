// The C interface of web/bench_host.cpp as a JavaScript object; the order of use stands there.

import { pairsOf } from './tracer.js';

/** What came of a step, as BenchStep in lab/bench/bench_run.h. */
export const BenchStep = { working: 0, stepped: 1, finished: 2 };

export function benchOf({ call, callForText, callWithBytes }) {
  return {
    plan: (scenes, settings, baseline, place) => callForText('benchPlan', scenes, settings, baseline, place),
    planned() {
      const pairs = pairsOf(callForText('benchPlanned'));
      const of = (name) => pairs.filter(([key]) => key === name).map(([, value]) => value);
      return { scenes: of('scenes'), values: Object.fromEntries(pairsOf(of('values').join('\n'))), rows: of('rows') };
    },
    scene: (json, name) => callForText('benchScene', json, name),
    imageNames: () => callForText('benchImageNames').split('\n').filter(Boolean),
    measure: (name, bytes) => callWithBytes('measureImageFile', name, bytes),
    give: (name, bytes, width) => callWithBytes('benchImage', name, bytes, bytes.length, width),
    begin: (clockStep, renderer) => callForText('benchBegin', clockStep, renderer),
    leaveOut: (row) => call('benchLeaveOut', row),
    prepare: () => call('benchPrepare'),
    continueFrom: (series) => callForText('benchContinue', series),
    series: () => callForText('benchSeries'),
    start: (rounds, sessions, seconds) => call('benchStart', rounds, sessions, seconds),
    measure: () => call('benchMeasure'),
    row: () => call('benchRow'),
    drawn: () => call('benchDrawn'),
    rounds: () => call('benchRounds'),
    problems: () => callForText('benchProblems'),
    results: (context, contexts, environment, command) =>
      JSON.parse(callForText('benchResults', context, contexts, environment, command)),
    end: () => call('benchEnd'),
  };
}
