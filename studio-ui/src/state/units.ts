/** Lengths are kept in cm; people may read and type them in inches. */

export type Units = "cm" | "inch";

const CM_PER_INCH = 2.54;

/** A length in cm as a number in the chosen unit. */
export function fromCm(cm: number, units: Units): number {
  return units === "cm" ? cm : cm / CM_PER_INCH;
}

export function toCm(value: number, units: Units): number {
  return units === "cm" ? value : value * CM_PER_INCH;
}

export function unitMark(units: Units): string {
  return units === "cm" ? "cm" : "in";
}

/** "12.5 cm", or "4 7/8 in": inches to the eighth, as tapes have them. */
export function lengthText(cm: number, units: Units): string {
  if (units === "cm") return `${trimmed(cm, 1)} cm`;
  const eighths = Math.round((Math.abs(cm) / CM_PER_INCH) * 8);
  const sign = cm < 0 && eighths > 0 ? "−" : "";
  const whole = Math.floor(eighths / 8);
  const rest = eighths % 8;
  if (rest === 0) return `${sign}${whole} in`;
  const [top, bottom] = rest % 4 === 0 ? [rest / 4, 2] : rest % 2 === 0 ? [rest / 2, 4] : [rest, 8];
  return `${sign}${whole > 0 ? `${whole} ` : ""}${top}/${bottom} in`;
}

/** A number without needless zeros; a true minus sign. */
export function trimmed(value: number, digits: number): string {
  const text = digits > 0 ? value.toFixed(digits).replace(/\.?0+$/, "") : value.toFixed(0);
  return (text === "-0" ? "0" : text).replace("-", "−");
}
