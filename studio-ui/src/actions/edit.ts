import { useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { addMade } from "./alter";
import { runJob } from "./jobs";

/** Changes the shown pattern as an instruction says; resolves with whether it was done. */
export async function editBy(instruction: string): Promise<boolean> {
  const before = currentVersion(useStudio.getState());
  const text = instruction.trim();
  if (before === null || text === "") return false;
  const job = await runJob("Editing the garment", {
    kind: "edit",
    pattern: before.pattern,
    instruction: text,
    color: before.color,
    looks: before.looks?.parts ?? [],
    print: before.print ?? null,
    ...(before.seed !== null ? { seed: before.seed } : {}),
  });
  const document = job?.documents[0];
  if (document === undefined) return false;
  addMade(text, document);
  useSession.getState().set({ tab: "adjust" });
  return true;
}
