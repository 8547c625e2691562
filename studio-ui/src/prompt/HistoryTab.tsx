import { useSession } from "../state/session";
import { useStudio } from "../state/store";
import { PatternThumbnail } from "../ui/PatternThumbnail";

const TIME = new Intl.DateTimeFormat("en-GB", { hour: "2-digit", minute: "2-digit" });

/** All versions, newest first; press one to go there. */
export function HistoryTab() {
  const history = useStudio((state) => state.history);
  if (history === null) return <p className="empty-note">Nothing has been done yet.</p>;
  const { goTo } = useStudio.getState();
  return (
    <section className="block first" aria-label="History">
      <div className="row">
        <h2>History</h2>
        <div className="spring" />
        <button
          type="button"
          className="link"
          disabled={history.entries.length < 2}
          onClick={() => useSession.getState().set({ dialog: "compare" })}
        >
          Compare two
        </button>
      </div>
      <ol className="history" reversed>
        {history.entries
          .map((entry, k) => (
            <li key={entry.id}>
              <button
                type="button"
                aria-current={k === history.index ? "step" : undefined}
                className={k > history.index ? "undone" : ""}
                onClick={() => goTo(k)}
              >
                <PatternThumbnail pattern={entry.value.pattern} />
                <span>
                  <span className="history-label">{entry.label}</span>
                  <span className="muted">
                    {TIME.format(entry.at)}
                    {k > history.index ? " · undone" : ""}
                  </span>
                </span>
              </button>
            </li>
          ))
          .reverse()}
      </ol>
    </section>
  );
}
