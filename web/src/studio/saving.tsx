/** Saves a result: its pictures, tables, files, its folder, and its page, as the server offers them. */

import { useState } from "preact/hooks";
import { download } from "../parts/download";
import { shownUnits } from "../parts/units";
import { server, type Answer, type Exports, type WholeJob } from "./server";
import { attempt } from "./study";

interface Props {
  job: WholeJob;
  answer: Answer;
  exports: Exports;
}

const FOLDER = "folder ";
const PAGE = "page ";

export function Saving({ job, answer, exports }: Props) {
  const [what, setWhat] = useState(FOLDER);
  const [form, setForm] = useState("");
  const [style, setStyle] = useState(Object.keys(exports.looks)[0] ?? "");
  const [busy, setBusy] = useState(false);
  const [kind, name] = [what.slice(0, what.indexOf(" ")), what.slice(what.indexOf(" ") + 1)];
  const forms = kind === "picture" ? exports.pictures : kind === "table" ? exports.tables : [];
  const chosen = forms.includes(form) ? form : (forms[0] ?? "");
  const units = Object.entries(shownUnits.value).map(([quantity, { name, factor }]) => [quantity, [name, factor]] as const);
  const save = () =>
    attempt(async () => {
      setBusy(true);
      try {
        const wanted = { kind, name, form: chosen, ...(kind === "picture" ? { style, units: Object.fromEntries(units) } : {}) };
        const file = await (kind === "page" ? server.page(job.number) : server.export(job.number, wanted));
        download(file.content, file.name);
      } finally {
        setBusy(false);
      }
    });
  const list = (title: string, each: string, names: string[]) =>
    names.length > 0 && (
      <optgroup label={title}>
        {names.map((option) => (
          <option value={`${each} ${option}`}>{option}</option>
        ))}
      </optgroup>
    );
  return (
    <div class="row" role="group" aria-label="Save the result">
      <label>
        Save
        <select value={what} onChange={(event) => setWhat(event.currentTarget.value)}>
          <option value={FOLDER}>everything, as one zip</option>
          {job.view && <option value={PAGE}>the interactive page, as one HTML file</option>}
          {list("Pictures", "picture", answer.pictures.map((picture) => picture.name))}
          {list("Tables", "table", answer.tables.map((table) => table.title))}
          {list("Files", "file", answer.files)}
        </select>
      </label>
      {forms.length > 0 && (
        <label>
          Format
          <select value={chosen} onChange={(event) => setForm(event.currentTarget.value)}>
            {forms.map((each) => (
              <option>{each}</option>
            ))}
          </select>
        </label>
      )}
      {kind === "picture" && (
        <label>
          Style
          <select value={style} onChange={(event) => setStyle(event.currentTarget.value)}>
            {Object.entries(exports.looks).map(([look, words]) => (
              <option value={look}>{words}</option>
            ))}
          </select>
        </label>
      )}
      {kind === "picture" && units.length > 0 && <span class="quiet">axes in {units.map(([, [name]]) => name).join(" and ")}, as in the view</span>}
      <button type="button" disabled={busy} onClick={() => void save()}>
        {busy ? "The file is made" : "Save file"}
      </button>
    </div>
  );
}
