/** Colours of strain: how much longer the cloth is than it was cut, in its most stretched direction. */

import type { Rgb } from "./colors";

/** Strain and colour; between two stops colours are mixed. Told apart by lightness too. */
export const STRAIN_STOPS: readonly [number, Rgb][] = [
  [-0.05, [0.33, 0.55, 0.78]],
  [0.0, [0.9, 0.93, 0.95]],
  [0.05, [0.97, 0.83, 0.4]],
  [0.12, [0.87, 0.38, 0.16]],
  [0.25, [0.45, 0.07, 0.18]],
];

export function strainColor(strain: number): Rgb {
  const first = STRAIN_STOPS[0] as [number, Rgb];
  if (!(strain > first[0])) return first[1];
  for (let k = 1; k < STRAIN_STOPS.length; k += 1) {
    const [low, from] = STRAIN_STOPS[k - 1] as [number, Rgb];
    const [high, to] = STRAIN_STOPS[k] as [number, Rgb];
    if (strain <= high) {
      const t = (strain - low) / (high - low);
      return [
        from[0] + t * (to[0] - from[0]),
        from[1] + t * (to[1] - from[1]),
        from[2] + t * (to[2] - from[2]),
      ];
    }
  }
  return (STRAIN_STOPS[STRAIN_STOPS.length - 1] as [number, Rgb])[1];
}

/** For the legend: a CSS gradient from the first stop to the last, evenly spaced by strain. */
export function strainGradient(): string {
  const low = (STRAIN_STOPS[0] as [number, Rgb])[0];
  const high = (STRAIN_STOPS[STRAIN_STOPS.length - 1] as [number, Rgb])[0];
  const stops = STRAIN_STOPS.map(([strain, [r, g, b]]) => {
    const channels = [r, g, b].map((channel) => Math.round(255 * channel)).join(" ");
    return `rgb(${channels}) ${((100 * (strain - low)) / (high - low)).toFixed(1)}%`;
  });
  return `linear-gradient(to right, ${stops.join(", ")})`;
}
