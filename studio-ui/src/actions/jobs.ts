/** Work that takes a while: started, watched by its events, cancelled. One at a time in this window. */

import { ApiError, api } from "../api/client";
import type { Job, JobEventName, JobRequest } from "../api/types";
import { garmentMesh } from "../garment/mesh-cache";
import { notify, useSession } from "../state/session";
import { tellFailure } from "./failures";

const EVENTS: JobEventName[] = ["place", "stage", "frame", "done", "failed", "cancelled", "stopped"];
const ENDS: JobEventName[] = ["done", "failed", "cancelled", "stopped"];

let source: EventSource | null = null;
let fetching = false;

/** Resolves with the finished job, or null where it failed, was cancelled or could not begin; that is told. */
export async function runJob(title: string, request: JobRequest): Promise<Job | null> {
  const session = useSession.getState();
  if (useSession.getState().job !== null) {
    notify("info", "One piece of work is still under way.", "Wait for it, or cancel it.");
    return null;
  }
  try {
    const job = await api.startJob(request);
    session.set({ job, jobTitle: title, frame: null });
    const ended = await watched(job);
    if (ended.state === "failed") {
      const error = ended.error ?? { code: "unknown", message: "It failed without saying why.", hint: "" };
      tellFailure(new ApiError(error, 500));
      return null;
    }
    return ended.state === "cancelled" ? null : ended;
  } catch (error) {
    tellFailure(error);
    return null;
  } finally {
    source?.close();
    source = null;
    session.set({ job: null, frame: null });
  }
}

export async function cancelJob(): Promise<void> {
  const { job } = useSession.getState();
  if (job === null) return;
  try {
    await api.cancelJob(job.id);
  } catch (error) {
    tellFailure(error);
  }
}

function watched(job: Job): Promise<Job> {
  return new Promise((resolve, reject) => {
    const events = api.jobEvents(job.id);
    source = events;
    for (const name of EVENTS)
      events.addEventListener(name, (event) => {
        const latest = JSON.parse((event as MessageEvent<string>).data) as Job;
        useSession.getState().set({ job: latest });
        if (name === "frame") void showFrame(latest);
        if (ENDS.includes(name)) {
          events.close();
          resolve(latest);
        }
      });
    events.onerror = () => {
      // The browser connects again by itself; where it gave up we ask once, for the job may have ended.
      if (events.readyState !== EventSource.CLOSED) return;
      api.job(job.id).then((latest) => {
        if (["queued", "running"].includes(latest.state))
          reject(new Error("The connection to the studio was lost."));
        else resolve(latest);
      }, reject);
    };
  });
}

/** Fetches the newest frame; while one is on its way later ones are skipped. */
async function showFrame(job: Job): Promise<void> {
  if (fetching || job.frame_mesh === null) return;
  fetching = true;
  try {
    const [positions] = await Promise.all([api.frame(job.id), garmentMesh(job.frame_mesh)]);
    if (useSession.getState().job?.id === job.id)
      useSession.getState().set({ frame: { mesh: job.frame_mesh, number: job.frame, positions } });
  } catch {
    // A frame that is missed is followed by another.
  } finally {
    fetching = false;
  }
}
