// Framing of debug adapter messages: a header with `Content-Length`, an empty line, the message.

const SEPARATOR = "\r\n\r\n";

export function frame(message: unknown): Buffer {
  const body = Buffer.from(JSON.stringify(message));
  return Buffer.concat([Buffer.from(`Content-Length: ${body.length}${SEPARATOR}`), body]);
}

/** Collects bytes and forwards each complete message. */
export class MessageReader {
  private rest = Buffer.alloc(0);

  constructor(private readonly receive: (message: unknown) => void) {}

  /** Adds bytes. Throws if they are not messages. */
  push(bytes: Buffer): void {
    this.rest = Buffer.concat([this.rest, bytes]);
    for (let next = this.take(); next !== undefined; next = this.take()) {
      this.receive(JSON.parse(next.toString()));
    }
  }

  private take(): Buffer | undefined {
    const end = this.rest.indexOf(SEPARATOR);
    if (end < 0) {
      return undefined;
    }
    const header = this.rest.subarray(0, end).toString();
    const length = /^content-length: *(\d+)$/im.exec(header)?.[1];
    if (length === undefined) {
      throw new Error(`The debug adapter has sent a message without its length: ${header}`);
    }
    const start = end + SEPARATOR.length;
    const next = start + Number(length);
    if (this.rest.length < next) {
      return undefined;
    }
    const body = this.rest.subarray(start, next);
    this.rest = this.rest.subarray(next);
    return body;
  }
}
