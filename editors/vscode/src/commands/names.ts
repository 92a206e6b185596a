// Names that VAL 3 takes, and what programs are to be called before they exist.

/** Why `name` cannot be the name of a program or an application; nothing when it can. */
export function nameFault(name: string, taken: (name: string) => boolean): string | undefined {
  if (!/^[A-Za-z_]\w*$/.test(name)) {
    return "A name begins with a letter and has letters, digits and underscores only.";
  }
  return taken(name.toLowerCase()) ? `There is a ${name} already.` : undefined;
}
