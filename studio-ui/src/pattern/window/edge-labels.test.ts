import { describe, expect, it } from "vitest";
import type { Place } from "../layout/arrangement";
import type { Panel, Point } from "../specification";
import { edgeLabels, nameExtent } from "./edge-labels";

const rectangle = (width: number, height: number): Panel =>
  ({
    vertices: [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height],
    ],
    edges: [0, 1, 2, 3].map((k) => ({ endpoints: [k, (k + 1) % 4] })),
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
  }) as unknown as Panel;
const place = (mirrored = false): Place => ({ at: [0, 0] as Point, angle: 0, mirrored });
const words = [0, 1, 2, 3].map((edge) => ({ edge, text: `${edge} +0.3 cm` }));

describe("numbers of seams", () => {
  it("stand inside their panel, beginning or ending at upright edges", () => {
    const labels = edgeLabels(rectangle(50, 60), place(), words, 3, null);
    expect(labels.map(({ edge, anchor }) => [edge, anchor])).toEqual([
      [0, "middle"],
      [1, "end"],
      [2, "middle"],
      [3, "start"],
    ]);
    for (const { point } of labels) {
      expect(point[0]).toBeGreaterThan(0);
      expect(point[0]).toBeLessThan(50);
      expect(point[1]).toBeGreaterThan(0);
      expect(point[1]).toBeLessThan(60);
    }
  });

  it("begin where they ended once the panel is turned over", () => {
    const labels = edgeLabels(rectangle(50, 60), place(true), words, 3, null);
    expect(labels.map(({ anchor }) => anchor)).toEqual(["middle", "start", "middle", "end"]);
  });

  it("make way for the name and for each other, or are left out", () => {
    const panel = rectangle(50, 60);
    const free = edgeLabels(panel, place(), words, 3, null);
    const name = nameExtent(place(), [25, 30], 3, 140, 16);
    const shifted = edgeLabels(panel, place(), words, 3, name);
    expect(shifted).toHaveLength(4);
    expect(shifted[1]?.point[1]).not.toBe(free[1]?.point[1]);
    expect(shifted[0]).toEqual(free[0]);
    expect(edgeLabels(rectangle(12, 6), place(), words, 3, null).length).toBeLessThan(4);
  });
});
