// Stored view of a cell: position and target of the camera, and the half height of a parallel picture.

/** Returns the key of a cell. Cells with another arm have another view. */
export function viewKey({ application, arm }: { application: string; arm: { name: string } }): string {
  return `view.${application}.${arm.name}`;
}

/** Parses six or seven finite numbers in mm; `undefined` if the text has others. */
export function storedView(text: string | undefined): number[] | undefined {
  try {
    const view: unknown = JSON.parse(text ?? "null");
    return Array.isArray(view) && (view.length === 6 || view.length === 7) && view.every((value) => typeof value === "number" && Number.isFinite(value)) ? view : undefined;
  } catch {
    return undefined;
  }
}
