// Error output of `val3` as messages. Pure functions.

/** Returns the error and its help, or the effect of an interruption, without line breaks; empty if there is neither. */
export function messageOf(errors: string): string {
  const lines = errors.trimEnd().split("\n");
  const first = lines.findLastIndex((line) => /^(error|interrupted): /.test(line));
  const texts = first === -1 ? [] : lines.slice(first).map((line) => line.trim().replace(/^error: /, "").replace(/^help: /, "Help: "));
  return texts.filter((text) => text !== "").join(". ");
}

/** Returns the last line, which summarises a pull, without the folder in which it ran. */
export function summaryOf(errors: string): string {
  return (errors.trimEnd().split("\n").at(-1) ?? "").replace(/^\.: /, "");
}

/** Returns the lines that `val3` writes in addition to its result, for example about a push that was recovered. */
export function notesOf(errors: string): string[] {
  return errors.split("\n").filter((line) => /^(note|warning): /.test(line));
}

/** Returns the fingerprint of a certificate that is not accepted yet; `undefined` for other errors. */
export function unknownFingerprint(errors: string): string | undefined {
  return /^error: cannot start TLS at \S+: its certificate is not known: (SHA256(?::[0-9A-F]{2}){32})$/m.exec(errors)?.[1];
}

/** Whether the controller has rejected the password or its absence. The reply is that of FTP (RFC 959). */
export function isLoginRejected(errors: string): boolean {
  return /^error: cannot log in at \S+: 530 /m.test(errors);
}
