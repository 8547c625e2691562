import { IconButton } from "../../ui/Button";
import { addPointsToSelected, arrangeAnew, fitAll } from "./commands";
import { PatternIcon, type PatternIconName } from "./icons";
import { type Switches, type Tool, usePatternView } from "./pattern-view-state";
import { PX_PER_CM_TRUE, zoomedAt } from "./view";

const TOOLS: { tool: Tool; label: string; key: string }[] = [
  { tool: "select", label: "Select and drag", key: "V" },
  { tool: "point", label: "Add points: click on an edge", key: "P" },
  { tool: "sew", label: "Sew: choose two free edges", key: "S" },
  { tool: "pan", label: "Move the sheet", key: "G" },
];

const SWITCHES: { name: keyof Switches & PatternIconName; label: string; key: string; text: string }[] = [
  { name: "mirror", label: "Mirror editing: change both sides of the body", key: "M", text: "Mirror" },
  { name: "hem", label: "Whole hem: a free edge moves with the hem all round", key: "H", text: "Hem" },
  { name: "snap", label: "Snapping; hold Ctrl to switch it off for one drag", key: "N", text: "Snap" },
];

export function Toolbar() {
  const { tool, view, size, set, flip, ...switches } = usePatternView();
  const percent = Math.round((100 * view.scale) / PX_PER_CM_TRUE);
  return (
    <div className="window-bar" role="toolbar" aria-label="Pattern window">
      <h2>Pattern</h2>
      <div className="group">
        {TOOLS.map((each) => (
          <ToolButton
            key={each.tool}
            icon={each.tool}
            label={each.label}
            shortcut={each.key}
            pressed={tool === each.tool}
            onClick={() => set({ tool: each.tool, sewFrom: null, ghost: null, message: null })}
          />
        ))}
      </div>
      <div className="group">
        {SWITCHES.map((each) => (
          <ToolButton
            key={each.name}
            icon={each.name}
            label={each.label}
            shortcut={each.key}
            pressed={switches[each.name]}
            text={each.text}
            onClick={() => flip(each.name)}
          />
        ))}
      </div>
      <div className="spring" />
      <div className="group">
        <IconButton
          icon="plus"
          label="Add a point to the middle of the edge"
          shortcut="A"
          onClick={addPointsToSelected}
        />
        <ToolButton
          icon="numbers"
          label="Numbers of seams"
          pressed={switches.numbers}
          onClick={() => flip("numbers")}
        />
        <ToolButton icon="tidy" label="Arrange the panels anew" shortcut="T" onClick={arrangeAnew} />
        <IconButton icon="fit" label="Show the whole pattern" shortcut="F" onClick={fitAll} />
        <button
          type="button"
          className="button quiet small zoom"
          title="True size (1)"
          aria-label={`Zoom ${percent} %; to true size`}
          onClick={() =>
            set({ view: zoomedAt(view, [size[0] / 2, size[1] / 2], PX_PER_CM_TRUE / view.scale) })
          }
        >
          {percent} %
        </button>
      </div>
    </div>
  );
}

interface ToolButtonProps {
  icon: PatternIconName;
  label: string;
  shortcut?: string;
  pressed?: boolean;
  text?: string;
  onClick: () => void;
}

function ToolButton({ icon, label, shortcut, pressed, text, onClick }: ToolButtonProps) {
  return (
    <button
      type="button"
      className={text === undefined ? "icon-button" : "icon-button worded"}
      aria-label={label}
      aria-pressed={pressed}
      title={shortcut === undefined ? label : `${label} (${shortcut})`}
      onClick={onClick}
    >
      <PatternIcon name={icon} />
      {text !== undefined && <span className="word">{text}</span>}
    </button>
  );
}
