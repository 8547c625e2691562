/** Two garments that words asked for: one is shown, the other waits with all that was done to it. */

import type { Document } from "../api/types";
import type { Piece } from "../state/outfit";
import { useProject } from "../state/project";
import { usePrompt } from "../state/prompt";
import { useSession } from "../state/session";
import { useStudio } from "../state/store";
import { openMade } from "./generate";

/** Shows another garment of the outfit, as it was left. */
export function showPiece(index: number): void {
  const { outfit, set } = useSession.getState();
  const piece = outfit?.pieces[index];
  if (outfit === null || piece === undefined || index === outfit.shown) return;
  const pieces = outfit.pieces.map((each, k) => (k === outfit.shown ? asLeft(each) : each));
  if (piece.left === null) openMade(piece.document);
  else {
    useStudio.getState().restore(piece.left.history);
    useProject.getState().set(piece.left.project);
    if (piece.document.seed !== null) usePrompt.getState().set({ seed: piece.document.seed });
  }
  set({ outfit: { pieces, shown: index } });
}

/** The outfit of what a job made, with one of it shown; null where that is one garment. */
export function outfitOf(documents: Document[], shown: Document): { pieces: Piece[]; shown: number } | null {
  const same = documents.filter((each) => each.seed === shown.seed);
  if (same.length < 2 || same.some((each) => !each.part)) return null;
  return { pieces: same.map((document) => ({ document, left: null })), shown: same.indexOf(shown) };
}

function asLeft(piece: Piece): Piece {
  const { history } = useStudio.getState();
  const { set: _, ...project } = useProject.getState();
  return history === null ? piece : { ...piece, left: { history, project } };
}
