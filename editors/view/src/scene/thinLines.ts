// Lines with a width of one pixel, of which hundreds of thousands are drawn quickly.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { Segments, SIZE } from "./segments";

export class ThinLines {
  readonly object = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
  readonly segments = new Segments();
  private shown: Float32Array | undefined;

  constructor() {
    this.object.frustumCulled = false;
  }

  /** Uploads the changes, and shows the first segments. */
  show(count: number): void {
    const { segments, object: { geometry } } = this;
    if (this.shown !== segments.positions) {
      geometry.dispose();
      geometry.setAttribute("position", new BufferAttribute(segments.positions, 3));
      geometry.setAttribute("color", new BufferAttribute(segments.colours, 3));
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
    this.object.visible = count > 0;
  }
}
