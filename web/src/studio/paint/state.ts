/** What is painted and moved on the plate, before and after it is in the text of the study. */

import { computed, effect, signal } from "@preact/signals";
import { changeAll, loaded, pathOf, plate, values } from "../study";
import type { Change, Part, PlateDrawing, Tables, Value } from "../server";
import { ABSENT, changesTo, gridOf, mirrored, painted, type Grid, type Place } from "./grid";
import { changesOf, type Placement } from "./place";

export type Tool = "brush" | "line" | "rectangle" | "fill" | "move";
export interface Tile {
  letter: string;
  name: string;
  isNew: boolean; // not in the text until it is painted
}

export const CLAMP = "plate.clamp.corners"; // path, also the name of the clamp among the parts

export const tool = signal<Tool>("brush");
export const chosen = signal(""); // letter of the tile to paint
export const across = signal(false); // mirror left and right
export const up = signal(false); // mirror top and bottom
export const cursor = signal<Place>([0, 0]);
export const anchor = signal<Place | null>(null); // first end of a line or rectangle
export const stroke = signal<Place[]>([]); // places below the moving pointer
export const selected = signal(""); // path of a part, or that of the clamp
export const moved = signal<Record<string, Placement>>({}); // parts that are not yet in the drawing, by path
export const clamp = signal<number | null>(null); // length that is not yet in the drawing, m
const draft = signal<Grid | null>(null); // map that is not yet in the text
const added = signal<{ letter: string; name: string }[]>([]);

effect(() => {
  void loaded.value; // tiles that were added belong to the study before
  added.value = [];
});

export const table = computed<Tables | null>(() => {
  const entry = values.value["plate"];
  return typeof entry === "object" && !Array.isArray(entry) ? entry : null;
});

/** The last plate that could be built. */
export const drawing = signal<PlateDrawing | null>(null);

effect(() => {
  if (plate.value !== null || table.value === null) drawing.value = plate.value;
});

const entries = (value: Value | undefined): [string, Value][] =>
  typeof value === "object" && !Array.isArray(value) ? Object.entries(value) : [];

/** Tiles that can be painted: those of the study, new ones, and the absent tile. */
export const tiles = computed<Tile[]>(() => {
  const given = entries(table.value?.["tiles"]).map(([letter, name]) => ({ letter, name: String(name), isNew: false }));
  const taken = new Set(given.map(({ letter }) => letter));
  const fresh = added.value.filter(({ letter }) => !taken.has(letter)).map((tile) => ({ ...tile, isNew: true }));
  return [...given, ...fresh, { letter: ABSENT, name: "no plate", isNew: false }];
});

export const inText = computed<Grid | null>(() => (table.value === null ? null : gridOf(table.value)));

/** The map as it is drawn, with the stroke that is being painted. */
export const grid = computed<Grid | null>(() => {
  const base = draft.value ?? inText.value;
  if (base === null || stroke.value.length === 0) return base;
  return painted(base, mirrored(base, stroke.value, across.value, up.value), letterOf());
});

/** Parts of the drawing that the text still has, each where it was moved last. */
export const parts = computed<(Part & Placement)[]>(() =>
  (drawing.value?.parts ?? []).map((part) => ({ ...part, ...moved.value[pathOf(part.steps)] })),
);

export const clamped = computed<number | null>(() => clamp.value ?? drawing.value?.clamp ?? null);
export const isPending = computed(() => draft.value !== null);

/** The chosen tile, or else the first. */
export const letterOf = (): string =>
  tiles.value.some(({ letter }) => letter === chosen.value) ? chosen.value : (tiles.value[0]?.letter ?? ABSENT);

effect(() => {
  drawing.value; // a new drawing has everything where the text has it
  moved.value = {};
  clamp.value = null;
});

let strokes = 0;

/** Put a map into the text, as one step of the history. */
export function commit(next: Grid | null): void {
  stroke.value = [];
  if (next === null) return;
  const mine = (strokes += 1);
  draft.value = next;
  const used = new Set(next.flat());
  void changeAll(() => [
    ...added.peek().filter(({ letter }) => used.has(letter) && !hasTile(letter))
      .map(({ letter, name }): Change => ({ steps: ["plate", "tiles", letter], value: name })),
    ...changesTo(next, table.peek() ?? {}),
  ]).then(() => {
    if (mine === strokes) draft.value = null;
  });
}

const hasTile = (letter: string): boolean => entries(table.peek()?.["tiles"]).some(([given]) => given === letter);

/** Paint places with the chosen tile and put the map into the text. */
export function paint(places: Place[]): void {
  stroke.value = places;
  commit(grid.peek());
}

const LETTERS = "123456789abcdefghijklmnpqrstuvwxyzABCDEFGHIJKLMNPQRSTUVWXYZ";

/** Add a tile to the palette; it joins the text with the first stroke. */
export function addTile(name: string): void {
  const taken = new Set(tiles.peek().map(({ letter }) => letter));
  const letter = Array.from(LETTERS).find((each) => !taken.has(each));
  if (letter === undefined) return;
  added.value = [...added.peek(), { letter, name }];
  chosen.value = letter;
}

/** Show a part elsewhere; `settle` puts it into the text. */
export function move(part: Part, placement: Placement): void {
  moved.value = { ...moved.peek(), [pathOf(part.steps)]: placement };
}

export function settle(part: Part): void {
  const placement = moved.peek()[pathOf(part.steps)];
  if (placement !== undefined) void changeAll(() => changesOf(part, placement, values.peek()));
}
