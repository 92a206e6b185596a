// Part of a run, which a page that was opened late receives as one message (docs/src/view.md).

import { type Message, messageFrom, type RunMessage } from "./protocol";
import { framesIn } from "./recording";
import { RunLog } from "./runLog";

/** First byte of a message with a part. */
const KIND = 2;

/** Kind, three bytes, the number of messages in the state, and the begin time. */
const HEADER = 16;

/** Whether a binary message contains a part. */
export function isPart(bytes: Uint8Array): boolean {
  return bytes[0] === KIND && bytes.length >= HEADER;
}

/** Decodes a part. */
export function partOf(bytes: Uint8Array): RunLog {
  const reading = readPart(bytes);
  for (;;) {
    const { done, value } = reading.next();
    if (done === true) {
      return value;
    }
  }
}

/** Decodes a part, message by message. Its first messages are the complete state at its beginning. */
export function* readPart(bytes: Uint8Array): Generator<void, RunLog> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const part = new RunLog(view.getFloat64(8, true));
  let left = view.getUint32(4, true);
  for (const frame of framesIn(bytes.subarray(HEADER))) {
    const isState = left > 0;
    left -= 1;
    yield;
    if ("samples" in frame) {
      part.samples.add(frame.samples, isState);
      continue;
    }
    const message = messageFrom(frame.text);
    if (message?.kind === "rewind") {
      part.cut(message.t);
    } else if (message !== undefined && belongsToRun(message)) {
      part.add(message, isState);
    }
  }
  return part;
}

function belongsToRun(message: Message): message is RunMessage {
  return !["answer", "rewind", "select", "past"].includes(message.kind);
}
