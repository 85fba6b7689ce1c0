// The laboratory's program as a JavaScript object, see module.js: web/lab_exports.cpp, and web/bench_exports.cpp, where
// the order of use stands.

import { linesOf, pairsOf } from './module.js';

/** What came of a step, as BenchStep in lab/bench/bench_run.h. */
export const BenchStep = { working: 0, stepped: 1, finished: 2 };

export function labCalls(module) {
  const { call, callForText, callWithBytes, readback } = module;
  return {
    ...module,

    numerics: () => JSON.parse(callForText('measureNumerics')),
    /** Answers { problems, answers }: eight numbers a ray, in and out. */
    traceRays(json, rays) {
      const bytes = new Uint8Array(rays.buffer, rays.byteOffset, rays.byteLength);
      const problems = callWithBytes('traceRays', json, bytes, rays.length / 8);
      return { problems, answers: readback('tracedRays', Float32Array).data };
    },

    plan: (scenes, settings, baseline, place) => callForText('benchPlan', scenes, settings, baseline, place),
    planned() {
      const pairs = pairsOf(callForText('benchPlanned'));
      const of = (name) => pairs.filter(([key]) => key === name).map(([, value]) => value);
      return { scenes: of('scenes'), values: Object.fromEntries(pairsOf(of('values').join('\n'))), rows: of('rows') };
    },
    scene: (json, name) => callForText('benchScene', json, name),
    imageNames: () => linesOf(callForText('benchImageNames')),
    give: (name, bytes, width) => callWithBytes('benchImage', name, bytes, bytes.length, width),
    begin: (clockStep) => callForText('benchBegin', clockStep),
    leaveOut: (row) => call('benchLeaveOut', row),
    prepare: () => call('benchPrepare'),
    continueFrom: (series) => callForText('benchContinue', series),
    series: () => callForText('benchSeries'),
    start: (rounds, sessions, seconds) => call('benchStart', rounds, sessions, seconds),
    step: () => call('benchMeasure'),
    row: () => call('benchRow'),
    drawn: () => call('benchDrawn'),
    rounds: () => call('benchRounds'),
    problems: () => callForText('benchProblems'),
    results: (context, contexts, environment, command) =>
      JSON.parse(callForText('benchResults', context, contexts, environment, command)),
  };
}
