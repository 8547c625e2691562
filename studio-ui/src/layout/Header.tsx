import { openFiles } from "../actions/open-file";
import { saveProject } from "../actions/projects";
import { useDisplay } from "../state/display";
import { canRedo, canUndo } from "../state/history";
import { type SaveState, useProject } from "../state/project";
import { remember } from "../state/remembered";
import { useSession } from "../state/session";
import { type Theme, useStudio } from "../state/store";
import type { Units } from "../state/units";
import { Button, IconButton } from "../ui/Button";
import { Segmented } from "../ui/Segmented";
import { DownloadMenu } from "./DownloadMenu";

export function Header() {
  const history = useStudio((state) => state.history);
  const { undo, redo, units, theme } = useStudio.getState();
  const shown = {
    units: useStudio((state) => state.units) ?? units,
    theme: useStudio((state) => state.theme) ?? theme,
  };
  const sidebar = useDisplay((state) => state.sidebar);
  const { set } = useSession.getState();
  return (
    <header className="header">
      <IconButton
        icon="sidebar"
        label={sidebar ? "Hide the left column" : "Show the left column"}
        pressed={sidebar}
        onClick={() => useDisplay.getState().change({ sidebar: !sidebar })}
      />
      <h1 className="brand">
        <img src="./icon.svg" alt="" width={22} height={22} />
        <span>
          SwiftTailor <span className="brand-light">Studio</span>
        </span>
      </h1>
      <div className="divider" />
      <ProjectName />
      <div className="spring" />
      <div className="group">
        <IconButton
          icon="undo"
          label="Undo"
          shortcut="Ctrl+Z"
          disabled={history === null || !canUndo(history)}
          onClick={undo}
        />
        <IconButton
          icon="redo"
          label="Redo"
          shortcut="Ctrl+Shift+Z"
          disabled={history === null || !canRedo(history)}
          onClick={redo}
        />
      </div>
      <div className="divider" />
      <div className="group">
        <Button
          icon="open"
          look="quiet"
          onClick={() => set({ dialog: "projects" })}
          title="Open a project or a file (Ctrl+O)"
        >
          Open
        </Button>
        <Button
          icon="save"
          look="quiet"
          disabled={history === null}
          onClick={() => void saveProject()}
          title="Save (Ctrl+S)"
        >
          Save
        </Button>
        <Button
          icon="compare"
          look="quiet"
          disabled={history === null || history.entries.length < 2}
          onClick={() => set({ dialog: "compare" })}
          title="Compare two versions (C)"
        >
          Compare
        </Button>
        <DownloadMenu />
      </div>
      <div className="divider" />
      <Segmented<Units>
        label="Units"
        value={shown.units}
        options={[
          { value: "cm", label: "cm", title: "Centimetres" },
          { value: "inch", label: "in", title: "Inches" },
        ]}
        onChange={(value) => {
          remember("units", value);
          useStudio.getState().setUnits(value);
        }}
      />
      <IconButton
        icon={shown.theme === "dark" ? "light" : "dark"}
        label={shown.theme === "dark" ? "Light colours" : "Dark colours"}
        onClick={() => chooseTheme(shown.theme === "dark" ? "light" : "dark")}
      />
      <IconButton
        icon="help"
        label="Keyboard shortcuts and tour"
        shortcut="?"
        onClick={() => set({ dialog: "shortcuts" })}
      />
      <input
        id="file-input"
        type="file"
        className="visually-hidden"
        tabIndex={-1}
        aria-label="Open a pattern or a picture"
        accept=".json,image/png,image/jpeg,image/webp"
        multiple
        onChange={(event) => {
          void openFiles([...(event.target.files ?? [])]);
          event.target.value = "";
        }}
      />
    </header>
  );
}

export function chooseTheme(theme: Theme): void {
  remember("theme", theme);
  useStudio.getState().setTheme(theme);
}

const SAVED: Record<SaveState, string> = {
  unsaved: "Not saved yet",
  saving: "Saving …",
  autosaved: "Autosaved",
  saved: "Saved",
  failed: "Not saved",
};

function ProjectName() {
  const { name, save, id } = useProject();
  const change = useProject.getState().set;
  const kept = id === null ? "Kept in this browser" : SAVED[save];
  return (
    <div className="project-name">
      <input
        aria-label="Name of the project"
        value={name}
        maxLength={80}
        spellCheck={false}
        onChange={(event) => change({ name: event.target.value })}
        onKeyDown={(event) => {
          if (event.key === "Enter") event.currentTarget.blur();
        }}
      />
      <span className={`save-state ${save}`} title={kept}>
        {kept}
      </span>
    </div>
  );
}
