/** Files from outside of the folder, dropped on the page or chosen: measured ones, studies, and cells of studies. */

import { signal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { chooseFile, list } from "./chosen";
import { Refusal, server } from "./server";
import { attempt, ENDING, notice, openFile } from "./study";

interface Added {
  name: string; // with the folders that it was dropped in
  content: File;
}

const pending = signal<Added[]>([]); // several files that need a folder
const folder = signal("");
/** Files whose names are in the folder already, of all that were dropped together. */
const taken = signal<{ files: Added[]; all: string[] } | null>(null);
const progress = signal("");
const isOver = signal(false); // files are held over the page
const NO_USE = "unsupported"; // code of the refusal of a file that nothing reads
let solids: string[] = []; // endings of files that a study names

const isStudy = (name: string) => name.endsWith(ENDING);
const isSolid = (name: string) => solids.some((ending) => name.toLowerCase().endsWith(ending));
const isMeasured = (name: string) => !isStudy(name) && !isSolid(name);
/** The file, or the folder that was dropped with it. */
const top = (name: string) => name.split("/")[0] ?? "";

/** Take the files that are dropped anywhere on the page; `endings` are those of CAD files and meshes. */
export function followDrops(endings: string[]): void {
  solids = endings;
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

/** Add files at once if their place is clear; several loose measured files need a folder first. */
async function take(added: Added[]): Promise<void> {
  const visible = added.filter(({ name }) => !name.split("/").some((part) => part.startsWith(".")));
  const some = visible.length > 0 ? visible : added.slice(0, 1); // the server refuses a hidden file with its reason
  const first = some[0];
  if (first === undefined) return;
  const isOneFolder = some.every(({ name }) => name.startsWith(`${top(first.name)}/`));
  const measured = some.filter(({ name }) => isMeasured(name));
  if (isOneFolder || measured.length < 2) return add(some, false);
  pending.value = measured;
  folder.value ||= "measured";
  const others = some.filter(({ name }) => !isMeasured(name)); // they belong beside the studies
  if (others.length > 0) await add(others, false);
}

async function add(added: Added[], replace: boolean, all = added.map(({ name }) => name)): Promise<void> {
  const [repeated, useless]: [Added[], string[]] = [[], []];
  taken.value = null;
  try {
    for (const [k, each] of added.entries()) {
      progress.value = `Adding ${each.name}, ${k + 1} of ${added.length}`;
      try {
        list(await server.upload(each.name, each.content, replace));
      } catch (reason) {
        const code = reason instanceof Refusal ? reason.problem?.code : undefined;
        if (code === "repeated") repeated.push(each);
        else if (code === NO_USE && useless.length + 1 < all.length) useless.push(each.name);
        else throw reason;
      }
    }
  } catch (reason) {
    progress.value = "";
    throw reason;
  }
  const useful = all.filter((name) => !useless.includes(name));
  const leftOut = useless.length > 0 ? ` Left out, because nothing reads them: ${useless.join(", ")}.` : "";
  progress.value = repeated.length === 0 ? `Added ${[...new Set(useful.map(top))].join(", ")}.${leftOut}` : "";
  if (repeated.length > 0) taken.value = { files: repeated, all: useful };
  else await use(useful);
}

/** Use files that are in the folder now: open a study, choose measurements, and explain the others. */
async function use(names: string[]): Promise<void> {
  const study = names.find((name) => isStudy(name) && top(name) === name);
  const [measured, solid] = [names.find(isMeasured), names.find(isSolid)];
  if (measured !== undefined) chooseFile(top(measured));
  if (study !== undefined) await openFile(study);
  if (solid !== undefined) notice.value ??= `${solid} is in the folder. A study uses it with file = "${solid}" in its table [cell.solid].`;
}

function addPending(): void {
  const place = folder.peek().trim();
  const added = pending.peek().map((each) => ({ ...each, name: `${place}/${each.name}` }));
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
    </div>
  );
}

/** Questions about received files, and how far they are; a drop can happen beside any analysis. */
export function Received() {
  const already = taken.value;
  return (
    <>
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
      {already !== null && (
        <div class="row" role="alert">
          <span>
            In the folder already: {already.files.slice(0, 3).map(({ name }) => name).join(", ")}
            {already.files.length > 3 && ` and ${already.files.length - 3} more`}.
          </span>
          <button type="button" onClick={() => void attempt(() => add(already.files, true, already.all))}>
            Replace
          </button>
          <button
            type="button"
            onClick={() => {
              taken.value = null;
              void attempt(() => use(already.all));
            }}
          >
            Use what is there
          </button>
        </div>
      )}
      <p class="quiet" role="status">
        {progress.value}
      </p>
    </>
  );
}
