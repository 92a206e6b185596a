// Corners of the boxes around drawn parts.

import { Box3, type Group } from "three";

export function corners(groups: readonly (Group | undefined)[]): [x: number, y: number, z: number][] {
  const parts = groups.flatMap((group) => group?.children ?? []);
  parts.forEach((part) => part.updateMatrixWorld(true));
  const boxes = parts.map((part) => new Box3().setFromObject(part)).filter((box) => !box.isEmpty());
  return boxes.flatMap(({ min, max }) => [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z): [number, number, number] => [x, y, z]))));
}
