import { useState } from "react";
import { addPicture } from "../actions/open-file";
import type { FileInfo, Part } from "../api/types";
import { usePrompt } from "../state/prompt";
import { IconButton } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Segmented } from "../ui/Segmented";

const PARTS: { value: Part | "auto"; label: string; title: string }[] = [
  { value: "auto", label: "All", title: "The garment that the picture shows" },
  { value: "upper", label: "Top", title: "Only what is worn above the waist" },
  { value: "lower", label: "Bottom", title: "Only what is worn below the waist" },
];

/** Pictures of the garment beside what was looked at in them. */
export function PictureField() {
  const { pictures, part, set } = usePrompt();
  return (
    <div className="pictures">
      {pictures.map((picture, k) => (
        <Picture
          key={picture.id}
          picture={picture}
          label={pictures.length > 1 ? (k === 0 ? "Front" : "Back") : "Picture"}
          onRemove={() => set({ pictures: pictures.filter((each) => each.id !== picture.id) })}
        />
      ))}
      {pictures.length > 0 && (
        <div className="row">
          <span className="label">Make</span>
          <Segmented
            label="Which part of the picture is made"
            value={part ?? "auto"}
            options={PARTS}
            onChange={(value) => set({ part: value === "auto" ? null : value })}
          />
        </div>
      )}
      {pictures.length < 2 && (
        <label className="drop-field">
          <Icon name="picture" />
          <span>
            {pictures.length === 0 ? "Add a picture" : "Add one of the back"}
            <span className="muted"> – drop, paste or choose</span>
          </span>
          <input
            type="file"
            accept="image/png,image/jpeg,image/webp"
            className="visually-hidden"
            onChange={(event) => {
              const file = event.target.files?.[0];
              if (file !== undefined) void addPicture(file);
              event.target.value = "";
            }}
          />
        </label>
      )}
    </div>
  );
}

function Picture({ picture, label, onRemove }: { picture: FileInfo; label: string; onRemove: () => void }) {
  const [unseen, setUnseen] = useState(false);
  return (
    <div className="picture-pair">
      <figure>
        <img src={picture.url} alt={`${label} as given`} />
        <figcaption>{label}</figcaption>
      </figure>
      <figure>
        {unseen ? (
          <div className="unseen">
            <Icon name="warning" />
            No garment is seen in it. Try one with a plain background.
          </div>
        ) : (
          <img src={picture.seen_url} alt="What was looked at" onError={() => setUnseen(true)} />
        )}
        <figcaption>What was looked at</figcaption>
      </figure>
      <IconButton icon="close" label={`Remove: ${label}`} onClick={onRemove} className="remove" />
    </div>
  );
}
