/** Prints of cloth at true scale: the mesh's texture coordinates are cm of the pattern. */

import { CanvasTexture, RepeatWrapping, SRGBColorSpace } from "three";
import type { Print } from "../state/display";
import { fromHex, lightness, mixed, toHex } from "./colors";

/** Width and height of one repeat, cm. */
const REPEAT_CM: Record<Exclude<Print, "plain">, number> = { stripes: 3, checks: 4, dots: 4, ruler: 10 };
const PIXELS = 256;

/** null for plain cloth. The print is drawn in the cloth's colour and one that stands out from it. */
export function printTexture(print: Print, cloth: string, anisotropy: number): CanvasTexture | null {
  if (print === "plain") return null;
  const canvas = document.createElement("canvas");
  canvas.width = PIXELS;
  canvas.height = PIXELS;
  const context = canvas.getContext("2d");
  if (context === null) return null;
  draw(context, print, cloth);
  const texture = new CanvasTexture(canvas);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.repeat.setScalar(1 / REPEAT_CM[print]);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = anisotropy;
  return texture;
}

function draw(context: CanvasRenderingContext2D, print: Exclude<Print, "plain">, cloth: string): void {
  const ground = fromHex(cloth);
  const contrast =
    lightness(ground) > 0.55 ? mixed(ground, [0.08, 0.1, 0.16], 0.72) : mixed(ground, [1, 1, 1], 0.82);
  context.fillStyle = cloth;
  context.fillRect(0, 0, PIXELS, PIXELS);
  context.fillStyle = toHex(contrast);
  context.strokeStyle = toHex(contrast);
  if (print === "stripes") context.fillRect(0, 0, PIXELS / 3, PIXELS);
  if (print === "checks") {
    context.globalAlpha = 0.5;
    context.fillRect(0, 0, PIXELS / 2, PIXELS);
    context.fillRect(0, 0, PIXELS, PIXELS / 2);
  }
  if (print === "dots")
    for (const [x, y] of [
      [0.25, 0.25],
      [0.75, 0.75],
    ] as const) {
      context.beginPath();
      context.arc(x * PIXELS, y * PIXELS, 0.11 * PIXELS, 0, 2 * Math.PI);
      context.fill();
    }
  if (print === "ruler")
    for (let cm = 0; cm < 10; cm += 1) {
      context.lineWidth = cm === 0 ? 8 : cm === 5 ? 4 : 1.6;
      const at = (cm / 10) * PIXELS + (cm === 0 ? 4 : 0);
      context.beginPath();
      context.moveTo(at, 0);
      context.lineTo(at, PIXELS);
      context.moveTo(0, at);
      context.lineTo(PIXELS, at);
      context.stroke();
    }
}
