// Colours of the drawing. The colours of phases are distinguishable with all kinds of colour blindness (Okabe and Ito).

export interface Look {
  body: number;
  joint: number;
  accent: number;
  gridFine: number;
  gridCoarse: number;
  /** Things around the arm. */
  object: number;
  point: number;
  selected: number;
  /** Points out of reach. */
  unreachable: number;
  sky: number;
  ground: number;
}

export const LIGHT: Look = {
  body: 0xf2f3f4, joint: 0x59636e, accent: 0xf2b705, gridFine: 0xd3d9e0, gridCoarse: 0xaab4bf,
  object: 0xb8c0c8, point: 0x3b4652, selected: 0xd6007f, unreachable: 0xc62828, sky: 0xffffff, ground: 0xaab2bb,
};
export const DARK: Look = {
  body: 0xd9dde2, joint: 0x57616c, accent: 0xf2b705, gridFine: 0x232b34, gridCoarse: 0x3c4854,
  object: 0x6f7a86, point: 0xb9c4d0, selected: 0xff6ec7, unreachable: 0xff5252, sky: 0xdfe8f2, ground: 0x39424c,
};

const PHASES = new Map([
  ["nominal", 0x0072b2], ["blend", 0xe69f00], ["alter", 0xcc79a7], ["connection", 0x009e73],
  ["compliant", 0x56b4e9], ["stopping", 0xd55e00], ["waiting", 0x8a949e],
]);

export function phaseColour(phase: string | undefined): number {
  return PHASES.get(phase ?? "") ?? 0x8a949e;
}

export function css(colour: number): string {
  return `#${colour.toString(16).padStart(6, "0")}`;
}

/**
 * Spheres in which a queued move leaves its segment before the target and reaches the next segment, and spheres of both.
 * No phase has these colours.
 */
export const CORNERS = { leave: 0xf0e442, reach: 0x7a4fbf, both: 0x8fa83a } as const;

/** Colours of the axes x, y and z. */
export const AXES = [0xd8453a, 0x3a9d4a, 0x3f7fe0] as const;
