import { useSession } from "../state/session";
import { Button } from "../ui/Button";
import { Dialog } from "../ui/Dialog";
import { SHORTCUTS } from "./shortcuts";

export function ShortcutsDialog() {
  const { set, server } = useSession.getState();
  return (
    <Dialog title="Keyboard shortcuts" onClose={() => set({ dialog: null })}>
      <div className="shortcuts">
        {SHORTCUTS.map(({ where, list }) => (
          <section key={where}>
            <h3>{where}</h3>
            <dl>
              {list.map(({ keys, does }) => (
                <div key={keys}>
                  <dt>
                    <Keys text={keys} />
                  </dt>
                  <dd>{does}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
      <footer className="dialog-footer">
        <Button onClick={() => set({ dialog: "tour" })}>Take the tour</Button>
        <span className="muted">SwiftTailor {server?.version ?? ""}</span>
      </footer>
    </Dialog>
  );
}

function Keys({ text }: { text: string }) {
  return text.split(/( or | and |, )/).map((part, k) =>
    k % 2 === 1 ? (
      part
    ) : (
      <span key={part} className="keys">
        {part.split("+").map((key) => (
          <kbd key={key}>{key === "" ? "+" : key}</kbd>
        ))}
      </span>
    ),
  );
}
