// Lines of several pixels, all of one kind in one buffer.

import { InstancedInterleavedBuffer, InterleavedBufferAttribute } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

/** Numbers of a segment: its start and its end. */
const SIZE = 6;

export interface LineLook {
  width: number;
  dash?: number;
  opacity?: number;
  isOnTop?: boolean;
}

export class Lines {
  readonly object: LineSegments2;
  count = 0;
  private positions = new Float32Array(0);
  private colours = new Float32Array(0);
  private uploaded = 0;

  constructor({ width, dash, opacity = 1, isOnTop = false }: LineLook) {
    const material = new LineMaterial({
      vertexColors: true, linewidth: width, dashed: dash !== undefined, dashSize: dash ?? 1, gapSize: (dash ?? 1) * 0.7,
      transparent: opacity < 1, opacity, depthTest: !isOnTop,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = isOnTop ? 5 : 1;
    this.reserve(64);
  }

  add(from: ArrayLike<number>, to: ArrayLike<number>, [r, g, b]: readonly [number, number, number]): void {
    if ((this.count + 1) * SIZE > this.positions.length) {
      this.reserve(this.count * 2);
    }
    this.positions.set([from[0] ?? 0, from[1] ?? 0, from[2] ?? 0, to[0] ?? 0, to[1] ?? 0, to[2] ?? 0], this.count * SIZE);
    this.colours.set([r, g, b, r, g, b], this.count * SIZE);
    this.count += 1;
  }

  clear(): void {
    this.count = 0;
    this.uploaded = 0;
  }

  /** The position at an end of a segment. */
  end(index: number): readonly [number, number, number] {
    const at = index * SIZE + 3;
    return [this.positions[at] ?? 0, this.positions[at + 1] ?? 0, this.positions[at + 2] ?? 0];
  }

  /** Uploads what has been added, and shows the first segments. */
  show(count = this.count): void {
    const { geometry } = this.object;
    if (this.uploaded < this.count) {
      for (const name of ["instanceStart", "instanceColorStart"]) {
        const { data } = geometry.getAttribute(name) as InterleavedBufferAttribute;
        data.addUpdateRange(this.uploaded * SIZE, (this.count - this.uploaded) * SIZE);
        data.needsUpdate = true;
      }
      this.uploaded = this.count;
      if (this.object.material.dashed) {
        this.object.computeLineDistances();
      }
    }
    geometry.instanceCount = count;
    this.object.visible = count > 0;
  }

  private reserve(segments: number): void {
    const [positions, colours] = [new Float32Array(segments * SIZE), new Float32Array(segments * SIZE)];
    positions.set(this.positions);
    colours.set(this.colours);
    [this.positions, this.colours, this.uploaded] = [positions, colours, 0];
    const geometry = new LineSegmentsGeometry();
    for (const [values, start, end] of [[positions, "instanceStart", "instanceEnd"], [colours, "instanceColorStart", "instanceColorEnd"]] as const) {
      const buffer = new InstancedInterleavedBuffer(values, SIZE, 1);
      geometry.setAttribute(start, new InterleavedBufferAttribute(buffer, 3, 0));
      geometry.setAttribute(end, new InterleavedBufferAttribute(buffer, 3, 3));
    }
    this.object.geometry.dispose();
    this.object.geometry = geometry;
  }
}
