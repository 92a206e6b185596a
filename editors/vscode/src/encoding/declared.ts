// Finds the encodings in which a file can be read, from its bytes. Pure functions.

const UTF8_MARK = [0xef, 0xbb, 0xbf];
const UTF16_MARKS = [[0xff, 0xfe], [0xfe, 0xff]];
/** Decodes every byte, so that any file can be read and saved unchanged. */
export const LATIN1 = "iso88591";
const DECLARATION = /^<\?xml[^>]*?\sencoding\s*=\s*["']([\w.:-]+)["']/i;
/** Number of bytes that contain the declaration. */
const HEAD = 200;
/** Names of encodings that differ in VS Code. */
const NAMES: Record<string, string> = { latin1: LATIN1, l1: LATIN1, cp1252: "windows1252" };

/**
 * Returns the possible encodings for these bytes, by VS Code's names, the declared one first. Empty if a byte order
 * mark decides.
 */
export function encodingsOf(bytes: Uint8Array): string[] {
  if (UTF16_MARKS.some((mark) => startsWith(bytes, mark))) {
    return [];
  }
  const declared = startsWith(bytes, UTF8_MARK) ? undefined : declaredEncoding(bytes);
  if (declared !== undefined && !isUtf8(declared)) {
    return [...new Set([declared, LATIN1])];
  }
  return [isValidUtf8(bytes) ? "utf8" : LATIN1];
}

/** Whether both encodings yield the same bytes for a text, except for a byte order mark. */
export function isSameEncoding(left: string, right: string): boolean {
  return left === right || (isUtf8(left) && isUtf8(right));
}

export function isUtf8(encoding: string): boolean {
  return encoding === "utf8" || encoding === "utf8bom";
}

/** Whether both texts declare the same encoding, or neither declares one. */
export function isDeclaredAlike(left: Uint8Array, right: Uint8Array): boolean {
  return declaredEncoding(left) === declaredEncoding(right);
}

/**
 * Returns the encoding in the XML declaration. ASCII is a part of UTF-8. A declaration that is readable as ASCII is not
 * UTF-16.
 */
function declaredEncoding(bytes: Uint8Array): string | undefined {
  const text = startsWith(bytes, UTF8_MARK) ? bytes.subarray(UTF8_MARK.length) : bytes;
  const head = Buffer.from(text.subarray(0, HEAD)).toString("latin1");
  const name = DECLARATION.exec(head)?.[1]?.toLowerCase().replace(/[^a-z0-9]/g, "");
  return name === undefined || /^(?:utf|ucs|ascii|usascii)/.test(name) ? name && "utf8" : (NAMES[name] ?? name);
}

function startsWith(bytes: Uint8Array, mark: number[]): boolean {
  return mark.every((byte, index) => bytes[index] === byte);
}

function isValidUtf8(bytes: Uint8Array): boolean {
  try {
    new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return true;
  } catch {
    return false;
  }
}
