/** Lines and outlines of a plate, as `haptonic.plate.layout.drawing` gives them, on a canvas. */

import { themeColour } from "./colours";

export type Point = [number, number]; // m, or pixels of a canvas
export type Loop = Point[]; // corners of a closed line
export type Placed = (point: Point) => Point; // from metres to pixels

export interface Drawing {
  plate: Loop[];
  regions: Record<string, Loop[]>;
  features: { outline: Loop; places: Point[] }[]; // outline about the axis
  held: { hold: string; ends: Loop }[];
  patches: Record<string, [number, number, number, number]>; // middle and size
}

export interface Look {
  ink: string;
  rim: string; // around letters, so that they can be read on any colour
}

export const ON_MAP = "#1c2126"; // on colours that are the same in light and dark
const IN_BOTH: Look = { ink: ON_MAP, rim: "#ffffff" };

/** Outlines of pillars, discs and holes whose axis is where `wanted` says. */
export function traceFeatures(
  context: CanvasRenderingContext2D,
  features: Drawing["features"],
  placed: Placed,
  wanted: (place: Point) => boolean = () => true,
): void {
  context.beginPath();
  for (const { outline, places } of features)
    for (const place of places)
      if (wanted(place)) trace(context, outline.map(([x, y]) => [place[0] + x, place[1] + y]), placed);
}

/** Supported parts of the sides. */
export function drawHeld(context: CanvasRenderingContext2D, held: Drawing["held"], placed: Placed): void {
  context.save();
  context.strokeStyle = themeColour("carrier");
  context.lineWidth = 4 * devicePixelRatio;
  for (const { hold, ends } of held) {
    context.setLineDash(hold === "clamped" ? [] : [5 * devicePixelRatio, 3 * devicePixelRatio]);
    context.beginPath();
    trace(context, ends, placed);
    context.stroke();
  }
  context.restore();
}

/** Add a closed line to the path. */
export function trace(context: CanvasRenderingContext2D, loop: Loop, placed: Placed): void {
  loop.forEach((corner, k) => (k === 0 ? context.moveTo(...placed(corner)) : context.lineTo(...placed(corner))));
  context.closePath();
}

export function strokeLoop(context: CanvasRenderingContext2D, loop: Loop, placed: Placed): void {
  context.beginPath();
  trace(context, loop, placed);
  context.stroke();
}

/** Corners of a rectangle with a middle and a size. */
export function corners([x, y]: Point, [width, height]: Point): Loop {
  const [across, up] = [width / 2, height / 2];
  return [[x - across, y - up], [x + across, y - up], [x + across, y + up], [x - across, y + up]];
}

/** Write the name of a region below the middle of its uppermost edge, the longest if there are several. */
export function nameRegion(
  context: CanvasRenderingContext2D, name: string, loops: Loop[], placed: Placed, look = IN_BOTH,
): void {
  const edges = loops.flatMap((loop) =>
    loop.map((corner, k): [Point, Point] => [placed(corner), placed(loop[(k + 1) % loop.length] ?? corner)]),
  );
  const level = edges.filter(([start, end]) => Math.abs(start[1] - end[1]) < 1);
  const top = Math.min(...level.map(([start]) => start[1]));
  const length = ([start, end]: [Point, Point]) => Math.abs(start[0] - end[0]);
  const [uppermost] = level.filter(([start]) => start[1] < top + 1).sort((a, b) => length(b) - length(a));
  if (uppermost === undefined) return;
  const [start, end] = uppermost;
  writeName(context, name, [(start[0] + end[0]) / 2, top + 17 * devicePixelRatio], look);
}

/** A text with a rim, within the canvas. */
export function writeName(context: CanvasRenderingContext2D, name: string, [middle, y]: Point, look = IN_BOTH): void {
  context.save();
  context.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.lineWidth = 3 * devicePixelRatio;
  context.strokeStyle = look.rim;
  context.fillStyle = look.ink;
  const wide = context.measureText(name).width / 2;
  const x = Math.min(Math.max(middle, wide), context.canvas.width - wide);
  context.strokeText(name, x, y);
  context.fillText(name, x, y);
  context.restore();
}
