/** Commands on the store: what the history says, and that undo gives the same bytes. */

import { beforeEach, describe, expect, it } from "vitest";
import type { Version } from "../../state/document";
import type { PatternJson } from "../../state/pattern-json";
import { currentVersion, useStudio } from "../../state/store";
import { problemsOf } from "../edits/validity";
import { at } from "../geometry/at";
import { arranged } from "../layout/arrangement";
import { panelOf, type Specification, stitchOf } from "../specification";
import { realPattern } from "../testing/real-patterns";
import {
  addPointsToSelected,
  deleteSelected,
  nudge,
  removeStitches,
  rotateSelected,
  selectAll,
  sewSelected,
} from "./commands";
import { commandFor } from "./keys";
import { usePatternView } from "./pattern-view-state";

const pattern = realPattern("gc_1000067");

function shown(): Specification {
  const version = currentVersion(useStudio.getState());
  if (version === null) throw new Error("nothing is open");
  return version.pattern;
}

function labels(): string[] {
  return useStudio.getState().history?.entries.map((entry) => entry.label) ?? [];
}

beforeEach(() => {
  useStudio.getState().open("Opened", { pattern: pattern as unknown as PatternJson } as Version);
  usePatternView.getState().set({
    arrangement: arranged(pattern),
    mirror: false,
    message: null,
    tool: "select",
    sewFrom: null,
  });
});

describe("commands", () => {
  it("each make one entry, and undo gives the same bytes", () => {
    const { select, undo } = useStudio.getState();
    const before = JSON.stringify(shown());
    const steps: [string, () => void][] = [
      ["Move point", () => nudge([0, 1])],
      ["Delete point of pant_f_l", deleteSelected],
    ];
    for (const [label, run] of steps) {
      select({ kind: "vertex", panel: "pant_f_l", vertex: 2 });
      run();
      expect(labels().at(-1)).toBe(label);
      expect(problemsOf(shown())).toEqual([]);
      expect(JSON.stringify(shown())).not.toBe(before);
      undo();
      expect(JSON.stringify(shown())).toBe(before);
      expect(shown()).toBe(pattern);
    }
  });

  it("add a point to the selected edge and select it", () => {
    useStudio.getState().select({ kind: "edge", panel: "pant_f_l", edge: 0 });
    addPointsToSelected();
    expect(panelOf(shown(), "pant_f_l").vertices.length).toBe(8);
    expect(panelOf(shown(), "pant_b_l").vertices.length).toBe(14);
    expect(useStudio.getState().selection).toEqual([{ kind: "vertex", panel: "pant_f_l", vertex: 1 }]);
  });

  it("remove a stitch of the selected edge and sew it again", () => {
    const edge = { panel: "pant_f_l", edge: 0 };
    const [one, other] = at(shown().pattern.stitches, stitchOf(shown(), edge));
    useStudio.getState().select({ kind: "edge", ...edge });
    deleteSelected();
    expect(stitchOf(shown(), edge)).toBe(-1);
    useStudio.getState().setSelection([
      { kind: "edge", ...one },
      { kind: "edge", ...other },
    ]);
    sewSelected();
    expect(stitchOf(shown(), one)).toBe(stitchOf(shown(), other));
    expect(labels()).toEqual(["Opened", "Remove stitch", `Sew ${one.panel} to ${other.panel}`]);
  });

  it("remove several stitches although their numbers change on the way", () => {
    const all = shown().pattern.stitches.map((_, k) => k);
    removeStitches(all);
    expect(shown().pattern.stitches).toEqual([]);
    expect(labels().length).toBe(2);
  });

  it("change both sides where mirror editing is on", () => {
    usePatternView.getState().set({ mirror: true });
    useStudio.getState().select({ kind: "vertex", panel: "pant_f_l", vertex: 4 });
    nudge([1, 0]);
    for (const name of ["pant_f_l", "pant_f_r"])
      expect(panelOf(shown(), name)).not.toBe(panelOf(pattern, name));
    expect(panelOf(shown(), "pant_b_l")).toBe(panelOf(pattern, "pant_b_l"));
  });

  it("say why nothing was done, and leave no entry", () => {
    useStudio.getState().select({ kind: "panel", panel: "pant_f_l" });
    addPointsToSelected();
    expect(usePatternView.getState().message).toMatch(/Select one edge/);
    sewSelected();
    expect(usePatternView.getState().tool).toBe("sew");
    expect(labels()).toEqual(["Opened"]);
  });

  it("turn and move panels in the window, and leave the pattern", () => {
    selectAll();
    const before = usePatternView.getState().arrangement;
    rotateSelected(90);
    nudge([1, 1]);
    expect(usePatternView.getState().arrangement).not.toEqual(before);
    expect(shown()).toBe(pattern);
    expect(labels()).toEqual(["Opened", "Turn panels", "Move panels"]);
  });
});

describe("keys", () => {
  const press = (key: string, more: Partial<{ shiftKey: boolean; ctrlKey: boolean }> = {}) =>
    commandFor({ key, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...more });

  it("move by a tenth of a centimetre, by one with Shift", () => {
    const { select } = useStudio.getState();
    select({ kind: "vertex", panel: "pant_f_l", vertex: 0 });
    press("ArrowRight")?.();
    const place = usePatternView.getState().arrangement.pant_f_l;
    const by = place?.mirrored ? -0.1 : 0.1;
    expect(at(panelOf(shown(), "pant_f_l").vertices, 0)[0]).toBeCloseTo(
      at(panelOf(pattern, "pant_f_l").vertices, 0)[0] + by,
      9,
    );
    press("ArrowUp", { shiftKey: true })?.();
    expect(at(panelOf(shown(), "pant_f_l").vertices, 0)[1]).toBeCloseTo(
      at(panelOf(pattern, "pant_f_l").vertices, 0)[1] + 1,
      9,
    );
  });

  it("leave the shell's keys to the shell", () => {
    for (const key of ["?", "c", "d", "[", "\\"]) expect(press(key)).toBeNull();
    for (const key of ["z", "y", "s", "o"]) expect(press(key, { ctrlKey: true })).toBeNull();
  });

  it("put a tool down before the selection is cleared", () => {
    useStudio.getState().select({ kind: "panel", panel: "pant_f_l" });
    press("p")?.();
    expect(usePatternView.getState().tool).toBe("point");
    press("Escape")?.();
    expect(usePatternView.getState().tool).toBe("select");
    press("Escape")?.();
    expect(useStudio.getState().selection).toEqual([]);
    expect(press("Escape")).toBeNull();
  });
});
