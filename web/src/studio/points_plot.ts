/** Plot of computed designs: filled marks with error bars, hollow marks for previews. */

import { effect } from "@preact/signals";
import uPlot from "uplot";
import { themeColour } from "../parts/colours";
import { tickText } from "../parts/numbers";
import { axisLook, kept, leftAxis, onClick, widthIn, within } from "../parts/plot";
import { at, drawn, horizontal, ORDER, points, scaleOf, selected, type Scale } from "./points_data";

const HEIGHT = 280; // CSS pixels
const RADIUS = 3.5;
const REACH = 20; // of a click
const COLOURS = 4; // --curve-0 to --curve-3 of the theme

interface Mark {
  place: number;
  x: number;
  y: number;
  error: number | null;
  series: number;
}

interface Marks {
  list: Mark[];
  titles: string[];
  x: Scale;
  y: Scale;
}

/** Marks of the drawn points in the units of the axes; results of the first unit are drawn. */
export function marksOf(): Marks {
  const places = drawn.value;
  const title = horizontal.value;
  const results = places.flatMap((place) => points.value[place]?.results ?? []);
  const unit = results[0]?.unit ?? "";
  const titles = [...new Set(results.filter((each) => each.unit === unit).map((each) => each.title))];
  const abscissae = places.map((place) => at(points.value[place]!, place, title));
  const xUnit = points.value[places[0] ?? 0]?.varied.find((each) => each.title === title)?.unit ?? "";
  const x = title === ORDER ? { factor: 1, unit: "" } : scaleOf(abscissae, xUnit);
  const y = scaleOf(results.filter((each) => each.unit === unit).map(({ value }) => value), unit);
  const list = places.flatMap((place, k) =>
    (points.value[place]?.results ?? [])
      .filter((each) => each.unit === unit)
      .map((each) => ({
        place,
        x: abscissae[k]! * x.factor,
        y: each.value * y.factor,
        error: each.error === null ? null : each.error * y.factor,
        series: titles.indexOf(each.title),
      })),
  );
  return { list, titles, x, y };
}

/** Text of a tick of the horizontal axis; designs are counted in whole numbers. */
const tick = (value: number) => (horizontal.peek() === ORDER && !Number.isInteger(value) ? "" : tickText(value));

/** Ends of an axis with some room beyond its marks. */
function range(values: number[]): [number, number] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (!Number.isFinite(low)) return [0, 1];
  const room = 0.06 * (high - low) || Math.abs(high) * 0.05 || 1;
  return [low - room, high + room];
}

export function plotPoints(element: HTMLElement): () => void {
  let marks = marksOf();
  const size = () => ({ width: widthIn(element), height: HEIGHT });
  const label = (name: string, { unit }: Scale) => (unit ? `${name} / ${unit}` : name);
  const ranges = () => ({
    x: range(marks.list.map((mark) => mark.x)),
    y: range(marks.list.flatMap((mark) => [mark.y - (mark.error ?? 0), mark.y + (mark.error ?? 0)])),
  });
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: false },
      cursor: { points: { show: false }, x: false, y: false, drag: { x: false, y: false } },
      scales: { x: { time: false, range: () => ranges().x }, y: { range: () => ranges().y } },
      axes: [
        { ...axisLook(), label: " ", labelSize: 22, size: 34, values: (_, splits) => splits.map(tick) },
        { ...leftAxis(), label: " " },
      ],
      series: [{}, { show: true, stroke: "transparent", points: { show: false } }],
      hooks: { draw: [(u) => within(u, () => paint(u, marks))] },
    },
    [[0, 1], [0, 1]],
    element,
  );
  onClick(plot, (left, top) => {
    const away = ({ x, y }: Mark) => Math.hypot(plot.valToPos(x, "x") - left, plot.valToPos(y, "y") - top);
    const nearest = marks.list.reduce<Mark | null>((best, mark) => (best && away(best) <= away(mark) ? best : mark), null);
    if (nearest !== null && away(nearest) < REACH) selected.value = nearest.place;
  });
  return kept(plot, element, size, [
    effect(() => {
      marks = marksOf();
      selected.value;
      plot.axes[0]!.label = label(horizontal.value, marks.x);
      plot.axes[1]!.label = label(marks.titles.join(", "), marks.y);
      const { x, y } = ranges();
      plot.setData([x, y]);
      element.dataset["marks"] = String(marks.list.length);
    }),
  ]);
}

function paint(plot: uPlot, { list }: Marks): void {
  const { ctx } = plot;
  const size = RADIUS * devicePixelRatio;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  for (const { place, x, y, error, series } of list) {
    const [left, top] = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)];
    ctx.strokeStyle = ctx.fillStyle = themeColour(`curve-${series % COLOURS}`);
    ctx.beginPath();
    if (series % 2) ctx.rect(left - size, top - size, 2 * size, 2 * size); // series differ by more than colour
    else ctx.arc(left, top, size, 0, 2 * Math.PI);
    if (error === null) ctx.stroke();
    else {
      ctx.fill();
      ctx.beginPath();
      ctx.moveTo(left, plot.valToPos(y - error, "y", true));
      ctx.lineTo(left, plot.valToPos(y + error, "y", true));
      ctx.stroke();
    }
    if (place !== selected.peek()) continue;
    ctx.strokeStyle = themeColour("ink");
    ctx.beginPath();
    ctx.arc(left, top, 2.4 * size, 0, 2 * Math.PI);
    ctx.stroke();
  }
}
