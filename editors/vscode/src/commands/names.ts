// Names that VAL 3 allows for new programs and applications.

/** Returns the reason why `name` cannot name a program or an application; `undefined` if it can. */
export function nameFault(name: string, taken: (name: string) => boolean): string | undefined {
  if (!/^[A-Za-z_]\w*$/.test(name)) {
    return "A name begins with a letter and has letters, digits and underscores only.";
  }
  return taken(name.toLowerCase()) ? `There is a ${name} already.` : undefined;
}
