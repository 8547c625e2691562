/**
 * A sewing pattern as GarmentCode's JSON holds it, and as the server sends it: centimetres, loops in order
 * (edge k joins vertex k to vertex k + 1), control points relative to the edge.
 *
 * Nothing here is ever changed in place. An edit makes new objects for what differs and keeps all others, so
 * that a panel that is the same object looks the same.
 */

export type Point = readonly [number, number];

export interface QuadraticCurvature {
  readonly type: "quadratic";
  readonly params: readonly [Point];
}

export interface CubicCurvature {
  readonly type: "cubic";
  readonly params: readonly [Point, Point];
}

/** Radius in cm, which does not follow the end points; large: more than half a turn; right: bulges right. */
export interface CircleCurvature {
  readonly type: "circle";
  readonly params: readonly [number, number, number];
}

export type Curvature = QuadraticCurvature | CubicCurvature | CircleCurvature;

export interface Edge {
  readonly endpoints: readonly [number, number];
  readonly label?: string;
  /** Absent: straight. */
  readonly curvature?: Curvature;
}

export interface Panel {
  readonly translation: readonly [number, number, number];
  /** Degrees about x, y and z. */
  readonly rotation: readonly [number, number, number];
  readonly vertices: readonly Point[];
  readonly edges: readonly Edge[];
  readonly label?: string;
}

export interface EdgeRef {
  readonly panel: string;
  readonly edge: number;
}

export interface VertexRef {
  readonly panel: string;
  readonly vertex: number;
}

/** Plain: start of the first meets the end of the second. "right_wrong": start meets start. */
export type Stitch = readonly [EdgeRef, EdgeRef] | readonly [EdgeRef, EdgeRef, "right_wrong"];

export interface Specification {
  readonly pattern: {
    readonly panels: Readonly<Record<string, Panel>>;
    readonly stitches: readonly Stitch[];
    readonly panel_order: readonly string[];
  };
  readonly parameters?: unknown;
  readonly parameter_order?: unknown;
  readonly properties?: unknown;
}

/** The panel of that name. */
export function panelOf(specification: Specification, name: string): Panel {
  const panel = Object.hasOwn(specification.pattern.panels, name)
    ? specification.pattern.panels[name]
    : undefined;
  if (panel === undefined) throw new RangeError(`There is no panel named '${name}'.`);
  return panel;
}

/** Names of all panels, in the pattern's own order. */
export function panelNames(specification: Specification): readonly string[] {
  return specification.pattern.panel_order;
}

export function sameEdge(one: EdgeRef, other: EdgeRef): boolean {
  return one.panel === other.panel && one.edge === other.edge;
}

export function sameVertex(one: VertexRef, other: VertexRef): boolean {
  return one.panel === other.panel && one.vertex === other.vertex;
}

/** Key of an edge or vertex in maps and sets. */
export function edgeKey(ref: EdgeRef): string {
  return `${ref.panel}\u0000${ref.edge}`;
}

export function vertexKey(ref: VertexRef): string {
  return `${ref.panel}\u0000${ref.vertex}`;
}

/** Number of the stitch that holds an edge, or -1. */
export function stitchOf(specification: Specification, ref: EdgeRef): number {
  return specification.pattern.stitches.findIndex((s) => sameEdge(s[0], ref) || sameEdge(s[1], ref));
}

export function isRightWrong(stitch: Stitch): boolean {
  return stitch[2] === "right_wrong";
}

/** The edge on the other side of a stitch. */
export function partnerIn(stitch: Stitch, ref: EdgeRef): EdgeRef {
  return sameEdge(stitch[0], ref) ? stitch[1] : stitch[0];
}
