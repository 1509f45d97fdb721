/** The study that the page edits: its text is the truth, and the form shows its values. */

import { computed, signal, type Signal } from "@preact/signals";
import { Refusal, server, type Checked, type Problem, type Remark, type Step, type Tables, type Value } from "./server";

const PAUSE = 250; // ms after the last letter before the text is checked
const STEP = 800; // ms; letters within it are undone together
const MOST_STEPS = 300;

export const text = signal("");
export const values = signal<Tables>({});
export const broken = signal(false); // the text is not TOML, so the values are those of an earlier text
export const problems = signal<Problem[]>([]);
export const remarks = signal<Remark[]>([]);
export const file = signal<string | null>(null);
export const files = signal<string[]>([]);
export const notice = signal<Problem | string | null>(null); // why the last action was refused
const saved = signal<string | null>(null); // text of the file, as far as this page knows
const past = signal<string[]>([]);
const future = signal<string[]>([]);

export const unsaved = computed(() => text.value !== (saved.value ?? ""));
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

let number = 0; // of the newest check; answers to older ones are dropped
let timer = 0;
let typed = -Infinity; // time of the last letter, ms since the page was loaded
let queue: Promise<void> = Promise.resolve();

function take(state: Checked): void {
  number += 1;
  broken.value = state.values === null && text.peek().trim() !== "";
  if (!broken.value) values.value = state.values ?? {};
  problems.value = state.problems;
  remarks.value = state.remarks;
}

/** Run an action; its refusal is shown. */
export async function attempt(action: () => Promise<void>): Promise<void> {
  notice.value = null;
  try {
    await action();
  } catch (reason) {
    if (!(reason instanceof Refusal)) throw reason;
    notice.value = reason.problem ?? reason.message;
  }
}

function replace(next: string, isTyped = false): void {
  if (next === text.peek()) return;
  const now = performance.now();
  const begins = past.peek().length === 0 && text.peek() === ""; // an empty page is nothing to go back to
  if (!begins && !(isTyped && now - typed < STEP)) past.value = [...past.peek(), text.peek()].slice(-MOST_STEPS);
  typed = isTyped ? now : -Infinity;
  future.value = [];
  text.value = next;
}

function checkLater(pause = PAUSE): void {
  clearTimeout(timer);
  timer = window.setTimeout(() => void attempt(checkNow), pause);
}

async function checkNow(): Promise<void> {
  const mine = (number += 1);
  const state = await server.check(text.peek());
  if (mine === number) take(state);
}

/** The text was edited by hand. */
export function edit(next: string): void {
  replace(next, true);
  checkLater();
}

/** Another text, as one step of the history. */
export function setText(next: string): void {
  replace(next);
  checkLater(0);
}

/** Change one key; null removes it. Changes are made one after another. */
export function change(steps: Step[], value: Value | null): void {
  queue = queue.then(() =>
    attempt(async () => {
      for (;;) {
        const before = text.peek();
        const state = await server.change(before, steps, value);
        if (text.peek() !== before) continue; // letters were typed meanwhile
        replace(state.text);
        clearTimeout(timer);
        take(state);
        return;
      }
    }),
  );
}

/** Take the newest text of one list, and put the current one into the other. */
function swap(from: Signal<string[]>, to: Signal<string[]>): void {
  const next = from.peek().at(-1);
  if (next === undefined) return;
  from.value = from.peek().slice(0, -1);
  to.value = [...to.peek(), text.peek()];
  typed = -Infinity;
  text.value = next;
  checkLater(0);
}

export const undo = () => swap(past, future);
export const redo = () => swap(future, past);

export const openFile = (name: string) =>
  attempt(async () => {
    const state = await server.open(name);
    replace(state.text);
    file.value = state.name;
    saved.value = state.text;
    take(state);
  });

export const openTemplate = (name: string) =>
  attempt(async () => {
    const state = await server.template(name);
    replace(state.text);
    file.value = null;
    saved.value = null;
    take(state);
  });

export const save = (name: string) =>
  attempt(async () => {
    const written = text.peek();
    const answer = await server.save(name, written, name === file.peek() ? saved.peek() : null);
    file.value = answer.name;
    saved.value = written;
    files.value = answer.files;
  });

/** Text of a path, with the tables of lists counted from 1, as errors name it. */
export function pathOf(steps: Step[]): string {
  return steps.reduce<string>(
    (path, step) => (typeof step === "number" ? `${path}[${step + 1}]` : path ? `${path}.${step}` : step),
    "",
  );
}
