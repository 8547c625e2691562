import "../testing/fast-check-seed";
import { readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { moveVertices } from "../edits/move-vertices";
import { renamePanel } from "../edits/rename-panel";
import { at } from "../geometry/at";
import { boxMiddle, boxSize } from "../geometry/bounds";
import { panelBox } from "../geometry/outline";
import { distance } from "../geometry/point";
import { type Point, panelNames, panelOf, type Specification } from "../specification";
import { realPatterns } from "../testing/real-patterns";
import { arranged, boxOnSheet, hasOverlaps, kept, moved, rotated, toPanel, toSheet } from "./arrangement";
import { placePanel } from "./placing";
import { shelves } from "./shelves";

interface LayoutNumbers {
  id: string;
  layout: {
    corners: Point[];
    sheet: Point;
    panels: { name: string; mirrored: boolean; low: Point; size: Point; caption: [number, number, number] }[];
  };
}

const numbers = JSON.parse(
  readFileSync("src/pattern/geometry/python-numbers.json", "utf8"),
) as LayoutNumbers[];

describe("the layout is the package's drawing", () => {
  for (const { id, layout } of numbers)
    it(id, () => {
      const specification = realPatterns().find((p) => p.id === id)?.pattern as Specification;
      const placed = layout.panels.map((wanted) => {
        const got = placePanel(wanted.name, panelOf(specification, wanted.name), 1.2);
        expect(got.mirrored).toBe(wanted.mirrored);
        expect(distance(got.size, [wanted.size[0] / 10, wanted.size[1] / 10])).toBeLessThan(1e-6);
        expect(distance(got.low, [wanted.low[0] / 10, wanted.low[1] / 10])).toBeLessThan(1e-6);
        expect(Math.abs(got.caption.size - wanted.caption[2] / 10)).toBeLessThan(1e-6);
        return got;
      });
      const { corners, sheet } = shelves(
        placed.map((p) => p.size),
        3,
      );
      corners.forEach((corner, k) => {
        const [x, y] = at(layout.corners, k);
        expect(distance(corner, [x / 10, y / 10])).toBeLessThan(1e-6);
      });
      expect(distance(sheet, [layout.sheet[0] / 10, layout.sheet[1] / 10])).toBeLessThan(1e-6);
    });
});

const first = new Map(realPatterns().map((p) => [p.pattern, arranged(p.pattern)]));
const arrangedOnce = (pattern: Specification) => first.get(pattern) ?? arranged(pattern);
const real = fc.constantFrom(...realPatterns().map((p) => p.pattern));

describe("the arrangement", () => {
  it("has no panels on each other", () => {
    for (const { pattern } of realPatterns()) expect(hasOverlaps(pattern, arrangedOnce(pattern))).toBe(false);
  });

  it("moves no panel when an outline is edited", () => {
    fc.assert(
      fc.property(real, fc.nat(), fc.nat(), (pattern, p, v) => {
        const before = arrangedOnce(pattern);
        const name = at(panelNames(pattern), p % panelNames(pattern).length);
        const vertex = v % panelOf(pattern, name).vertices.length;
        const after = moveVertices(pattern, new Map([[name, new Map([[vertex, [0, -30] as Point]])]]));
        expect(kept(before, pattern, after.specification)).toBe(before);
      }),
    );
  });

  it("keeps the place of a panel that is renamed", () => {
    fc.assert(
      fc.property(real, fc.nat(), (pattern, p) => {
        const name = at(panelNames(pattern), p % panelNames(pattern).length);
        const before = arrangedOnce(pattern);
        const after = kept(before, pattern, renamePanel(pattern, name, "another name").specification);
        expect(after["another name"]).toBe(before[name]);
        expect(after[name]).toBeUndefined();
        expect(Object.keys(after).length).toBe(Object.keys(before).length);
      }),
    );
  });

  it("puts a new panel beside all others, which stay", () => {
    for (const { pattern } of realPatterns()) {
      const first = at(panelNames(pattern), 0);
      const without: Specification = {
        ...pattern,
        pattern: {
          panels: Object.fromEntries(Object.entries(pattern.pattern.panels).filter(([n]) => n !== first)),
          stitches: [],
          panel_order: pattern.pattern.panel_order.filter((n) => n !== first),
        },
      };
      if (panelNames(without).length < 2) continue;
      const before = arranged(without);
      const after = kept(before, without, pattern);
      for (const name of panelNames(without)) expect(after[name]).toBe(before[name]);
      expect(hasOverlaps(pattern, after)).toBe(false);
    }
  });

  it("turns a panel about its middle and maps points there and back", () => {
    fc.assert(
      fc.property(real, fc.nat(), fc.integer({ min: -360, max: 360 }), (pattern, p, degrees) => {
        const name = at(panelNames(pattern), p % panelNames(pattern).length);
        const panel = panelOf(pattern, name);
        const middle = boxMiddle(panelBox(panel));
        const before = arrangedOnce(pattern);
        const after = rotated(moved(before, [name], [3, 4]), name, panel, degrees);
        const [was, is] = [before[name], after[name]];
        if (was === undefined || is === undefined) throw new Error(name);
        const [x, y] = toSheet(was, middle);
        expect(distance(toSheet(is, middle), [x + 3, y + 4])).toBeLessThan(1e-9);
        expect(distance(toPanel(is, toSheet(is, [1, 2])), [1, 2])).toBeLessThan(1e-9);
        const [one, other] = [boxSize(boxOnSheet(panel, was)), boxSize(boxOnSheet(panel, is))];
        if (degrees % 180 === 0) expect(distance(one, other)).toBeLessThan(1e-6);
      }),
    );
  });
});
