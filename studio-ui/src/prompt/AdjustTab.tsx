import { useState } from "react";
import { editBy } from "../actions/edit";
import { useSession } from "../state/session";
import { currentVersion, lastReading, useStudio } from "../state/store";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { ChipList } from "./ChipList";
import { DimensionSliders } from "./DimensionSliders";

/** Instructions, sliders and everything that the pattern shows. */
export function AdjustTab() {
  const version = useStudio(currentVersion);
  const reading = useStudio(lastReading);
  if (version === null) return <p className="empty-note">Make a garment or open one first.</p>;
  return (
    <>
      <Instruct />
      <DimensionSliders />
      {reading !== null && (
        <section className="block" aria-label="Features">
          <h2>Features</h2>
          <ChipList kind="made" chips={[...reading.made, ...reading.assumed]} />
          <ChipList kind="shown" chips={reading.shown} />
        </section>
      )}
    </>
  );
}

function Instruct() {
  const [text, setText] = useState("");
  const busy = useSession((state) => state.job !== null);
  const set = useSession.getState().set;
  const version = useStudio(currentVersion);
  const compare = useStudio((state) => (state.history?.index ?? 0) > 0);
  const send = async () => {
    if (await editBy(text)) setText("");
  };
  return (
    <section className="block first" aria-label="Instruction">
      <form
        className="instruct"
        onSubmit={(event) => {
          event.preventDefault();
          void send();
        }}
      >
        <label className="field">
          <span className="label">Change it in words</span>
          <textarea
            id="instruction"
            rows={2}
            value={text}
            placeholder="give it long sleeves and make the skirt 10 cm shorter"
            onChange={(event) => setText(event.target.value)}
            onKeyDown={(event) => {
              if (event.key !== "Enter" || event.shiftKey) return;
              event.preventDefault();
              event.stopPropagation();
              void send();
            }}
          />
        </label>
        <Button look="primary" disabled={busy || text.trim() === ""} onClick={() => void send()}>
          Change
        </Button>
      </form>
      {version !== null && version.changes.length + version.open.length > 0 && (
        <div className="changes" role="status">
          <h3>What changed</h3>
          <ul>
            {version.changes.map((change) => (
              <li key={change} className="done">
                <Icon name="check" size={14} />
                {change}
              </li>
            ))}
            {version.open.map((open) => (
              <li key={open} className="open">
                <Icon name="warning" size={14} />
                Not done: {open}
              </li>
            ))}
          </ul>
          {compare && (
            <button type="button" className="link" onClick={() => set({ dialog: "compare" })}>
              Compare with before
            </button>
          )}
        </div>
      )}
    </section>
  );
}
