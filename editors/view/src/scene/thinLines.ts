// Lines that are one pixel wide, of which hundreds of thousands are drawn quickly.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { Segments, SIZE } from "./segments";

export class ThinLines {
  readonly object = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
  /** The segments after the shown ones, faint. */
  readonly rest = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.5 }));
  readonly segments = new Segments();
  private shown: Float32Array | undefined;

  constructor() {
    this.object.frustumCulled = false;
    this.rest.frustumCulled = false;
  }

  /** Uploads the changes, and shows the first segments. The others are faint. */
  show(count: number): void {
    const { segments, object: { geometry } } = this;
    if (this.shown !== segments.positions) {
      const [positions, colours] = [new BufferAttribute(segments.positions, 3), new BufferAttribute(segments.colours, 3)];
      for (const part of [geometry, this.rest.geometry]) {
        part.dispose();
        part.setAttribute("position", positions);
        part.setAttribute("color", colours);
      }
      this.shown = segments.positions;
    } else if (segments.changed < segments.count) {
      for (const name of ["position", "color"]) {
        const attribute = geometry.getAttribute(name) as BufferAttribute;
        attribute.addUpdateRange(segments.changed * SIZE, (segments.count - segments.changed) * SIZE);
        attribute.needsUpdate = true;
      }
    }
    segments.changed = segments.count;
    geometry.setDrawRange(0, count * 2);
    this.rest.geometry.setDrawRange(count * 2, (segments.count - count) * 2);
    this.object.visible = count > 0;
    this.rest.visible = count < segments.count;
  }
}
