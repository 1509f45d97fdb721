/** The list of runs in this folder, newest first: open or remove one. */

import { other } from "./compare";
import { jobs, lost, remove, showResult, shown, shownJob } from "./jobs";
import type { Job } from "./server";

const STATES = { running: "running", done: "", failed: "failed", cancelled: "cancelled", interrupted: "interrupted" };
const stateOf = ({ state }: Job) => (state === "running" && lost.value ? "unknown, because the server does not answer" : STATES[state]);

export function Runs() {
  const list = [...jobs.value].reverse();
  const own = list.find(({ number }) => number === shown.value); // runs of commands come and go beside it
  return (
    <>
      <p class="hidden" role="status">
        {own === undefined ? "" : `${own.analysis}: ${stateOf(own) || "finished"}`}
      </p>
      {list.length > 0 && (
        <details class="section">
          <summary>
            Runs <span class="quiet">{list.length} in this folder</span>
          </summary>
          <div class="wide" tabIndex={0} role="group" aria-label="Runs">
            <table>
              <thead>
                <tr>
                  <th scope="col">run</th>
                  <th scope="col">study</th>
                  <th scope="col">file</th>
                  <th scope="col">begun</th>
                  <th scope="col">took</th>
                  <th scope="col" colSpan={2}>
                    <span class="hidden">compare and remove</span>
                  </th>
                </tr>
              </thead>
              <tbody>
                {list.map((job) => (
                  <Run key={job.number} job={job} />
                ))}
              </tbody>
            </table>
          </div>
        </details>
      )}
    </>
  );
}

function Run({ job }: { job: Job }) {
  const name = `${job.number}. ${job.analysis}`;
  return (
    <tr>
      <td>
        <button type="button" class="minor" aria-pressed={shown.value === job.number}
          onClick={() => showResult(job.number)}>
          {name} {stateOf(job) && `(${stateOf(job)})`}
        </button>
      </td>
      <td class="study-title">{job.title || "-"}</td>
      <td>
        {job.file} {job.byCommand && <span class="quiet">command line</span>}
      </td>
      <td class="number">{began(job.started)}</td>
      <td class="number">{job.state === "running" ? "" : `${Math.round(job.seconds)} s`}</td>
      <td>
        {job.state === "done" && job.number !== shown.value && job.analysis === shownJob.value?.analysis && (
          <button type="button" class="minor" aria-pressed={other.value === job.number}
            onClick={() => (other.value = job.number)} aria-label={`Compare the shown run with ${name}`}>
            Compare
          </button>
        )}
      </td>
      <td>
        {job.state !== "running" && (
          <button type="button" class="minor" onClick={() => void remove(job.number)} aria-label={`Remove ${name}`}>
            Remove
          </button>
        )}
      </td>
    </tr>
  );
}

const began = (seconds: number) =>
  new Date(1000 * seconds).toLocaleString([], { dateStyle: "short", timeStyle: "short" });
