// Memory of motion messages: parts that equal a part of the previous message are stored once. In an hour of motion they
// are most of the messages.

import type { MotionMessage } from "./wire";

/** Returns the message with the equal parts of the previous one. */
export function shared(message: MotionMessage, previous: MotionMessage | undefined): MotionMessage {
  const { path = [], queue = [] } = previous ?? {};
  return {
    ...message,
    path: message.path.map((piece) => path.find((known) => isEqual(known, piece)) ?? piece),
    queue: message.queue.map((move) => queue.find((known) => isEqual(known, move)) ?? move),
  };
}

/** Whether two values of messages are equal, at any depth. */
function isEqual(one: unknown, other: unknown): boolean {
  if (typeof one !== "object" || typeof other !== "object" || one === null || other === null) {
    return one === other;
  }
  if (Array.isArray(one)) {
    return Array.isArray(other) && one.length === other.length && one.every((value, index) => isEqual(value, other[index]));
  }
  const [entries, values] = [Object.entries(one), other as Record<string, unknown>];
  return entries.length === Object.keys(other).length && entries.every(([key, value]) => isEqual(value, values[key]));
}
