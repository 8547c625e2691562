import { dismiss, useSession } from "../state/session";
import { IconButton } from "./Button";
import { Icon } from "./Icon";

const ICONS = { ok: "check", info: "info", warning: "warning", error: "error" } as const;

/** Messages; errors stay until they are closed. */
export function Notices() {
  const notices = useSession((state) => state.notices);
  return (
    <section className="notices" aria-label="Messages" aria-live="polite">
      {notices.map(({ id, kind, message, hint, action }) => (
        <div key={id} className={`notice ${kind}`} role={kind === "error" ? "alert" : "status"}>
          <Icon name={ICONS[kind]} />
          <div>
            <p className="message">{message}</p>
            {hint !== "" && <p className="hint">{hint}</p>}
            {action !== null && (
              <button
                type="button"
                className="link"
                onClick={() => {
                  dismiss(id);
                  action.run();
                }}
              >
                {action.label}
              </button>
            )}
          </div>
          <IconButton icon="close" label="Close this message" onClick={() => dismiss(id)} />
        </div>
      ))}
    </section>
  );
}
