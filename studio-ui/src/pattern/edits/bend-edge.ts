/** Bends edges: curve handles, straight to curved and back, the depth of a curve in cm. */

import { bulge, type Curve, chordLength, type Shape, toRelative } from "../geometry/curve";
import { curveOf } from "../geometry/outline";
import { type EdgeRef, type Point, panelOf, type Specification } from "../specification";
import { type Edit, edited, refused, withPanels } from "./edit";

export type CurveKind = "line" | "quadratic" | "cubic" | "circle";

/** A straight edge that is made a curve bends outward by this share of its length, so that it shows. */
const FIRST_BEND = 0.1;
/** An arc flatter than this share of its chord would have a radius without meaning. */
const FLATTEST_ARC = 1e-4;

export function kindOf(shape: Shape): CurveKind {
  return shape?.type ?? "line";
}

/** Gives an edge another shape over the same end points. */
export function reshapeEdge(specification: Specification, ref: EdgeRef, shape: Shape): Edit {
  const panel = panelOf(specification, ref.panel);
  if (shape !== undefined && !shape.params.flat().every(Number.isFinite))
    return refused(specification, "The curve is not made of finite numbers.");
  const edges = panel.edges.map((edge, k) => {
    if (k !== ref.edge) return edge;
    const { curvature: _, ...rest } = edge;
    return shape === undefined ? rest : { ...rest, curvature: shape };
  });
  return edited(withPanels(specification, { [ref.panel]: { ...panel, edges } }));
}

/** The shape whose handle has been moved to a point, cm in the panel's frame. Handle 0 of an arc is its middle. */
export function shapeWithHandle(curve: Curve, handle: number, to: Point): Shape {
  const { shape, start, end } = curve;
  if (shape === undefined) return undefined;
  const relative = toRelative(to, start, end);
  if (shape.type === "quadratic") return { type: "quadratic", params: [relative] };
  if (shape.type === "cubic")
    return {
      type: "cubic",
      params: handle === 0 ? [relative, shape.params[1]] : [shape.params[0], relative],
    };
  return arcOfBulge(relative[1], chordLength(curve));
}

/** An arc by the height of its middle over the chord, as a share of it, positive to the left of travel. */
export function arcOfBulge(height: number, chord: number): Shape {
  const sagitta = Math.max(Math.abs(height), FLATTEST_ARC) * chord;
  const radius = Math.max((chord * chord) / 4 + sagitta * sagitta, 0) / (2 * sagitta);
  return {
    type: "circle",
    params: [Math.max(radius, chord / 2), sagitta > chord / 2 ? 1 : 0, height < 0 ? 1 : 0],
  };
}

/** The shape of another kind that is most like this one; a straight edge bends to the given side. */
export function shapeOfKind(curve: Curve, kind: CurveKind, outward: "left" | "right"): Shape {
  if (kind === kindOf(curve.shape)) return curve.shape;
  if (kind === "line") return undefined;
  const height = curve.shape === undefined ? (outward === "left" ? FIRST_BEND : -FIRST_BEND) : bulge(curve);
  if (kind === "circle") return arcOfBulge(height, chordLength(curve));
  if (kind === "quadratic") return { type: "quadratic", params: [[0.5, 2 * height]] };
  if (curve.shape?.type === "quadratic") {
    // Exactly the same curve, one degree up.
    const [x, y] = curve.shape.params[0];
    return {
      type: "cubic",
      params: [
        [(2 / 3) * x, (2 / 3) * y],
        [(2 / 3) * x + 1 / 3, (2 / 3) * y],
      ],
    };
  }
  const y = (4 / 3) * height;
  return { type: "cubic", params: [[1 / 3, y], [2 / 3, y]] }; // biome-ignore format: one row
}

/** The shape whose middle stands off the chord by so many cm, positive to the left; of a line, an arc. */
export function shapeOfDepth(curve: Curve, depth: number): Shape {
  const chord = chordLength(curve);
  if (chord === 0) return curve.shape;
  const { shape } = curve;
  const height = depth / chord;
  if (shape === undefined || shape.type === "circle")
    return Math.abs(height) < FLATTEST_ARC ? undefined : arcOfBulge(height, chord);
  const more = height - bulge(curve);
  if (shape.type === "quadratic") {
    const [x, y] = shape.params[0];
    return { type: "quadratic", params: [[x, y + 2 * more]] };
  }
  const [[x1, y1], [x2, y2]] = shape.params;
  const each = (4 / 3) * more;
  return { type: "cubic", params: [[x1, y1 + each], [x2, y2 + each]] }; // biome-ignore format: one row
}

/** Height of an edge's middle over its chord in cm, positive to the left of travel. */
export function depthOf(specification: Specification, ref: EdgeRef): number {
  const curve = curveOf(panelOf(specification, ref.panel), ref.edge);
  return bulge(curve) * chordLength(curve);
}
