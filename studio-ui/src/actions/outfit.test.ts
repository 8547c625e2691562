import { beforeEach, expect, test } from "vitest";
import type { Document, Part } from "../api/types";
import { versionOf } from "../state/document";
import { useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { openChosen } from "./generate";
import { outfitOf, showPiece } from "./outfit";

const made = (seed: number, part: Part | null) =>
  ({
    title: `${part} ${seed}`,
    prompt: "a blouse and a skirt",
    seed,
    part,
    pattern: { pattern: { panels: {} } },
  }) as unknown as Document;
const BLOUSE = made(3, "upper");
const SKIRT = made(3, "lower");

beforeEach(() => useSession.getState().set({ outfit: null, variants: null }));

test("of several seeds the two of one seed belong together; of one garment nothing does", () => {
  const all = [made(2, "upper"), BLOUSE, made(2, "lower"), SKIRT];
  expect(outfitOf(all, SKIRT)?.pieces.map((each) => each.document)).toEqual([BLOUSE, SKIRT]);
  expect(outfitOf(all, SKIRT)?.shown).toBe(1);
  expect(outfitOf([made(1, null), made(2, null)], made(1, null))).toBeNull();
});

test("the other garment is shown, and what was done to the first is there when it is shown again", () => {
  openChosen(BLOUSE, [BLOUSE, SKIRT]);
  useStudio.getState().add("shorter", { ...versionOf(BLOUSE), title: "shorter" });
  showPiece(1);
  expect(currentVersion(useStudio.getState())?.title).toBe(SKIRT.title);
  showPiece(0);
  expect(currentVersion(useStudio.getState())?.title).toBe("shorter");
  expect(useStudio.getState().history?.entries.length).toBe(2);
  expect(useSession.getState().outfit?.shown).toBe(0);
});

test("another garment that is opened ends the outfit", () => {
  openChosen(BLOUSE, [BLOUSE, SKIRT]);
  openChosen(made(1, null), [made(1, null)]);
  expect(useSession.getState().outfit).toBeNull();
});
