import type { Document } from "../api/types";
import { type ClothLook, PLAIN_LOOK } from "./cloth";
import { DEFAULT_CLOTH } from "./cloth-color";
import { printTile } from "./print-tile";

/** A garment in its own colours and print, whatever is looked at in its window; plain where its print is not to be had. */
export async function ownLook({
  color,
  looks,
  print,
}: Pick<Document, "color" | "looks" | "print">): Promise<ClothLook> {
  const tile = print ? await printTile(print).catch(() => null) : null;
  const panels = looks?.panels ?? PLAIN_LOOK.panels;
  return { ...PLAIN_LOOK, color: color ?? DEFAULT_CLOTH, panels, tile };
}
