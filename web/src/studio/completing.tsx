/** The list of completions at the cursor: Ctrl+Space, arrows, Enter, Escape. */

import { computed, signal } from "@preact/signals";
import { completionsAt } from "./completion";
import type { Key } from "./server";
import { edit, text } from "./study";

const LIST = "completions";
const TALL = 14; // rems that the list needs below the line

const cursor = signal<number | null>(null); // null while the list is closed
const active = signal(0);
const keys = signal<Key[]>([]);
const parameters = signal("");
const offered = computed(() =>
  cursor.value === null ? { from: 0, list: [] } : completionsAt(text.value, cursor.value, keys.value, parameters.value),
);

/** Offer the declared keys, and in expressions the names of a table. */
export function completeWith(declared: Key[], table: string): void {
  [keys.value, parameters.value] = [declared, table];
}

export const closeCompletions = () => (cursor.value = null);

/** Follow the cursor while the list is open. */
export function moveCompletions(area: HTMLTextAreaElement): void {
  if (cursor.peek() === null) return;
  cursor.value = area.selectionStart;
  active.value = 0;
}

/** Handle a key of the text; true if it belongs to the list. */
export function completionKey(event: KeyboardEvent, area: HTMLTextAreaElement): boolean {
  const { list } = offered.peek();
  if (event.key === " " && event.ctrlKey) {
    [cursor.value, active.value] = [area.selectionStart, 0];
  } else if (cursor.peek() === null || list.length === 0) {
    return false;
  } else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
    active.value = (active.peek() + (event.key === "ArrowDown" ? 1 : list.length - 1)) % list.length;
  } else if (event.key === "Enter" || event.key === "Tab") {
    accept(area, active.peek());
  } else if (event.key === "Escape") {
    closeCompletions();
  } else {
    return false;
  }
  event.preventDefault();
  return true;
}

function accept(area: HTMLTextAreaElement, place: number): void {
  const { from, list } = offered.peek();
  const chosen = list[place];
  if (chosen === undefined || cursor.peek() === null) return;
  area.setRangeText(chosen.insert, from, cursor.peek()!, "end");
  closeCompletions();
  edit(area.value);
  area.focus();
}

/** Attributes of the text, for screen readers. */
export function completionAttributes() {
  const open = offered.value.list.length > 0;
  return { "aria-autocomplete": "list" as const, ...(open ? { "aria-controls": LIST, "aria-activedescendant": `${LIST}-${active.value}` } : {}) };
}

export function Completions({ area }: { area: { current: HTMLTextAreaElement | null } }) {
  const { from, list } = offered.value;
  const place = area.current;
  if (cursor.value === null || place === null) return null;
  const lines = text.value.slice(0, from).split("\n");
  const line = place.scrollHeight / text.value.split("\n").length;
  const below = place.offsetTop + lines.length * line - place.scrollTop + 6;
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const fits = place.getBoundingClientRect().top - place.offsetTop + below + TALL * rem < innerHeight;
  const vertical = fits ? { top: `${below}px` } : { top: `${below - line - 6}px`, transform: "translateY(-100%)" };
  const left = `min(calc(${place.offsetLeft}px + ${(lines.at(-1) ?? "").length}ch), max(0px, 100% - 22rem))`;
  return (
    <ul id={LIST} role="listbox" tabIndex={0} aria-label="Completions" class="completions" style={{ ...vertical, left }}>
      {list.length === 0 && (
        <li role="option" aria-selected="false" class="quiet">
          Nothing fits here.
        </li>
      )}
      {list.map(({ label, detail }, number) => (
        <li
          id={`${LIST}-${number}`}
          role="option"
          aria-selected={number === active.value}
          ref={(item) => {
            if (number === active.value) item?.scrollIntoView({ block: "nearest" });
          }}
          onMouseDown={(event) => {
            event.preventDefault(); // the text keeps the focus
            accept(place, number);
          }}
        >
          <code>{label}</code> <span class="quiet">{detail}</span>
        </li>
      ))}
    </ul>
  );
}
