/** The form: a section for each table of the study, from the declarations. */

import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { ComponentChildren } from "preact";
import { inSentence, isTable, parsed, typedText, type Branch } from "./declared";
import { Field } from "./field";
import type { Step, Tables, Value } from "./server";
import { broken, change, isWithin, loaded, opened, pathOf, problems, values } from "./study";

const FEWEST = 3; // keys that are worth folding away

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

/** Plain keys of a table, then the tables in it; what the study does not have is folded away where it is much. */
function Contents({ branches, steps, given }: ContentsProps) {
  // what has been shown, or used where it is folded, stays there until another study is opened: nothing jumps
  const [shown, used] = useMemo(() => [new Set<string>(), new Set<string>()], [loaded.value]);
  const isFurther = ({ name, key }: Branch) =>
    !key.required && !shown.has(name) && (given[name] === undefined || used.has(name));
  const [keys, tables] = [branches.filter((branch) => !isTable(branch)), branches.filter(isTable)];
  // a table of which the study has nothing is shown whole
  const isFolded = steps.length > 0 && !keys.every(isFurther);
  const foldable = keys.filter((branch) => isFurther(branch) && branch.key.kind !== "choice");
  const furtherKeys = isFolded && foldable.length >= FEWEST ? foldable : [];
  const furtherTables = steps.length === 0 ? tables.filter(isFurther) : [];
  const plain = keys.filter((branch) => !furtherKeys.includes(branch));
  const sections = tables.filter((branch) => !furtherTables.includes(branch));
  for (const { name } of [...plain, ...sections]) shown.add(name);
  const fields = (group: Branch[]) => (
    <div class="fields">
      {group.map((branch) => (
        <Field key={branch.key.path} branch={branch} steps={[...steps, branch.name]} value={given[branch.name]} />
      ))}
    </div>
  );
  const sectionOf = (branch: Branch) => (
    <Section
      key={branch.key.path}
      branch={branch}
      steps={[...steps, branch.name]}
      value={given[branch.name]}
      onOpen={() => used.add(branch.name)}
    />
  );
  return (
    <>
      {plain.length > 0 && fields(plain)}
      {furtherKeys.length > 0 && (
        <Further
          title="Further keys"
          about={furtherKeys.map(({ key }) => inSentence(key.title)).join(", ")}
          steps={steps}
          branches={furtherKeys}
        >
          <div onFocusIn={() => furtherKeys.forEach(({ name }) => used.add(name))}>{fields(furtherKeys)}</div>
        </Further>
      )}
      {sections.map(sectionOf)}
      {furtherTables.length > 0 && (
        <Further title="Further tables" about="that the study does not have" steps={steps} branches={furtherTables}>
          {furtherTables.map(sectionOf)}
        </Further>
      )}
    </>
  );
}

interface FurtherProps {
  title: string;
  about: string;
  steps: Step[];
  branches: Branch[];
  children: ComponentChildren;
}

/** What the study does not have; it opens by itself for a problem in it, and for a table that is asked for. */
function Further({ title, about, steps, branches, children }: FurtherProps) {
  const [open, setOpen] = useState(false);
  const paths = branches.map(({ name }) => pathOf([...steps, name]));
  const isNeeded = paths.some((path) => isOpened(path) || problems.value.some((each) => isWithin(each.path, path)));
  useEffect(() => {
    if (isNeeded) setOpen(true);
  }, [isNeeded]);
  return (
    <details class="further" open={open} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>
        {title} <span class="quiet">{about}</span>
      </summary>
      {children}
    </details>
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
      {value !== undefined && !key.required && <Remove steps={steps}>Remove {inSentence(key.title)}</Remove>}
    </>
  );
}

/** Tables of one name. */
function List({ branch, steps, items }: { branch: Branch; steps: Step[]; items: Value[] }) {
  const title = inSentence(branch.key.title);
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
