/** The analysis that is chosen, with its options and its files. */

import { computed, signal } from "@preact/signals";
import type { Analysis, Listed, Option, Wanted } from "./server";
import { broken, file, files, plate, problems, text } from "./study";

export type Answered = string | number | boolean;

export const analyses = signal<Analysis[]>([]);
export const measured = signal<string[]>([]); // files and folders of measurements
const given = signal<Record<string, Record<string, Answered>>>({}); // options by the name of the analysis
const used = signal<Record<string, boolean>>({}); // whether the study is used, where the user has chosen
const named = signal("");

const first = computed(() => analyses.value.find(({ interactive }) => interactive) ?? analyses.value[0]);
export const analysis = computed(() => analyses.value.find((each) => each.name === named.value) ?? first.value);
export const options = computed(() => given.value[analysis.value?.name ?? ""] ?? {});
export const isWrong = computed(() => problems.value.length > 0 || broken.value || text.value.trim() === "");

/** True if the chosen analysis uses the study of the page. */
export const usesStudy = computed(() => {
  const chosen = analysis.value;
  if (chosen === undefined || chosen.study === "none") return false;
  if (chosen.study === "needed") return true;
  return used.value[chosen.name] ?? (chosen.study === "optional" && plate.value !== null);
});

/** Questions whose answer is missing. */
export const missing = computed(() =>
  (analysis.value?.options ?? []).filter(({ name, required }) => required && (options.value[name] ?? "") === ""),
);

export const wanted = computed((): Wanted | null => {
  const chosen = analysis.value;
  if (chosen === undefined) return null;
  const alone = !usesStudy.value;
  return { analysis: chosen.name, options: options.value, alone, text: alone ? "" : text.value, file: file.value };
});

export function choose(name: string): void {
  named.value = name;
}

export function answer(option: string, value: Answered): void {
  const name = analysis.peek()?.name ?? "";
  given.value = { ...given.peek(), [name]: { ...given.peek()[name], [option]: value } };
}

export function useStudy(whether: boolean): void {
  used.value = { ...used.peek(), [analysis.peek()?.name ?? ""]: whether };
}

/** Take the lists of the folder. */
export function list(listed: Listed): void {
  files.value = listed.files;
  measured.value = listed.measured;
}

export const namesFile = ({ form }: Option) => form === "path";
const takesFile = ({ examines, options: all }: Analysis) => examines && all.some((option) => option.required && namesFile(option));

/** Analyses of measured files. */
export const ofFiles = computed(() => analyses.value.filter(takesFile));

/** Choose a measured file, for the chosen analysis or else the first one that takes files. */
export function chooseFile(name: string, by = analysis.peek()): void {
  const taking = by !== undefined && takesFile(by) ? by : ofFiles.peek()[0];
  const option = taking?.options.find((each) => each.required && namesFile(each));
  if (taking === undefined || option === undefined) return;
  choose(taking.name);
  answer(option.name, name);
}
