import { useState } from "react";
import { drape } from "../actions/drape";
import type { FabricName } from "../api/types";
import { useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";

/** Physics on request, and what is known of the garment. */
export function DrapeBar() {
  const version = useStudio(currentVersion);
  const fabrics = useSession((state) => state.server?.fabrics) ?? [];
  const dragged = useStudio((state) => state.draft !== null);
  const busy = useSession((state) => state.job !== null);
  const [chosen, setChosen] = useState<FabricName | null>(null);
  const fabric = chosen ?? version?.fabric ?? "cotton";
  const off = busy || version === null;
  return (
    <div className="window-foot">
      <label className="inline">
        <span>Fabric</span>
        <select value={fabric} onChange={(event) => setChosen(event.target.value as FabricName)}>
          {fabrics.map((name) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <Button
        icon="sparkle"
        className="small"
        disabled={off || version?.mesh === null}
        title="Physics from the garment as it is: wrinkles, and nothing inside the body. Some seconds"
        onClick={() => void drape("finish", fabric)}
      >
        Finish
      </Button>
      <Button
        icon="wave"
        className="small"
        disabled={off}
        title="Physics from the flat panels, as on a sewing table. Some seconds; watch it hang"
        onClick={() => void drape("drape", fabric)}
      >
        Drape
      </Button>
      <div className="spring" />
      {!busy && !dragged && version !== null && version.quality !== null && <Quality {...version.quality} />}
    </div>
  );
}

/** Whether it hangs well, and what is wrong where it does not. */
function Quality({ accepted, reasons }: { accepted: boolean; reasons: readonly string[] }) {
  if (accepted)
    return (
      <span className="quality ok" title="Hangs well">
        <Icon name="check" size={14} />
        <span className="words">Hangs well</span>
      </span>
    );
  return (
    <Popover
      label="What is wrong"
      align="end"
      trigger={({ ref, ...attributes }) => (
        <button ref={ref} type="button" className="quality warning" title="What is wrong" {...attributes}>
          <Icon name="warning" size={14} />
          <span className="words">Hangs with faults</span>
        </button>
      )}
    >
      {() => (
        <ul className="reasons">
          {reasons.map((reason) => (
            <li key={reason}>{reason}</li>
          ))}
        </ul>
      )}
    </Popover>
  );
}
