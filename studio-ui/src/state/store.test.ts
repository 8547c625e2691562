import { beforeEach, describe, expect, it } from "vitest";
import type { Document, TrimMark } from "../api/types";
import { versionOf } from "./document";
import type { PatternJson } from "./pattern-json";
import { currentVersion, shownFindings, shownMesh, shownPattern, shownTrims, useStudio } from "./store";

function square(side: number, panels = ["front"]): PatternJson {
  const panel = {
    translation: [0, 0, 0] as [number, number, number],
    rotation: [0, 0, 0] as [number, number, number],
    vertices: [
      [0, 0],
      [side, 0],
      [side, side],
      [0, side],
    ] as [number, number][],
    edges: [0, 1, 2, 3].map((k) => ({ endpoints: [k, (k + 1) % 4] as [number, number] })),
  };
  return {
    pattern: {
      panels: Object.fromEntries(panels.map((name) => [name, panel])),
      stitches: [],
      panel_order: panels,
    },
  };
}

const document = (pattern: PatternJson, mesh: string): Document => ({
  origin: "example",
  title: "A square",
  pattern,
  findings: [],
  seams: [],
  mesh,
  unsewable: null,
  body: "body",
  reading: {
    made: [],
    assumed: [],
    cannot: [],
    unknown: [],
    shown: [],
    language: null,
    color: null,
    fabric: null,
  },
  dimensions: [],
  description: "",
  notes: [],
  warnings: [],
  changes: [],
  open: [],
  quality: null,
  garment: "sewn",
  color: "#123456",
  fabric: "cotton",
  edge_length: 2,
  seed: 7,
  prompt: "a square",
  seconds: {},
});

const state = () => useStudio.getState();

describe("the store", () => {
  beforeEach(() => state().open("Opened", versionOf(document(square(10), "mesh-10"))));

  it("makes one entry of a drag, however long it is", () => {
    for (let side = 11; side < 40; side += 1) state().preview(square(side));
    const last = square(40);
    state().preview(last);
    expect(state().history?.entries).toHaveLength(1);
    expect(shownPattern(state())).toBe(last);
    state().apply("Move point", last);
    expect(state().history?.entries.map((entry) => entry.label)).toEqual(["Opened", "Move point"]);
    expect(state().draft).toBeNull();
  });

  it("keeps the garment that came for the last state of a drag", () => {
    const last = square(40);
    state().preview(last);
    state().answerDraft({ pattern: last, findings: [], seams: [], mesh: "mesh-40", edge_length: 2.5 });
    expect(shownMesh(state())).toBe("mesh-40");
    state().apply("Move point", last);
    expect(currentVersion(state())).toMatchObject({
      mesh: "mesh-40",
      garment: "sewn",
      edge_length: 2.5,
      findings: [],
      color: "#123456",
      seed: 7,
      reading: null,
    });
  });

  it("asks anew where the garment is of an earlier state of the drag", () => {
    state().preview(square(20));
    state().answerDraft({ pattern: square(20), findings: [], seams: [], mesh: "mesh-20", edge_length: 2.5 });
    state().apply("Move point", square(40));
    expect(currentVersion(state())).toMatchObject({ mesh: null, findings: null });
    expect(shownFindings(state())).toBeNull();
  });

  it("drops what arrives for a pattern that is gone", () => {
    const other = square(99);
    state().amend(other, { mesh: "mesh-99", edge_length: 2.5 });
    expect(currentVersion(state())?.mesh).toBe("mesh-10");
    state().answerDraft({ pattern: other, findings: [], seams: [], mesh: "mesh-99", edge_length: 2.5 });
    expect(shownMesh(state())).toBe("mesh-10");
  });

  it("brings garment and pattern back together on undo", () => {
    state().apply("Larger", square(20));
    state().undo();
    expect(shownMesh(state())).toBe("mesh-10");
    expect(state().history?.entries).toHaveLength(2);
    state().redo();
    expect(shownPattern(state())?.pattern.panels.front?.vertices[1]).toEqual([20, 0]);
  });

  it("forgets selected places that a pattern no longer has", () => {
    state().apply("Two panels", square(10, ["front", "back"]));
    state().setSelection([
      { kind: "panel", panel: "back" },
      { kind: "edge", panel: "front", edge: 3 },
      { kind: "edge", panel: "front", edge: 4 },
    ]);
    state().undo();
    expect(state().selection).toEqual([{ kind: "edge", panel: "front", edge: 3 }]);
  });

  it("takes back a drag that was given up", () => {
    state().preview(square(33));
    state().cancelPreview();
    expect(shownPattern(state())?.pattern.panels.front?.vertices[1]).toEqual([10, 0]);
  });

  it("undoes where panels were laid, and counts small steps as one", () => {
    const places = (x: number) => ({ front: { at: [x, 0] as [number, number], angle: 0, mirrored: false } });
    state().arrange("Move panels", places(0), places(1));
    state().arrange("Move panels", places(1), places(2));
    expect(state().history?.entries).toHaveLength(2);
    state().apply("Larger", square(20));
    expect(currentVersion(state())?.arrangement).toEqual(places(2));
    state().goTo(0);
    expect(currentVersion(state())?.arrangement).toEqual(places(0));
    expect(currentVersion(state())?.mesh).toBe("mesh-10");
  });

  it("does not keep a hasty garment", () => {
    const dragged = square(12);
    state().preview(dragged);
    state().answerDraft({
      pattern: dragged,
      findings: [],
      seams: [],
      mesh: "mesh-hasty",
      edge_length: 2.5,
      hasty: true,
    });
    expect(shownMesh(state())).toBe("mesh-hasty");
    state().apply("Drag", dragged);
    expect(currentVersion(state())?.mesh).toBeNull();
    expect(currentVersion(state())?.findings).toEqual([]);
  });

  it("marks pockets where they were until it is known where they are", () => {
    const mark = (x: number): TrimMark => ({
      trim: "zip",
      panel: "front",
      kind: "zip",
      points: [
        [x, 0],
        [x, 9],
      ],
      radius: 0,
    });
    expect(shownTrims(state())).toEqual([]);
    expect(shownTrims(state())).toBe(shownTrims(state()));
    const [before, dragged, after] = [[mark(5)], [mark(6)], [mark(7)]];
    state().open("Opened", versionOf({ ...document(square(10), "mesh-10"), trims: before }));
    const larger = square(12);
    state().preview(larger);
    expect(shownTrims(state())).toBe(before);
    const answer = { findings: [], seams: [], mesh: null, edge_length: 2.5 };
    state().answerDraft({ ...answer, pattern: larger, trims: dragged });
    expect(shownTrims(state())).toBe(dragged);
    state().apply("Drag", larger);
    expect(shownTrims(state())).toBe(dragged);
    state().amend(larger, { trims: after });
    expect(shownTrims(state())).toBe(after);
    state().undo();
    expect(shownTrims(state())).toBe(before);
  });

  it("dyes the cloth in its print too, and keeps what is printed on it", () => {
    const pattern = square(10);
    const colors = ["#ffffff", "#123456"];
    const print = { kind: "dots" as const, colors, sizes: { radius: 1 } };
    useStudio.getState().open("Made", { ...versionOf(document(pattern, "mesh")), print });
    useStudio.getState().dye("#aa0000");
    expect(currentVersion(useStudio.getState())?.print).toEqual({ ...print, colors: ["#ffffff", "#aa0000"] });
    useStudio.getState().apply("Move", square(12));
    expect(currentVersion(useStudio.getState())?.print?.colors).toEqual(["#ffffff", "#aa0000"]);
    useStudio.getState().open("Made", versionOf(document(pattern, "mesh")));
    useStudio.getState().dye("#00aa00");
    expect(currentVersion(useStudio.getState())?.print ?? null).toBeNull();
  });

  it("toggles what is selected", () => {
    state().select({ kind: "panel", panel: "front" }, "toggle");
    state().select({ kind: "edge", panel: "front", edge: 1 }, "toggle");
    state().select({ kind: "panel", panel: "front" }, "toggle");
    expect(state().selection).toEqual([{ kind: "edge", panel: "front", edge: 1 }]);
    state().select(null);
    expect(state().selection).toEqual([]);
  });
});
