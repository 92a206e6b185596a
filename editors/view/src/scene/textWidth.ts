// Width of names over the drawing.

const FONT = "11px system-ui, sans-serif";

/** Space at both sides of a name together, in px, as in scene.css. */
const PADDING = 8;

/** Number of stored widths. Names with changing numbers must not fill the memory. */
const MOST = 2000;

const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null | undefined;

/** Returns the width of a name in px. */
export function textWidth(text: string, isBold: boolean): number {
  const key = `${isBold ? "b" : "n"}${text}`;
  const known = widths.get(key);
  if (known !== undefined) {
    return known;
  }
  context ??= document.createElement("canvas").getContext("2d");
  if (context === null) {
    return text.length * 7 + PADDING;
  }
  context.font = isBold ? `600 ${FONT}` : FONT;
  const width = Math.ceil(context.measureText(text).width) + PADDING;
  if (widths.size >= MOST) {
    widths.clear();
  }
  widths.set(key, width);
  return width;
}
