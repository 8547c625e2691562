/** Files from the user's disk: patterns are opened, pictures go to the prompt. */

import { api } from "../api/client";
import type { PatternJson as WirePattern } from "../api/types";
import { versionOf } from "../state/document";
import { usePrompt } from "../state/prompt";
import { notify, useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { tellFailure } from "./failures";
import { BODY_ENDINGS, fitToMesh } from "./fit";
import { newProject } from "./projects";

const PICTURES = ["image/png", "image/jpeg", "image/webp"];

export async function openFiles(files: File[]): Promise<void> {
  for (const file of files) {
    if (PICTURES.includes(file.type)) await addPicture(file);
    else if (file.name.toLowerCase().endsWith(".json")) await openPattern(file);
    else if (BODY_ENDINGS.some((ending) => file.name.toLowerCase().endsWith(ending))) {
      useSession.getState().set({ tab: "body" });
      await fitToMesh(file);
    } else
      notify(
        "error",
        `"${file.name}" is neither a picture nor a pattern.`,
        "Give a PNG, JPEG or WebP picture, a GarmentCode pattern (.json), or a body mesh (.obj, .ply, .glb, .stl).",
      );
  }
}

export async function addPicture(file: File): Promise<void> {
  const { server, set } = useSession.getState();
  const most = server?.limits.upload_bytes ?? Number.POSITIVE_INFINITY;
  if (file.size > most) {
    const megabytes = (bytes: number) => (bytes / 1e6).toFixed(0);
    notify(
      "error",
      `The picture is too large: ${megabytes(file.size)} MB, and at most ${megabytes(most)} MB are read.`,
      "Save it smaller, or as JPEG.",
    );
    return;
  }
  set({ working: "Looking at the picture" });
  try {
    const info = await api.sendPicture(file);
    const { pictures, set: change } = usePrompt.getState();
    change({ pictures: [...pictures, info].slice(-2) });
    set({ tab: "describe" });
  } catch (error) {
    tellFailure(error);
  } finally {
    set({ working: null });
  }
}

export async function openPattern(file: File): Promise<void> {
  const { server, set } = useSession.getState();
  const most = server?.limits.pattern_bytes ?? Number.POSITIVE_INFINITY;
  if (file.size > most) {
    notify(
      "error",
      `"${file.name}" is too large for a pattern.`,
      `At most ${Math.round(most / 1000)} kB are read.`,
    );
    return;
  }
  let pattern: WirePattern;
  try {
    pattern = JSON.parse(await file.text()) as WirePattern;
  } catch {
    notify(
      "error",
      `"${file.name}" is not JSON.`,
      "Give a pattern file as GarmentCode or SwiftTailor writes it.",
    );
    return;
  }
  const title = file.name.replace(/(_specification)?\.json$/i, "");
  set({ working: "Opening the pattern" });
  try {
    const made = await api.open({ pattern, title });
    const { text, set: change } = usePrompt.getState();
    // Words of the garment that was shown before are none of this one; what is being written stays.
    if (text === currentVersion(useStudio.getState())?.prompt) change({ text: made.prompt });
    newProject(title);
    useStudio.getState().open(`Opened ${file.name}`, versionOf(made));
    for (const warning of made.warnings) notify("warning", warning);
  } catch (error) {
    tellFailure(error);
  } finally {
    set({ working: null });
  }
}
