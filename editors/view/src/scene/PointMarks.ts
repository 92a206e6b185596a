// Points of the cell as small solids with names.

import { Color, InstancedMesh, Matrix4, MeshBasicMaterial, OctahedronGeometry } from "three";
import { type PointName, pointText } from "../panels/points/edits";
import type { CellPoint } from "../panels/shared/cell";
import type { Label } from "./Labels";
import type { Look } from "./palette";

/** Largest number of drawn points. */
const MOST = 4000;

export class PointMarks {
  readonly object = new InstancedMesh(new OctahedronGeometry(1, 0), new MeshBasicMaterial(), MOST);
  labels: readonly Label[] = [];
  private placed: readonly unknown[] = [];

  constructor() {
    this.object.count = 0;
    this.object.frustumCulled = false;
  }

  /** Places the points with a size in mm if something has changed. */
  place(points: readonly CellPoint[], chosen: PointName | undefined, unreachable: ReadonlyMap<string, string>, size: number, look: Look): void {
    const wanted = [points, chosen, unreachable, size, look];
    if (wanted.every((value, index) => value === this.placed[index])) {
      return;
    }
    this.placed = wanted;
    const drawn = points.slice(0, MOST);
    this.labels = drawn.map((point, index): Label => {
      const name = pointText(point);
      const isChosen = chosen !== undefined && pointText(chosen) === name;
      const isFar = unreachable.has(name);
      const [x = 0, y = 0, z = 0] = point.pose;
      const scale = isChosen ? size * 1.7 : size;
      this.object.setMatrixAt(index, new Matrix4().makeScale(scale, scale, scale).setPosition(x, y, z));
      this.object.setColorAt(index, new Color(isFar ? look.unreachable : isChosen ? look.selected : look.point));
      return { text: isFar ? `${name} (out of reach)` : name, at: point.pose, kind: isChosen ? "selected" : "point" };
    });
    this.object.count = drawn.length;
    this.object.instanceMatrix.needsUpdate = true;
    if (this.object.instanceColor !== null) {
      this.object.instanceColor.needsUpdate = true;
    }
  }
}
