/** What pointer and keys do on the drawing of the plate. */

import type { Key } from "../../parts/keys";
import { corners, type Point } from "../../parts/plan";
import { changeAll, pathOf, values } from "../study";
import type { Part } from "../server";
import { clampHandles, HANDLE, placeAt, pointAt, type Scene } from "./canvas";
import { areaAround, lineBetween, rectangleBetween, type Place } from "./grid";
import { lengthText, snapped, stepFor, type Placement } from "./place";
import {
  anchor, chosen, clamp, clamped, CLAMP, commit, cursor, drawing, grid, move, paint, parts, selected, settle, stroke, tiles,
  tool, type Tool,
} from "./state";

const NEAR = 6; // CSS pixels from which a part is drawn to a line
const TOOLS: Record<string, Tool> = { b: "brush", l: "line", r: "rectangle", f: "fill", v: "move" };
const FAR = 10; // steps with Shift

type Drag = (point: Point) => void;

/** Places between the ends of a stroke, for the chosen tool. */
function placesOf(start: Place, end: Place): Place[] {
  return tool.peek() === "rectangle" ? rectangleBetween(start, end) : lineBetween(start, end);
}

function stepOf({ x }: Scene): number {
  return stepFor((x.at(-1) ?? 1) / Math.max(x.length - 1, 1));
}

/** Follow the pointer on a canvas; returns what ends it. */
export function followPointer(canvas: HTMLCanvasElement, scene: () => Scene): () => void {
  let drag: Drag | null = null;
  let settled: () => void = () => undefined;
  const pointOf = (event: PointerEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return pointAt(scene(), [event.clientX - box.left, event.clientY - box.top]);
  };
  const down = (event: PointerEvent) => {
    if (event.button !== 0) return;
    const point = pointOf(event);
    if (tool.peek() === "move") [drag, settled] = picked(scene(), point);
    else [drag, settled] = begun(scene(), point);
    if (drag !== null) canvas.setPointerCapture(event.pointerId);
  };
  const along = (event: PointerEvent) => drag?.(pointOf(event));
  const over = () => {
    if (drag !== null) settled();
    drag = null;
  };
  const lost = () => {
    drag = null;
    stroke.value = [];
  };
  const listeners = { pointerdown: down, pointermove: along, pointerup: over, pointercancel: lost };
  for (const [name, listener] of Object.entries(listeners)) canvas.addEventListener(name, listener as EventListener);
  return () => {
    for (const [name, listener] of Object.entries(listeners))
      canvas.removeEventListener(name, listener as EventListener);
  };
}

const NOTHING: [Drag | null, () => void] = [null, () => undefined];

/** Begin a stroke. */
function begun(scene: Scene, point: Point): [Drag | null, () => void] {
  const [start, map] = [placeAt(scene, point), grid.peek()];
  if (start === null || map === null) return NOTHING;
  cursor.value = start;
  anchor.value = null;
  if (tool.peek() === "fill") {
    paint(areaAround(map, start));
    return NOTHING;
  }
  let last = start;
  stroke.value = [start];
  const drag = (next: Point) => {
    const end = placeAt(scene, next);
    if (end === null || (end[0] === last[0] && end[1] === last[1])) return;
    stroke.value = tool.peek() === "brush" ? [...stroke.peek(), ...lineBetween(last, end)] : placesOf(start, end);
    cursor.value = last = end;
  };
  return [drag, () => commit(grid.peek())];
}

/** Pick a handle, a part or the clamped corners at a point. */
function picked(scene: Scene, point: Point): [Drag | null, () => void] {
  const near = (2 * HANDLE) / scene.scale;
  const isAt = ([x, y]: Point) => Math.hypot(point[0] - x, point[1] - y) < near;
  const every = parts.peek();
  const current = every.find((part) => pathOf(part.steps) === selected.peek());
  if (current !== undefined && current.size.length > 0) {
    const [wide = 0, high = 0] = current.size;
    const around = corners(current.centre, [wide, high]);
    const number = around.findIndex(isAt);
    const fixed = around[(number + 2) % 4];
    if (number >= 0 && fixed !== undefined)
      return [(next) => move(current, stretched(current, fixed, next, scene)), () => settle(current)];
  }
  const length = clamped.peek();
  if (length !== null && clampHandles(scene, length).some(isAt)) {
    selected.value = CLAMP;
    return [(next) => setClamp(reachOf(next, scene), scene), settleClamp];
  }
  const part = [...every].reverse().find(({ centre, size, diameter }) => {
    const [wide = 0, high = 0] = diameter === null ? size : [diameter, diameter];
    const [across, up] = [Math.abs(point[0] - centre[0]), Math.abs(point[1] - centre[1])];
    return across < Math.max(wide / 2, near) && up < Math.max(high / 2, near);
  });
  selected.value = part === undefined ? "" : pathOf(part.steps);
  if (part === undefined) return NOTHING;
  const [left, low] = [point[0] - part.centre[0], point[1] - part.centre[1]];
  const drag = ([x, y]: Point) => move(part, placedAt(part, [x - left, y - low], scene));
  return [drag, () => settle(part)];
}

function placedAt(part: Part, [x, y]: Point, scene: Scene): Placement {
  const [wide = 0, high = 0] = part.diameter === null ? part.size : [part.diameter, part.diameter];
  const [step, near] = [stepOf(scene), NEAR / scene.scale];
  const centre: Point = [snapped(x, wide / 2, scene.x, step, near), snapped(y, high / 2, scene.y, step, near)];
  return { ...part, centre };
}

/** The part with one corner fixed and the opposite one at a point. */
function stretched(part: Part, [left, low]: Point, [x, y]: Point, scene: Scene): Placement {
  const [step, near] = [stepOf(scene), NEAR / scene.scale];
  const [right, top] = [snapped(x, 0, scene.x, step, near), snapped(y, 0, scene.y, step, near)];
  const size = [Math.max(Math.abs(right - left), step), Math.max(Math.abs(top - low), step)];
  return { ...part, centre: [(left + right) / 2, (low + top) / 2], size: [...size, ...part.size.slice(2)] };
}

/** Distance of a point from the nearest corner along the side that it is nearest to. */
function reachOf([x, y]: Point, scene: Scene): number {
  const [right, top] = [scene.x.at(-1) ?? 0, scene.y.at(-1) ?? 0];
  const [across, up] = [Math.min(x, right - x), Math.min(y, top - y)];
  return Math.max(across, up);
}

function setClamp(length: number, scene: Scene): void {
  const step = stepOf(scene);
  clamp.value = Math.max(Math.round(length / step) * step, step);
}

function settleClamp(): void {
  const length = clamp.peek();
  if (length === null) return;
  const steps = ["plate", "clamp", "corners"];
  void changeAll(() => {
    const table = values.peek()["plate"] as Record<string, Record<string, string>>;
    return [{ steps, value: lengthText(length, table["clamp"]?.["corners"]) }];
  });
}

/** Move, or with `larger` stretch, what is selected by some steps. */
function nudge(scene: Scene, [right, above]: Point, larger: boolean): void {
  const step = stepOf(scene);
  if (selected.peek() === CLAMP) {
    setClamp((clamped.peek() ?? step) + (right + above) * step, scene);
    settleClamp();
    return;
  }
  const part = parts.peek().find(({ steps }) => pathOf(steps) === selected.peek());
  if (part === undefined) return;
  const [x, y] = part.centre;
  const [wide = 0, high = 0, ...further] = part.size;
  if (larger && part.size.length === 0) return;
  move(part, larger
    ? { ...part, size: [Math.max(wide + right * step, step), Math.max(high + above * step, step), ...further] }
    : { ...part, centre: [x + right * step, y + above * step] });
  settle(part);
}

function walk(right: number, above: number): void {
  const map = grid.peek();
  if (map === null) return;
  const [row, column] = cursor.peek();
  const within = (value: number, count: number) => Math.min(Math.max(value, 0), count - 1);
  cursor.value = [within(row - above, map.length), within(column + right, map[0]?.length ?? 1)];
}

/** Paint at the cursor; lines and rectangles need their first end before. */
function press(): void {
  const [map, place, start] = [grid.peek(), cursor.peek(), anchor.peek()];
  if (map === null || tool.peek() === "move") return;
  if (tool.peek() === "fill") paint(areaAround(map, place));
  else if (tool.peek() === "brush") paint([place]);
  else if (start === null) anchor.value = place;
  else {
    anchor.value = null;
    paint(placesOf(start, place));
  }
}

/** Select the next part, the clamped corners last. */
function selectNext(by: number): void {
  const paths = [...parts.peek().map(({ steps }) => pathOf(steps)), ...(drawing.peek()?.clamp ? [CLAMP] : [])];
  const count = paths.length;
  const next = paths.indexOf(selected.peek()) + by;
  selected.value = paths[((next % count) + count) % count] ?? "";
  tool.value = "move";
}

export function paintKeys(scene: () => Scene): Key[] {
  const arrow = (right: number, above: number) => (event: KeyboardEvent) => {
    const far = event.shiftKey ? FAR : 1;
    if (tool.peek() !== "move") walk(right * far, above * far);
    else nudge(scene(), [right * far, above * far], false);
  };
  const pick = (number: number) => () => {
    const tile = tiles.peek()[number];
    if (tile !== undefined) chosen.value = tile.letter;
  };
  const stretch = (right: number, above: number) => () => {
    if (tool.peek() === "move") nudge(scene(), [right, above], true);
  };
  return [
    {
      keys: "← → ↑ ↓",
      effect: "move the cursor, or the selected part; ten steps with Shift",
      actions: {
        ArrowLeft: arrow(-1, 0), ArrowRight: arrow(1, 0), ArrowUp: arrow(0, 1), ArrowDown: arrow(0, -1),
      },
    },
    { keys: "space", effect: "paint; of a line or rectangle first one end, then the other", actions: { " ": press } },
    {
      keys: "1 … 9",
      effect: "choose a tile, in the order of the palette",
      actions: Object.fromEntries(Array.from({ length: 9 }, (_, k) => [String(k + 1), pick(k)])),
    },
    {
      keys: Object.keys(TOOLS).join(" "),
      effect: Object.values(TOOLS).join(", "),
      actions: Object.fromEntries(Object.entries(TOOLS).map(([key, name]) => [key, () => (tool.value = name)])),
    },
    { keys: "n p", effect: "select the next or the previous part", actions: { n: () => selectNext(1), p: () => selectNext(-1) } },
    {
      keys: "+ − > <",
      effect: "make the selected patch wider, narrower, higher or lower",
      actions: { "+": stretch(1, 0), "-": stretch(-1, 0), ">": stretch(0, 1), "<": stretch(0, -1) },
    },
    { keys: "Esc", effect: "forget the first end", actions: { Escape: () => (anchor.value = null) } },
  ];
}
