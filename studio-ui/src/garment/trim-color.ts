/** Colours of pockets, buttons and the like, the same as in the server's previews (garment/trim_colors.py). */

import type { TrimLook } from "../api/types";
import { fromHex, linear, type Rgb } from "./colors";

/** Cloth that throws back less light than this has lighter stitches. */
const DARK = 0.04;
/** Least light, linear, that cloth of any colour throws back: folds of black cloth are seen. */
export const DARKEST = 0.01;
const LIGHT = 0.25;
/** So much lighter are what is sewn on dark cloth and lines on it, linear light. */
const [SEEN_ON_DARK, LINES_ON_DARK] = [0.012, 0.04] as const;
const [METAL, LEATHER, LIGHT_BUTTON, DARK_BUTTON] = ["#8d8f94", "#4a3226", "#bdb6a8", "#6b5a49"] as const;
/** Leather on black cloth, and how far apart the channels of that are at most. */
const [BLACK_LEATHER, GREYISH] = ["#33312f", 0.02] as const;

/** Light that a part throws back, linear channels, on cloth of a colour ("#rrggbb"). */
export function trimColor(look: TrimLook, cloth: string): Rgb {
  const ground = linearOf(cloth, DARKEST);
  const light = brightness(ground);
  if (look === "cloth") return light < DARK ? raised(ground, SEEN_ON_DARK) : scaled(ground, 0.94);
  if (look === "dark") return light >= DARK ? scaled(ground, 0.3) : lineOnDark(ground);
  if (look === "button") return linearOf(light < LIGHT ? LIGHT_BUTTON : DARK_BUTTON);
  if (look === "metal") return linearOf(METAL);
  const isBlack = light < DARK && Math.max(...ground) - Math.min(...ground) < GREYISH;
  return linearOf(isBlack ? BLACK_LEATHER : LEATHER);
}

/** Of a line on dark cloth: twice as light, and so much lighter at least that it is seen on black. */
function lineOnDark(ground: Rgb): Rgb {
  const [r, g, b] = raised(ground, LINES_ON_DARK);
  return [Math.max(r, 2.2 * ground[0]), Math.max(g, 2.2 * ground[1]), Math.max(b, 2.2 * ground[2])];
}

/** Light that a part of a colour of its own ("#rrggbb") throws back, linear channels. */
export function ownColor(color: string): Rgb {
  return linearOf(color, DARKEST);
}

/** Of the edges of a part of that colour: darker, or lighter where it is dark already. */
export function edgeColor(part: Rgb): Rgb {
  return scaled(part, brightness(part) >= DARK ? 0.5 : 2.6);
}

function linearOf(hex: string, least = 0): Rgb {
  const [r, g, b] = fromHex(hex);
  return [Math.max(linear(r), least), Math.max(linear(g), least), Math.max(linear(b), least)];
}

function scaled([r, g, b]: Rgb, factor: number): Rgb {
  return [factor * r, factor * g, factor * b];
}

function raised([r, g, b]: Rgb, by: number): Rgb {
  return [r + by, g + by, b + by];
}

function brightness([r, g, b]: Rgb): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
