// Last bytes of sockets and serial lines, as text and in hexadecimal.

export interface Transfer {
  t: number;
  link: string;
  dir: "in" | "out";
  bytes: readonly number[];
}

/** Largest number of shown bytes of a transfer. */
const SHOWN = 64;

/** Formats printable characters unchanged, and other bytes in angle brackets: `OK<0d><0a>`. */
export function asText(bytes: readonly number[]): string {
  const text = bytes.slice(-SHOWN).map((byte) => (byte >= 32 && byte < 127 ? String.fromCharCode(byte) : `<${hex(byte)}>`)).join("");
  return bytes.length > SHOWN ? `…${text}` : text;
}

export function asHex(bytes: readonly number[]): string {
  const text = bytes.slice(-SHOWN).map(hex).join(" ");
  return bytes.length > SHOWN ? `… ${text}` : text;
}

function hex(byte: number): string {
  return byte.toString(16).padStart(2, "0");
}

/** Returns the last transfers of a channel up to a time, the newest first. */
export function lastTransfers(transfers: readonly Transfer[], link: string, end: number, count: number): Transfer[] {
  return transfers.filter((transfer) => transfer.link === link && transfer.t <= end).slice(-count).reverse();
}
