// Drawing on a canvas with the colours of the page.

/** Returns the colour with a property name. */
export type Colour = (name: string) => string;

/** Adapts the canvas to its size in CSS pixels and to the resolution of the screen, and draws in CSS pixels. */
export function paintCanvas(element: HTMLCanvasElement | null, width: number, height: number, draw: (canvas: CanvasRenderingContext2D, colour: Colour) => void): void {
  const context = element?.getContext("2d");
  if (!element || !context) {
    return;
  }
  const scale = window.devicePixelRatio || 1;
  element.width = Math.round(width * scale);
  element.height = Math.round(height * scale);
  element.style.height = `${height}px`;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  const style = getComputedStyle(element);
  draw(context, (name) => style.getPropertyValue(name).trim());
}
