import { type DragEvent, useEffect, useRef, useState } from "react";
import { reconnect } from "./actions/boot";
import { addPicture, openFiles } from "./actions/open-file";
import { GarmentWindow } from "./garment/GarmentWindow";
import { CompareDialog } from "./layout/CompareDialog";
import { ErrorBoundary } from "./layout/ErrorBoundary";
import { Header } from "./layout/Header";
import { JobBar } from "./layout/JobBar";
import { PatternPane } from "./layout/PatternPane";
import { ProjectsDialog } from "./layout/ProjectsDialog";
import { ShortcutsDialog } from "./layout/ShortcutsDialog";
import { Splitter } from "./layout/Splitter";
import { listenForShortcuts } from "./layout/shortcuts";
import { Tour } from "./layout/Tour";
import { Sidebar } from "./prompt/Sidebar";
import { VariantsTray } from "./prompt/VariantsTray";
import { useDisplay } from "./state/display";
import { useSession } from "./state/session";
import { useStudio } from "./state/store";
import { Button } from "./ui/Button";
import { Icon } from "./ui/Icon";
import { Notices } from "./ui/Notices";

export function App() {
  const dialog = useSession((state) => state.dialog);
  const theme = useStudio((state) => state.theme);
  const [dragging, setDragging] = useState(false);
  useEffect(listenForShortcuts, []);
  useEffect(listenForPaste, []);
  useEffect(() => {
    document.documentElement.dataset.theme = theme;
  }, [theme]);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: files may be dropped anywhere; there are buttons for it too.
    <div
      className="app"
      onDragOver={(event) => {
        if (!hasFiles(event)) return;
        event.preventDefault();
        setDragging(true);
      }}
      onDragLeave={(event) => {
        if (event.relatedTarget === null) setDragging(false);
      }}
      onDrop={(event) => {
        if (!hasFiles(event)) return;
        event.preventDefault();
        setDragging(false);
        void openFiles([...event.dataTransfer.files]);
      }}
    >
      <Header />
      <Banners />
      <Work />
      <JobBar />
      <Working />
      <Notices />
      {dragging && <div className="drop-veil">Drop a picture of a garment, or a pattern file</div>}
      {dialog === "shortcuts" && <ShortcutsDialog />}
      {dialog === "projects" && <ProjectsDialog />}
      {dialog === "compare" && <CompareDialog />}
      {dialog === "tour" && <Tour />}
    </div>
  );
}

function Work() {
  const { layout, sidebar, sidebarWidth, split, change } = useDisplay();
  const windows = useRef<HTMLDivElement>(null);
  const clamp = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));
  return (
    <main className="work">
      {sidebar && (
        <>
          <Sidebar width={sidebarWidth} />
          <Splitter
            label="Width of the left column"
            value={sidebarWidth}
            min={260}
            max={520}
            step={20}
            onDrag={(px, from) => change({ sidebarWidth: clamp(from + px, 260, 520) })}
            onChange={(value) => change({ sidebarWidth: value })}
          />
        </>
      )}
      <div className="windows" ref={windows}>
        {layout !== "garment" && (
          <div className="half" style={{ flexGrow: layout === "both" ? split : 1 }} data-tour="pattern">
            <ErrorBoundary what="The pattern">
              <PatternPane />
            </ErrorBoundary>
          </div>
        )}
        {layout === "both" && (
          <Splitter
            label="Between pattern and garment"
            value={100 * split}
            min={20}
            max={80}
            step={5}
            onDrag={(px, from) => {
              const width = windows.current?.clientWidth ?? 1;
              change({ split: clamp(from / 100 + px / width, 0.2, 0.8) });
            }}
            onChange={(value) => change({ split: value / 100 })}
          />
        )}
        {layout !== "pattern" && (
          <div className="half" style={{ flexGrow: layout === "both" ? 1 - split : 1 }}>
            <ErrorBoundary what="The garment">
              <GarmentWindow />
            </ErrorBoundary>
          </div>
        )}
        <VariantsTray />
      </div>
    </main>
  );
}

/** What is off, and how to get it. */
function Banners() {
  const connected = useSession((state) => state.connected);
  const notices = useSession((state) => state.server?.notices) ?? [];
  return (
    <>
      {connected === false && (
        <div className="banner error" role="alert">
          <Icon name="error" />
          <span>
            The studio’s server does not answer. Look whether <code>swifttailor studio</code> still runs, and
            start it again if not.
          </span>
          <Button className="small" onClick={() => void reconnect()}>
            Try again
          </Button>
        </div>
      )}
      {notices.map((notice) => (
        <div key={notice} className="banner warning" role="status">
          <Icon name="warning" />
          <span>{notice}</span>
        </div>
      ))}
    </>
  );
}

/** Quick work that takes longer than one notices. */
function Working() {
  const working = useSession((state) => state.working);
  const loading = useSession((state) => state.connected === null);
  const text = working ?? (loading ? "Starting" : null);
  return (
    <div className="working" role="status" data-shown={text !== null || undefined}>
      {text !== null && (
        <>
          <span className="spinner" aria-hidden="true" />
          {text} …
        </>
      )}
    </div>
  );
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer.types.includes("Files");
}

function listenForPaste(): () => void {
  const listener = (event: ClipboardEvent) => {
    const file = [...(event.clipboardData?.files ?? [])].find((each) => each.type.startsWith("image/"));
    if (file === undefined) return;
    event.preventDefault();
    void addPicture(file);
  };
  document.addEventListener("paste", listener);
  return () => document.removeEventListener("paste", listener);
}
