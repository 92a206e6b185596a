// Poses as in VAL 3: [x, y, z, rx, ry, rz] in mm and degrees, with the rotation Rx * Ry * Rz.

export type Vector = readonly [number, number, number];
/** Rows of a rotation matrix. */
export type Rotation = readonly [Vector, Vector, Vector];

export interface Frame {
  position: Vector;
  rotation: Rotation;
}

export const IDENTITY: Frame = { position: [0, 0, 0], rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] };
const DEGREE = Math.PI / 180;

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function add(a: Vector, b: Vector, factor = 1): Vector {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}

export function scaled(a: Vector, factor: number): Vector {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function turned(rotation: Rotation, vector: Vector): Vector {
  return [dot(rotation[0], vector), dot(rotation[1], vector), dot(rotation[2], vector)];
}

export function transposed([a, b, c]: Rotation): Rotation {
  return [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]];
}

export function multiplied(left: Rotation, right: Rotation): Rotation {
  const columns = transposed(right);
  const row = (values: Vector): Vector => [dot(values, columns[0]), dot(values, columns[1]), dot(values, columns[2])];
  return [row(left[0]), row(left[1]), row(left[2])];
}

export function composed(left: Frame, right: Frame): Frame {
  return {
    position: add(left.position, turned(left.rotation, right.position)),
    rotation: multiplied(left.rotation, right.rotation),
  };
}

export function inverse({ position, rotation }: Frame): Frame {
  const back = transposed(rotation);
  return { position: scaled(turned(back, position), -1), rotation: back };
}

/** Returns the rotation around an axis with length 1. */
export function aroundAxis([x, y, z]: Vector, degrees: number): Rotation {
  const [s, c] = [Math.sin(degrees * DEGREE), Math.cos(degrees * DEGREE)];
  const t = 1 - c;
  return [
    [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
    [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
    [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
  ];
}

/** Returns the axis of a rotation, multiplied by its angle in degrees. */
export function rotationVector(rotation: Rotation): Vector {
  const [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = rotation;
  const sine: Vector = [(zy - yz) / 2, (xz - zx) / 2, (yx - xy) / 2];
  const length = Math.hypot(...sine);
  const angle = Math.atan2(length, (xx + yy + zz - 1) / 2) / DEGREE;
  return length < 1e-12 ? [0, 0, 0] : scaled(sine, angle / length);
}

export function frameOf(pose: readonly number[]): Frame {
  const [x = 0, y = 0, z = 0, rx = 0, ry = 0, rz = 0] = pose;
  const rotation = multiplied(aroundAxis([1, 0, 0], rx), multiplied(aroundAxis([0, 1, 0], ry), aroundAxis([0, 0, 1], rz)));
  return { position: [x, y, z], rotation };
}

export function poseOf({ position, rotation }: Frame): number[] {
  const [[xx, xy, xz], [yx, yy, yz], [, , zz]] = rotation;
  const ry = Math.asin(Math.max(-1, Math.min(1, xz)));
  const isPole = Math.abs(xz) > 1 - 1e-12;
  const rx = isPole ? Math.atan2(yx, yy) * Math.sign(xz) : Math.atan2(-yz, zz);
  const rz = isPole ? 0 : Math.atan2(-xy, xx);
  return [...position, rx / DEGREE, ry / DEGREE, rz / DEGREE];
}
