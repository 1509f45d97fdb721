/** The study that the page edits: its text is the truth, and the form shows its values. */

import { computed, signal, type Signal } from "@preact/signals";
import { Refusal, server, type Change, type Checked, type Edited, type PlateDrawing, type Problem, type Remark, type Step, type Tables, type Value } from "./server";

/** Where a study is saved: its file, and the text of the file as far as this page knows; null without a file. */
class Source {
  readonly file = signal<string | null>(null);
  readonly saved = signal<string | null>(null);
}

/** A text of the history with its study, and its values if they are known. */
interface Version {
  text: string;
  values: Tables | null;
  source: Source;
}

export const ENDING = ".toml"; // of a study's file
const PAUSE = 250; // ms after the last letter before the text is checked
const STEP = 800; // ms; letters within it are undone together
const MOST_STEPS = 100; // with values, some kilobytes each

export const text = signal("");
export const values = signal<Tables>({});
export const broken = signal(false); // the text is not TOML, so the values are those of an earlier text
export const plate = signal<PlateDrawing | null>(null); // null without a plate, and while it cannot be built
export const problems = signal<Problem[]>([]);
export const remarks = signal<Remark[]>([]);
const source = signal(new Source());
export const file = computed(() => source.value.file.value);
export const files = signal<string[]>([]);
export const loaded = signal(0); // number of studies that the page has shown, apart from designs of one study
export const notice = signal<Problem | string | null>(null); // why the last action was refused
const kept = signal<{ name: string; problem: Problem } | null>(null); // the file that was last not replaced
/** Name of the file that the shown notice is about, because it was not replaced; null for another notice. */
export const conflict = computed(() => (kept.value?.problem === notice.value ? (kept.value?.name ?? null) : null));
// table that another part of the page has opened in the form, and whether the form has moved to it
export const opened = signal<{ path: string; isReached: boolean } | null>(null);
export const opening = signal(""); // what is read to replace the text
const past = signal<Version[]>([]);
const future = signal<Version[]>([]);

export const unsaved = computed(() => text.value !== (source.value.saved.value ?? ""));
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

let number = 0; // of the newest check; answers to older ones are dropped
let examined = ""; // the text that values and problems belong to
let timer = 0;
let typed = -Infinity; // time of the last letter, ms since the page was loaded
// actions that replace the text, one after the other: a change belongs to the study in which it was made
let queue: Promise<void> = Promise.resolve();
let isOther = true; // the next state is that of another study

/** Take the state of a text. */
function take(state: Checked & { text: string }): void {
  number += 1;
  if (isOther) loaded.value += 1;
  isOther = false;
  examined = state.text;
  broken.value = state.values === null && text.peek().trim() !== "";
  if (!broken.value) values.value = state.values ?? {};
  plate.value = state.plate;
  problems.value = state.problems;
  remarks.value = state.remarks;
}

/** Run an action of the user; its refusal, if any, replaces that of the action before. */
export async function attempt(action: () => Promise<void>): Promise<void> {
  notice.value = null;
  await react(action);
}

/** Run an action that follows from news of the server; a refusal that the user has not read stays. */
export async function react(action: () => Promise<void>): Promise<void> {
  try {
    await action();
  } catch (reason) {
    if (!(reason instanceof Refusal)) throw reason;
    notice.value = reason.problem ?? reason.message;
  }
}

/** Run an action after those that were begun before it. */
const inTurn = (action: () => Promise<void>): Promise<void> => (queue = queue.then(() => attempt(action)));

/** Wait until every change is in the text. */
export const settled = (): Promise<void> => queue;

const current = (): Version => ({
  source: source.peek(),
  text: text.peek(),
  values: examined === text.peek() && !broken.peek() ? values.peek() : null,
});

/** Another text; `at` is the time when the user made the change, ms since the page was loaded. */
function replace(next: string, isTyped = false, own = source.peek(), at = performance.now()): void {
  if (next === text.peek() && own === source.peek()) return;
  const begins = past.peek().length === 0 && text.peek() === ""; // an empty page is nothing to go back to
  if (!begins && !(isTyped && at - typed < STEP)) past.value = [...past.peek(), current()].slice(-MOST_STEPS);
  typed = isTyped ? at : -Infinity;
  future.value = [];
  source.value = own;
  text.value = next;
}

/** Check the text after the user has changed it; refusals of later actions stay. */
function checkLater(pause = PAUSE): void {
  notice.value = null;
  clearTimeout(timer);
  timer = window.setTimeout(() => void react(checkNow), pause);
}

async function checkNow(): Promise<void> {
  const mine = (number += 1);
  const asked = text.peek();
  const state = await server.check(asked);
  if (mine === number) take({ ...state, text: asked });
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

/** Change one key; null removes it. Changes of a hand in motion, such as on a slider, are undone together. */
export const change = (steps: Step[], value: Value | null, isMoving = false) =>
  void changeAll(() => [{ steps, value }], isMoving);

/** Change several keys as one step of the history, determined when all earlier changes have been made. */
export function changeAll(wanted: () => Change[], isMoving = false): Promise<void> {
  const at = performance.now();
  return inTurn(async () => {
    const own = source.peek();
    for (;;) {
      if (examined !== text.peek()) await checkNow(); // after an undo, `values` are older than the text
      const [before, changes] = [text.peek(), wanted()];
      if (changes.length === 0) return;
      const state = await server.change(before, changes);
      if (source.peek() !== own) return; // undone beyond the opening of the study
      if (text.peek() !== before) continue; // letters were typed meanwhile
      replace(state.text, isMoving, own, at);
      clearTimeout(timer);
      take(state);
      return;
    }
  });
}

/** Take the newest text of one list, and put the current one into the other. */
function swap(from: Signal<Version[]>, to: Signal<Version[]>): void {
  const next = from.peek().at(-1);
  if (next === undefined) return;
  from.value = from.peek().slice(0, -1);
  to.value = [...to.peek(), current()];
  typed = -Infinity;
  text.value = next.text;
  if (next.source !== source.peek()) [source.value, isOther] = [next.source, true];
  if (next.values !== null) [values.value, examined] = [next.values, next.text]; // so that nothing waits for the check
  checkLater(0);
}

export const undo = () => swap(past, future);
export const redo = () => swap(future, past);

/** Another study in place of the text, as one step of the history. */
function begin(next: string, name: string | null): void {
  isOther = true;
  const saved = name === null ? null : next;
  if (next === text.peek() && name === file.peek()) {
    source.peek().saved.value = saved; // another program may have written the same text
    return;
  }
  const own = new Source();
  [own.file.value, own.saved.value] = [name, saved];
  replace(next, false, own);
}

/** Open a study if the user leaves a text that is not saved, once every change is in it. */
const open = (name: string, read: () => Promise<Edited & { name?: string }>) =>
  inTurn(async () => {
    if (unsaved.peek() && !confirm("The study has changes that are not saved. Leave them? Undo brings them back.")) return;
    opening.value = name;
    try {
      const state = await read();
      begin(state.text, state.name ?? null);
      take(state);
    } finally {
      opening.value = "";
    }
  });

export const openFile = (name: string) => open(name, () => server.open(name));
export const openTemplate = (name: string) => open(name, () => server.template(name));

/** Another study without a file, as one step of the history. */
export function openText(next: string): void {
  begin(next, null);
  checkLater(0);
}

/** Show the text of a result, as another study if that of the page has another file. */
export const showVersion = (version: string, name: string) => (name === (file.peek() ?? name) ? setText(version) : openText(version));

/** True if a file contains a text, as far as this page knows. */
export const isSaved = (version: string, name: string) => file.value === name && source.value.saved.value === version;

/** Open a computed design of a job, as one step of the history. */
export const openDesign = (job: number, point: number) =>
  inTurn(async () => {
    const state = await server.design(job, point);
    replace(state.text);
    take(state);
  });

/** Save the text; a file with another text is replaced only if the user has decided so. */
export const save = (name: string, replaces = false) =>
  inTurn(async () => {
    const [own, written] = [source.peek(), text.peek()];
    const known = name === own.file.peek() ? own.saved.peek() : null;
    const answer = await server.save(name, written, known, replaces).catch((reason: unknown) => {
      if (reason instanceof Refusal && reason.problem?.code === "repeated") kept.value = { name, problem: reason.problem };
      throw reason;
    });
    [own.file.value, own.saved.value] = [answer.name, written];
    files.value = answer.files;
  });

/** True for the path of a table, or of a key or table in it. */
export function isWithin(path: string, table: string): boolean {
  return path === table || path.startsWith(`${table}.`) || path.startsWith(`${table}[`);
}

/** Text of a path, with the tables of lists counted from 1, as errors name it. */
export function pathOf(steps: Step[]): string {
  return steps.reduce<string>(
    (path, step) => (typeof step === "number" ? `${path}[${step + 1}]` : path ? `${path}.${step}` : step),
    "",
  );
}
