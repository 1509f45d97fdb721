/** What all plots share: their place on the page, clicks, and painting behind the curves. */

import type uPlot from "uplot";
import { onTheme, themeColour } from "./colours";
import { tickText } from "./numbers";

const NARROWEST = 240; // CSS pixels
const FONT = "13px system-ui, sans-serif";
const TICK = 10; // CSS pixels, length of a tick
const GAP = 5; // CSS pixels between a tick and its label
const APART = 6; // CSS pixels between the widest label and the title

/** Look of an axis; numbers have true minus signs and powers of ten. */
export const axisLook = () => ({
  stroke: () => themeColour("ink"),
  ticks: { stroke: () => themeColour("rule"), size: TICK },
  gap: GAP,
  grid: { show: false },
  font: FONT,
  labelFont: "14px system-ui, sans-serif",
  values: (_: uPlot, splits: (number | null)[]) => splits.map((value) => (value === null ? "" : tickText(value))),
});

/** An axis at the left, as wide as its widest label. */
export const leftAxis = () => ({ ...axisLook(), labelSize: 24, size: widthOfLabels });

function widthOfLabels({ ctx }: uPlot, values: string[] | null): number {
  ctx.save();
  ctx.font = FONT;
  const widths = (values ?? []).map((value) => ctx.measureText(value).width);
  ctx.restore();
  return Math.ceil(TICK + GAP + Math.max(0, ...widths) + APART);
}

/** Options of a curve that is drawn between pixels as it is, not on whole ones, which makes stairs of flat curves. */
export const BETWEEN_PIXELS = { pxAlign: 0 };

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
