import { describe, expect, it } from "vitest";
import { fromCm, lengthText, toCm, trimmed } from "./units";

describe("units", () => {
  it("writes cm without needless zeros", () => {
    expect(lengthText(12, "cm")).toBe("12 cm");
    expect(lengthText(12.34, "cm")).toBe("12.3 cm");
    expect(lengthText(-0.04, "cm")).toBe("0 cm");
    expect(trimmed(-5.7, 1)).toBe("−5.7");
    expect(trimmed(100, 0)).toBe("100");
    expect(trimmed(1.5, 2)).toBe("1.5");
  });

  it("writes inches to the eighth, as tapes have them", () => {
    expect(lengthText(2.54, "inch")).toBe("1 in");
    expect(lengthText(2.54 * 4.875, "inch")).toBe("4 7/8 in");
    expect(lengthText(2.54 * 0.75, "inch")).toBe("3/4 in");
    expect(lengthText(2.54 * 2.5, "inch")).toBe("2 1/2 in");
    expect(lengthText(-2.54 * 1.25, "inch")).toBe("−1 1/4 in");
    expect(lengthText(0.05, "inch")).toBe("0 in");
  });

  it("goes there and back", () => {
    for (const cm of [0, 0.1, 17, 250.5]) expect(toCm(fromCm(cm, "inch"), "inch")).toBeCloseTo(cm, 12);
    expect(toCm(3, "cm")).toBe(3);
  });
});
