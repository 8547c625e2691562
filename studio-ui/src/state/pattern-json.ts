/** A sewing pattern as GarmentCode's JSON has it. Lengths in cm, angles in degrees, local y up. */

export type Point = [number, number];

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

export interface PanelJson {
  translation: [number, number, number];
  rotation: [number, number, number];
  vertices: Point[];
  edges: EdgeJson[];
  label?: string;
}

export interface StitchSide {
  panel: string;
  edge: number;
}

/** Two edges; "right_wrong" as a third element: start meets start. */
export type StitchJson = [StitchSide, StitchSide] | [StitchSide, StitchSide, "right_wrong"];

export interface PatternJson {
  pattern: {
    panels: Record<string, PanelJson>;
    stitches: StitchJson[];
    panel_order?: string[];
  };
  parameters?: unknown;
  parameter_order?: unknown;
  properties?: Record<string, unknown>;
}
