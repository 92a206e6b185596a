// Area in which a pointer holds a pressed button.

export interface Area {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Distance around the button in which it stays held, in CSS pixels: a finger rolls while it presses. */
const SLACK = 8;

/** Whether a pointer at this place of the window still holds a button that had this area when it was pressed. */
export function isWithin({ left, right, top, bottom }: Area, x: number, y: number): boolean {
  return x >= left - SLACK && x <= right + SLACK && y >= top - SLACK && y <= bottom + SLACK;
}
