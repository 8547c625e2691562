import { useEffect, useState } from "react";
import { openChosen } from "../actions/generate";
import type { Document } from "../api/types";
import { garmentMesh } from "../garment/mesh-cache";
import { renderedPicture } from "../garment/picture";
import { PART_NAMES } from "../state/outfit";
import { fromWire } from "../state/pattern-json";
import { useSession } from "../state/session";
import { IconButton } from "../ui/Button";
import { PatternThumbnail } from "../ui/PatternThumbnail";

/** Garments that were made of the same words with different seeds, to choose one. */
export function VariantsTray() {
  const variants = useSession((state) => state.variants);
  const { set } = useSession.getState();
  if (variants === null) return null;
  return (
    <section className="variants" aria-label="Choose one">
      <header className="row">
        <h2>Choose one</h2>
        <span className="muted">
          {variants.some((each) => each.part)
            ? "Each pair is made with another seed. The other garment of the pair opens with the one you choose."
            : "Each is made with another seed."}
        </span>
        <div className="spring" />
        <IconButton icon="close" label="Keep what was open" onClick={() => set({ variants: null })} />
      </header>
      <ul>
        {variants.map((variant) => (
          <li key={`${variant.part} ${variant.seed}`}>
            <button type="button" onClick={() => openChosen(variant, variants)}>
              <Picture variant={variant} />
              <PatternThumbnail pattern={fromWire(variant.pattern)} />
              <span className="row">
                <strong>
                  {variant.part ? `${PART_NAMES[variant.part]}, seed` : "Seed"} {variant.seed}
                </strong>
                <span className="muted">
                  {variant.open.length === 0 ? "All that was asked for" : `${variant.open.length} not done`}
                </span>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Picture({ variant }: { variant: Document }) {
  const [source, setSource] = useState<string | null>(null);
  useEffect(() => {
    let gone = false;
    if (variant.mesh !== null)
      garmentMesh(variant.mesh)
        .then((mesh) => renderedPicture(mesh, variant.body, variant))
        .then(
          (url) => {
            if (!gone) setSource(url);
          },
          () => {},
        );
    return () => {
      gone = true;
    };
  }, [variant]);
  return source === null ? (
    <span className="picture waiting" />
  ) : (
    <img className="picture" src={source} alt={variant.description} />
  );
}
