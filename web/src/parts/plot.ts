/** What all plots share: their place on the page, clicks, and painting behind the curves. */

import type uPlot from "uplot";
import { onTheme } from "./colours";

const NARROWEST = 240; // CSS pixels

/** Width of a plot in an element, CSS pixels. */
export function widthIn(element: HTMLElement): number {
  return Math.max(element.clientWidth, NARROWEST);
}

/** Keep a plot in the size of its element and in the theme's colours until the returned function removes it. */
export function kept(
  plot: uPlot,
  element: HTMLElement,
  size: () => { width: number; height: number },
  effects: (() => void)[],
): () => void {
  const stops = [...effects, onTheme(() => plot.redraw(false, true))];
  const resized = new ResizeObserver(() => plot.setSize(size()));
  resized.observe(element);
  return () => {
    resized.disconnect();
    for (const stop of stops) stop();
    plot.destroy();
  };
}

/** Call a function with the place of each click in a plot, CSS pixels; uPlot keeps back the click of a drag. */
export function onClick(plot: uPlot, pick: (left: number, top: number) => void): void {
  plot.over.addEventListener("click", ({ clientX, clientY }) => {
    const box = plot.over.getBoundingClientRect();
    pick(clientX - box.left, clientY - box.top);
  });
}

/** Paint within the axes. */
export function within({ ctx, bbox }: uPlot, paint: () => void): void {
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  paint();
  ctx.restore();
}
