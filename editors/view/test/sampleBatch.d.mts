// The types of the encoder.
export interface TestSample {
  t: number;
  joints: readonly number[];
  speed?: number;
  phase?: number;
  tool?: number;
  source?: number;
  limit?: number;
}
export function encoded(list: readonly TestSample[]): Buffer;
