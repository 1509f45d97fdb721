/** The answer of a job: the interactive view or sentences, then tables, remarks and pictures. */

import { useEffect, useRef, useState } from "preact/hooks";
import { Dataset } from "../dataset";
import { show } from "../views";
import { typeset } from "../parts/numbers";
import { Parts } from "./editor";
import { awaited, compute, lost, whole } from "./jobs";
import { host } from "./slider";
import { TableOf } from "./table";
import { Saving } from "./saving";
import { server, type Answer, type Exports, type WholeJob } from "./server";
import { file, isSaved, showVersion } from "./study";
import { arrived, canTurn, designOf } from "./turn";

export function Result({ exports }: { exports: Exports }) {
  const job = whole.value;
  const place = useRef<HTMLElement>(null);
  useEffect(() => {
    if (job === null || job.number !== awaited.job) return;
    awaited.job = 0;
    if (job.state !== "cancelled") place.current?.scrollIntoView(); // its designs stay in sight
  }, [job?.number]);
  if (job === null) return null;
  return (
    <section ref={place} id="result" class="result" aria-label={`Result of ${job.analysis}`}>
      {!canTurn.value && (
        <p class="notice">
          This result belongs to {[null, job.file].includes(file.value) ? "another version of the study" : job.file}.{" "}
          <button type="button" onClick={() => showVersion(job.text, job.file)}>
            Show that study
          </button>
        </p>
      )}
      {["cancelled", "interrupted"].includes(job.state) && <Unfinished job={job} />}
      {job.error !== null && (
        <>
          <h2>No result of {job.analysis}</h2>
          <Parts problem={{ ...job.error, path: job.error.argument, line: null }} />
        </>
      )}
      {job.answer !== null && <Shown key={designOf(job)} job={job} answer={job.answer} exports={exports} />}
    </section>
  );
}

/** A job that can be computed again, with its finished parts from the store. */
function Unfinished({ job }: { job: WholeJob }) {
  const { analysis, options, alone, text, file: name } = job;
  const [done, planned] = job.progress;
  return (
    <p>
      {job.state === "cancelled" ? `The computation of ${analysis} was cancelled` : `The server ended during the computation of ${analysis}`}
      {planned > 0 && ` at ${done} of ${planned}`}. Finished parts come from the store.{" "}
      <button type="button" disabled={lost.value}
        onClick={() => void compute({ analysis, options, alone, text, file: name }, job.number)}>
        Continue
      </button>
    </p>
  );
}

function Shown({ job, answer, exports }: { job: WholeJob; answer: Answer; exports: Exports }) {
  return (
    <>
      {job.view ? <View number={job.number} /> : <Words answer={answer} />}
      {answer.remarks.map((remark) => (
        <p class="doubt">{remark}</p>
      ))}
      <Saving job={job} answer={answer} exports={exports} />
      <dl class="repeat">
        <dt>The same as a command</dt>
        <dd>
          <code>{job.command}</code>
        </dd>
        <dt>in Python</dt>
        <dd>
          <code>{job.python}</code>
        </dd>
        {!job.alone && !isSaved(job.text, job.file) && (
          <dd class="quiet">once the study of this result is saved as {job.file}</dd>
        )}
      </dl>
      {answer.tables.length > 0 && (
        <details class="section" open={!job.view}>
          <summary>Tables</summary>
          {answer.tables.map((table) => (
            <TableOf table={table} />
          ))}
        </details>
      )}
      <Pictures job={job} answer={answer} />
    </>
  );
}

function Words({ answer }: { answer: Answer }) {
  return (
    <header>
      <h2>{answer.title}</h2>
      <p class="origin">{answer.origin}</p>
      {answer.summary.map((sentence) => (
        <p class="sentence">{typeset(sentence)}</p>
      ))}
    </header>
  );
}

/** The interactive view; other parts of the page do not draw it anew, and a newer result takes its place. */
function View({ number }: { number: number }) {
  const place = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState("");
  const remove = useRef(() => {});
  useEffect(() => () => remove.current(), []);
  useEffect(() => {
    let left = false;
    server.view(number).then(
      (content) => {
        if (left || place.current === null) return;
        remove.current = show(Dataset.read(content), place.current, host);
        arrived(number);
      },
      () => setProblem("The view cannot be loaded: the server does not answer."),
    );
    return () => {
      left = true;
    };
  }, [number]);
  return (
    <>
      {problem && <p role="alert">{problem}</p>}
      <div ref={place} />
    </>
  );
}

/** Pictures of the result, drawn by the server while this section is open. */
function Pictures({ job, answer }: { job: WholeJob; answer: Answer }) {
  const [isOpen, setOpen] = useState(!job.view);
  if (answer.pictures.length === 0) return null;
  return (
    <details class="section" open={isOpen} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>Pictures</summary>
      {isOpen && (
        <div class="pictures">
          {answer.pictures.map(({ name, caption }) => (
            <Picture key={`${job.number} ${name}`} address={server.picture(job.number, name)} name={name} caption={caption} />
          ))}
        </div>
      )}
    </details>
  );
}

function Picture({ address, name, caption }: { address: string; name: string; caption: string }) {
  const [state, setState] = useState("The picture is being drawn.");
  return (
    <figure>
      <img src={address} alt={caption || name} loading="lazy" onLoad={() => setState("")} onError={() => setState("The picture cannot be drawn.")} />
      {state && <p class="quiet">{state}</p>}
      <figcaption>{caption}</figcaption>
    </figure>
  );
}
