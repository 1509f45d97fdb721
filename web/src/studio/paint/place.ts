/** Positions and sizes of what lies on a plate: snapping, and the texts of their keys. */

import type { Point } from "../../parts/plan";
import type { Change, Part, Step, Tables, Value } from "../server";

const UNITS: Record<string, number> = { m: 1, cm: 1e-2, mm: 1e-3, um: 1e-6, "µm": 1e-6, nm: 1e-9 };
const USUAL = "mm";
const STEPS_IN_TILE = 50; // a step of movement is the largest 1, 2 or 5 below this part of a tile

/** Where a part lies, and its size. */
export interface Placement {
  steps: Step[];
  centre: Point;
  corner: Point;
  size: number[];
}

/** The step of movements for tiles of a width: 1, 2 or 5 times a power of ten. */
export function stepFor(tile: number): number {
  const wanted = tile / STEPS_IN_TILE;
  const power = 10 ** Math.floor(Math.log10(wanted) + 1e-9);
  return ([5, 2].find((digit) => digit * power <= wanted * (1 + 1e-9)) ?? 1) * power;
}

/** A multiple of the step, unless the middle or an end lies near a line or halfway between two. */
export function snapped(value: number, half: number, lines: number[], step: number, near: number): number {
  let best = Math.round(value / step) * step;
  let least = near;
  const targets = lines.flatMap((line, k) => [line, (line + (lines[k + 1] ?? line)) / 2]);
  for (const end of half > 0 ? [0, -half, half] : [0])
    for (const target of targets) {
      const away = Math.abs(value + end - target);
      if (away < least) [best, least] = [target - end, away];
    }
  return best;
}

/** A length in the unit of an earlier text. */
export function lengthText(length: number, before: Value | undefined): string {
  const unit = /^\s*[-+.\deE]+\s*([a-zµ]+)\s*$/.exec(String(before ?? ""))?.[1] ?? USUAL;
  const [name, factor] = unit in UNITS ? [unit, UNITS[unit] ?? 1e-3] : [USUAL, 1e-3];
  return `${Number((length / factor).toPrecision(9))} ${name}`;
}

function tableAt(tables: Tables, steps: Step[]): Tables {
  let value: Value | undefined = tables;
  for (const step of steps)
    value = Array.isArray(value) ? value[Number(step)] : (value as Tables | undefined)?.[String(step)];
  return (value ?? {}) as Tables;
}

const listed = (value: Value | undefined): Value[] => (Array.isArray(value) ? value : []);

/** Changes of the text that put a part elsewhere, and give it another size. */
export function changesOf(before: Part, after: Placement, tables: Tables): Change[] {
  const table = tableAt(tables, before.steps);
  const [centre, size] = [listed(table["centre"]), listed(table["size"])];
  const moved = after.centre.map((value, axis) => lengthText(value - before.corner[axis as 0 | 1], centre[axis]));
  const larger = after.size.map((value, axis) => (axis < 2 ? lengthText(value, size[axis]) : (size[axis] ?? "")));
  const differs = (texts: Value[], others: Value[]) => texts.some((text, k) => text !== others[k]);
  return [
    ...(differs(moved, centre) ? [{ steps: [...before.steps, "centre"], value: moved }] : []),
    ...(after.size.length > 0 && differs(larger, size) ? [{ steps: [...before.steps, "size"], value: larger }] : []),
  ];
}
