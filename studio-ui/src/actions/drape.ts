import type { FabricName } from "../api/types";
import { notify } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { addMade } from "./alter";
import { runJob } from "./jobs";

/** Physics on the shown garment: `finish` goes on from how it was sewn, `drape` starts from flat panels. */
export async function drape(kind: "finish" | "drape", fabric: FabricName): Promise<void> {
  const before = currentVersion(useStudio.getState());
  if (before === null) return;
  const job = await runJob(kind === "finish" ? `Finishing in ${fabric}` : `Draping in ${fabric}`, {
    kind,
    pattern: before.pattern,
    mesh: before.mesh,
    fabric,
    color: before.color,
    looks: before.looks?.parts ?? [],
    print: before.print ?? null,
  });
  const document = job?.documents[0];
  if (document === undefined) return;
  const stopped = document.garment === "stopped";
  addMade(`${kind === "finish" ? "Finish" : "Drape"} in ${fabric}${stopped ? ", stopped" : ""}`, document);
  if (document.quality !== null && !document.quality.accepted)
    notify(
      "warning",
      `It hangs with faults: ${document.quality.reasons.join("; ")}.`,
      "Check the findings, or make it wider there.",
    );
  else if (!stopped) notify("ok", "It hangs as it would by physics.");
}
