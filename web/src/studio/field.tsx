/** One key of the form: its label, its input, its help while it has the focus, and its problems. */

import { useState } from "preact/hooks";
import { allowedWords, parsed, typedText, type Branch } from "./declared";
import type { Step, Value } from "./server";
import { change, isWithin, pathOf, problems, remarks } from "./study";

interface Props {
  branch: Branch;
  steps: Step[];
  value: Value | undefined;
}

export function Field({ branch: { key }, steps, value }: Props) {
  const path = pathOf(steps);
  const mine = problems.value.filter((each) => isWithin(each.path, path));
  const doubts = remarks.value.filter((each) => isWithin(each.path, path));
  const id = `key-${path}`;
  const shared = {
    id,
    "aria-describedby": `${id}-about`,
    "aria-invalid": mine.length > 0,
    "aria-required": key.required,
  };
  const set = (typed: string) => {
    if (typed !== typedText(value)) change(steps, parsed(key, typed));
  };
  return (
    <div class={`field${mine.length > 0 ? " wrong" : ""}${value !== undefined ? " given" : ""}`}>
      <label for={id}>
        {key.title}
        {key.unit && key.kind !== "quantities" && <span class="quiet"> with unit</span>}
        {key.required && value === undefined && <span class="quiet"> (required)</span>}
      </label>
      {key.kind === "boolean" ? (
        <select {...shared} value={typedText(value)} onChange={(event) => change(steps, yesOrNo(event.currentTarget.value))}>
          <option value="">{key.default} (default)</option>
          <option>true</option>
          <option>false</option>
        </select>
      ) : key.closed ? (
        <select {...shared} value={typedText(value)} onChange={(event) => set(event.currentTarget.value)}>
          <option value="">{key.default ? `${key.default} (default)` : "not given"}</option>
          {key.names.map((name) => (
            <option>{name}</option>
          ))}
          {value !== undefined && !key.names.includes(typedText(value)) && <option>{typedText(value)}</option>}
        </select>
      ) : (
        <Typed {...shared} value={typedText(value)} lines={manyLines(value)} set={set}
          placeholder={key.default} names={[...key.names, ...key.numbers]} />
      )}
      <div id={`${id}-about`}>
        {mine.map((each) => (
          <p class="problem">
            {each.cause}; {each.next_step}
          </p>
        ))}
        {doubts.map((each) => (
          <p class="doubt">{each.text}</p>
        ))}
        <p class="help">
          {allowedWords(key)} <code>{path}</code>
        </p>
      </div>
    </div>
  );
}

const manyLines = (value: Value | undefined): number =>
  typeof value === "string" && value.includes("\n") ? Math.min(value.split("\n").length + 1, 30) : 0;

const yesOrNo = (text: string): boolean | null => (text === "" ? null : text === "true");

interface TypedProps {
  id: string;
  value: string;
  lines: number;
  set: (typed: string) => void;
  placeholder: string;
  names: string[];
}

/** A text input whose value is taken when it is left, or with Enter. */
function Typed({ value, lines, set, names, ...rest }: TypedProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const shared = {
    ...rest,
    value: draft ?? value,
    spellcheck: false,
    autocomplete: "off",
    onInput: (event: { currentTarget: { value: string } }) => setDraft(event.currentTarget.value),
    onBlur: () => {
      if (draft !== null) set(draft);
      setDraft(null);
    },
  };
  if (lines > 0) return <textarea {...shared} rows={lines} wrap="off" />;
  return (
    <>
      <input
        {...shared}
        type="text"
        list={names.length > 0 ? `${rest.id}-names` : undefined}
        onKeyDown={(event) => {
          if (event.key === "Enter" && draft !== null) set(draft);
          if (event.key === "Escape") setDraft(null);
        }}
      />
      {names.length > 0 && (
        <datalist id={`${rest.id}-names`}>
          {names.map((name) => (
            <option value={name} />
          ))}
        </datalist>
      )}
    </>
  );
}
