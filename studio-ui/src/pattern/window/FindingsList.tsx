import { mend } from "../../actions/mend";
import type { FindingInfo } from "../../api/types";
import type { Target } from "../../state/selection";
import { shownFindings, useStudio } from "../../state/store";
import { Button } from "../../ui/Button";
import { Icon, type IconName } from "../../ui/Icon";
import { showPoints } from "./commands";
import { usePatternView } from "./pattern-view-state";

const ICONS: Record<FindingInfo["severity"], IconName> = { error: "error", warning: "warning", info: "info" };
const ORDER: Record<FindingInfo["severity"], number> = { error: 0, warning: 1, info: 2 };

/** Where a finding is; null where it is the whole pattern. */
export function targetOf(finding: FindingInfo): Target | null {
  if (finding.stitch !== null && finding.code !== "dangling-stitch")
    return { kind: "seam", stitch: finding.stitch };
  if (finding.panel === "") return null;
  if (finding.edge !== null) return { kind: "edge", panel: finding.panel, edge: finding.edge };
  return { kind: "panel", panel: finding.panel };
}

/** How many faults there are, and below it each with its place and its mend. */
export function FindingsList() {
  const findings = useStudio(shownFindings);
  const open = usePatternView((state) => state.findingsOpen);
  const set = usePatternView((state) => state.set);
  const sorted = [...(findings ?? [])].sort((a, b) => ORDER[a.severity] - ORDER[b.severity]);
  const worst = sorted[0]?.severity ?? "ok";
  const faults = sorted.filter((f) => f.severity !== "info");
  return (
    <section className="findings" aria-label="Findings">
      <button
        type="button"
        className={`findings-badge ${worst}`}
        aria-expanded={open}
        disabled={sorted.length === 0}
        onClick={() => set({ findingsOpen: !open })}
      >
        <Icon name={sorted.length === 0 ? "check" : ICONS[worst as FindingInfo["severity"]]} size={16} />
        {findings === null ? "Checking …" : summary(sorted)}
      </button>
      {open && sorted.length > 0 && (
        <div className="findings-body">
          <ul>
            {sorted.map((finding, k) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: findings have no id and are replaced together.
              <Finding key={k} finding={finding} />
            ))}
          </ul>
          {faults.length > 0 && (
            <Button className="small" look="primary" onClick={() => void mend()}>
              Repair what is safe to repair
            </Button>
          )}
        </div>
      )}
    </section>
  );
}

function Finding({ finding }: { finding: FindingInfo }) {
  const focusOn = useStudio((state) => state.focusOn);
  const target = targetOf(finding);
  const place = [
    finding.panel,
    finding.edge === null ? "" : `edge ${finding.edge}`,
    finding.stitch === null ? "" : `seam ${finding.stitch}`,
  ].filter((part) => part !== "");
  return (
    <li className={finding.severity}>
      <button
        type="button"
        disabled={target === null}
        title={target === null ? undefined : "Show the place"}
        onClick={() => {
          if (target === null) return;
          focusOn(target);
          // The windows bring the target into view first; where the exact place is known, it is nearer.
          requestAnimationFrame(() => showPoints(finding.panel, finding.points));
        }}
      >
        <Icon name={ICONS[finding.severity]} size={16} />
        <span>
          <strong>{sentence(finding.message)}</strong>
          {place.length > 0 && <span className="where">{place.join(", ")}</span>}
          {finding.why !== "" && <span className="why">{sentence(finding.why)}</span>}
          {finding.repair !== "" && (
            <span className="how">To mend it: {finding.repair.replaceAll("--repair", "Repair")}</span>
          )}
        </span>
      </button>
    </li>
  );
}

function summary(sorted: readonly FindingInfo[]): string {
  const named = (severity: FindingInfo["severity"], one: string) => {
    const n = sorted.filter((f) => f.severity === severity).length;
    return n === 0 ? "" : `${n} ${n === 1 ? one : `${one}s`}`;
  };
  const parts = [named("error", "error"), named("warning", "warning"), named("info", "note")].filter(
    (p) => p !== "",
  );
  return parts.length === 0 ? "No faults" : parts.join(", ");
}

function sentence(text: string): string {
  const first = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(first) ? first : `${first}.`;
}
