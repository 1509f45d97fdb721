/** The bar at the top: templates, files of the folder, saving, undo and redo. */

import { useRef, useState } from "preact/hooks";
import type { Start } from "./server";
import { canRedo, canUndo, conflict, ENDING, file, files, notice, openFile, opening, openTemplate, redo, save, text, undo, unsaved } from "./study";
import { Parts } from "./editor";
import { Help } from "./help";
import { copyLink } from "./share";

const ANNOUNCED = 6000; // ms

export function Bar({ start }: { start: Start }) {
  const [name, setName] = useState<string | null>(null);
  const [copied, setCopied] = useState("");
  const announce = (result: string) => {
    setCopied(result);
    setTimeout(() => setCopied(""), ANNOUNCED);
  };
  const field = useRef<HTMLInputElement>(null);
  const target = name ?? file.value ?? "";
  return (
    <header class="bar">
      <div class="row">
        <h1>haptonic studio</h1>
        <label>
          New, from a template
          <select
            value=""
            onChange={(event) => {
              const chosen = event.currentTarget.value;
              event.currentTarget.value = "";
              setName(null);
              if (chosen) void openTemplate(chosen);
            }}
          >
            <option value="">choose</option>
            {Object.entries(start.templates).map(([template, about]) => (
              <option value={template} title={about}>
                {template}
              </option>
            ))}
          </select>
        </label>
        <label>
          Open, in {start.folder}
          <select
            value=""
            onChange={(event) => {
              const chosen = event.currentTarget.value;
              event.currentTarget.value = "";
              setName(null);
              if (chosen) void openFile(chosen);
            }}
          >
            <option value="">{files.value.length > 0 ? "choose" : "no study yet"}</option>
            {files.value.map((each) => (
              <option>{each}</option>
            ))}
          </select>
        </label>
        <form
          class="row"
          onSubmit={(event) => {
            event.preventDefault();
            const wanted = target.trim();
            if (wanted === "") return;
            void save(wanted.endsWith(ENDING) ? wanted : `${wanted}${ENDING}`);
            setName(null);
          }}
        >
          <label>
            File name
            <input
              ref={field}
              value={target}
              placeholder={`my${ENDING}`}
              spellcheck={false}
              autocomplete="off"
              onInput={(event) => setName(event.currentTarget.value)}
            />
          </label>
          <button type="submit" disabled={target.trim() === ""}>
            Save
          </button>
        </form>
        <button type="button" disabled={!canUndo.value} onClick={undo}>
          Undo
        </button>
        <button type="button" disabled={!canRedo.value} onClick={redo}>
          Redo
        </button>
        <button type="button" disabled={text.value === ""} onClick={() => void copyLink().then(announce)}>
          Copy link
        </button>
        <Help />
        <a class="narrow" href="#compute-title">
          Go to the analyses
        </a>
        <span class="quiet" role="status">
          {copied}
        </span>
        <span class="quiet" role="status">
          {opening.value ? `opening ${opening.value}` : unsaved.value ? "not saved" : file.value === null ? "" : "saved"}
        </span>
      </div>
      {notice.value !== null && (
        <div class="notice" role="alert">
          {typeof notice.value === "string" ? <p>{notice.value}</p> : <Parts problem={notice.value} />}
          {conflict.value !== null && <Conflict name={conflict.value} rename={() => field.current?.select()} />}
          <button type="button" class="minor" onClick={() => (notice.value = null)}>
            Close
          </button>
        </div>
      )}
    </header>
  );
}

/** Choices about a file with another text than the page knows. */
function Conflict({ name, rename }: { name: string; rename: () => void }) {
  return (
    <div class="row">
      <button type="button" onClick={rename}>
        Choose another name
      </button>
      <button type="button" onClick={() => void save(name, true)}>
        Replace {name}
      </button>
      <button type="button" onClick={() => void openFile(name)}>
        Open {name} in place of this text
      </button>
    </div>
  );
}
