import type { Chip } from "../api/types";
import { ReadingChip } from "./ReadingChip";

export type ChipKind = "made" | "assumed" | "cannot" | "unknown" | "shown";

const TITLES: Record<ChipKind, { title: string; about: string }> = {
  made: { title: "Made", about: "Asked for, and so in the pattern" },
  assumed: { title: "Assumed", about: "Not asked for, but likely; correct what is wrong" },
  cannot: { title: "Not possible yet", about: "Understood, and cannot be made yet" },
  unknown: { title: "Not understood", about: "Say it in other words" },
  shown: { title: "What the pattern shows", about: "Press one to change it" },
};

export function ChipList({ kind, chips }: { kind: ChipKind; chips: Chip[] }) {
  if (chips.length === 0) return null;
  const { title, about } = TITLES[kind];
  return (
    <section className="chip-list" aria-label={title}>
      <h3>
        {title} <span className="muted">{about}</span>
      </h3>
      <ul className="chips">
        {chips.map((chip) => (
          <li key={chip.id}>
            <ReadingChip chip={chip} kind={kind} />
          </li>
        ))}
      </ul>
    </section>
  );
}
