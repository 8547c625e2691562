/** The pattern for another body: a size, measures, or the default body again. */

import { api } from "../api/client";
import type { BodyAnswer, FitRequest, MeasuresAnswer } from "../api/types";
import type { Version } from "../state/document";
import type { History } from "../state/history";
import { notify, useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { addMade } from "./alter";
import { tellFailure } from "./failures";

const LARGEST_FILE = 100_000;

/** Refits the shown pattern and sews it on that body; resolves with whether it was done. */
export async function fitTo(
  label: string,
  whom: Omit<FitRequest, "pattern" | "color" | "looks" | "print">,
): Promise<boolean> {
  const { history } = useStudio.getState();
  const before = currentVersion(useStudio.getState());
  if (history === null || before === null || useSession.getState().working !== null) return false;
  const { set } = useSession.getState();
  set({ working: "Refitting the pattern" });
  try {
    const { color, looks, print = null } = before;
    const document = await api.fit({
      pattern: asDrafted(history).pattern,
      color,
      looks: looks?.parts ?? [],
      print,
      ...whom,
    });
    // Somebody who has gone on meanwhile is not called back.
    if (currentVersion(useStudio.getState())?.pattern !== before.pattern) return false;
    addMade(label, document);
    if (document.unsewable !== null) notify("warning", document.unsewable.message, document.unsewable.hint);
    return true;
  } catch (error) {
    tellFailure(error);
    return false;
  } finally {
    set({ working: null });
  }
}

/** Endings of files that are body meshes. */
export const BODY_ENDINGS = [".obj", ".ply", ".glb", ".stl"];

/** Somebody's own body: a mesh that is kept by the server, and the pattern refitted to it. */
export async function fitToMesh(file: File): Promise<void> {
  const { server, working, set } = useSession.getState();
  if (working !== null) return;
  const most = server?.limits.upload_bytes ?? Number.POSITIVE_INFINITY;
  if (file.size > most) {
    const said = `At most ${(most / 2 ** 20).toFixed(0)} MB are read. Decimate it: 30,000 faces are plenty.`;
    notify("error", `"${file.name}" is too large for a body.`, said);
    return;
  }
  set({ working: "Measuring the body" });
  let found: BodyAnswer;
  try {
    found = await api.sendBody(file);
  } catch (error) {
    tellFailure(error);
    return;
  } finally {
    set({ working: null });
  }
  await fitTo(`For ${found.name}`, { body: found.body, called: found.name });
}

/** Measures of a file, and the pattern refitted to them. */
export async function fitToFile(file: File): Promise<void> {
  if (file.size > LARGEST_FILE) {
    notify("error", `"${file.name}" is too large for a file of measures.`, "Give names and numbers in cm.");
    return;
  }
  let found: MeasuresAnswer;
  try {
    found = await api.measures({ file_name: file.name, text: await file.text() });
  } catch (error) {
    tellFailure(error);
    return;
  }
  const called = file.name.replace(/\.(ya?ml|json)$/i, "");
  await fitTo(`For ${called}`, { measures: found.measures, called });
}

/**
 * The version before the last refits: each refit starts from there, so that trying one size after the other
 * adds up no rounding.
 */
function asDrafted(history: History<Version>): Version {
  let k = history.index;
  while (k > 0 && history.entries[k]?.value.origin === "fit") k -= 1;
  const entry = history.entries[k] ?? history.entries[history.index];
  if (entry === undefined) throw new Error("a history has an entry that is shown");
  return entry.value;
}
