/**
 * A sewing pattern as GarmentCode's JSON has it. Lengths in cm, angles in degrees, local y up.
 *
 * The same as in api/types.ts, but with each kind of curve and its own numbers, so that the compiler helps.
 */

import type {
  EdgePlace,
  Point,
  StitchJson,
  PanelJson as WirePanel,
  PatternJson as WirePattern,
} from "../api/types";

export type { EdgePlace, Point, StitchJson };

export type Curvature =
  | { type: "quadratic"; params: [Point] }
  | { type: "cubic"; params: [Point, Point] }
  /** Radius in cm, large arc (0 or 1), right of the direction of travel (0 or 1). */
  | { type: "circle"; params: [number, number, number] };

export interface EdgeJson {
  endpoints: [number, number];
  curvature?: Curvature;
  label?: string;
}

export interface PanelJson extends Omit<WirePanel, "edges"> {
  edges: EdgeJson[];
}

export interface PatternJson extends Omit<WirePattern, "pattern"> {
  pattern: {
    panels: Record<string, PanelJson>;
    stitches: StitchJson[];
    panel_order: string[];
  };
}

/** The server has checked that numbers go with their kind of curve. */
export function fromWire({ pattern, ...rest }: WirePattern): PatternJson {
  const panels = pattern.panels as Record<string, PanelJson>;
  return {
    ...rest,
    pattern: { ...pattern, panels, panel_order: pattern.panel_order ?? Object.keys(panels) },
  };
}
