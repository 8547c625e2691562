import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import type { TrimLook } from "../api/types";
import type { Rgb } from "./colors";
import { edgeColor, trimColor } from "./trim-color";

/** Of the server's previews; tests/studio/test_trims.py writes them. */
const KNOWN = JSON.parse(readFileSync("src/garment/trim-colors.json", "utf8")) as {
  look: TrimLook;
  cloth: string;
  linear: Rgb;
}[];

describe("colours of trims", () => {
  it("are those of the server's previews", () => {
    expect(KNOWN.length).toBeGreaterThan(20);
    for (const { look, cloth, linear } of KNOWN)
      trimColor(look, cloth).forEach((channel, k) => {
        expect(channel, `${look} on ${cloth}`).toBeCloseTo(linear[k] as number, 4);
      });
  });

  it("let edges stand out from any part", () => {
    for (const { linear } of KNOWN) {
      const [part, edge] = [linear, edgeColor(linear)].map((each) => Math.max(...each));
      const ratio = (edge as number) / (part as number);
      expect(Math.max(ratio, 1 / ratio)).toBeGreaterThan(1.9);
    }
  });
});
