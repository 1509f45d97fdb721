/** Computed designs of the shown job, which arrive while it is computed, and what is drawn of them. */

import { computed, effect, signal } from "@preact/signals";
import { signed, uncertain } from "../parts/numbers";
import { jobs, shown } from "./jobs";
import { server, type DesignPoint, type PointNumber } from "./server";
import { react } from "./study";

export const ORDER = "order of computation";
const ALL = "";

export const points = signal<DesignPoint[]>([]);
export const group = signal(ALL); // of the drawn points; all of them without one
export const across = signal<string | null>(null); // title of the horizontal axis, if the user chose one
export const selected = signal<number | null>(null); // place in the list of points
let of: number | null = null; // number of the job
let asking = false;

/** Places of the drawn points in the list. */
export const drawn = computed(() =>
  points.value.map((_, place) => place).filter((place) => !group.value || points.value[place]?.group === group.value),
);
export const groups = computed(() => [...new Set(points.value.map((point) => point.group))]);

/** Titles of the numbers that vary in every drawn point. */
export const axes = computed(() => {
  const lists = drawn.value.map((place) => (points.value[place]?.varied ?? []).map(({ title }) => title));
  return [...new Set(lists[0])].filter((title) => lists.every((list) => list.includes(title)));
});

export const horizontal = computed(() => {
  const wanted = across.value;
  return wanted !== null && (wanted === ORDER || axes.value.includes(wanted)) ? wanted : (axes.value[0] ?? ORDER);
});

export function followPoints(): void {
  effect(() => {
    const job = jobs.value.find(({ number }) => number === shown.value);
    if (shown.value !== of) {
      of = shown.value;
      points.value = [];
      selected.value = across.value = null;
      group.value = ALL;
    }
    if (job !== undefined && job.points > points.value.length) void more(job.number);
  });
}

async function more(number: number): Promise<void> {
  if (asking) return; // the next list of jobs asks again
  asking = true;
  await react(async () => {
    const first = points.peek().length;
    const next = await server.points(number, first);
    asking = false; // before the signal, whose effect may ask for more
    if (number === of && first === points.peek().length) points.value = [...points.peek(), ...next];
  });
  asking = false;
}

export const at = (point: DesignPoint, place: number, title: string): number =>
  title === ORDER ? place + 1 : (point.varied.find((each) => each.title === title)?.value ?? NaN);

const PREFIXES: [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
];
const WITH_PREFIX = ["Hz", "m", "Pa"];

export interface Scale {
  factor: number; // from SI
  unit: string;
}

/** The unit in which the largest value has few digits before its point. */
export function scaleOf(values: number[], unit: string): Scale {
  const largest = Math.max(...values.map(Math.abs), 0);
  if (unit === "rad") return { factor: 180 / Math.PI, unit: "deg" };
  const [size, prefix] = PREFIXES.find(([least]) => WITH_PREFIX.includes(unit) && largest >= least) ?? [1, ""];
  return { factor: 1 / size, unit: prefix + unit };
}

/** A number for people: with its error, or marked as a preview; varied numbers are exact. */
export function written({ value, unit, error }: PointNumber, isResult: boolean): string {
  const scale = scaleOf([value], unit);
  const scaled = value * scale.factor;
  const text = isResult && error !== null ? uncertain(scaled, error * scale.factor) : signed(String(Number(scaled.toPrecision(isResult ? 4 : 6))));
  return `${text} ${scale.unit}`.trim() + (isResult && error === null ? " (preview)" : "");
}
