/** What drags do, from hold to pattern, on real patterns. */

import { describe, expect, it } from "vitest";
import { problemsOf } from "../edits/validity";
import { at } from "../geometry/at";
import { pointAt } from "../geometry/curve";
import { curveOf, edgeLength } from "../geometry/outline";
import { arranged, toSheet } from "../layout/arrangement";
import { type Point, panelNames, panelOf, type Specification, stitchOf } from "../specification";
import { realPatterns } from "../testing/real-patterns";
import { type DragPointer, type DragSetting, dragOf, shiftText } from "./drags";
import { hitAt, within } from "./hit-test";

const settings = realPatterns().map(({ id, pattern }): DragSetting & { id: string } => ({
  id,
  specification: pattern,
  arrangement: arranged(pattern),
  selection: [],
  mirror: false,
  hem: false,
  units: "cm",
}));

function pointer(to: Point, snap = false): DragPointer {
  return { to, snap, reach: 0.8, grid: 0.5 };
}

function placeOf(setting: DragSetting, panel: string, point: Point): Point {
  const place = setting.arrangement[panel];
  if (place === undefined) throw new Error(panel);
  return toSheet(place, point);
}

function moved(by: Point, from: Point): Point {
  return [from[0] + by[0], from[1] + by[1]];
}

describe("a drag", () => {
  it("of a point moves it by what the hand moves, on panels that are turned over too", () => {
    for (const setting of settings)
      for (const panel of panelNames(setting.specification)) {
        const vertex = at(panelOf(setting.specification, panel).vertices, 0);
        const from = placeOf(setting, panel, vertex);
        const drag = dragOf({ kind: "vertex", panel, vertex: 0 }, from, setting, false);
        const { edit, reading } = drag.to(pointer(moved([0.6, -0.4], from)));
        if (edit === null || edit.refused !== undefined) continue;
        const after = placeOf(setting, panel, at(panelOf(edit.specification, panel).vertices, 0));
        expect(after[0] - from[0]).toBeCloseTo(0.6, 9);
        expect(after[1] - from[1]).toBeCloseTo(-0.4, 9);
        expect(reading).toBe("0.4 cm down, 0.6 cm right");
      }
  });

  it("that ends where it began leaves the very same pattern", () => {
    for (const setting of settings) {
      const panel = at(panelNames(setting.specification), 0);
      for (const hit of [
        { kind: "vertex", panel, vertex: 1 },
        { kind: "edge", panel, edge: 1, t: 0.5 },
      ] as const) {
        const drag = dragOf(hit, [3, 4], { ...setting, hem: true, mirror: true }, false);
        drag.to(pointer([13, 24]));
        expect(drag.to(pointer([3, 4], true)).edit?.specification).toBe(setting.specification);
      }
    }
  });

  it("of a hem goes outward by steps and keeps each edge's shape", () => {
    let hems = 0;
    for (const setting of settings) {
      const { specification } = setting;
      for (const panel of panelNames(specification).filter((name) => /skirt_(front|back)$/.test(name))) {
        const free = panelOf(specification, panel)
          .edges.map((_, edge) => ({ panel, edge }))
          .filter((ref) => stitchOf(specification, ref) < 0);
        const height = (edge: number) =>
          placeOf(setting, panel, pointAt(curveOf(panelOf(specification, panel), edge), 0.5))[1];
        const hem = free.sort((a, b) => height(a.edge) - height(b.edge))[0];
        if (hem === undefined) continue;
        const drag = dragOf({ kind: "edge", ...hem, t: 0.5 }, [0, 0], { ...setting, hem: true }, false);
        const { edit, reading } = drag.to(pointer([3, -10.1], true));
        if (edit === null) throw new Error(panel);
        expect(reading).toMatch(/longer|shorter/);
        expect(edit.refused).toBeUndefined();
        expect(problemsOf(edit.specification)).toEqual([]);
        expect(edgeLength(edit.specification, hem)).toBeCloseTo(edgeLength(specification, hem), 6);
        hems += 1;
      }
    }
    expect(hems).toBeGreaterThan(5);
  });

  it("of a handle bends the edge to the pointer, on both sides where mirror editing is on", () => {
    const setting = at(
      settings.filter(
        (s) => Object.hasOwn(s.specification.pattern.panels, "left_ftorso") && s.id !== "gc_1002038",
      ),
      0,
    );
    const panel = "left_ftorso";
    const curve = curveOf(panelOf(setting.specification, panel), 0);
    const from = placeOf(setting, panel, pointAt(curve, 0.5));
    const drag = dragOf(
      { kind: "handle", panel, edge: 0, handle: 0 },
      from,
      { ...setting, mirror: true },
      false,
    );
    const { edit } = drag.to(pointer(moved([3, 3], from)));
    expect(edit?.refused).toBeUndefined();
    const changed = panelNames(setting.specification).filter(
      (name) => panelOf(edit?.specification as Specification, name) !== panelOf(setting.specification, name),
    );
    expect(changed).toContain("left_ftorso");
    expect(changed).toContain("right_ftorso");
  });

  it("of a panel moves it in the window and leaves the pattern alone", () => {
    const setting = at(settings, 0);
    const panel = at(panelNames(setting.specification), 0);
    const { edit, arrangement } = dragOf({ kind: "panel", panel }, [0, 0], setting, false).to(
      pointer([7, 8]),
    );
    expect(edit).toBeNull();
    const [before, after] = [setting.arrangement[panel]?.at, arrangement?.[panel]?.at];
    expect(after).toEqual(moved([7, 8], before ?? [0, 0]));
  });
});

describe("what lies under the pointer", () => {
  it("is the point, the edge or the panel that is there", () => {
    for (const { specification, arrangement } of settings)
      for (const panel of panelNames(specification)) {
        const place = arrangement[panel];
        if (place === undefined) throw new Error(panel);
        const own = panelOf(specification, panel);
        const reach = { vertex: 0.05, edge: 0.05 };
        own.vertices.forEach((point, vertex) => {
          const hit = hitAt(specification, arrangement, toSheet(place, point), reach, []);
          expect(hit).toMatchObject({ kind: "vertex", panel });
          if (hit?.kind === "vertex") {
            const [x, y] = at(own.vertices, hit.vertex);
            expect(Math.hypot(x - point[0], y - point[1])).toBeLessThan(0.05);
          } else throw new Error(`${panel} ${vertex}`);
        });
        own.edges.forEach((_, edge) => {
          if (edgeLength(specification, { panel, edge }) < 1) return;
          const middle = toSheet(place, pointAt(curveOf(own, edge), 0.5));
          expect(hitAt(specification, arrangement, middle, reach, [])).toMatchObject({ kind: "edge", panel });
        });
      }
  });

  it("in a rectangle around everything is every panel", () => {
    for (const { specification, arrangement } of settings) {
      const all = within(specification, arrangement, [
        [-9999, -9999],
        [9999, 9999],
      ]);
      expect(all).toEqual(panelNames(specification).map((panel) => ({ kind: "panel", panel })));
    }
  });
});

it("shifts are read off in words", () => {
  expect(shiftText([0, -10], "cm")).toBe("10 cm down");
  expect(shiftText([-2.54, 0], "inch")).toBe("1 in left");
  expect(shiftText([0, 0], "cm")).toBe("not moved");
});
