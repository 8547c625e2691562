/** Chips and sliders: the pattern is cut to what they say. */

import { api } from "../api/client";
import type { ChangeRequest, ClothPrint, Document, PartLook } from "../api/types";
import { versionOf } from "../state/document";
import { LatestWins } from "../state/latest-wins";
import { fromWire, type PatternJson } from "../state/pattern-json";
import { carriedReading } from "../state/reading";
import { notify, useSession } from "../state/session";
import { currentVersion, lastReading, useStudio } from "../state/store";
import { tellFailure } from "./failures";

/** One change at once, such as a chip: "hem: midi". */
export async function alter(label: string, change: ChangeRequest): Promise<void> {
  const before = currentVersion(useStudio.getState());
  if (before === null) return;
  const session = useSession.getState();
  session.set({ working: "Recutting" });
  try {
    const document = await api.alter({
      pattern: before.pattern,
      changes: [change],
      color: before.color,
      looks: before.looks?.parts ?? [],
      print: before.print ?? null,
    });
    addMade(label, document);
  } catch (error) {
    tellFailure(error);
  } finally {
    session.set({ working: null });
  }
}

/** Adds what was made of the shown version to the history; words and seed it was made of stay. */
export function addMade(label: string, document: Document): void {
  const before = currentVersion(useStudio.getState());
  const { title, prompt, seed } = before ?? document;
  const reading = carriedReading(lastReading(useStudio.getState()), document.reading);
  useStudio.getState().add(label, { ...versionOf(document), title, prompt, seed, reading });
  for (const open of document.open)
    notify("warning", `Not done: ${open}`, "Say it in other words, or move the pattern's points by hand.");
  for (const warning of document.warnings) notify("warning", warning);
}

interface Slide {
  pattern: PatternJson;
  color: string | null;
  looks: PartLook[];
  print: ClothPrint | null;
  dimension: string;
  value: number;
  label: string;
}

let slide: { base: Slide; shown: Document | null; released: boolean; asked: number } | null = null;

const slider = new LatestWins<Slide, Document>(
  ({ pattern, color, looks, print, dimension, value }) =>
    api.alter({ pattern, changes: [{ dimension, value }], color, looks, print }),
  (document, state) => {
    if (slide === null) return;
    slide.shown = document;
    if (slide.released && state.value === slide.asked) return finish(state.label, document);
    const { findings, seams, trims = [], mesh, edge_length } = document;
    const pattern = fromWire(document.pattern);
    useStudio.getState().previewAnswered({ pattern, findings, seams, trims, mesh, edge_length });
  },
  (error) => {
    slide = null;
    useStudio.getState().cancelPreview();
    tellFailure(error);
  },
  (busy) => useSession.getState().set({ sewing: busy }),
);

/** While the slider moves; always measured from the version that was there when it was taken. */
export function slideTo(dimension: string, value: number, label: string): void {
  const version = currentVersion(useStudio.getState());
  if (version === null) return;
  if (slide === null || slide.base.dimension !== dimension || slide.released) {
    slider.reset();
    const { pattern, color, print = null } = version;
    const base = { pattern, color, looks: version.looks?.parts ?? [], print, dimension, value, label };
    slide = { base, shown: null, released: false, asked: value };
  }
  slide.asked = value;
  slider.request({ ...slide.base, value, label });
}

/** The slider was let go: one entry in the history, as soon as its garment is there. */
export function slideEnds(label: string): void {
  if (slide === null) return;
  slide.released = true;
  if (!slider.busy && slide.shown !== null) finish(label, slide.shown);
}

function finish(label: string, document: Document): void {
  slide = null;
  addMade(label, document);
}
