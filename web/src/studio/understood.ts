/** What the library understands of the chosen files: asked anew after every answer, the latest one wins. */

import { computed, effect, signal } from "@preact/signals";
import { Dataset } from "../dataset";
import { analysis, isWrong, missing, usesStudy, wanted } from "./chosen";
import { Refusal, server, type Answer, type Problem, type Wanted } from "./server";
import { isWithin } from "./study";

const PAUSE = 400; // ms after the last change

interface Understood {
  answer: Answer;
  data: Dataset | null;
}

export const understood = signal<Understood | null>(null);
export const refused = signal<Problem | null>(null); // why the files cannot be read with these answers
export const lostServer = signal("");
export const isReading = signal(false);

/** Name of the option that a refusal is about; empty if it is about the file. */
export const questionOf = computed(() => {
  const problem = refused.value;
  const names = (analysis.value?.options ?? []).map(({ name }) => name);
  if (problem === null) return "";
  const steps = problem.argument.split(/[.[]/); // "response.reference" is about the option "reference"
  const named = names.find((name) => name === steps[0]) ?? names.find((name) => steps.includes(name));
  return named ?? names.find((name) => problem.next_step.includes(`${name}=`)) ?? "";
});

/** Table of the study that the next step of a refusal names, such as "trials.sensor"; empty without one. */
export const tableOf = computed(() => {
  const path = /\[([\w.]+)\]/.exec(refused.value?.next_step ?? "")?.[1] ?? "";
  const tables = analysis.value?.tables ?? [];
  return tables.some((table) => isWithin(path, table)) ? path : "";
});

let timer = 0;
let next: Wanted | null = null;
let isBusy = false;

export function followReading(): void {
  let before = "";
  effect(() => {
    const [asked, chosen] = [wanted.value, analysis.value];
    const ready = chosen?.examines && missing.value.length === 0 && !(usesStudy.value && chosen.study === "optional" && isWrong.value);
    const key = ready ? JSON.stringify(asked) : "";
    if (key === before) return;
    before = key;
    clearTimeout(timer);
    isReading.value = ready === true;
    next = null;
    if (!ready || asked === null) {
      understood.value = refused.value = null;
      return;
    }
    timer = window.setTimeout(() => {
      next = asked;
      void readOn();
    }, PAUSE);
  });
}

async function readOn(): Promise<void> {
  if (isBusy) return;
  isBusy = true;
  try {
    while (next !== null) {
      const asked: Wanted = next;
      const given = await server.examine(asked);
      if (next !== asked) continue; // the answers have changed meanwhile
      next = null;
      refused.value = given.problem;
      understood.value = given.answer && { answer: given.answer, data: given.view === null ? null : Dataset.read(bytes(given.view)) };
      lostServer.value = "";
      isReading.value = false;
    }
  } catch (reason) {
    if (!(reason instanceof Refusal)) throw reason;
    next = null;
    lostServer.value = reason.message;
    isReading.value = false;
  } finally {
    isBusy = false;
  }
}

function bytes(coded: string): ArrayBuffer {
  return Uint8Array.from(atob(coded), (letter) => letter.charCodeAt(0)).buffer;
}
