/** What was asked for stays in view while the garment is changed: the chips follow the pattern. */

import type { Chip, Reading } from "../api/types";

/**
 * The reading of a changed pattern, in the terms of what was asked for before.
 *
 * A statement that was made or assumed keeps its place with the value that the pattern has now, and so do pockets and
 * the like as long as they are on it; what could not be made or understood stays; all else that the pattern shows is
 * listed as such.
 */
export function carriedReading(before: Reading | null, after: Reading): Reading {
  if (before === null) return after;
  const asked = [...after.made, ...after.assumed];
  const known = new Map<string, Chip>();
  for (const chip of [...after.shown, ...asked]) {
    const name = topic(chip);
    if (name !== null) known.set(name, chip);
  }
  const placed = new Set<string>();
  const follow = (chips: Chip[]) =>
    chips.flatMap((chip) => {
      const name = topic(chip);
      const now = name === null ? undefined : known.get(name);
      if (name === null || now === undefined) return [];
      placed.add(name);
      if (chip.claim === null) return [{ ...chip, holds: now.holds }];
      const same = now.value === chip.value;
      return [same ? chip : { ...now, id: chip.id, certainty: null, from: "pattern" as const, holds: true }];
    });
  const made = follow(before.made);
  const assumed = follow(before.assumed);
  // What an instruction asked for besides is made now, too.
  const isPlaced = (chip: Chip) => placed.has(topic(chip) ?? "");
  const added = asked.filter((chip) => !isPlaced(chip));
  for (const name of added.map(topic)) if (name !== null) placed.add(name);
  return {
    ...after,
    made: [...made, ...added],
    assumed,
    cannot: joined(before.cannot, after.cannot),
    unknown: joined(before.unknown, after.unknown),
    shown: after.shown.filter((chip) => !isPlaced(chip)),
    language: before.language,
  };
}

/** What a chip is a statement about, whatever it says of it; null of steps and of words that were not understood. */
function topic(chip: Chip): string | null {
  return chip.claim ?? (chip.id.startsWith("trim:") ? chip.id : null);
}

function joined(before: Chip[], after: Chip[]): Chip[] {
  const texts = new Set(before.map((chip) => chip.text));
  return [...before, ...after.filter((chip) => !texts.has(chip.text))];
}
