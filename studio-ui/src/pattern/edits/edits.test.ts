/** What holds for every edit, on real patterns and random places. */

import "../testing/fast-check-seed";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { at } from "../geometry/at";
import { pointAt } from "../geometry/curve";
import { nearestOn } from "../geometry/nearest";
import { curveOf, edgeLength, edgeLengths, signedArea } from "../geometry/outline";
import { distance } from "../geometry/point";
import {
  type EdgeRef,
  isRightWrong,
  type Point,
  panelNames,
  panelOf,
  partnerIn,
  type Specification,
  stitchOf,
  type VertexRef,
} from "../specification";
import { realPatterns } from "../testing/real-patterns";
import { addPoint } from "./add-point";
import { type CurveKind, reshapeEdge, shapeOfDepth, shapeOfKind, shapeWithHandle } from "./bend-edge";
import { counterpartOf } from "./counterpart";
import { deletePoint, facingPoint } from "./delete-point";
import type { Edit } from "./edit";
import { hemOf, movesOfHem } from "./hem";
import { angleOf, movesForAngle, movesForLength, movesToPlace, verticesOf } from "./measure-edge";
import {
  addPointMirrored,
  deletePointMirrored,
  makeStitchMirrored,
  mirroredEdge,
  moveMirrored,
  removeStitchMirrored,
  reshapeMirrored,
} from "./mirror";
import { movesOf, moveVertices } from "./move-vertices";
import { renamePanel } from "./rename-panel";
import { makeStitch, removeStitch, turnStitch } from "./stitches";
import { problemsOf } from "./validity";

const real = fc.constantFrom(...realPatterns().map((p) => p.pattern));
const delta = fc.tuple(
  fc.double({ min: -30, max: 30, noNaN: true }),
  fc.double({ min: -30, max: 30, noNaN: true }),
);
const share = fc.double({ min: 0.01, max: 0.99, noNaN: true });

function edgeFrom(specification: Specification, seed: number): EdgeRef {
  const all = panelNames(specification).flatMap((panel) =>
    panelOf(specification, panel).edges.map((_, edge) => ({ panel, edge })),
  );
  return at(all, seed % all.length);
}

/** A free edge, or any where all are sewn. */
function freeEdgeFrom(specification: Specification, seed: number): EdgeRef {
  for (let k = 0; k < 400; k++) {
    const ref = edgeFrom(specification, seed + k);
    if (stitchOf(specification, ref) < 0) return ref;
  }
  return edgeFrom(specification, seed);
}

function vertexFrom(specification: Specification, seed: number): VertexRef {
  const { panel, edge } = edgeFrom(specification, seed);
  return { panel, vertex: edge };
}

interface Step {
  readonly name: string;
  readonly run: (specification: Specification) => Edit;
}

/** Any edit at any place. */
const step: fc.Arbitrary<Step> = fc
  .record({
    kind: fc.constantFrom(
      "move", "moveBoth", "edge", "hem", "kind", "depth", "handle", "bendBoth", "add", "addBoth", "delete",
      "deleteBoth", "sew", "sewBoth", "unpick", "unpickBoth", "turn", "rename", "length", "angle", "place",
    ), // biome-ignore format: a list of words
    a: fc.nat(),
    b: fc.nat(),
    by: delta,
    share,
    curve: fc.constantFrom<CurveKind[]>("line", "quadratic", "cubic", "circle"),
  })
  .map(({ kind, a, b, by, share: s, curve: wanted }) => ({
    name: kind,
    run: (specification): Edit => {
      const edge = edgeFrom(specification, a);
      const vertex = vertexFrom(specification, a);
      const curve = curveOf(panelOf(specification, edge.panel), edge.edge);
      const stitch = a % Math.max(specification.pattern.stitches.length, 1);
      const moves = movesOf([vertex, vertexFrom(specification, b)], () => by);
      switch (kind) {
        case "move":
          return moveVertices(specification, moves);
        case "moveBoth":
          return moveMirrored(specification, moves);
        case "edge":
          return moveVertices(
            specification,
            movesOf(verticesOf(specification, edge), () => by),
          );
        case "hem": {
          const hem = hemOf(specification, edge);
          return hem === null
            ? moveVertices(specification, new Map())
            : moveVertices(specification, movesOfHem(specification, hem, by[0]));
        }
        case "kind":
          return reshapeEdge(specification, edge, shapeOfKind(curve, wanted, b % 2 ? "left" : "right"));
        case "depth":
          return reshapeEdge(specification, edge, shapeOfDepth(curve, by[0]));
        case "handle":
          return reshapeEdge(specification, edge, shapeWithHandle(curve, b % 2, by));
        case "bendBoth":
          return reshapeMirrored(specification, edge, shapeOfKind(curve, wanted, "left"));
        case "add":
          return addPoint(specification, edge, s);
        case "addBoth":
          return addPointMirrored(specification, edge, s);
        case "delete":
          return deletePoint(specification, vertex);
        case "deleteBoth":
          return deletePointMirrored(specification, vertex);
        case "sew":
          return makeStitch(specification, freeEdgeFrom(specification, a), freeEdgeFrom(specification, b));
        case "sewBoth":
          return makeStitchMirrored(
            specification,
            freeEdgeFrom(specification, a),
            freeEdgeFrom(specification, b),
          );
        case "unpick":
          return removeStitch(specification, stitch);
        case "unpickBoth":
          return removeStitchMirrored(specification, stitch);
        case "turn":
          return turnStitch(specification, stitch);
        case "rename":
          return renamePanel(
            specification,
            vertex.panel,
            at(["", "__proto__", "x", vertex.panel, "a b"], b % 5),
          );
        case "length":
          return moveVertices(
            specification,
            movesForLength(specification, edge, 1 + Math.abs(by[0]), "start"),
          );
        case "angle":
          return moveVertices(specification, movesForAngle(specification, edge, by[0] * 12, "middle"));
        case "place":
          return moveVertices(specification, movesToPlace(specification, vertex, by));
      }
    },
  }));

describe("every edit", () => {
  it("of real patterns starts from valid ones", () => {
    for (const { id, pattern } of realPatterns()) expect(problemsOf(pattern), id).toEqual([]);
  });

  it("gives a valid pattern, leaves the old one as it was, and says where edges and points went", () => {
    const done = new Map<string, number>();
    fc.assert(
      fc.property(real, fc.array(step, { minLength: 1, maxLength: 8 }), (pattern, steps) => {
        let specification: Specification = { ...pattern, properties: { trims: ["zip"] } };
        for (const { name, run } of steps) {
          const before = JSON.stringify(specification);
          const edit = run(specification);
          expect(JSON.stringify(specification), name).toBe(before);
          expect(problemsOf(edit.specification), name).toEqual([]);
          expect(edit.specification.properties, name).toEqual({ trims: ["zip"] });
          if (edit.refused !== undefined) expect(edit.specification, name).toBe(specification);
          else if (edit.specification !== specification) done.set(name, (done.get(name) ?? 0) + 1);
          for (const panel of panelNames(specification))
            for (const vertex of panelOf(specification, panel).vertices.keys()) {
              const place = edit.vertex({ panel, vertex });
              if (place !== null)
                expect(place.vertex, name).toBeLessThan(
                  panelOf(edit.specification, place.panel).vertices.length,
                );
              for (const edge of edit.edges({ panel, edge: vertex }))
                expect(edge.edge, name).toBeLessThan(panelOf(edit.specification, edge.panel).edges.length);
            }
          specification = edit.specification;
        }
      }),
      { numRuns: 250 },
    );
    // None of the kinds was refused each time: 21 kinds in about 1,100 steps.
    expect(done.size).toBe(21);
  }, 60_000);
});

describe("a point that is added", () => {
  it("changes no outline and keeps all seams paired at the same share", () => {
    fc.assert(
      fc.property(real, fc.nat(), share, (pattern, seed, s) => {
        const ref = edgeFrom(pattern, seed);
        const number = stitchOf(pattern, ref);
        const edit = addPoint(pattern, ref, s);
        fc.pre(edit.refused === undefined);
        const pieces = edit.edges(ref);
        expect(pieces.length).toBe(2);
        const [first, second] = [at(pieces, 0), at(pieces, 1)];
        const whole = edgeLength(pattern, ref);
        expect(Math.abs(edgeLength(edit.specification, first) - s * whole)).toBeLessThan(1e-4);
        expect(
          Math.abs(edgeLength(edit.specification, first) + edgeLength(edit.specification, second) - whole),
        ).toBeLessThan(1e-5);
        expect(
          Math.abs(
            signedArea(panelOf(edit.specification, ref.panel)) - signedArea(panelOf(pattern, ref.panel)),
          ),
        ).toBeLessThan(0.05);
        if (number < 0) {
          expect(edit.specification.pattern.stitches.length).toBe(pattern.pattern.stitches.length);
          return;
        }
        expect(edit.specification.pattern.stitches.length).toBe(pattern.pattern.stitches.length + 1);
        const partner = partnerIn(at(pattern.pattern.stitches, number), ref);
        const ratio = edgeLength(pattern, partner) / whole;
        for (const piece of pieces) {
          const stitch = at(edit.specification.pattern.stitches, stitchOf(edit.specification, piece));
          expect(isRightWrong(stitch)).toBe(isRightWrong(at(pattern.pattern.stitches, number)));
          const mine = edgeLength(edit.specification, piece);
          const theirs = edgeLength(edit.specification, partnerIn(stitch, piece));
          expect(Math.abs(theirs - ratio * mine)).toBeLessThan(1e-3);
        }
        // Where the halves meet, their partners meet too.
        const middle = edit.vertex({ panel: ref.panel, vertex: ref.edge });
        expect(middle).not.toBeNull();
        expect(facingPoint(edit.specification, { panel: second.panel, vertex: second.edge })).not.toBeNull();
      }),
      { numRuns: 150 },
    );
  }, 30_000);

  it("and is deleted again leaves the pattern as it was", () => {
    fc.assert(
      fc.property(real, fc.nat(), fc.double({ min: 0.1, max: 0.9, noNaN: true }), (pattern, seed, s) => {
        const ref = edgeFrom(pattern, seed);
        const added = addPoint(pattern, ref, s);
        fc.pre(added.refused === undefined);
        const middle = at(added.edges(ref), 1);
        const back = deletePoint(added.specification, { panel: middle.panel, vertex: middle.edge });
        expect(back.refused).toBeUndefined();
        expect(back.notes).toEqual([]);
        expect(back.specification.pattern.stitches.length).toBe(pattern.pattern.stitches.length);
        for (const name of panelNames(pattern)) {
          const [before, after] = [panelOf(pattern, name), panelOf(back.specification, name)];
          expect(after.vertices.length).toBe(before.vertices.length);
          for (const edge of before.edges.keys()) {
            const [one, other] = [curveOf(before, edge), curveOf(after, edge)];
            for (const t of [0, 0.3, 0.5, 0.8]) {
              const p = pointAt(one, t);
              const near = nearestOn(other, p).distance;
              expect(near).toBeLessThan(1e-3);
            }
            expect(Math.abs(at(edgeLengths(after), edge) - at(edgeLengths(before), edge))).toBeLessThan(1e-3);
          }
        }
      }),
      { numRuns: 80 },
    );
  }, 60_000);
});

describe("moving", () => {
  it("a whole edge keeps its shape and moves no other point", () => {
    fc.assert(
      fc.property(real, fc.nat(), delta, (pattern, seed, by) => {
        const ref = edgeFrom(pattern, seed);
        const edit = moveVertices(
          pattern,
          movesOf(verticesOf(pattern, ref), () => by),
        );
        fc.pre(edit.refused === undefined);
        const [before, after] = [panelOf(pattern, ref.panel), panelOf(edit.specification, ref.panel)];
        expect(at(after.edges, ref.edge)).toBe(at(before.edges, ref.edge));
        expect(Math.abs(at(edgeLengths(after), ref.edge) - at(edgeLengths(before), ref.edge))).toBeLessThan(
          1e-6,
        );
        const moved = verticesOf(pattern, ref).map((v) => v.vertex);
        before.vertices.forEach((p, k) => {
          if (!moved.includes(k)) expect(at(after.vertices, k)).toBe(p);
        });
        for (const name of panelNames(pattern))
          if (name !== ref.panel) expect(panelOf(edit.specification, name)).toBe(panelOf(pattern, name));
      }),
    );
  });

  it("one point of an arc keeps the arc's angle", () => {
    fc.assert(
      fc.property(real, fc.nat(), delta, (pattern, seed, by) => {
        const ref = edgeFrom(pattern, seed);
        const curve = curveOf(panelOf(pattern, ref.panel), ref.edge);
        fc.pre(curve.shape?.type === "circle");
        const edit = moveVertices(
          pattern,
          movesOf([{ panel: ref.panel, vertex: ref.edge }], () => by),
        );
        fc.pre(edit.refused === undefined);
        const after = curveOf(panelOf(edit.specification, ref.panel), ref.edge);
        const bend = (c: typeof curve) =>
          c.shape?.type === "circle" ? c.shape.params[0] / distance(c.start, c.end) : 0;
        expect(Math.abs(bend(after) / bend(curve) - 1)).toBeLessThan(1e-9);
      }),
      { numRuns: 400 },
    );
  });

  it("by numbers gives these numbers", () => {
    fc.assert(
      fc.property(
        real,
        fc.nat(),
        fc.double({ min: 1, max: 80, noNaN: true }),
        fc.double({ min: -179, max: 179, noNaN: true }),
        fc.constantFrom("start" as const, "end" as const, "middle" as const),
        (pattern, seed, length, angle, anchor) => {
          const ref = edgeFrom(pattern, seed);
          fc.pre(edgeLength(pattern, ref) > 0.5);
          const longer = moveVertices(pattern, movesForLength(pattern, ref, length, anchor));
          if (longer.refused === undefined)
            expect(Math.abs(edgeLength(longer.specification, ref) - length)).toBeLessThan(1e-5);
          const turned = moveVertices(pattern, movesForAngle(pattern, ref, angle, anchor));
          if (turned.refused === undefined)
            expect(Math.abs(angleOf(turned.specification, ref) - angle)).toBeLessThan(1e-5);
        },
      ),
    );
  });

  it("the hem of a skirt moves all its panels down by the same", () => {
    const skirts = realPatterns().filter((p) => Object.hasOwn(p.pattern.pattern.panels, "skirt_front"));
    expect(skirts.length).toBeGreaterThan(3);
    let rings = 0;
    for (const { id, pattern } of skirts) {
      const front = panelOf(pattern, "skirt_front");
      // The lowest free edge is the hem.
      const free = front.edges
        .map((_, edge) => ({ panel: "skirt_front", edge }))
        .filter((ref) => stitchOf(pattern, ref) < 0);
      const height = ({ edge }: EdgeRef) => pointAt(curveOf(front, edge), 0.5)[1];
      const lowest = free.sort((a, b) => height(a) - height(b))[0];
      if (lowest === undefined) continue;
      const hem = hemOf(pattern, lowest);
      if (hem === null) throw new Error(id);
      expect(hem.outward, id).toEqual([0, -1, 0]);
      if (!hem.edges.some((e) => e.panel === "skirt_back")) continue;
      rings += 1;
      const edit = moveVertices(pattern, movesOfHem(pattern, hem, 10));
      for (const { panel, edge } of hem.edges) {
        const [before, after] = [panelOf(pattern, panel), panelOf(edit.specification, panel)];
        expect(at(after.vertices, edge)[1], id).toBeCloseTo(at(before.vertices, edge)[1] - 10, 9);
        expect(at(after.vertices, edge)[0], id).toBeCloseTo(at(before.vertices, edge)[0], 9);
      }
    }
    expect(rings).toBeGreaterThan(2);
  });
});

describe("bending", () => {
  it("to a depth gives this depth", () => {
    fc.assert(
      fc.property(real, fc.nat(), fc.double({ min: -15, max: 15, noNaN: true }), (pattern, seed, depth) => {
        const ref = edgeFrom(pattern, seed);
        const before = curveOf(panelOf(pattern, ref.panel), ref.edge);
        fc.pre(distance(before.start, before.end) > 1);
        const edit = reshapeEdge(pattern, ref, shapeOfDepth(before, depth));
        const after = curveOf(panelOf(edit.specification, ref.panel), ref.edge);
        const chord = distance(after.start, after.end);
        const [x, y] = pointAt(after, 0.5);
        const d: Point = [after.end[0] - after.start[0], after.end[1] - after.start[1]];
        const height = (d[0] * (y - after.start[1]) - d[1] * (x - after.start[0])) / chord;
        expect(Math.abs(height - depth)).toBeLessThan(1e-3 * chord + 1e-6);
      }),
    );
  });

  it("by a handle puts the handle there", () => {
    fc.assert(
      fc.property(real, fc.nat(), delta, (pattern, seed, to) => {
        const ref = edgeFrom(pattern, seed);
        const curve = curveOf(panelOf(pattern, ref.panel), ref.edge);
        fc.pre(curve.shape?.type === "circle" && distance(curve.start, curve.end) > 2);
        const after = { ...curve, shape: shapeWithHandle(curve, 0, to) };
        // The middle of the arc is as far from the chord as the pointer, and on its side.
        const d: Point = [curve.end[0] - curve.start[0], curve.end[1] - curve.start[1]];
        const chord = Math.hypot(...d);
        const height = ([x, y]: Point) => (d[0] * (y - curve.start[1]) - d[1] * (x - curve.start[0])) / chord;
        expect(Math.abs(height(pointAt(after, 0.5)) - height(to))).toBeLessThan(1e-3 * chord);
      }),
      { numRuns: 300 },
    );
  });
});

describe("mirror editing", () => {
  const pairs = realPatterns().flatMap(({ id, pattern }) =>
    panelNames(pattern)
      .map((panel) => ({ id, pattern, panel, other: counterpartOf(pattern, panel) }))
      .filter((each) => each.other !== null && each.other.deviation < 1e-6),
  );

  it("finds the counterparts that names tell", () => {
    let told = 0;
    for (const { panel, other } of pairs) {
      const twin = panel.startsWith("left_") ? panel.replace("left_", "right_") : null;
      if (twin === null) continue;
      expect(other?.panel).toBe(twin);
      told += 1;
    }
    expect(told).toBeGreaterThan(20);
    const own = pairs.filter(({ panel, other }) => other?.panel === panel);
    expect(own.length).toBeGreaterThan(5);
  });

  it("is its own inverse: the counterpart of the counterpart", () => {
    for (const { pattern, panel, other } of pairs) {
      if (other === null) continue;
      const back = counterpartOf(pattern, other.panel);
      expect(back?.panel).toBe(panel);
      for (const k of panelOf(pattern, panel).vertices.keys()) expect(back?.vertex(other.vertex(k))).toBe(k);
    }
  });

  it("keeps both sides alike", () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...pairs),
        fc.nat(),
        delta,
        share,
        fc.constantFrom(0, 1, 2, 3),
        (each, v, by, s, what) => {
          const { pattern, panel } = each;
          const vertex = v % panelOf(pattern, panel).vertices.length;
          const edge = { panel, edge: vertex };
          const curve = curveOf(panelOf(pattern, panel), vertex);
          const edit = [
            () =>
              moveMirrored(
                pattern,
                movesOf([{ panel, vertex }], () => by),
              ),
            () => reshapeMirrored(pattern, edge, shapeOfKind(curve, "cubic", "left")),
            () => addPointMirrored(pattern, edge, s),
            () => deletePointMirrored(pattern, { panel, vertex }),
          ][what]?.();
          fc.pre(edit !== undefined && edit.refused === undefined && edit.notes.length === 0);
          if (edit === undefined) return;
          const after = counterpartOf(edit.specification, panel);
          expect(after?.panel).toBe(each.other?.panel);
          expect(after?.deviation).toBeLessThan(1e-4);
        },
      ),
      { numRuns: 200 },
    );
  }, 30_000);

  it("sews and unpicks both sides", () => {
    for (const { pattern, panel } of pairs) {
      const count = panelOf(pattern, panel).edges.length;
      for (let edge = 0; edge < count; edge++) {
        const number = stitchOf(pattern, { panel, edge });
        if (number < 0) continue;
        const stitch = at(pattern.pattern.stitches, number);
        const [a, b] = [mirroredEdge(pattern, stitch[0]), mirroredEdge(pattern, stitch[1])];
        if (a === null || b === null || stitchOf(pattern, a) !== stitchOf(pattern, b)) continue;
        const open = removeStitchMirrored(pattern, number).specification;
        for (const ref of [stitch[0], stitch[1], a, b]) expect(stitchOf(open, ref)).toBe(-1);
        if (isRightWrong(stitch)) continue;
        const sewn = makeStitchMirrored(open, stitch[0], stitch[1]).specification;
        expect(sewn.pattern.stitches.length).toBe(pattern.pattern.stitches.length);
        expect(stitchOf(sewn, a)).toBe(stitchOf(sewn, b));
      }
    }
  });
});
