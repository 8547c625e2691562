import { api } from "../api/client";
import { useProject } from "../state/project";
import { notify, useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { tellFailure } from "./failures";

/** Saves the shown version in a format that the server writes; "zip" is everything. */
export async function download(format: string): Promise<void> {
  const version = currentVersion(useStudio.getState());
  if (version === null) return;
  const session = useSession.getState();
  session.set({ working: `Writing ${format.toUpperCase()}` });
  try {
    const { name, blob } = await api.exported({
      pattern: version.pattern,
      mesh: version.mesh,
      format,
      title: useProject.getState().name,
      color: version.color,
      looks: version.looks?.parts ?? [],
      print: version.print ?? null,
      prompt: version.prompt,
      seed: version.seed,
    });
    saveFile(name, blob);
    notify("ok", `Saved ${name}.`);
  } catch (error) {
    tellFailure(error, () => void download(format));
  } finally {
    session.set({ working: null });
  }
}

export function saveFile(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
