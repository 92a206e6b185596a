// Recorded run in the page: frames, compressed with gzip, in base64. A frame is `u8 type` (0 text, 1 samples), `u32
// length`, and its bytes.

export type Frame = { text: string } | { samples: ArrayBuffer };

export async function* framesOf(encoded: string): AsyncGenerator<Frame> {
  const packed = Uint8Array.from(atob(encoded.trim()), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  const view = new DataView(bytes);
  let at = 0;
  while (at + 5 <= bytes.byteLength) {
    const [type, length] = [view.getUint8(at), view.getUint32(at + 1, true)];
    const content = bytes.slice(at + 5, at + 5 + length);
    yield type === 0 ? { text: new TextDecoder().decode(content) } : { samples: content };
    at += 5 + length;
  }
}
