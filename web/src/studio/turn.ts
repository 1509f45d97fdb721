/** The number that the user turns: its preview at once, its certified curves a moment later. */

import { computed, effect, signal } from "@preact/signals";
import type { Dataset } from "../dataset";
import type { Turned } from "../parts/host";
import { jobs, shown, whole } from "./jobs";
import { server, type Knob, type WholeJob } from "./server";
import { attempt, change, file, react, text } from "./study";

const PAUSE = 50; // ms after a move before its certified curves are computed; a newer move replaces them

export const knobs = signal<Knob[]>([]);
export const selected = signal(""); // path of a number
export const turnedTo = signal<number | null>(null); // its value; null if it is that of the result
const previews = signal<Record<string, { job: number; count: number; data: Dataset }>>({});
/** Certified curves of a job that goes on; `count` is that of their versions. */
const first = signal<{ job: number; count: number; at: number; data: Dataset } | null>(null);

export const knob = computed(() => knobs.value.find(({ path }) => path === selected.value) ?? knobs.value[0]);
export const isPrepared = computed(() => previews.value[knob.value?.path ?? ""] !== undefined);
/** True while the text is that of the result, or differs from it in the turned number only. */
export const canTurn = computed(() => turnedTo.value !== null || whole.value?.alone || text.value === whole.value?.text);

export const turned = computed((): Turned | null => {
  const [value, of] = [turnedTo.value, knob.value];
  if (value === null || of === undefined) return null;
  return {
    certified: first.value?.at === value ? first.value.data : null,
    preview: previews.value[of.path]?.data ?? null,
    at: value * of.scale,
  };
});

export const written = ({ unit }: Knob, value: number): string => `${Number(value.toPrecision(9))} ${unit}`.trim();
const asValue = (of: Knob, value: number) => (of.unit ? written(of, value) : Number(value.toPrecision(9)));

interface Move {
  of: Knob;
  value: number;
}

let timer = 0;
let moved: Move | null = null; // the last one, until it is to be certified
let next: Move | null = null; // to certify when the server has answered the one before
let isSending = false;
let latest = { job: 0, path: "", at: 0 }; // the last value that was sent

export function select(path: string): void {
  selected.value = path;
  void attempt(async () => void (await server.wish(path)));
}

/** The slider moves. */
export function move(of: Knob, value: number): void {
  turnedTo.value = value;
  moved = { of, value };
  clearTimeout(timer);
  timer = window.setTimeout(settle, PAUSE);
}

/** Certify the last value to which the slider moved: after a pause, or when the pointer is released. */
export function settle(): void {
  clearTimeout(timer);
  if (moved === null) return;
  next = moved;
  moved = null;
  void attempt(certify);
}

/** The slider is released, or moved by a key: the text follows, keys in a row as one step of its history. */
export const release = (of: Knob, value: number) => change(of.steps, asValue(of, value), true);

/** Send values one after the other: two requests at once could arrive in another order. */
async function certify(): Promise<void> {
  if (isSending) return;
  isSending = true;
  try {
    while (next !== null) {
      const [{ of, value }, base] = [next, whole.peek()];
      next = null;
      if (base === null) return;
      const { number } = await server.turn(base, text.peek(), of.steps, asValue(of, value), file.peek());
      latest = { job: number, path: of.path, at: value };
      shown.value = number;
    }
  } catch (reason) {
    turnedTo.value = null;
    throw reason;
  } finally {
    isSending = false;
  }
}

let unturned = 0; // number of the last job that belongs to no turned number

/** Number of the job from which a number was turned to this one: the same view shows both. */
export const designOf = (job: WholeJob) => (job.turned && unturned > 0 ? unturned : (unturned = job.number));

/** The view shows the result of a job: the design that was turned is that of the result. */
export function arrived(job: number): void {
  if (job !== latest.job || turnedTo.peek() === latest.at) turnedTo.value = null;
}

/** Fetch what the worker has prepared, once each. */
export function followTurns(): void {
  const asked = new Set<string>();
  const once = (name: string, action: () => Promise<void>) => {
    if (asked.has(name)) return;
    asked.add(name);
    void react(action);
  };
  effect(() => {
    const job = whole.value;
    if (job === null) return;
    const isOfTurn = job.number === latest.job;
    once(`end ${job.number}`, async () => {
      // along the turned number the preview of the design before is still one of this design
      previews.value = isOfTurn ? Object.fromEntries(Object.entries(previews.peek()).filter(([path]) => path === latest.path)) : {};
      knobs.value = job.view
        ? knobs.peek().map((of) => (isOfTurn && of.path === latest.path ? { ...of, value: latest.at } : of))
        : [];
      if (!job.view) turnedTo.value = null;
    });
  });
  effect(() => {
    const started = jobs.value.find(({ number }) => number === latest.job);
    if (started?.first && started.state === "running") {
      const { number: job, first: count } = started;
      once(`first ${job} ${count}`, async () => {
        const { at } = latest;
        const data = await server.part(job, "first");
        const known = first.peek();
        const isOlder = known !== null && known.job === job && known.count > count;
        if (data !== null && latest.job === job && !isOlder) first.value = { job, count, at, data };
      });
    }
    const job = jobs.value.find(({ number }) => number === whole.value?.number);
    if (!job?.turns) return;
    once(`knobs ${job.number}`, async () => {
      const list = await server.knobs(job.number);
      if (whole.peek()?.number === job.number) knobs.value = list;
    });
    const place = knobs.value.findIndex((of) => of === knob.value);
    const path = knob.value?.path ?? "";
    const count = job.previews[path] ?? 0;
    if (count > 0 && asked.has(`knobs ${job.number}`))
      once(`preview ${job.number} ${count} ${path}`, async () => {
        const data = await server.part(job.number, `previews/${place}`);
        const known = previews.peek()[path];
        const isOlder = known !== undefined && known.job === job.number && known.count >= count;
        if (data !== null && whole.peek()?.number === job.number && !isOlder)
          previews.value = { ...previews.peek(), [path]: { job: job.number, count, data } };
      });
  });
}
