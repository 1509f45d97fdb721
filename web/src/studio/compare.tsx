/** Two runs side by side: their sentences, the changed keys, and the differences of their numbers. */

import { effect, signal } from "@preact/signals";
import { typeset } from "../parts/numbers";
import { jobs, shown } from "./jobs";
import { server, type Compared } from "./server";
import { react } from "./study";
import { TableOf } from "./table";

export const other = signal<number | null>(null); // the run with which the shown one is compared
const compared = signal<Compared | null>(null);

export function followComparison(): void {
  effect(() => {
    const [first, second] = [other.value, shown.value];
    const answered = (number: number | null) => jobs.value.find((job) => job.number === number && job.state === "done");
    const [own, against] = [answered(second), answered(first)];
    const isOther = own !== undefined && own.analysis !== against?.analysis;
    if (against === undefined || isOther) other.value = null;
    if (first === second || against === undefined || own === undefined || isOther) {
      compared.value = null;
      return;
    }
    void react(async () => {
      const answer = await server.compare(first!, second!);
      if (other.peek() === first && shown.peek() === second) compared.value = answer;
    });
  });
}

export function Comparison() {
  if (compared.value === null) return null;
  const { runs, tables } = compared.value;
  return (
    <section class="section" aria-labelledby="comparison-title">
      <h2 id="comparison-title">{runs.map(({ name }) => name).join(" and ")}</h2>
      <div class="sides-by-side">
        {runs.map(({ name, title, summary }) => (
          <div>
            <h3>
              {name} <span class="quiet">{title}</span>
            </h3>
            {summary.map((sentence) => (
              <p class="sentence">{typeset(sentence)}</p>
            ))}
          </div>
        ))}
      </div>
      {tables.map((table) => (
        <TableOf table={table} />
      ))}
      <p class="quiet">Bold differences exceed the sum of both errors. Equal numbers are left out.</p>
      <button type="button" onClick={() => (other.value = null)}>
        Close the comparison
      </button>
    </section>
  );
}
