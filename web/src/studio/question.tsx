/** A question of an analysis: its input, its help while it has the focus, and why its answer was refused. */

import { answer, measured, options, type Answered } from "./chosen";
import { Parts } from "./editor";
import type { Option } from "./server";
import { files } from "./study";
import { questionOf, refused } from "./understood";

export function Question({ option }: { option: Option }) {
  const id = `option-${option.name}`;
  const title = option.name.replaceAll("_", " ");
  const wrong = questionOf.value === option.name ? refused.value : null;
  const about = { id, "aria-describedby": `${id}-help`, "aria-invalid": wrong !== null };
  const shown = options.value[option.name] ?? option.default ?? "";
  const set = (value: Answered) => answer(option.name, value);
  const number = option.form === "int" || option.form === "float";
  return (
    <div class={`field given${wrong !== null ? " wrong" : ""}`}>
      {option.form === "bool" ? (
        <label class="check">
          <input {...about} type="checkbox" checked={shown === true} onChange={(event) => set(event.currentTarget.checked)} />
          {title}
        </label>
      ) : (
        <>
          <label for={id}>
            {title}
            {option.unit && <span class="quiet"> with unit, such as 1 {option.unit}</span>}
            {option.required && shown === "" && <span class="quiet"> (required)</span>}
          </label>
          {option.form === "path" ? (
            <FileSelect about={about} value={String(shown)} set={set} />
          ) : option.form === "choice" ? (
            <select {...about} value={String(shown)} onChange={(event) => set(event.currentTarget.value)}>
              {option.default === null && <option value="">not given</option>}
              {option.choices.map((choice) => (
                <option>{choice}</option>
              ))}
            </select>
          ) : (
            <input
              {...about}
              type="text"
              inputMode={number ? "decimal" : "text"}
              spellcheck={false}
              autocomplete="off"
              value={String(shown)}
              onChange={({ currentTarget: { value: typed } }) => set(number ? numberOr(typed) : typed)}
            />
          )}
        </>
      )}
      {wrong !== null && (
        <div class="refusal">
          <Parts problem={{ ...wrong, path: "", line: null }} />
        </div>
      )}
      <p id={`${id}-help`} class="help">
        {option.help}
      </p>
    </div>
  );
}

interface SelectProps {
  about: object;
  value: string;
  set: (value: string) => void;
}

function FileSelect({ about, value, set }: SelectProps) {
  const known = [...measured.value, ...files.value];
  return (
    <select {...about} value={value} onChange={(event) => set(event.currentTarget.value)}>
      <option value="">{known.length > 0 ? "not given" : "no file in the folder"}</option>
      {measured.value.length > 0 && (
        <optgroup label="Measured files">
          {measured.value.map((name) => (
            <option>{name}</option>
          ))}
        </optgroup>
      )}
      {files.value.length > 0 && (
        <optgroup label="Studies">
          {files.value.map((name) => (
            <option>{name}</option>
          ))}
        </optgroup>
      )}
      {value !== "" && !known.includes(value) && <option>{value}</option>}
    </select>
  );
}

/** The number of a typed text, or else the text, which the server refuses with its reason. */
const numberOr = (typed: string) => (typed.trim() === "" || Number.isNaN(Number(typed)) ? typed : Number(typed));
