// Lines with a width of several pixels, all with the same properties in one buffer.

import { InstancedInterleavedBuffer, InterleavedBufferAttribute } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { Segments, SIZE } from "./segments";

export interface LineLook {
  width: number;
  dash?: number;
  opacity?: number;
  isOnTop?: boolean;
}

export class Lines {
  readonly object: LineSegments2;
  readonly segments = new Segments();
  private shown: Float32Array | undefined;

  constructor({ width, dash, opacity = 1, isOnTop = false }: LineLook) {
    const material = new LineMaterial({
      vertexColors: true, linewidth: width, dashed: dash !== undefined, dashSize: dash ?? 1, gapSize: (dash ?? 1) * 0.7,
      transparent: opacity < 1, opacity, depthTest: !isOnTop,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = isOnTop ? 5 : 1;
    this.show();
  }

  /** Uploads the changes, and shows all segments. */
  show(): void {
    const { segments, object } = this;
    if (this.shown !== segments.positions) {
      this.renew();
    }
    if (segments.changed < segments.count) {
      for (const name of ["instanceStart", "instanceColorStart"]) {
        const { data } = object.geometry.getAttribute(name) as InterleavedBufferAttribute;
        data.addUpdateRange(segments.changed * SIZE, (segments.count - segments.changed) * SIZE);
        data.needsUpdate = true;
      }
      segments.changed = segments.count;
      if (object.material.dashed) {
        object.computeLineDistances();
      }
    }
    object.geometry.instanceCount = segments.count;
    object.visible = segments.count > 0;
  }

  /** Creates the geometry again after the arrays have grown. */
  private renew(): void {
    const { positions, colours } = this.segments;
    const geometry = new LineSegmentsGeometry();
    for (const [values, start, end] of [[positions, "instanceStart", "instanceEnd"], [colours, "instanceColorStart", "instanceColorEnd"]] as const) {
      const buffer = new InstancedInterleavedBuffer(values, SIZE, 1);
      geometry.setAttribute(start, new InterleavedBufferAttribute(buffer, 3, 0));
      geometry.setAttribute(end, new InterleavedBufferAttribute(buffer, 3, 3));
    }
    this.object.geometry.dispose();
    this.object.geometry = geometry;
    this.segments.changed = 0;
    this.shown = positions;
  }
}
