import { describe, expect, it } from "vitest";
import { amended, canRedo, canUndo, movedTo, pushed, started } from "./history";

describe("history", () => {
  it("loses what could be redone when something else is done", () => {
    let history = pushed(pushed(started("a", 1), "b", 2), "c", 3);
    history = pushed(movedTo(history, 0), "d", 4);
    expect(history.entries.map((entry) => entry.label)).toEqual(["a", "d"]);
    expect([canUndo(history), canRedo(history)]).toEqual([true, false]);
  });

  it("stays within its ends", () => {
    const history = pushed(started("a", 1), "b", 2);
    expect(movedTo(history, -5).index).toBe(0);
    expect(movedTo(history, 9).index).toBe(1);
  });

  it("keeps the last hundred", () => {
    let history = started("0", 0);
    for (let k = 1; k <= 250; k += 1) history = pushed(history, String(k), k);
    expect(history.entries).toHaveLength(100);
    expect(history.entries[history.index]?.value).toBe(250);
    expect(new Set(history.entries.map((entry) => entry.id)).size).toBe(100);
  });

  it("amends every entry that is meant and no other", () => {
    const history = pushed(pushed(started("a", 1), "b", 2), "c", 1);
    const after = amended(
      history,
      (value) => value === 1,
      () => 7,
    );
    expect(after.entries.map((entry) => entry.value)).toEqual([7, 2, 7]);
    expect(history.entries.map((entry) => entry.value)).toEqual([1, 2, 1]);
  });
});
