import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { armFrames, type Chain } from "../../src/kinematics";
import { composed, frameOf, IDENTITY } from "../../src/panels/pendant/pose";
import { reachOutline } from "../../src/scene/reach";

const ARMS = (JSON.parse(readFileSync(join(process.cwd(), "test/scene/armCapsules.json"), "utf8")) as { arm: Chain }[]).map(({ arm }) => arm);
const TOOLS = [[0, 0, 0, 0, 0, 0], [0, 0, 300, 0, 0, 0], [150, -80, 60, 0, 45, 0]];

/** A generator of numbers from 0 to 1 that repeats. */
function random(): () => number {
  let state = 1;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

test("positions of a tool are within its reach, and close to its border in some postures", () => {
  for (const arm of ARMS) {
    for (const tool of TOOLS) {
      const outline = reachOutline(arm, tool);
      const centre = arm.links[0]?.offset[2] ?? 0;
      const lengths = outline.map(([distance, height]) => Math.hypot(distance, height - centre));
      const next = random();
      let most = 0;
      for (let count = 0; count < 20_000; count += 1) {
        const joints = arm.axes.map(({ min, max }) => min + next() * (max - min));
        const [x, y, z] = composed(armFrames(arm, IDENTITY, joints).flange, frameOf(tool)).position;
        const [distance, height] = [Math.hypot(x, y), z - centre];
        const direction = (Math.atan2(distance, -height) / Math.PI) * (lengths.length - 1);
        const around = [-1, 0, 1, 2].map((step) => lengths[Math.floor(direction) + step] ?? 0);
        most = Math.max(most, Math.hypot(distance, height) / Math.max(...around));
      }
      assert.ok(most > 0.9 && most < 1.03, `${arm.axes.length} axes, tool ${tool.join()}: ${most}`);
    }
  }
});
