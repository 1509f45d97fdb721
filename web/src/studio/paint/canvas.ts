/** The drawing of a plate that is painted: tiles, pillars, supports, parts and the cursor. */

import { themeColour } from "../../parts/colours";
import {
  corners, drawHeld, nameRegion, strokeLoop, trace, traceFeatures, writeName, type Placed, type Point,
} from "../../parts/plan";
import { pathOf } from "../study";
import type { PlateDrawing } from "../server";
import { ABSENT, linesFor, type Grid, type Place } from "./grid";
import { anchor, clamped, cursor, drawing, grid, inText, parts, selected, CLAMP, tiles, tool } from "./state";

export const MARGIN = 12; // CSS pixels around the map, for handles on its border
export const HANDLE = 5; // half of a handle, CSS pixels
const GRID_FROM = 5; // CSS pixels of a tile from which lines between tiles are drawn
const COLOURS = 4; // --curve-0 to --curve-3 of the theme
const TALLEST = 0.6; // of the window

const look = () => ({ ink: themeColour("ink"), rim: themeColour("paper") });

/** Where the map lies on the canvas. */
export interface Scene {
  x: number[]; // lines, m
  y: number[];
  scale: number; // CSS pixels per metre
}

export function sceneOf(map: Grid, width: number): Scene {
  const plan = drawing.peek();
  const x = linesFor(map[0]?.length ?? 1, plan?.x ?? []);
  const y = linesFor(map.length, plan?.y ?? []);
  const [wide, high] = [x.at(-1) ?? 1, y.at(-1) ?? 1];
  const room = Math.max(width - 2 * MARGIN, 50);
  return { x, y, scale: Math.min(room / wide, (TALLEST * innerHeight) / high) };
}

export const sizeOf = ({ x, y, scale }: Scene): Point => [
  (x.at(-1) ?? 0) * scale + 2 * MARGIN,
  (y.at(-1) ?? 0) * scale + 2 * MARGIN,
];

/** From CSS pixels of the canvas to metres. */
export const pointAt = ({ y, scale }: Scene, [left, top]: Point): Point => [
  (left - MARGIN) / scale,
  (y.at(-1) ?? 0) - (top - MARGIN) / scale,
];

/** The tile at a point; null beyond the map. */
export function placeAt({ x, y }: Scene, [across, height]: Point): Place | null {
  const column = x.findIndex((line) => line > across) - 1;
  const row = y.findIndex((line) => line > height) - 1;
  return column < 0 || row < 0 ? null : [y.length - 2 - row, column];
}

/** Colour of a tile: the first lattice is grey, the others have the colours of curves. */
export function colourOf(letter: string): string {
  const lattices = drawing.value?.lattices ?? [];
  const coloured = tiles.value.filter(({ letter: each, name }) => each !== ABSENT && name !== lattices[0]);
  const number = coloured.findIndex((tile) => tile.letter === letter);
  return number < 0 ? "rule" : `curve-${number % COLOURS}`;
}

/** Handles of the clamped corners: the end of the supported part of each side. */
export function clampHandles({ x, y }: Scene, length: number): Point[] {
  const [right, top] = [x.at(-1) ?? 0, y.at(-1) ?? 0];
  const ends = (most: number) => [length, most - length];
  return [0, top].flatMap((height) => ends(right).map((at): Point => [at, height]))
    .concat([0, right].flatMap((side) => ends(top).map((at): Point => [side, at])));
}

export function drawPlate(canvas: HTMLCanvasElement, scene: Scene, isFocused: boolean): void {
  const [context, map, plan] = [canvas.getContext("2d"), grid.peek(), drawing.peek()];
  if (context === null || map === null) return;
  const ratio = devicePixelRatio;
  const height = scene.y.at(-1) ?? 0;
  const placed: Placed = ([x, y]) => [ratio * (MARGIN + x * scene.scale), ratio * (MARGIN + (height - y) * scene.scale)];
  context.clearRect(0, 0, canvas.width, canvas.height);
  drawTiles(context, map, scene, placed);
  if (plan !== null) drawFeatures(context, plan, map, scene, placed);
  drawParts(context, scene, placed);
  const outlined: [Place | null, string, number[]][] = [
    [isFocused && tool.peek() !== "move" ? cursor.peek() : null, "accent", []],
    [anchor.peek(), "carrier", [3, 3]],
  ];
  for (const [place, colour, dashes] of outlined) if (place !== null) outlineTile(context, place, scene, placed, colour, dashes);
}

function boundsOf([row, column]: Place, { x, y }: Scene): [Point, Point] {
  const low = y.length - 2 - row;
  return [[x[column] ?? 0, y[low + 1] ?? 0], [x[column + 1] ?? 0, y[low] ?? 0]];
}

function drawTiles(context: CanvasRenderingContext2D, map: Grid, scene: Scene, placed: Placed): void {
  const shades = new Map(tiles.peek().map(({ letter }) => [letter, themeColour(colourOf(letter))]));
  context.save();
  context.globalAlpha = 0.34;
  map.forEach((line, row) =>
    line.forEach((letter, column) => {
      if (letter === ABSENT) return;
      const [[left, top], [right, bottom]] = boundsOf([row, column], scene).map(placed) as [Point, Point];
      context.fillStyle = shades.get(letter) ?? themeColour("carrier");
      context.fillRect(left, top, right - left, bottom - top);
    }),
  );
  const [columns, rows] = [scene.x.length - 1, scene.y.length - 1];
  const [wide, high] = [scene.x.at(-1) ?? 0, scene.y.at(-1) ?? 0];
  if ((wide / columns) * scene.scale >= GRID_FROM) {
    context.globalAlpha = 1;
    context.strokeStyle = themeColour("rule");
    context.lineWidth = 1;
    context.beginPath();
    const lines: [Point, Point][] = [
      ...scene.x.map((x): [Point, Point] => [[x, 0], [x, high]]),
      ...scene.y.map((y): [Point, Point] => [[0, y], [wide, y]]),
    ];
    for (const [start, end] of lines) {
      context.moveTo(...placed(start));
      context.lineTo(...placed(end));
    }
    context.stroke();
  }
  context.restore();
  context.canvas.dataset["tiles"] = `${columns} x ${rows}`;
}

/** Pillars and names of the last plate that could be built, where its tiles have not been painted over. */
function drawFeatures(
  context: CanvasRenderingContext2D, plan: PlateDrawing, map: Grid, scene: Scene, placed: Placed,
): void {
  const before = inText.peek();
  if (plan.x.length !== scene.x.length || plan.y.length !== scene.y.length) return;
  const isSame = (point: Point) => {
    const place = placeAt(scene, point);
    return place !== null && map[place[0]]?.[place[1]] === before?.[place[0]]?.[place[1]];
  };
  context.strokeStyle = context.fillStyle = themeColour("quiet");
  context.lineWidth = devicePixelRatio;
  traceFeatures(context, plan.features, placed, isSame);
  context.stroke();
  context.strokeStyle = themeColour("ink");
  for (const loop of plan.plate) strokeLoop(context, loop, placed);
  drawHeld(context, plan.held, placed);
  for (const [name, loops] of Object.entries(plan.regions)) nameRegion(context, name, loops, placed, look());
}

function drawParts(context: CanvasRenderingContext2D, scene: Scene, placed: Placed): void {
  const isMoving = tool.peek() === "move";
  context.lineWidth = 1.5 * devicePixelRatio;
  for (const part of parts.peek()) {
    const [wide = 0, high = 0] = part.diameter === null ? part.size : [part.diameter, part.diameter];
    const around = corners(part.centre, [wide, high]);
    context.save();
    context.strokeStyle = themeColour("ink");
    context.fillStyle = themeColour("gap");
    context.beginPath();
    if (part.diameter !== null || wide === 0) {
      const radius = Math.max(((part.diameter ?? 0) / 2) * scene.scale, HANDLE) * devicePixelRatio;
      context.arc(...placed(part.centre), radius, 0, 2 * Math.PI);
    } else trace(context, around, placed);
    context.globalAlpha = part.diameter === null ? 0.85 : 0.3;
    context.fill();
    context.globalAlpha = 1;
    context.stroke();
    context.restore();
    const [x, y] = placed([part.centre[0], part.centre[1]]);
    const below = wide === 0 ? -10 : 4; // CSS pixels; the name of a point is above it
    writeName(context, part.name, [x, y + below * devicePixelRatio], look());
    if (isMoving && pathOf(part.steps) === selected.peek())
      drawHandles(context, part.size.length > 0 ? around : [part.centre], placed);
  }
  const length = clamped.peek();
  if (isMoving && length !== null && selected.peek() === CLAMP)
    drawHandles(context, clampHandles(scene, length), placed);
}

function drawHandles(context: CanvasRenderingContext2D, points: Point[], placed: Placed): void {
  const half = HANDLE * devicePixelRatio;
  context.fillStyle = themeColour("paper");
  context.strokeStyle = themeColour("accent");
  for (const point of points) {
    const [x, y] = placed(point);
    context.fillRect(x - half, y - half, 2 * half, 2 * half);
    context.strokeRect(x - half, y - half, 2 * half, 2 * half);
  }
}

function outlineTile(
  context: CanvasRenderingContext2D, place: Place, scene: Scene, placed: Placed, colour: string, dashes: number[],
): void {
  const [[left, top], [right, bottom]] = boundsOf(place, scene).map(placed) as [Point, Point];
  context.save();
  context.strokeStyle = themeColour(colour);
  context.lineWidth = 2.5 * devicePixelRatio;
  context.setLineDash(dashes.map((length) => length * devicePixelRatio));
  context.strokeRect(left, top, right - left, bottom - top);
  context.restore();
}
