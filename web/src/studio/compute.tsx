/** The list of analyses with their questions, and the jobs of this studio. */

import { useEffect, useState } from "preact/hooks";
import { analyses, analysis, choose, isWrong, missing, usesStudy, wanted } from "./chosen";
import { cancel, compute, elapsed, lost, running, whole } from "./jobs";
import { Received } from "./drop";
import { Runs } from "./runs";
import type { Job } from "./server";
import { settled } from "./study";
import { isReading, refused } from "./understood";
import { Questions } from "./wizard";

export function Compute() {
  const chosen = analysis.value;
  const job = running();
  if (chosen === undefined) return null;
  const wrong = usesStudy.value && chosen.study !== "settings" && isWrong.value;
  const unread = chosen.examines && (isReading.value || refused.value !== null);
  const begin = async () => {
    await settled(); // a change or an opening may not be in the text yet
    if (wanted.peek() !== null) await compute(wanted.peek()!);
  };
  return (
    <section class="compute" aria-labelledby="compute-title">
      <h2 id="compute-title">Compute</h2>
      <div class="row">
        <label>
          Analysis
          <select value={chosen.name} onChange={(event) => choose(event.currentTarget.value)}>
            {analyses.value.map((each) => (
              <option>{each.name}</option>
            ))}
          </select>
        </label>
        <button type="button" class="main" disabled={lost.value || wrong || unread || missing.value.length > 0} onClick={() => void begin()}>
          Compute {chosen.name}
        </button>
        {job !== undefined && (
          <button type="button" onClick={() => void cancel(job.number)}>
            Cancel
          </button>
        )}
        {whole.value !== null && <a href="#result">Go to the result</a>}
        {wrong && <span class="quiet">The study has problems, or is empty.</span>}
      </div>
      <p class="quiet">{chosen.help}</p>
      <Received />
      <Questions chosen={chosen} />
      {job !== undefined && !job.turned && <Running job={job} />}
      <Runs />
    </section>
  );
}

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
