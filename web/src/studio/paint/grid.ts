/** The map of a plate as rows of letters, the topmost first, and what the tools do to it. */

import type { Change, Tables, Value } from "../server";

export type Grid = string[][];
export type Place = [row: number, column: number];
export type Border = "left" | "right" | "above" | "below";

export const ABSENT = "."; // letter of an absent tile, as in `haptonic.study.plate_map`
const MOST_TILES = 100_000; // the check refuses more
const MAP = ["plate", "map"];
const ROWS = ["plate", "rows"];

/** The whole map of a table [plate]; null if its lines have different lengths or there are none. */
export function gridOf(plate: Tables): Grid | null {
  const { map, rows } = plate;
  if (typeof map !== "string") return null;
  const lines = map.trim().split(/\r?\n/).map((line) => Array.from(line.trim()));
  const width = lines[0]?.length ?? 0;
  if (width === 0 || lines.some((line) => line.length !== width)) return null;
  if (typeof rows !== "number" || rows % lines.length !== 0 || rows <= 0 || rows * width > MOST_TILES) return lines;
  return Array.from({ length: rows }, (_, row) => lines[row % lines.length] ?? []);
}

/** The changes of the text that give this map; lines that repeat stay one line where the study counts rows. */
export function changesTo(grid: Grid, plate: Tables): Change[] {
  const counted = plate["rows"] !== undefined;
  const lines = grid.map((row) => row.join(""));
  const period = counted ? periodOf(lines) : lines.length;
  const written = `${lines.slice(0, period).join("\n")}\n`;
  const rows: Value | null = period < lines.length ? lines.length : null;
  return [
    ...(written.trim() === String(plate["map"]).trim() ? [] : [{ steps: MAP, value: written }]),
    ...(counted && plate["rows"] !== rows ? [{ steps: ROWS, value: rows }] : []),
  ];
}

function periodOf(lines: string[]): number {
  for (let period = 1; period <= lines.length / 2; period++)
    if (lines.length % period === 0 && lines.every((line, k) => line === lines[k % period])) return period;
  return lines.length;
}

/** The map with one letter at some places; places outside of it are left out. */
export function painted(grid: Grid, places: Place[], letter: string): Grid {
  const rows = new Map<number, string[]>();
  for (const [row, column] of places) {
    const line = rows.get(row) ?? grid[row]?.slice();
    if (line === undefined || column < 0 || column >= line.length) continue;
    line[column] = letter;
    rows.set(row, line);
  }
  return grid.map((line, row) => rows.get(row) ?? line);
}

/** Places on the straight line between two. */
export function lineBetween([i, j]: Place, [k, l]: Place): Place[] {
  const count = Math.max(Math.abs(k - i), Math.abs(l - j));
  return Array.from({ length: count + 1 }, (_, step): Place => {
    const share = count === 0 ? 0 : step / count;
    return [Math.round(i + share * (k - i)), Math.round(j + share * (l - j))];
  });
}

export function rectangleBetween([i, j]: Place, [k, l]: Place): Place[] {
  const places: Place[] = [];
  for (let row = Math.min(i, k); row <= Math.max(i, k); row++)
    for (let column = Math.min(j, l); column <= Math.max(j, l); column++) places.push([row, column]);
  return places;
}

/** Places of one letter that are connected with a place by their sides. */
export function areaAround(grid: Grid, start: Place): Place[] {
  const letter = grid[start[0]]?.[start[1]];
  const seen = grid.map((line) => line.map(() => false));
  const places: Place[] = [];
  for (const front: Place[] = [start]; ; ) {
    const next = front.pop();
    if (next === undefined) return places;
    const [row, column] = next;
    const line = seen[row];
    if (line === undefined || line[column] !== false || grid[row]?.[column] !== letter) continue;
    line[column] = true;
    places.push(next);
    front.push([row - 1, column], [row + 1, column], [row, column - 1], [row, column + 1]);
  }
}

/** The places with their images in the middle lines of the map. */
export function mirrored(grid: Grid, places: Place[], across: boolean, up: boolean): Place[] {
  const [last, end] = [grid.length - 1, (grid[0]?.length ?? 0) - 1];
  const sideways = across ? [...places, ...places.map(([row, column]): Place => [row, end - column])] : places;
  return up ? [...sideways, ...sideways.map(([row, column]): Place => [last - row, column])] : sideways;
}

/** The map with a copy of a border line beside it, or without the line; one line always remains. */
export function resized(grid: Grid, border: Border, larger: boolean): Grid {
  if (border === "above" || border === "below") {
    const first = border === "above";
    if (!larger) return grid.length === 1 ? grid : first ? grid.slice(1) : grid.slice(0, -1);
    const line = (first ? grid[0] : grid.at(-1)) ?? [];
    return first ? [line, ...grid] : [...grid, line];
  }
  return grid.map((line) => {
    const first = border === "left";
    if (!larger) return line.length === 1 ? line : first ? line.slice(1) : line.slice(0, -1);
    const letter = (first ? line[0] : line.at(-1)) ?? ABSENT;
    return first ? [letter, ...line] : [...line, letter];
  });
}

/** Positions of lines between letters: the known ones if their number fits, else continued evenly, m. */
export function linesFor(count: number, lines: number[]): number[] {
  const step = lines.length > 1 ? (lines.at(-1) ?? 1) / (lines.length - 1) : 1;
  return lines.length === count + 1 ? lines : Array.from({ length: count + 1 }, (_, k) => k * step);
}
