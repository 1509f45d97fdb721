/** Keys of a view: what each does, and when it belongs to an element instead. */

import { signal } from "@preact/signals";
import type { Pace } from "./cycle";

export interface Key {
  keys: string; // as the list prints them
  effect: string;
  actions: Record<string, (event: KeyboardEvent) => void>; // by `KeyboardEvent.key`
}

interface KeyList {
  title: string;
  keys: Key[];
}

/** All keys of the page: each part adds its own. */
export const keyLists = signal<KeyList[]>([]);

/** Add the keys of a part to the list of the page until the returned function is called. */
export function addKeys(title: string, keys: Key[]): () => void {
  const added = { title, keys };
  keyLists.value = [...keyLists.peek(), added];
  return () => (keyLists.value = keyLists.peek().filter((each) => each !== added));
}

/** The key that starts and stops a motion. */
export const motionKey = ({ playing }: Pace): Key => ({
  keys: "space",
  effect: "move or stop",
  actions: { " ": () => (playing.value = !playing.value) },
});

const WRITTEN_IN = "input, textarea, select"; // use letters and arrows themselves
const PRESSED = "button, summary, a"; // use the space bar themselves

export function keyPressed(event: KeyboardEvent, keys: Key[]): void {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
  const target = event.target as HTMLElement;
  if (target.closest(WRITTEN_IN) !== null) return;
  if (event.key === " " && target.closest(PRESSED) !== null) return;
  const action = keys.map((key) => key.actions[event.key]).find((found) => found !== undefined);
  if (action === undefined) return;
  event.preventDefault();
  action(event);
}
