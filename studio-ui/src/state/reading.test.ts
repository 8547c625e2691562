import { describe, expect, it } from "vitest";
import type { Chip, Reading } from "../api/types";
import { carriedReading } from "./reading";

function chip(claim: string | null, value: string, text = `${claim}: ${value}`): Chip {
  return {
    id: `${claim}-${text}`,
    claim,
    dimension: null,
    about: "",
    label: claim ?? "",
    value,
    text,
    unit: "",
    certainty: 0.9,
    from: "text",
    holds: true,
    choices: [],
    range: null,
  };
}

function reading(parts: Partial<Reading>): Reading {
  const none = { made: [], assumed: [], cannot: [], unknown: [], shown: [] };
  return { ...none, language: "en", color: null, fabric: null, ...parts };
}

describe("carriedReading", () => {
  const before = reading({
    made: [chip("hem", "knee"), chip("sleeves", "long")],
    assumed: [chip("collar", "none")],
    cannot: [chip(null, "", "buttons")],
    unknown: [chip(null, "", "xyzzy")],
    shown: [chip("fit", "easy")],
  });

  it("keeps what was asked for in its place, with the value that the pattern has now", () => {
    const now = reading({
      shown: [chip("hem", "midi"), chip("sleeves", "long"), chip("collar", "none"), chip("fit", "loose")],
    });
    const after = carriedReading(before, now);
    expect(after.made.map((each) => each.text)).toEqual(["hem: midi", "sleeves: long"]);
    expect(after.assumed.map((each) => each.text)).toEqual(["collar: none"]);
    expect(after.shown.map((each) => each.text)).toEqual(["fit: loose"]);
    expect(after.cannot.map((each) => each.text)).toEqual(["buttons"]);
    expect(after.unknown.map((each) => each.text)).toEqual(["xyzzy"]);
  });

  it("shows nothing that the pattern no longer has, and no claim twice", () => {
    const after = carriedReading(
      before,
      reading({ made: [chip("hem", "mini")], shown: [chip("hem", "mini")] }),
    );
    expect(after.made.map((each) => each.text)).toEqual(["hem: mini"]);
    expect(after.assumed).toEqual([]);
    expect(after.shown).toEqual([]);
  });

  it("adds what an instruction asked for", () => {
    const after = carriedReading(
      before,
      reading({ made: [chip("slit", "left")], shown: [chip("hem", "knee")] }),
    );
    expect(after.made.map((each) => each.text)).toEqual(["hem: knee", "slit: left"]);
  });

  it("keeps pockets and the like where they were, as long as they are on it", () => {
    const trim = (name: string, more: Partial<Chip> = {}): Chip => ({
      ...chip(null, "", name),
      id: `trim:${name}`,
      value: null,
      ...more,
    });
    const dressed = reading({ made: [trim("zip")], assumed: [trim("belt"), trim("fly")], shown: [] });
    const now = reading({
      made: [trim("pockets")],
      shown: [trim("zip", { from: "pattern" }), trim("belt", { from: "pattern", holds: false })],
    });
    const after = carriedReading(dressed, now);
    expect(after.made.map((each) => [each.text, each.from])).toEqual([
      ["zip", "text"],
      ["pockets", "text"],
    ]);
    // The belt has no place any more, and the fly was taken off.
    expect(after.assumed.map((each) => [each.text, each.holds])).toEqual([["belt", false]]);
    expect(after.shown).toEqual([]);
  });
});
