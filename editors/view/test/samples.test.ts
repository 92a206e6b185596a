import assert from "node:assert/strict";
import { test } from "node:test";
import { Samples } from "../src/samples";
import { encoded } from "./sampleBatch.mjs";

/** Three batches with samples every 4 ms, and a gap before each batch. */
function threeBatches(): Samples {
  const samples = new Samples();
  for (const start of [0, 1, 2]) {
    samples.add(encoded(Array.from({ length: 5 }, (_, index) => ({ t: start + index * 0.004, joints: [index, 0], phase: 0 }))));
  }
  return samples;
}

const times = (samples: Samples, t: number): number[] => [...samples.after(t)].map((sample) => sample.t);

test("samples after any time are the later part of all samples", () => {
  const samples = threeBatches();
  const all = times(samples, -1);
  assert.equal(all.length, 15);
  for (const t of [-1, 0, 0.001, 0.004, 0.016, 0.5, 1, 1.008, 2.015, 2.016, 9]) {
    assert.deepEqual(times(samples, t), all.filter((time) => time > t), `${t}`);
  }
  assert.deepEqual(times(new Samples(), 0), []);
});

test("whatever discards samples begins another epoch", () => {
  const samples = threeBatches();
  const epochs = [samples.epoch];
  for (const discard of [() => samples.cut(1.5), () => samples.drop(1), () => samples.clear()]) {
    discard();
    epochs.push(samples.epoch);
  }
  assert.equal(new Set(epochs).size, epochs.length);
});

test("a batch that was read before it was cut is read again", () => {
  const samples = threeBatches();
  assert.equal(samples.at(2.016)?.joints[0], 4);
  samples.cut(2.004);
  assert.deepEqual(times(samples, 1.5), [2, 2.004]);
  assert.equal(samples.at(9)?.joints[0], 1);
});
