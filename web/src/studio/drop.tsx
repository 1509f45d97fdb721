/** Measured files from outside of the folder: dropped on the page, or chosen. */

import { signal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { chooseFile, list } from "./chosen";
import { Refusal, server } from "./server";
import { attempt } from "./study";

interface Added {
  name: string; // with the folders that it was dropped in
  content: File;
}

const pending = signal<Added[]>([]); // several files that need a folder
const folder = signal("");
const taken = signal<Added[]>([]); // files whose names are in the folder already
const progress = signal("");
const isOver = signal(false); // files are held over the page
let target = ""; // what is chosen after the files are there

/** Take the files that are dropped anywhere on the page. */
export function followDrops(): void {
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    isOver.value = true;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) isOver.value = false;
  });
  addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    isOver.value = false;
    const entries = [...(event.dataTransfer?.items ?? [])].map((item) => item.webkitGetAsEntry());
    const plain = [...(event.dataTransfer?.files ?? [])];
    void attempt(async () => {
      const found = (await Promise.all(entries.filter((entry) => entry !== null).map(contents))).flat();
      await take(found.length > 0 ? found : plain.map((content) => ({ name: content.name, content })));
    });
  });
}

/** Files of a dropped file or folder, with their folders in the names. */
async function contents(entry: FileSystemEntry): Promise<Added[]> {
  const name = entry.fullPath.replace(/^\//, "");
  if (entry.isFile) {
    const content = await new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed));
    return [{ name, content }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const inside: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed));
    if (some.length === 0) break; // the browser gives a hundred at a time
    inside.push(...some);
  }
  return (await Promise.all(inside.map(contents))).flat();
}

/** Add files at once if their place is clear: a single one, or those of one folder. */
async function take(added: Added[]): Promise<void> {
  const visible = added.filter(({ name }) => !name.split("/").some((part) => part.startsWith(".")));
  const [first] = visible;
  if (first === undefined) return;
  const top = first.name.split("/")[0] ?? "";
  if (visible.every(({ name }) => name.startsWith(`${top}/`)) || visible.length === 1) {
    target = top;
    await add(visible, false);
    return;
  }
  pending.value = visible;
  folder.value ||= "measured";
}

async function add(added: Added[], replace: boolean): Promise<void> {
  const repeated: Added[] = [];
  taken.value = [];
  try {
    for (const [k, each] of added.entries()) {
      progress.value = `Adding ${each.name}, ${k + 1} of ${added.length}`;
      try {
        list(await server.upload(each.name, each.content, replace));
      } catch (reason) {
        if (!(reason instanceof Refusal) || reason.problem?.code !== "repeated") throw reason;
        repeated.push(each);
      }
    }
    progress.value = repeated.length === 0 ? `Added ${target}.` : "";
    taken.value = repeated;
    if (repeated.length === 0) chooseFile(target);
  } catch (reason) {
    progress.value = "";
    throw reason;
  }
}

function addPending(): void {
  target = folder.peek().trim();
  const added = pending.peek().map((each) => ({ ...each, name: `${target}/${each.name}` }));
  pending.value = [];
  void attempt(() => add(added, false));
}

export function Drop() {
  const [file, whole] = [useRef<HTMLInputElement>(null), useRef<HTMLInputElement>(null)];
  const picked = ({ currentTarget }: { currentTarget: HTMLInputElement }) => {
    const added = [...(currentTarget.files ?? [])].map((content) => ({ name: content.webkitRelativePath || content.name, content }));
    currentTarget.value = ""; // so that the same file can be chosen again
    void attempt(() => take(added));
  };
  const hidden = { type: "file", class: "hidden", tabIndex: -1, "aria-hidden": true, multiple: true, onChange: picked } as const;
  return (
    <div class={`drop${isOver.value ? " over" : ""}`}>
      <p>
        Drop a file or a folder anywhere on this page, or{" "}
        <button type="button" onClick={() => file.current?.click()}>
          Choose files
        </button>{" "}
        <button type="button" onClick={() => whole.current?.click()}>
          Choose a folder
        </button>
      </p>
      <input {...hidden} ref={file} data-choose="files" />
      <input {...hidden} ref={whole} data-choose="folder" {...{ webkitdirectory: true }} />
      {pending.value.length > 0 && (
        <form
          class="row"
          onSubmit={(event) => {
            event.preventDefault();
            addPending();
          }}
        >
          <label>
            Folder for {pending.value.length} files
            <input value={folder.value} spellcheck={false} autocomplete="off"
              onInput={(event) => (folder.value = event.currentTarget.value)} />
          </label>
          <button type="submit" disabled={folder.value.trim() === ""}>
            Add
          </button>
          <button type="button" onClick={() => (pending.value = [])}>
            Leave them
          </button>
        </form>
      )}
      {taken.value.length > 0 && (
        <div class="row" role="alert">
          <span>
            In the folder already: {taken.value.slice(0, 3).map(({ name }) => name).join(", ")}
            {taken.value.length > 3 && ` and ${taken.value.length - 3} more`}.
          </span>
          <button type="button" onClick={() => void attempt(() => add(taken.peek(), true))}>
            Replace
          </button>
          <button
            type="button"
            onClick={() => {
              taken.value = [];
              chooseFile(target);
            }}
          >
            Use what is there
          </button>
        </div>
      )}
      <p class="quiet" role="status">
        {progress.value}
      </p>
    </div>
  );
}
