import { describe, expect, it } from "vitest";
import type { TrimMark } from "../../api/types";
import { trimsByPanel } from "./TrimMarks";

const mark = (panel: string, trim: string): TrimMark => ({
  trim,
  panel,
  kind: "button",
  points: [[1, 2]],
  radius: 0.6,
});

describe("marks of trims", () => {
  it("are sorted by panel, and keep their order", () => {
    const marks = [mark("left", "a"), mark("right", "b"), mark("left", "c")];
    const found = trimsByPanel(marks);
    expect([...found.keys()]).toEqual(["left", "right"]);
    expect(found.get("left")?.map(({ trim }) => trim)).toEqual(["a", "c"]);
    expect(trimsByPanel([]).size).toBe(0);
  });
});
