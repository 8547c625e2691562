/** Colours of seams: eight that people with any kind of colour blindness can tell, and a dash for the rest. */

// Okabe and Ito (2008), "Color Universal Design", with the yellow darkened so that it shows on white paper.
const LIGHT = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b58900", "#56b4e9", "#7a3e9d", "#8c564b"];
const DARK = ["#4aa8ff", "#ff8a3d", "#2fd6a3", "#f0a3cb", "#f0d54a", "#9ad8ff", "#c79bff", "#d8a08f"];
const DASHES = ["", "6 3", "2 3", "8 3 2 3"];

export function seamColor(stitch: number, theme: "light" | "dark"): string {
  const colors = theme === "dark" ? DARK : LIGHT;
  return colors[stitch % colors.length] as string;
}

/** An SVG dash array: seams of the same colour differ in it. */
export function seamDash(stitch: number): string {
  return DASHES[Math.floor(stitch / LIGHT.length) % DASHES.length] as string;
}
