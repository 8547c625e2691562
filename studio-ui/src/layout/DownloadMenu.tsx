import { download } from "../actions/download";
import type { FormatInfo } from "../api/types";
import { useSession } from "../state/session";
import { useStudio } from "../state/store";
import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";

const GROUPS: { of: FormatInfo["of"]; title: string }[] = [
  { of: "both", title: "Everything" },
  { of: "pattern", title: "Pattern" },
  { of: "garment", title: "Garment" },
];

/** Every file that the command line writes, and one archive with all of them. */
export function DownloadMenu() {
  const formats = useSession((state) => state.server?.formats) ?? [];
  const empty = useStudio((state) => state.history === null);
  return (
    <Popover
      label="Download"
      kind="menu"
      align="end"
      trigger={({ ref, ...attributes }) => (
        <button
          ref={ref}
          type="button"
          className="button primary"
          disabled={empty || formats.length === 0}
          {...attributes}
        >
          <Icon name="download" />
          Download
          <Icon name="chevron" size={14} />
        </button>
      )}
    >
      {(close) =>
        GROUPS.map(({ of, title }) => {
          const own = formats.filter((format) => format.of === of);
          if (own.length === 0) return null;
          return (
            // biome-ignore lint/a11y/useSemanticElements: a group of a menu.
            <div key={of} role="group" aria-label={title} className="menu-group">
              <p className="menu-title" aria-hidden="true">
                {title}
              </p>
              {own.map((format) => (
                <button
                  key={format.name}
                  type="button"
                  role="menuitem"
                  className="menu-item"
                  onClick={() => {
                    close();
                    void download(format.name);
                  }}
                >
                  <span className="format">{format.name.toUpperCase()}</span>
                  <span className="about">{format.about}</span>
                </button>
              ))}
            </div>
          );
        })
      }
    </Popover>
  );
}
