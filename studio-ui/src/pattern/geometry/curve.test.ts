import "../testing/fast-check-seed";
import { readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { type Point, panelOf } from "../specification";
import { realPattern } from "../testing/real-patterns";
import { at } from "./at";
import { boxOf, curveBox } from "./bounds";
import {
  arcOf,
  type Curve,
  derivativeAt,
  mirroredShape,
  pointAt,
  reversedShape,
  type Shape,
  scaledShape,
  splitAt,
  toAbsolute,
  toRelative,
} from "./curve";
import { flattened } from "./flatten";
import { curveLength, parameterAtShare, shareAtParameter } from "./length";
import { nearestOn } from "./nearest";
import { curveOf, edgeLengths, panelBox, signedArea } from "./outline";
import { axesOf, pointInWorld } from "./placement";
import { distance } from "./point";

interface EdgeNumbers {
  panel: string;
  edge: number;
  length: number;
  at_share: number;
  points: Point[];
  derivative: Point;
  box: [Point, Point];
  halves: [Shape | null, Shape | null];
  cut: Point;
}

interface PatternNumbers {
  id: string;
  edges: EdgeNumbers[];
  panels: Record<string, { area: number; box: [Point, Point]; world: [number, number, number][] }>;
}

const numbers = JSON.parse(
  readFileSync("src/pattern/geometry/python-numbers.json", "utf8"),
) as PatternNumbers[];

function expectNear(got: readonly number[], wanted: readonly number[], within = 1e-7): void {
  expect(got.length).toBe(wanted.length);
  got.forEach((value, k) => {
    expect(Math.abs(value - at(wanted, k))).toBeLessThan(within);
  });
}

describe("the package's numbers of real edges", () => {
  const kinds = new Set<string>();
  for (const { id, edges } of numbers)
    it(`are met in ${id}`, () => {
      const specification = realPattern(id);
      for (const wanted of edges) {
        const curve = curveOf(panelOf(specification, wanted.panel), wanted.edge);
        kinds.add(curve.shape?.type ?? "line");
        expectNear([curveLength(curve)], [wanted.length], 1e-8);
        expectNear([parameterAtShare(curve, 0.3)], [wanted.at_share], 1e-9);
        [0.25, 0.5, 0.9].forEach((t, k) => {
          expectNear(pointAt(curve, t), at(wanted.points, k));
        });
        expectNear(derivativeAt(curve, 0.25), wanted.derivative);
        const box = curveBox(curve);
        expectNear([...box.low, ...box.high], wanted.box.flat());
        const halves = splitAt(curve, 0.37);
        expectNear(halves.point, wanted.cut);
        [halves.first, halves.second].forEach((half, k) => {
          const other = at(wanted.halves, k) ?? undefined;
          expect(half?.type).toBe(other?.type);
          expectNear(half?.params.flat() ?? [], other?.params.flat() ?? [], 1e-6);
        });
      }
    });
  it("are of all four kinds", () => {
    expect([...kinds].sort()).toEqual(["circle", "cubic", "line", "quadratic"]);
  });

  it("are met by all panels: area, box and place", () => {
    for (const { id, panels } of numbers) {
      const specification = realPattern(id);
      for (const [name, wanted] of Object.entries(panels)) {
        const panel = panelOf(specification, name);
        expect(Math.abs(signedArea(panel) / wanted.area - 1)).toBeLessThan(1e-5);
        const box = panelBox(panel);
        expectNear([...box.low, ...box.high], wanted.box.flat());
        const axes = axesOf(panel);
        wanted.world.forEach((point, k) => {
          expectNear(pointInWorld(panel, axes, at(panel.vertices, k)), point);
        });
      }
    }
  });
});

const coordinate = fc.double({ min: -100, max: 100, noNaN: true });
const point = fc.tuple(coordinate, coordinate);
const share = fc.double({ min: 0.02, max: 0.98, noNaN: true });
const relative = fc.tuple(
  fc.double({ min: -0.5, max: 1.5, noNaN: true }),
  fc.double({ min: -1.5, max: 1.5, noNaN: true }),
);
const shape: fc.Arbitrary<Shape> = fc.oneof(
  fc.constant(undefined),
  relative.map((p): Shape => ({ type: "quadratic", params: [p] })),
  fc.tuple(relative, relative).map(([p, q]): Shape => ({ type: "cubic", params: [p, q] })),
  fc
    .tuple(fc.double({ min: 0.51, max: 8, noNaN: true }), fc.constantFrom(0, 1), fc.constantFrom(0, 1))
    .map(([r, large, right]): Shape => ({ type: "circle", params: [r, large, right] })),
);
/** Curves of a chord of 1 to 200 cm; radii are drawn as shares of it. */
const curve: fc.Arbitrary<Curve> = fc
  .tuple(point, point, shape)
  .filter(([a, b]) => distance(a, b) > 1)
  .map(([start, end, s]) => ({
    start,
    end,
    shape: s?.type === "circle" ? scaledShape(s, distance(start, end)) : s,
  }));

describe("curves", () => {
  it("trace the same points after a split", () => {
    fc.assert(
      fc.property(curve, share, share, (whole, cut, t) => {
        const { first, second, point: middle } = splitAt(whole, cut);
        const one = { shape: first, start: whole.start, end: middle };
        const two = { shape: second, start: middle, end: whole.end };
        expect(distance(pointAt(one, t), pointAt(whole, cut * t))).toBeLessThan(1e-5);
        expect(distance(pointAt(two, t), pointAt(whole, cut + (1 - cut) * t))).toBeLessThan(1e-5);
        expect(Math.abs(curveLength(one) + curveLength(two) - curveLength(whole))).toBeLessThan(1e-4);
      }),
    );
  });

  it("are the same backwards, and reflected after a reflection", () => {
    fc.assert(
      fc.property(curve, share, (whole, t) => {
        const back = { shape: reversedShape(whole.shape), start: whole.end, end: whole.start };
        expect(distance(pointAt(back, 1 - t), pointAt(whole, t))).toBeLessThan(1e-6);
        const flip = ([x, y]: Point): Point => [-x, y];
        const other = { shape: mirroredShape(whole.shape), start: flip(whole.start), end: flip(whole.end) };
        expect(distance(pointAt(other, t), flip(pointAt(whole, t)))).toBeLessThan(1e-6);
      }),
    );
  });

  it("find the place of a share of their length", () => {
    fc.assert(
      fc.property(curve, share, (whole, wanted) => {
        expect(Math.abs(shareAtParameter(whole, parameterAtShare(whole, wanted)) - wanted)).toBeLessThan(
          1e-6,
        );
      }),
    );
  });

  it("have no point nearer than the nearest", () => {
    fc.assert(
      fc.property(curve, point, (whole, to) => {
        const found = nearestOn(whole, to);
        expect(distance(pointAt(whole, found.t), found.point)).toBeLessThan(1e-9);
        for (const p of flattened(whole, 0.01))
          expect(distance(p, to)).toBeGreaterThan(found.distance - 0.05);
      }),
    );
  });

  it("stay in their box and touch it", () => {
    fc.assert(
      fc.property(curve, (whole) => {
        const { low, high } = curveBox(whole);
        const around = boxOf(flattened(whole, 1e-3));
        expect(Math.min(around.low[0] - low[0], around.low[1] - low[1])).toBeGreaterThan(-1e-6);
        expect(Math.max(around.low[0] - low[0], around.low[1] - low[1])).toBeLessThan(0.02);
        expect(Math.max(around.high[0] - high[0], around.high[1] - high[1])).toBeLessThan(1e-6);
        expect(Math.min(around.high[0] - high[0], around.high[1] - high[1])).toBeGreaterThan(-0.02);
      }),
    );
  });

  it("turn control points into cm and back", () => {
    fc.assert(
      fc.property(point, point, relative, (start, end, r) => {
        fc.pre(distance(start, end) > 0.1);
        expect(distance(toRelative(toAbsolute(r, start, end), start, end), r)).toBeLessThan(1e-9);
      }),
    );
  });
});

it("an arc with too small a radius is a semicircle", () => {
  const arc = arcOf([1, 0, 1], [0, 0], [10, 0]);
  expect(arc.radius).toBe(5);
  expect(arc.sweep).toBeCloseTo(Math.PI, 12);
});

it("lengths of a panel are remembered with it", () => {
  const panel = panelOf(realPattern(at(numbers, 0).id), Object.keys(at(numbers, 0).panels)[0] ?? "");
  expect(edgeLengths(panel)).toBe(edgeLengths(panel));
});
