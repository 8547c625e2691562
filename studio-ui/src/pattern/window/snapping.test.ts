import { describe, expect, it } from "vitest";
import { snapPoint, snapShift } from "./snapping";

const targets = {
  points: [[10, 40]] as [number, number][],
  origin: [3, 3] as [number, number],
  circles: [],
  grid: 0.5,
};

describe("a dragged point", () => {
  it("is level with another, and says so", () => {
    const { point, guides } = snapPoint([20.2, 40.3], targets, 0.5);
    expect(point).toEqual([20, 40]);
    expect(guides.map((g) => g.label)).toEqual(["level with a point"]);
  });

  it("goes straight up from where it was", () => {
    expect(snapPoint([3.2, 25.13], { ...targets, grid: 0 }, 0.5)).toMatchObject({
      point: [3, 25.13],
      guides: [{ label: "straight up" }],
    });
  });

  it("lies where its edge is as long as the one it is sewn to", () => {
    const circles = [{ center: [0, 0] as [number, number], radius: 30, label: "as long as skirt_back" }];
    const { point, guides } = snapPoint([18.1, 24.2], { ...targets, circles }, 0.5);
    expect(Math.hypot(...point)).toBeCloseTo(30, 9);
    expect(guides[0]?.label).toBe("as long as skirt_back");
  });

  it("stays where it is when nothing is near", () => {
    expect(snapPoint([55.12, 71.33], { ...targets, grid: 0 }, 0.5)).toEqual({
      point: [55.12, 71.33],
      guides: [],
    });
  });
});

describe("a shift", () => {
  it("goes along one axis and in steps", () => {
    expect(snapShift([0.2, -10.1], 0.5, 0.3).point).toEqual([0, -10]);
    expect(snapShift([4.13, 6.2], 0, 0.3).point).toEqual([4.13, 6.2]);
  });
});
