/** Colours as sRGB channels from 0 to 1. */

export type Rgb = readonly [number, number, number];

export function fromHex(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export function toHex([r, g, b]: Rgb): string {
  return `#${[r, g, b]
    .map((channel) =>
      Math.round(255 * Math.min(1, Math.max(0, channel)))
        .toString(16)
        .padStart(2, "0"),
    )
    .join("")}`;
}

export function mixed(a: Rgb, b: Rgb, share: number): Rgb {
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])];
}

/** How light a colour looks, 0 to 1 (Rec. 709 weights on sRGB values). */
export function lightness([r, g, b]: Rgb): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Light of an sRGB channel: vertex colours and materials are linear, ours are sRGB. */
export function linear(channel: number): number {
  return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

/** Twelve quiet colours for panels; neighbours in the list differ in hue and lightness. */
export const PANEL_COLORS: readonly Rgb[] = [
  "#7fb3d5",
  "#f0b27a",
  "#82c9a1",
  "#d98880",
  "#bb9bd6",
  "#e6d27a",
  "#76c7c0",
  "#c59a7b",
  "#9aa7dd",
  "#b5c974",
  "#e3a1c0",
  "#a8b3ad",
].map(fromHex);
