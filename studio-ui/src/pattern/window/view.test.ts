import "../testing/fast-check-seed";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { distance } from "../geometry/point";
import type { Point } from "../specification";
import { fitted, gridStep, onScreen, onSheet, panned, type View, zoomedAt } from "./view";

const number = fc.double({ min: -500, max: 500, noNaN: true });
const point: fc.Arbitrary<Point> = fc.tuple(number, number);
const view: fc.Arbitrary<View> = fc.record({
  scale: fc.double({ min: 0.5, max: 300, noNaN: true }),
  corner: point,
});

describe("the view", () => {
  it("goes from sheet to screen and back", () => {
    fc.assert(
      fc.property(view, point, (seen, place) => {
        expect(distance(onSheet(seen, onScreen(seen, place)), place)).toBeLessThan(1e-6);
      }),
    );
  });

  it("keeps what is under the pointer when it zooms", () => {
    fc.assert(
      fc.property(view, point, fc.double({ min: 0.1, max: 10, noNaN: true }), (seen, px, factor) => {
        const after = zoomedAt(seen, px, factor);
        expect(distance(onSheet(after, px), onSheet(seen, px))).toBeLessThan(1e-6);
      }),
    );
  });

  it("moves with the hand", () => {
    fc.assert(
      fc.property(view, point, point, (seen, px, by) => {
        const place = onSheet(seen, px);
        expect(distance(onScreen(panned(seen, by), place), [px[0] + by[0], px[1] + by[1]])).toBeLessThan(
          1e-4,
        );
      }),
    );
  });

  it("shows the whole of a box inside the margins", () => {
    const margins = { top: 36, right: 18, bottom: 70, left: 36 };
    fc.assert(
      fc.property(
        point,
        fc.tuple(fc.double({ min: 5, max: 900, noNaN: true }), fc.double({ min: 5, max: 900, noNaN: true })),
        ([x, y], [w, h]) => {
          const seen = fitted({ low: [x, y], high: [x + w, y + h] }, [600, 700], margins);
          const [left, bottom] = onScreen(seen, [x, y]);
          const [right, top] = onScreen(seen, [x + w, y + h]);
          expect(left).toBeGreaterThan(35.9);
          expect(right).toBeLessThan(582.1);
          expect(top).toBeGreaterThan(35.9);
          expect(bottom).toBeLessThan(630.1);
        },
      ),
    );
  });
});

describe("grid lines", () => {
  it("are 1, 2 or 5 times a power of ten of a centimetre apart, and no closer than wanted", () => {
    for (const scale of [0.5, 1, 3, 4, 10, 37.8, 250]) {
      const step = gridStep(scale, 1, 10, false);
      expect(step * scale).toBeGreaterThanOrEqual(10 - 1e-9);
      expect(step * scale).toBeLessThanOrEqual(25 + 1e-9);
      const digit = Number((step / 10 ** Math.floor(Math.log10(step) + 1e-9)).toFixed(6));
      expect([1, 2, 5]).toContain(digit);
    }
  });

  it("are halves of an inch down to eighths", () => {
    expect(gridStep(100, 2.54, 10, true)).toBeCloseTo(2.54 / 8, 9);
    expect(gridStep(4, 2.54, 10, true)).toBeCloseTo(2.54, 9);
  });
});
