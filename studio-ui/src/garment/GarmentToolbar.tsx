import { type Coloring, type Print, type Side, useDisplay } from "../state/display";
import { currentVersion, useStudio } from "../state/store";
import { IconButton } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";
import { Segmented } from "../ui/Segmented";
import { DEFAULT_CLOTH } from "./cloth-color";
import type { GarmentViewer } from "./viewer";

const SIDES: { side: Side; label: string; key: string }[] = [
  { side: "front", label: "Front", key: "1" },
  { side: "back", label: "Back", key: "2" },
  { side: "left", label: "Side", key: "3" },
];

const COLORINGS: { value: Coloring; label: string }[] = [
  { value: "cloth", label: "Cloth" },
  { value: "panels", label: "Panels" },
  { value: "strain", label: "Strain" },
];

const PRINTS: { value: Print; label: string }[] = [
  { value: "plain", label: "Plain" },
  { value: "stripes", label: "Stripes, 1 cm" },
  { value: "checks", label: "Checks, 2 cm" },
  { value: "dots", label: "Dots, 1 cm" },
  { value: "ruler", label: "Ruler, 1 cm squares" },
];

const SWATCHES = ["#8fa9bd", "#1f2a44", "#2f5d50", "#a33b3b", "#d9a441", "#e9e4da", "#c98fa5", "#2b2b2e"];

export function GarmentToolbar({ viewer }: { viewer: GarmentViewer | null }) {
  const coloring = useDisplay((state) => state.coloring);
  const { change } = useDisplay.getState();
  return (
    <div className="window-bar" role="toolbar" aria-label="Garment window">
      <h2>Garment</h2>
      <div className="group">
        {SIDES.map(({ side, label, key }) => (
          <button
            key={side}
            type="button"
            className="button quiet small"
            title={`${label} (${key})`}
            onClick={() => viewer?.look(side)}
          >
            {label}
          </button>
        ))}
      </div>
      <div className="spring" />
      <Segmented
        label="Colouring"
        value={coloring}
        options={COLORINGS}
        onChange={(value) => change({ coloring: value, normals: false })}
      />
      <ClothPopover />
    </div>
  );
}

/** What of the garment is seen: a column of buttons over the view. */
export function ViewTools({ viewer }: { viewer: GarmentViewer | null }) {
  const { body, seams, wireframe, normals, change } = useDisplay();
  return (
    <div className="view-tools" role="toolbar" aria-label="What is shown" aria-orientation="vertical">
      <IconButton icon="fit" label="All of the garment" shortcut="0" onClick={() => viewer?.frameAll(true)} />
      <IconButton
        icon="body"
        label="Body"
        shortcut="B"
        pressed={body}
        onClick={() => change({ body: !body })}
      />
      <IconButton
        icon="seam"
        label="Seams"
        shortcut="S"
        pressed={seams}
        onClick={() => change({ seams: !seams })}
      />
      <IconButton
        icon="wire"
        label="Wireframe"
        shortcut="W"
        pressed={wireframe}
        onClick={() => change({ wireframe: !wireframe })}
      />
      <IconButton
        icon="normals"
        label="Normals"
        shortcut="N"
        pressed={normals}
        onClick={() => change({ normals: !normals })}
      />
    </div>
  );
}

/** Colour and print of the cloth. */
function ClothPopover() {
  const { trialPrint, change } = useDisplay();
  const own = useStudio((state) => currentVersion(state)?.print ?? null);
  const color = useStudio((state) => currentVersion(state)?.color ?? null) ?? DEFAULT_CLOTH;
  const dye = (to: string) => {
    useStudio.getState().dye(to);
    change({ coloring: "cloth", normals: false });
  };
  return (
    <Popover
      label="Cloth"
      align="end"
      trigger={({ ref, ...attributes }) => (
        <button
          ref={ref}
          type="button"
          className="button quiet small swatch-button"
          title="Colour and print"
          {...attributes}
        >
          <span className="swatch" style={{ background: color }} />
          <span className="visually-hidden">Cloth: colour and print</span>
          <Icon name="chevron" size={14} />
        </button>
      )}
    >
      {() => (
        <div className="cloth-popover">
          <h3>Colour</h3>
          <div className="swatches">
            {SWATCHES.map((swatch) => (
              <button
                key={swatch}
                type="button"
                className="swatch"
                style={{ background: swatch }}
                aria-label={`Colour ${swatch}`}
                aria-pressed={swatch === color}
                onClick={() => dye(swatch)}
              />
            ))}
            <label className="swatch custom" title="Another colour">
              <span className="visually-hidden">Another colour</span>
              <input type="color" value={color} onChange={(event) => dye(event.target.value)} />
            </label>
          </div>
          <h3>Print, at true scale</h3>
          <div className="options">
            {own !== null && (
              <label>
                <input
                  type="radio"
                  name="print"
                  checked={trialPrint === null}
                  onChange={() => change({ trialPrint: null, coloring: "cloth", normals: false })}
                />
                As described: {own.kind === "motif" ? (own.motif ?? "shapes") : own.kind}
              </label>
            )}
            {PRINTS.map(({ value, label }) => (
              <label key={value}>
                <input
                  type="radio"
                  name="print"
                  checked={(trialPrint ?? (own === null ? "plain" : null)) === value}
                  onChange={() =>
                    change({
                      trialPrint: value === "plain" && own === null ? null : value,
                      coloring: "cloth",
                      normals: false,
                    })
                  }
                />
                {label}
              </label>
            ))}
          </div>
        </div>
      )}
    </Popover>
  );
}
