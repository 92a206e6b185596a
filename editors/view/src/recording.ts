// Messages in sequence, as recordings and blocks contain them. A frame is `u8 type` (0 text, 1 samples), `u32 length`, and
// its bytes. The recording in a page is compressed with gzip, in base64.

export type Frame = { text: string } | { samples: Uint8Array };

const DECODER = new TextDecoder();

/** Returns the frames of a recording. Samples are views into one buffer, so that they need no additional memory. */
export async function framesOf(encoded: string): Promise<Generator<Frame>> {
  const stream = new Blob([decoded(encoded.trim())]).stream().pipeThrough(new DecompressionStream("gzip"));
  return framesIn(new Uint8Array(await new Response(stream).arrayBuffer()));
}

/** Returns the frames in a sequence of bytes. */
export function* framesIn(bytes: Uint8Array): Generator<Frame> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  while (at + 5 <= bytes.length) {
    const [type, length] = [view.getUint8(at), view.getUint32(at + 1, true)];
    const content = bytes.subarray(at + 5, at + 5 + length);
    yield type === 0 ? { text: DECODER.decode(content) } : { samples: content };
    at += 5 + length;
  }
}

/** Decodes base64. `Uint8Array.from` with a function needed 2 s for an hour. */
function decoded(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let index = 0; index < text.length; index += 1) {
    bytes[index] = text.charCodeAt(index);
  }
  return bytes;
}
