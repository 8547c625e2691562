import { useEffect, useState } from "react";
import { cancelJob } from "../actions/jobs";
import type { Job } from "../api/types";
import { useSession } from "../state/session";
import { Button } from "../ui/Button";

const STAGES: Record<string, string> = {
  loading: "Loading the networks",
  reading: "Reading the words",
  looking: "Looking at the picture",
  searching: "Choosing a pattern",
  altering: "Cutting the pattern",
  refining: "Refining the pattern",
  writing: "Writing the pattern",
  drawing: "Drawing the panels",
  network: "Sewing",
  decoding: "Closing the seams",
  sewing: "Sewing",
  meshing: "Laying out the cloth",
  draping: "Draping",
  finishing: "Finishing",
  saving: "Saving",
};

/** Progress of the work under way: stages with their seconds, the place in the queue, cancel or stop. */
export function JobBar() {
  const job = useSession((state) => state.job);
  const title = useSession((state) => state.jobTitle);
  const frame = useSession((state) => state.frame?.number ?? 0);
  const [cancelling, setCancelling] = useState(false);
  const seconds = useSeconds(job);
  useEffect(() => {
    if (job === null) setCancelling(false);
  }, [job]);
  if (job === null) return null;
  const physics = job.kind === "drape" || job.kind === "finish";
  const stage = job.stages.at(-1);
  const queued = job.state === "queued";
  const share = stage?.share ?? 0;
  return (
    <div className="job-bar" role="status" aria-label={title}>
      <div className="job-head">
        <strong>{title}</strong>
        <span className="muted">
          {queued
            ? `Waiting: ${job.place === 0 ? "next" : job.place === 1 ? "1 before it" : `${job.place} before it`}`
            : `${seconds.toFixed(1)} s`}
          {frame > 0 && ` · frame ${frame}`}
        </span>
        <Button
          icon={physics && !queued ? "stop" : "close"}
          className="small"
          disabled={cancelling}
          onClick={() => {
            setCancelling(true);
            void cancelJob();
          }}
        >
          {physics && !queued ? "Stop" : "Cancel"}
        </Button>
      </div>
      <progress max={1} value={queued || share === 0 ? undefined : share} aria-label={title} />
      <ol className="stages">
        {job.stages.map((each, k) => (
          <li key={`${each.name}-${String(k)}`} className={k === job.stages.length - 1 ? "now" : "done"}>
            {STAGES[each.name] ?? each.name.charAt(0).toUpperCase() + each.name.slice(1)}
            <span className="muted"> {each.seconds.toFixed(1)} s</span>
          </li>
        ))}
      </ol>
    </div>
  );
}

/** Seconds since the job began to run; between two events they go on by themselves. */
function useSeconds(job: Job | null): number {
  const [now, setNow] = useState(0);
  const [known, setKnown] = useState({ job, at: performance.now() });
  if (known.job !== job) setKnown({ job, at: performance.now() });
  useEffect(() => {
    if (job === null) return;
    const timer = setInterval(() => setNow(performance.now()), 100);
    return () => clearInterval(timer);
  }, [job]);
  if (job === null) return 0;
  return job.seconds + (job.state === "running" ? Math.max(0, now - known.at) / 1000 : 0);
}
