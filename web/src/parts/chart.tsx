/** A plot of curves or points over one axis, with a mark of what is selected. */

import { useLayoutEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { themeColour } from "./colours";
import { axisLook, BETWEEN_PIXELS, kept, leftAxis, onClick, widthIn, within } from "./plot";

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

export function Chart(props: Props) {
  const { x, curves, titles, height, limits, whole } = props;
  const place = useRef<HTMLDivElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const drawn = useRef<uPlot | null>(null);
  // the plot changes in the same frame as the words beside it
  useLayoutEffect(() => {
    const element = place.current;
    if (element === null) return;
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
          { ...axisLook(), label: titles[0], labelSize: 22, size: 34, ...(whole ? { incrs: [1, 2, 5, 10] } : {}) },
          { ...leftAxis(), label: titles[1] },
        ],
        series: [
          {},
          ...curves.map(({ colour, dash, width, points }) => ({
            ...BETWEEN_PIXELS,
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
  useLayoutEffect(() => drawn.current?.redraw(false, false));
  return <div class="curves" ref={place} />;
}
