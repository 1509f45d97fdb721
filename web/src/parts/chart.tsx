/** A plot of curves or points over one axis, with a mark of what is selected. */

import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { themeColour } from "./colours";
import { kept, onClick, widthIn, within } from "./plot";

export interface ChartCurve {
  values: (number | null)[];
  colour: string; // name in the theme
  dash?: number[];
  width?: number; // CSS pixels
  points?: boolean; // points without a line
}

interface Props {
  x: number[];
  curves: ChartCurve[];
  titles: [string, string]; // of the axes
  height: number; // CSS pixels
  whole?: boolean; // the x axis has whole numbers
  limits?: { x?: [number, number]; y?: [number, number] };
  below?: (plot: uPlot) => void; // paints behind the curves
  above?: (plot: uPlot) => void; // paints on them
  pick?: (x: number, y: number, plot: uPlot) => void; // values at a click
}

const LABELLED = { font: "13px system-ui, sans-serif", labelFont: "14px system-ui, sans-serif" };

export function Chart(props: Props) {
  const { x, curves, titles, height, limits, whole } = props;
  const place = useRef<HTMLDivElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const drawn = useRef<uPlot | null>(null);
  useEffect(() => {
    const element = place.current;
    if (element === null) return;
    const axis = { ...LABELLED, stroke: () => themeColour("ink"), ticks: { stroke: () => themeColour("rule") }, grid: { show: false } };
    const size = () => ({ width: widthIn(element), height });
    const plot = new uPlot(
      {
        ...size(),
        legend: { show: false },
        cursor: { points: { show: false }, x: false, y: false, drag: { x: true, y: true, uni: 20 } },
        scales: {
          x: { time: false, range: (_, low, high) => (low === null ? (limits?.x ?? [0, 1]) : [low, high]) },
          y: { range: (_, low, high) => (low === null ? (limits?.y ?? [0, 1]) : [low, high]) },
        },
        axes: [
          { ...axis, label: titles[0], labelSize: 22, size: 34, ...(whole ? { incrs: [1, 2, 5, 10] } : {}) },
          { ...axis, label: titles[1], labelSize: 24, size: 52 },
        ],
        series: [
          {},
          ...curves.map(({ colour, dash, width, points }) => ({
            stroke: () => themeColour(colour),
            fill: () => "transparent",
            dash: dash ?? [],
            width: points ? 0 : (width ?? 1.4),
            points: points ? { show: true, size: 4, fill: () => themeColour(colour), width: 0 } : { show: false },
          })),
        ],
        hooks: {
          drawClear: [(u) => within(u, () => latest.current.below?.(u))],
          draw: [(u) => within(u, () => latest.current.above?.(u))],
        },
      },
      [x, ...curves.map(({ values }) => values)],
      element,
    );
    if (limits?.x) plot.setScale("x", { min: limits.x[0], max: limits.x[1] });
    if (limits?.y) plot.setScale("y", { min: limits.y[0], max: limits.y[1] });
    onClick(plot, (left, top) => latest.current.pick?.(plot.posToVal(left, "x"), plot.posToVal(top, "y"), plot));
    drawn.current = plot;
    return kept(plot, element, size, []);
  }, [x, curves, titles[0], titles[1]]);
  useEffect(() => drawn.current?.redraw(false, false));
  return <div class="curves" ref={place} />;
}

/** A line from one border of the plot to the other at a value of x. */
export function verticalLine(plot: uPlot, value: number, colour: string, dashes: number[] = []): void {
  const { ctx, bbox } = plot;
  const x = plot.valToPos(value, "x", true);
  line(ctx, [x, bbox.top], [x, bbox.top + bbox.height], colour, dashes);
}

/** The same at a value of y. */
export function horizontalLine(plot: uPlot, value: number, colour: string, dashes: number[] = []): void {
  const { ctx, bbox } = plot;
  const y = plot.valToPos(value, "y", true);
  line(ctx, [bbox.left, y], [bbox.left + bbox.width, y], colour, dashes);
}

type Place = [number, number];

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
export function dot(ctx: CanvasRenderingContext2D, [x, y]: Place, colour: string): void {
  ctx.save();
  ctx.beginPath();
  ctx.arc(x, y, 5 * devicePixelRatio, 0, 2 * Math.PI);
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
