/** Lines, dots and areas that views paint on their plots; colours are names of the theme, dashes CSS pixels. */

import type uPlot from "uplot";
import { themeColour } from "./colours";

type Place = [number, number]; // pixels of the canvas

/** A line from one border of the plot to the other at a value of x; none beyond its borders. */
export function verticalLine(plot: uPlot, value: number, colour: string, dashes: number[] = []): void {
  const { ctx, bbox } = plot;
  const x = plot.valToPos(value, "x", true);
  if (x < bbox.left || x > bbox.left + bbox.width) return;
  line(ctx, [x, bbox.top], [x, bbox.top + bbox.height], colour, dashes);
}

/** The same at a value of y. */
export function horizontalLine(plot: uPlot, value: number, colour: string, dashes: number[] = []): void {
  const { ctx, bbox } = plot;
  const y = plot.valToPos(value, "y", true);
  line(ctx, [bbox.left, y], [bbox.left + bbox.width, y], colour, dashes);
}

export function line(ctx: CanvasRenderingContext2D, from: Place, to: Place, colour: string, dashes: number[] = []): void {
  ctx.save();
  ctx.strokeStyle = themeColour(colour);
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.setLineDash(dashes.map((length) => length * devicePixelRatio));
  ctx.beginPath();
  ctx.moveTo(...from);
  ctx.lineTo(...to);
  ctx.stroke();
  ctx.restore();
}

/** A dot at a place in pixels of the canvas. */
export function dot(ctx: CanvasRenderingContext2D, [x, y]: Place, colour: string, radius = 5): void {
  ctx.save();
  ctx.setLineDash([]); // a dashed curve leaves its dashes
  ctx.beginPath();
  ctx.arc(x, y, radius * devicePixelRatio, 0, 2 * Math.PI);
  ctx.fillStyle = themeColour(colour);
  ctx.strokeStyle = themeColour("paper");
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}

/** Shade an interval of x. */
export function shadeInterval(plot: uPlot, [low, high]: [number, number], colour: string): void {
  const { ctx, bbox } = plot;
  const [left, right] = [plot.valToPos(low, "x", true), plot.valToPos(high, "x", true)];
  ctx.fillStyle = themeColour(colour);
  ctx.fillRect(left, bbox.top, right - left, bbox.height);
}
