/** The form: a section for each table of the study, from the declarations. */

import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { ComponentChildren } from "preact";
import { isTable, parsed, typedText, type Branch } from "./declared";
import { Field } from "./field";
import type { Step, Tables, Value } from "./server";
import { broken, change, file, isWithin, opened, pathOf, problems, values } from "./study";

export function Form({ tree }: { tree: Branch[] }) {
  return (
    <div class="form">
      {broken.value && (
        <p class="problem" role="status">
          The text has a mistake in its syntax. The form shows the last values until it is corrected.
        </p>
      )}
      <fieldset disabled={broken.value}>
        <legend class="hidden">Keys of the study</legend>
        <Contents branches={tree} steps={[]} given={values.value} />
      </fieldset>
    </div>
  );
}

interface ContentsProps {
  branches: Branch[];
  steps: Step[];
  given: Tables;
}

/** Plain keys of a table, then the tables in it. */
function Contents({ branches, steps, given }: ContentsProps) {
  const plain = branches.filter((branch) => !isTable(branch));
  // a table that the study does not have stays below these words when it gets its first key, or it would jump and close
  const begun = useMemo(() => new Set<string>(), [file.value]);
  // at the top of the file there are so many that they hide the tables of the study
  const isFurther = ({ name, key }: Branch) =>
    steps.length === 0 && !key.required && (given[name] === undefined || begun.has(name));
  const further = branches.filter((branch) => isTable(branch) && isFurther(branch));
  const section = (branch: Branch) => (
    <Section
      key={branch.key.path}
      branch={branch}
      steps={[...steps, branch.name]}
      value={given[branch.name]}
      onOpen={() => isFurther(branch) && begun.add(branch.name)}
    />
  );
  return (
    <>
      {plain.length > 0 && (
        <div class="fields">
          {plain.map((branch) => (
            <Field key={branch.key.path} branch={branch} steps={[...steps, branch.name]} value={given[branch.name]} />
          ))}
        </div>
      )}
      {branches.filter((branch) => isTable(branch) && !isFurther(branch)).map(section)}
      {further.length > 0 && (
        <details class="further" open={further.some(({ key }) => isOpened(key.path))}>
          <summary>
            Further tables <span class="quiet">that the study does not have</span>
          </summary>
          {further.map(section)}
        </details>
      )}
    </>
  );
}

/** True if a table is to be opened, or a table in it. */
const isOpened = (path: string) => opened.value !== null && isWithin(opened.value.path, path);

interface TableProps {
  branch: Branch;
  steps: Step[];
  value: Value | undefined;
}

/** A table; its contents are drawn when it is open. */
function Section({ branch, steps, value, onOpen }: TableProps & { onOpen: () => void }) {
  const { key } = branch;
  const path = pathOf(steps);
  const wrong = problems.value.filter((each) => isWithin(each.path, path));
  const here = wrong.filter((each) => each.path === path);
  const [chosen, setChosen] = useState<boolean | null>(null);
  const choose = (isOpen: boolean) => {
    setChosen(isOpen);
    if (isOpen) onOpen();
  };
  const place = useRef<HTMLDetailsElement>(null);
  const asked = isOpened(path) ? opened.value : null;
  useEffect(() => {
    if (asked === null || asked.isReached) return;
    choose(true);
    if (asked.path !== path) return; // the table in this one
    place.current?.scrollIntoView();
    place.current?.querySelector("summary")?.focus();
    asked.isReached = true;
  }, [asked]);
  const open = chosen ?? (key.required || (steps.length > 1 && value !== undefined));
  return (
    <details
      ref={place}
      class="section"
      open={open}
      onToggle={({ currentTarget }) => {
        if (currentTarget.open !== open) choose(currentTarget.open);
      }}
    >
      <summary>
        {key.title}
        <span class="quiet"> {stateOf(value)}</span>
        {wrong.length > 0 && (
          <span class="problem">
            {" "}
            {wrong.length} problem{wrong.length > 1 ? "s" : ""}
          </span>
        )}
      </summary>
      {open && (
        <div class="inside">
          <p class="quiet">
            {key.help} <code>{key.kind === "tables" ? `[[${path}]]` : `[${path}]`}</code>
          </p>
          {here.map((each) => (
            <p class="problem">
              {each.cause}; {each.next_step}
            </p>
          ))}
          {key.kind === "tables" ? (
            <List branch={branch} steps={steps} items={Array.isArray(value) ? value : []} />
          ) : key.kind === "entries" ? (
            <Entries branch={branch} steps={steps} given={asTables(value)} />
          ) : (
            <Table branch={branch} steps={steps} value={value} />
          )}
        </div>
      )}
    </details>
  );
}

/** A table of declared keys, or the name that stands for one. */
function Table({ branch, steps, value }: TableProps) {
  const { key } = branch;
  const id = `key-${pathOf(steps)}`;
  const named = key.names.length > 0;
  const byName = named && (value === undefined || typeof value === "string");
  return (
    <>
      {named && (
        <div class="field">
          <label for={id}>{key.title}, by name</label>
          <select
            id={id}
            value={byName ? typedText(value) : "\n"}
            onChange={(event) => {
              const name = event.currentTarget.value;
              change(steps, name === "" ? null : name === "\n" ? {} : name);
            }}
          >
            <option value="">not given</option>
            {key.names.map((name) => (
              <option>{name}</option>
            ))}
            {typeof value === "string" && !key.names.includes(value) && <option>{value}</option>}
            <option value={"\n"}>other, by its constants</option>
          </select>
        </div>
      )}
      {!byName && <Contents branches={branch.inside} steps={steps} given={asTables(value)} />}
      {value !== undefined && !key.required && <Remove steps={steps}>Remove {key.title.toLowerCase()}</Remove>}
    </>
  );
}

/** Tables of one name. */
function List({ branch, steps, items }: { branch: Branch; steps: Step[]; items: Value[] }) {
  const title = branch.key.title.toLowerCase();
  return (
    <>
      {items.map((item, row) => (
        <fieldset class="item" key={row}>
          <legend>
            {branch.key.title} {row + 1}
          </legend>
          <Contents branches={branch.inside} steps={[...steps, row]} given={asTables(item)} />
          <Remove steps={[...steps, row]}>
            Remove {title} {row + 1}
          </Remove>
        </fieldset>
      ))}
      <button type="button" onClick={() => change([...steps, items.length], {})}>
        Add to {title}
      </button>
    </>
  );
}

/** Lines whose names the user chooses. */
function Entries({ branch: { key }, steps, given }: { branch: Branch; steps: Step[]; given: Tables }) {
  const [name, setName] = useState("");
  const [value, setValue] = useState("");
  const path = pathOf(steps);
  return (
    <>
      <ul class="entries">
        {Object.entries(given).map(([entry, content]) => (
          <li key={entry}>
            <label for={`key-${path}.${entry}`}>{entry}</label>
            <input
              id={`key-${path}.${entry}`}
              value={typedText(content)}
              onChange={(event) => change([...steps, entry], parsed(key, event.currentTarget.value))}
            />
            <Remove steps={[...steps, entry]}>Remove {entry}</Remove>
          </li>
        ))}
      </ul>
      <div class="row">
        <label>
          Name
          <input value={name} onInput={(event) => setName(event.currentTarget.value)} />
        </label>
        <label>
          Value
          <input value={value} onInput={(event) => setValue(event.currentTarget.value)} />
        </label>
        <button
          type="button"
          disabled={name === "" || value === ""}
          onClick={() => {
            change([...steps, name], parsed(key, value));
            setName("");
            setValue("");
          }}
        >
          Add a line
        </button>
      </div>
    </>
  );
}

function Remove({ steps, children }: { steps: Step[]; children: ComponentChildren }) {
  return (
    <button type="button" class="minor" onClick={() => change(steps, null)}>
      {children}
    </button>
  );
}

function stateOf(value: Value | undefined): string {
  if (value === undefined) return "";
  if (typeof value === "string") return value;
  if (Array.isArray(value)) return `${value.length} in the study`;
  return "in the study";
}

function asTables(value: Value | undefined): Tables {
  return typeof value === "object" && !Array.isArray(value) ? value : {};
}
