/** What was asked for stays in view while the garment is changed: the chips follow the pattern. */

import type { Chip, Reading } from "../api/types";

/**
 * The reading of a changed pattern, in the terms of what was asked for before.
 *
 * A statement that was made or assumed keeps its place with the value that the pattern has now; what could not be made
 * or understood stays; all else that the pattern shows is listed as such.
 */
export function carriedReading(before: Reading | null, after: Reading): Reading {
  if (before === null) return after;
  const asked = [...after.made, ...after.assumed];
  const known = new Map<string, Chip>();
  for (const chip of [...after.shown, ...asked]) if (chip.claim !== null) known.set(chip.claim, chip);
  const placed = new Set<string>();
  const follow = (chips: Chip[]) =>
    chips.flatMap((chip) => {
      if (chip.claim === null) return [];
      const now = known.get(chip.claim);
      if (now === undefined) return [];
      placed.add(chip.claim);
      const same = now.value === chip.value;
      return [same ? chip : { ...now, id: chip.id, certainty: null, from: "pattern" as const, holds: true }];
    });
  const made = follow(before.made);
  const assumed = follow(before.assumed);
  // What an instruction asked for besides is made now, too.
  const added = asked.filter((chip) => chip.claim === null || !placed.has(chip.claim));
  for (const chip of added) if (chip.claim !== null) placed.add(chip.claim);
  return {
    ...after,
    made: [...made, ...added],
    assumed,
    cannot: joined(before.cannot, after.cannot),
    unknown: joined(before.unknown, after.unknown),
    shown: after.shown.filter((chip) => chip.claim === null || !placed.has(chip.claim)),
    language: before.language,
  };
}

function joined(before: Chip[], after: Chip[]): Chip[] {
  const texts = new Set(before.map((chip) => chip.text));
  return [...before, ...after.filter((chip) => !texts.has(chip.text))];
}
