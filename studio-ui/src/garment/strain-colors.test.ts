import { describe, expect, it } from "vitest";
import { lightness } from "./colors";
import { STRAIN_STOPS, strainColor, strainGradient } from "./strain-colors";

describe("colours of strain", () => {
  it("are those of the stops, and stay within them", () => {
    for (const [strain, color] of STRAIN_STOPS)
      expect(strainColor(strain).map((c, k) => Math.abs(c - (color[k] ?? -1)) < 1e-9)).toEqual([
        true,
        true,
        true,
      ]);
    expect(strainColor(-3)).toEqual(STRAIN_STOPS[0]?.[1]);
    expect(strainColor(Number.NaN)).toEqual(STRAIN_STOPS[0]?.[1]);
    expect(strainColor(9)).toEqual(STRAIN_STOPS.at(-1)?.[1]);
  });

  it("get darker with every stretch, so that colour is not all that tells", () => {
    for (let strain = 0; strain < 0.25; strain += 0.01)
      expect(lightness(strainColor(strain + 0.01))).toBeLessThan(lightness(strainColor(strain)));
  });

  it("are laid out in the legend by strain", () => {
    expect(strainGradient()).toContain("16.7%");
    expect(strainGradient().match(/rgb/g)).toHaveLength(STRAIN_STOPS.length);
  });
});
