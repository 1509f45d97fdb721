/** Jobs of the server, as all pages of this studio see them. */

import { computed, effect, signal } from "@preact/signals";
import { followJobs, NO_ANSWER, server, type Job, type Wanted, type WholeJob } from "./server";
import { attempt, notice, react } from "./study";

export const jobs = signal<Job[]>([]);
export const lost = signal(false); // the server does not answer
export const shown = signal<number | null>(null); // number of the job whose answer is on the page
export const whole = signal<WholeJob | null>(null);
export const painting = signal(true); // the map of the plate is open
export const shownJob = computed(() => jobs.value.find(({ number }) => number === whole.value?.number));
export const awaited = { job: 0 }; // the job whose result comes into view when it is there
const heard = signal(0); // time of the last list
export const isFollowed = computed(() => heard.value > 0);

/** The job that is computed, as far as the server answers. */
export const running = () => (lost.value ? undefined : jobs.value.find((job) => job.state === "running"));

/** Seconds that a running job has taken until `now`. */
export const elapsed = (job: Job, now: number) => job.seconds + Math.max(0, now - heard.value) / 1000;

export function follow(): void {
  followJobs(
    (list) => {
      const newest = list.at(-1);
      // the answer of a job that ends is shown in the page that waits for it, and in a page without an answer
      if (newest && shown.peek() === null) shown.value = newest.number;
      heard.value = performance.now();
      jobs.value = list;
    },
    (gone) => {
      lost.value = gone;
      if (!gone && notice.peek() === NO_ANSWER) notice.value = "The server answers again. Make the last change once more.";
    },
  );
  effect(() => {
    const job = jobs.value.find((each) => each.number === shown.value);
    if (job === undefined || job.state === "running") return; // until then the result before stays
    const known = whole.peek();
    if (known?.number === job.number && known.state === job.state) return;
    void react(async () => {
      const answer = await server.job(job.number);
      if (shown.peek() === answer.number) whole.value = answer;
    });
  });
}

/** Show the result of a job that the user has chosen; the map above it closes. */
export function showResult(number: number): void {
  shown.value = number;
  painting.value = false;
}

/** Start a run and show it, in place of an unfinished run with the same order if there is one. */
export const compute = (wanted: Wanted, unfinished?: number) =>
  attempt(async () => {
    const { number } = await server.run(wanted);
    awaited.job = number;
    showResult(number);
    if (unfinished !== undefined) await server.remove(unfinished);
  });

export const remove = (number: number) =>
  attempt(async () => {
    if (shown.peek() === number) shown.value = whole.value = null;
    await server.remove(number);
  });

export const cancel = (number: number) => attempt(async () => void (await server.cancel(number)));
