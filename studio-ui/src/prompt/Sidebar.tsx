import { type Tab, useSession } from "../state/session";
import { AdjustTab } from "./AdjustTab";
import { BodyTab } from "./BodyTab";
import { DescribeTab } from "./DescribeTab";
import { HistoryTab } from "./HistoryTab";

const TABS: { tab: Tab; label: string }[] = [
  { tab: "describe", label: "Describe" },
  { tab: "adjust", label: "Adjust" },
  { tab: "body", label: "Body" },
  { tab: "history", label: "History" },
];

export function Sidebar({ width }: { width: number }) {
  const tab = useSession((state) => state.tab);
  const { set } = useSession.getState();
  return (
    <aside className="sidebar" style={{ width }} aria-label="Prompt and changes">
      <div className="tabs" role="tablist" aria-label="Column">
        {TABS.map(({ tab: each, label }, k) => (
          <button
            key={each}
            type="button"
            role="tab"
            id={`tab-${each}`}
            aria-selected={tab === each}
            aria-controls="tab-panel"
            tabIndex={tab === each ? 0 : -1}
            data-tour={each === "adjust" ? "adjust" : undefined}
            onClick={() => set({ tab: each })}
            onKeyDown={(event) => {
              const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? TABS.length - 1 : 0;
              const next = TABS[(k + by) % TABS.length];
              if (by === 0 || next === undefined) return;
              set({ tab: next.tab });
              document.getElementById(`tab-${next.tab}`)?.focus();
            }}
          >
            {label}
          </button>
        ))}
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, and so has to be reached by keys. */}
      <div className="tab-panel" id="tab-panel" role="tabpanel" aria-labelledby={`tab-${tab}`} tabIndex={0}>
        {tab === "describe" && <DescribeTab />}
        {tab === "adjust" && <AdjustTab />}
        {tab === "body" && <BodyTab />}
        {tab === "history" && <HistoryTab />}
      </div>
    </aside>
  );
}
