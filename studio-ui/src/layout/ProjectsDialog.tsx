import { useEffect } from "react";
import { openExample } from "../actions/boot";
import { tellFailure } from "../actions/failures";
import { deleteProject, openProject, refreshProjects } from "../actions/projects";
import { useSession } from "../state/session";
import { Button, IconButton } from "../ui/Button";
import { Dialog } from "../ui/Dialog";

const WHEN = new Intl.DateTimeFormat("en-GB", { dateStyle: "medium", timeStyle: "short" });

/** Open a project, a file or an example. */
export function ProjectsDialog() {
  const server = useSession((state) => state.server);
  const { set } = useSession.getState();
  const close = () => set({ dialog: null });
  useEffect(() => {
    refreshProjects().catch(tellFailure);
  }, []);
  return (
    <Dialog title="Open" onClose={close}>
      <div className="open-file">
        <div>
          <h3>A file</h3>
          <p className="muted">A GarmentCode pattern (.json), or a picture. You can also drop it anywhere.</p>
        </div>
        <Button
          look="primary"
          icon="open"
          onClick={() => {
            close();
            document.getElementById("file-input")?.click();
          }}
        >
          Choose a file
        </Button>
      </div>
      <h3>Projects</h3>
      {server === null || server.projects.length === 0 ? (
        <p className="muted">None yet. Save what you make, and it is listed here.</p>
      ) : (
        <ul className="projects">
          {server.projects.map((project) => (
            <li key={project.id}>
              <button
                type="button"
                className="project"
                onClick={() => {
                  close();
                  void openProject(project.id);
                }}
              >
                {project.thumbnail !== null ? (
                  <img src={project.thumbnail} alt="" />
                ) : (
                  <span className="picture" />
                )}
                <span>
                  <strong>{project.name}</strong>
                  <span className="muted">
                    {WHEN.format(new Date(project.saved))} · {project.versions}{" "}
                    {project.versions === 1 ? "version" : "versions"}
                    {project.draft ? " · autosaved since" : ""}
                  </span>
                </span>
              </button>
              <IconButton
                icon="trash"
                label={`Move “${project.name}” to the trash`}
                onClick={() => void deleteProject(project).catch(tellFailure)}
              />
            </li>
          ))}
        </ul>
      )}
      {server !== null && server.examples.length > 0 && (
        <>
          <h3>Examples</h3>
          <ul className="gallery wide">
            {server.examples.map((example) => (
              <li key={example.id}>
                <button
                  type="button"
                  onClick={() => {
                    close();
                    void openExample(example);
                  }}
                >
                  <img src={example.thumbnail} alt="" loading="lazy" />
                  <span>{example.title}</span>
                </button>
              </li>
            ))}
          </ul>
        </>
      )}
    </Dialog>
  );
}
