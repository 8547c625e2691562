import { openExample } from "../actions/boot";
import { generate } from "../actions/generate";
import { showPiece } from "../actions/outfit";
import { wearerNamed } from "../actions/wearers";
import { PART_NAMES } from "../state/outfit";
import { randomSeed, usePrompt } from "../state/prompt";
import { useSession } from "../state/session";
import { currentVersion, lastReading, useStudio } from "../state/store";
import { Button, IconButton } from "../ui/Button";
import { Segmented } from "../ui/Segmented";
import { ChipList } from "./ChipList";
import { PictureField } from "./PictureField";

const KINDS = ["made", "assumed", "cannot", "unknown"] as const;

/** Words, picture, seed; what was read of them; examples. */
export function DescribeTab() {
  const { text, seed, keepSeed, variants, set } = usePrompt();
  const server = useSession((state) => state.server);
  const busy = useSession((state) => state.job !== null);
  const wearer = wearerNamed(useStudio((state) => currentVersion(state)?.pattern ?? null));
  const limit = server?.limits.prompt_letters ?? 2000;
  return (
    <>
      <form
        className="prompt"
        data-tour="prompt"
        onSubmit={(event) => {
          event.preventDefault();
          void generate();
        }}
      >
        <label className="field">
          <span className="label">Describe a garment</span>
          <textarea
            id="prompt"
            rows={4}
            maxLength={limit}
            value={text}
            placeholder="a knee-length sleeveless dress with a V neck"
            onChange={(event) => set({ text: event.target.value })}
          />
        </label>
        <PictureField />
        <div className="row wrap">
          <label className="inline">
            <span className="label">Seed</span>
            <input
              type="number"
              className="seed"
              min={0}
              max={2147483647}
              value={seed}
              onChange={(event) =>
                set({ seed: Math.max(0, Math.floor(Number(event.target.value)) || 0), keepSeed: true })
              }
            />
          </label>
          <IconButton icon="dice" label="Another seed" onClick={() => set({ seed: randomSeed() })} />
          <IconButton
            icon={keepSeed ? "lock" : "unlock"}
            label={keepSeed ? "The seed is kept: the same garment again" : "A new seed each time"}
            pressed={keepSeed}
            onClick={() => set({ keepSeed: !keepSeed })}
          />
          <div className="spring" />
          <Segmented
            label="How many"
            value={variants}
            options={[
              { value: 1 as const, label: "1", title: "One garment" },
              { value: 4 as const, label: "4", title: "Four to choose from" },
            ]}
            onChange={(value) => set({ variants: value })}
          />
        </div>
        {wearer !== null && (
          <p className="muted small-text">
            For {wearer.name || "another body"}, unless the words name a size.{" "}
            <button type="button" className="link" onClick={() => useSession.getState().set({ tab: "body" })}>
              Change
            </button>
          </p>
        )}
        <Button
          look="primary"
          className="wide"
          icon="sparkle"
          disabled={busy || server === null}
          onClick={() => void generate()}
        >
          {variants === 4 ? "Make four garments" : "Make the garment"}
        </Button>
      </form>
      <OutfitChoice />
      <Read />
      <Gallery />
    </>
  );
}

/** Which of two garments is shown. */
function OutfitChoice() {
  const outfit = useSession((state) => state.outfit);
  const busy = useSession((state) => state.job !== null || state.working !== null);
  if (outfit === null) return null;
  return (
    <section className="block" aria-label="Two garments">
      <h2>Two garments</h2>
      <div className="row">
        <span className="label">Show</span>
        <Segmented
          label="Which of the two garments is shown"
          value={outfit.shown}
          options={outfit.pieces.map(({ document }, k) => ({
            value: k,
            label: PART_NAMES[document.part ?? "whole"],
            title: document.description,
          }))}
          onChange={showPiece}
          disabled={busy}
        />
      </div>
      <p className="muted small-text">Each is a project of its own: save each that you want to keep.</p>
    </section>
  );
}

function Read() {
  const version = useStudio(currentVersion);
  // While a pattern that was changed by hand is looked at, the chips stay.
  const reading = useStudio(lastReading);
  if (version === null || reading === null) return null;
  const some = KINDS.some((kind) => reading[kind].length > 0);
  return (
    <section className="block" aria-label="What was read" data-tour="chips">
      <h2>What was read</h2>
      {version.prompt !== "" && <p className="quote">{version.prompt}</p>}
      {some ? (
        KINDS.map((kind) => <ChipList key={kind} kind={kind} chips={reading[kind]} />)
      ) : (
        <ChipList kind="shown" chips={reading.shown.slice(0, 8)} />
      )}
      {version.notes.map((note) => (
        <p key={note} className="note">
          {note}
        </p>
      ))}
    </section>
  );
}

function Gallery() {
  const examples = useSession((state) => state.server?.examples) ?? [];
  if (examples.length === 0) return null;
  return (
    <section className="block" aria-label="Examples">
      <h2>Examples</h2>
      <ul className="gallery">
        {examples.map((example) => (
          <li key={example.id}>
            <button type="button" onClick={() => void openExample(example)} title={example.prompt}>
              <img src={example.thumbnail} alt="" loading="lazy" />
              <span>{example.title}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
