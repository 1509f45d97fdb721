/** The list of analyses with their options, and the jobs of this studio. */

import { useEffect, useState } from "preact/hooks";
import { cancel, compute, elapsed, running, whole } from "./jobs";
import { Runs } from "./runs";
import type { Analysis, Job, Option } from "./server";
import { broken, problems, text } from "./study";

type Given = Record<string, string | number | boolean>;

export function Compute({ analyses }: { analyses: Analysis[] }) {
  const [name, setName] = useState(analyses.find(({ interactive }) => interactive)?.name ?? analyses[0]?.name ?? "");
  const [given, setGiven] = useState<Record<string, Given>>({});
  const analysis = analyses.find((each) => each.name === name);
  const job = running();
  if (analysis === undefined) return null;
  const wrong = problems.value.length > 0 || broken.value || text.value.trim() === "";
  const options = given[name] ?? {};
  const set = (option: string, value: string | number | boolean) =>
    setGiven({ ...given, [name]: { ...options, [option]: value } });
  return (
    <section class="compute" aria-labelledby="compute-title">
      <h2 id="compute-title">Compute</h2>
      <div class="row">
        <label>
          Analysis
          <select value={name} onChange={(event) => setName(event.currentTarget.value)}>
            {analyses.map((each) => (
              <option>{each.name}</option>
            ))}
          </select>
        </label>
        <button type="button" class="main" disabled={wrong} onClick={() => void compute(name, options)}>
          Compute {name}
        </button>
        {job !== undefined && (
          <button type="button" onClick={() => void cancel(job.number)}>
            Cancel
          </button>
        )}
        {whole.value !== null && <a href="#result">Go to the result</a>}
        {wrong && <span class="quiet">The study has problems, or is empty.</span>}
      </div>
      <p class="quiet">{analysis.help}</p>
      {analysis.options.length > 0 && (
        <div class="fields">
          {analysis.options.map((option) => (
            <OptionField key={`${name}-${option.name}`} option={option} value={options[option.name]}
              set={(value) => set(option.name, value)} />
          ))}
        </div>
      )}
      {job !== undefined && !job.turned && <Running job={job} />}
      <Runs />
    </section>
  );
}

interface OptionProps {
  option: Option;
  value: string | number | boolean | undefined;
  set: (value: string | number | boolean) => void;
}

function OptionField({ option, value, set }: OptionProps) {
  const id = `option-${option.name}`;
  const title = option.name.replaceAll("_", " ");
  const about = { id, "aria-describedby": `${id}-help` };
  const shown = value ?? option.default ?? "";
  return (
    <div class="field given">
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
          </label>
          {option.form === "choice" ? (
            <select {...about} value={String(shown)} onChange={(event) => set(event.currentTarget.value)}>
              {option.choices.map((choice) => (
                <option>{choice}</option>
              ))}
            </select>
          ) : (
            <input
              {...about}
              type="text"
              inputMode={option.form === "int" || option.form === "float" ? "decimal" : "text"}
              value={String(shown)}
              onChange={({ currentTarget: { value: typed } }) =>
                set(option.form === "int" || option.form === "float" ? numberOr(typed) : typed)
              }
            />
          )}
        </>
      )}
      <p id={`${id}-help`} class="help">
        {option.help}
      </p>
    </div>
  );
}

/** The number of a typed text, or else the text, which the server refuses with its reason. */
const numberOr = (typed: string) => (typed.trim() === "" || Number.isNaN(Number(typed)) ? typed : Number(typed));

function Running({ job }: { job: Job }) {
  const [now, setNow] = useState(performance.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(performance.now()), 1000);
    return () => clearInterval(timer);
  }, []);
  const [done, planned, what] = job.progress;
  const share = planned > 0 ? { value: done, max: planned } : {};
  return (
    <div class="running">
      <progress {...share} aria-label={`Computing ${job.analysis}`} />
      <p>
        {`Computing ${job.analysis}${planned > 0 ? `: ${done} of ${planned}` : ""}${what && ` (${what})`}, `}
        {Math.floor(elapsed(job, now))} s.{" "}
        <span class="quiet">{job.cost}</span>
      </p>
    </div>
  );
}
