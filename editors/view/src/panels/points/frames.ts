// Frame in which a point is taught.

import { type PointName, pointText } from "./edits";

/** Frame; `undefined` for the present father of the point. */
export type ChosenFrame = PointName | undefined;

const WORLD: PointName = { name: "world", key: null };

/** Returns the frames in which a point can be taught, without its present father: world, and the frames of its application or library. */
export function framesFor({ name, father }: { name: string; father: string | null }, frames: readonly PointName[]): PointName[] {
  const library = libraryOf(name);
  const present = father ?? WORLD.name;
  return [WORLD, ...frames.filter((frame) => libraryOf(frame.name) === library)].filter((frame) => wireText(frame) !== present);
}

/** Arguments of `teach` for a frame. */
export function frameArguments(frame: ChosenFrame): { frame?: PointName } {
  return frame === undefined ? {} : { frame: { name: frame.name, key: frame.key } };
}

export function frameText(frame: ChosenFrame, father: string | null): string {
  return frame === undefined ? father ?? WORLD.name : pointText(frame);
}

function libraryOf(name: string): string {
  return name.includes(":") ? name.slice(0, name.indexOf(":")) : "";
}

/** Formats a name as in `father` of a point. */
function wireText({ name, key }: PointName): string {
  return key === null ? name : `${name}[${key}]`;
}
