// Computes where a camera has to be to show all given positions within a free area of the picture.

type Position = readonly [number, number, number];

/** Unit vectors of a camera: to the right, up, and from the target to the camera. */
export interface Axes {
  across: Position;
  up: Position;
  back: Position;
}

export interface Lens {
  /** Tangent of half the vertical angle of view. */
  slope: number;
  /** Aspect ratio: width of the picture divided by its height. */
  aspect: number;
  isParallel: boolean;
}

/** Free area of the picture; the entire picture is -1 to 1 in both directions. */
export interface Area {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export interface Place {
  target: Position;
  /** Distance of the camera from the target, in mm. A parallel picture extends `distance * slope` above its centre. */
  distance: number;
}

/** Number of iterations after which the distance and the target have converged to far less than a pixel. */
const STEPS = 20;

/** Smallest distance in mm, for example for a single position. */
const NEAREST = 200;

export function fitted(positions: readonly Position[], axes: Axes, { slope, aspect, isParallel }: Lens, area: Area): Place {
  const seen = positions.map((position): Position => [dot(position, axes.across), dot(position, axes.up), dot(position, axes.back)]);
  const [left, bottom, far] = extreme(seen, Math.min);
  const [right, top, near] = extreme(seen, Math.max);
  const [width, height] = [area.right - area.left, area.top - area.bottom];
  const centre = [(area.left + area.right) / 2, (area.bottom + area.top) / 2] as const;
  const depth = (far + near) / 2;
  let distance = Math.max((right - left) / (aspect * width), (top - bottom) / height, NEAREST * slope) / slope;
  let [x, y] = [(left + right) / 2 - centre[0] * distance * slope * aspect, (bottom + top) / 2 - centre[1] * distance * slope];
  for (let step = 0; step < STEPS && !isParallel; step += 1) {
    const shown = seen.map(([px, py, pz]): Position => {
      const away = Math.max(distance - (pz - depth), 1) * slope;
      return [(px - x) / (away * aspect), (py - y) / away, 0];
    });
    const [least, most] = [extreme(shown, Math.min), extreme(shown, Math.max)];
    x += ((least[0] + most[0]) / 2 - centre[0]) * distance * slope * aspect;
    y += ((least[1] + most[1]) / 2 - centre[1]) * distance * slope;
    const factor = Math.max((most[0] - least[0]) / width, (most[1] - least[1]) / height);
    distance = Math.max(distance * Math.min(Math.max(factor, 0.8), 2), near - depth + NEAREST);
  }
  const target = [0, 1, 2].map((axis) => x * (axes.across[axis] ?? 0) + y * (axes.up[axis] ?? 0) + depth * (axes.back[axis] ?? 0));
  return { target: [target[0] ?? 0, target[1] ?? 0, target[2] ?? 0], distance };
}

export const WHOLE: Area = { left: -1, right: 1, bottom: -1, top: 1 };

/** Whether an area contains another area. */
export function contains(outer: Area, inner: Area): boolean {
  return outer.left <= inner.left && outer.right >= inner.right && outer.bottom <= inner.bottom && outer.top >= inner.top;
}

/** Returns the area between the bars over the picture. Bars that cover more than a third are ignored. */
export function areaBetween(height: number, bars: readonly { top: number; bottom: number }[]): Area {
  const third = height / 3;
  const above = Math.max(0, ...bars.map(({ bottom }) => bottom).filter((bottom) => bottom <= third));
  const below = Math.max(0, ...bars.map(({ top }) => height - top).filter((share) => share <= third));
  const margin = 0.94;
  return { left: -margin, right: margin, top: 1 - Math.max((2 * above) / height, 1 - margin), bottom: Math.max((2 * below) / height, 1 - margin) - 1 };
}

function dot(a: Position, b: Position): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Returns the least or the greatest coordinate in each direction. */
function extreme(positions: readonly Position[], choose: (a: number, b: number) => number): Position {
  return positions.reduce((found, position): Position => [choose(found[0], position[0]), choose(found[1], position[1]), choose(found[2], position[2])], positions[0] ?? [0, 0, 0]);
}
