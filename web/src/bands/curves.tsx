/** The band diagram: curves, gaps, carrier and the mode that is shown. */

import { effect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { themeColour } from "../parts/colours";
import { dot, horizontalLine } from "../parts/marks";
import { axisLook, BETWEEN_PIXELS, kept, leftAxis, onClick, widthIn, within } from "../parts/plot";
import { titled, wavevectorUnits, type Unit } from "../parts/units";
import type { BandDiagram, Gap, Point } from "./diagram_data";
import { layerOfDiagram, type Layer, type Newer } from "./layer";
import { paintLayer } from "./paint_layer";
import type { Choice } from "./state";

const LOWEST = 340; // CSS pixels, least height of the diagram
const ASPECT = 0.72; // height over width
const REACH = 40; // CSS pixels, largest distance of a click from the mode that it picks

interface Props {
  diagram: BandDiagram;
  choice: Choice;
  newer: Newer;
}

export function Curves({ diagram, choice, newer }: Props) {
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const element = place.current;
    if (element === null) return;
    return drawn(element, diagram, choice, newer);
  }, [diagram, choice, newer]);
  return <div class="curves" ref={place} />;
}

/** Draw the diagram into an element and keep it up to date; returns what removes it. */
function drawn(element: HTMLElement, diagram: BandDiagram, choice: Choice, { layer, isWaiting }: Newer): () => void {
  const factor = () => choice.unit.peek().factor;
  const own = layerOfDiagram(diagram);
  const drawnLayer = () => layer.peek() ?? own;
  const lengthOf = (of: Layer) => wavevectorUnit(choice, of).factor;
  const end = (of: Layer) => (of.distance[diagram.rows - 1] ?? 1) / lengthOf(of);
  const branches = diagram.branches();
  const data = (): uPlot.AlignedData => [
    Array.from(diagram.distance, (distance) => distance / lengthOf(own)),
    ...branches.map((curve) => curve.map((value) => (value === null ? null : value / factor()))),
  ];
  const size = () => {
    const width = widthIn(element);
    return { width, height: Math.max(LOWEST, Math.min(ASPECT * width, 0.7 * innerHeight)) };
  };
  const cornerAt = () => {
    const of = drawnLayer();
    return diagram.corners.map(({ row }) => (of.distance[row] ?? 0) / lengthOf(of));
  };
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: false },
      cursor: { points: { show: false }, x: false, y: false, drag: { x: true, y: true, uni: 20 } },
      scales: {
        x: { time: false, range: (_, low, high) => [low, high] },
        y: { range: (_, low, high) => (low === null ? [0, 1] : [low < 0.2 * high ? 0 : low, high]) },
      },
      axes: [
        {
          ...axisLook(),
          splits: cornerAt,
          values: () => cornerAt().map((at, k) => `${diagram.corners[k]?.label}\n${Number(at.toPrecision(3))}`),
          font: "14px system-ui, sans-serif",
          size: 56,
          label: "wavevector",
          labelSize: 22,
          grid: { stroke: () => themeColour("rule"), width: 1 },
        },
        { ...leftAxis(), label: "frequency" },
      ],
      series: [
        {},
        ...branches.map(() => ({
          ...BETWEEN_PIXELS,
          stroke: () =>
            layer.peek() !== null ? "transparent" : themeColour(isWaiting.peek() ? "rule" : "ink"),
          width: 1.6,
          points: { show: false },
        })),
      ],
      hooks: {
        drawClear: [
          (u) =>
            within(u, () => {
              const held = choice.held.peek();
              const gaps = isWaiting.peek() ? [] : (layer.peek() ?? diagram).gaps;
              paintGaps(u, gaps, diagram.carrier, factor());
              if (held !== null) paintLayer(u, diagram, held.layer, factor(), lengthOf(held.layer), "held");
            }),
        ],
        draw: [
          (u) => {
            const drawn = layer.peek();
            if (drawn !== null)
              within(u, () =>
                paintLayer(u, diagram, drawn, factor(), lengthOf(drawn), drawn.isPreview ? "preview" : "certified"),
              );
            paintMarks(u, diagram, choice, drawnLayer());
          },
        ],
      },
    },
    data(),
    element,
  );
  const whole = () => plot.setScale("y", { min: 0, max: diagram.top / factor() });
  const along = () => {
    const held = choice.held.peek();
    plot.setScale("x", { min: 0, max: Math.max(end(drawnLayer()), held === null ? 0 : end(held.layer)) });
  };
  whole();
  onClick(plot, (left, top) => {
    const point = nearest(plot, diagram, factor(), lengthOf(own), left, top);
    if (point !== undefined) choice.point.value = point;
  });
  Object.assign(element, { plot }); // for tests
  return kept(plot, element, size, [
    effect(() => {
      const [x, y] = plot.axes;
      if (x !== undefined) x.label = titled("length of the path", choice.wavevectorUnit.value);
      if (y !== undefined) y.label = titled("frequency", choice.unit.value);
      plot.setData(data(), true);
      whole();
      along();
    }),
    effect(() => {
      void [layer.value, choice.held.value];
      along();
    }),
    effect(() => {
      const high = diagram.at(choice.point.value) / factor();
      void [layer.value, isWaiting.value, choice.held.value]; // drawn anew
      if (high > (plot.scales["y"]?.max ?? Infinity)) plot.setScale("y", { min: 0, max: 1.03 * high });
      else plot.redraw(false, false);
    }),
  ]);
}

/** The chosen unit of wavevectors, for the pitch of a layer. */
function wavevectorUnit(choice: Choice, { pitch }: Layer): Unit {
  const unit = choice.wavevectorUnit.peek();
  return wavevectorUnits(pitch).find(({ name }) => name === unit.name) ?? unit;
}

/** Mode whose point is nearest to a place in CSS pixels; none beyond `REACH`. */
function nearest(
  plot: uPlot,
  diagram: BandDiagram,
  factor: number,
  length: number,
  left: number,
  top: number,
): Point | undefined {
  let [best, least]: [Point | undefined, number] = [undefined, REACH];
  for (let row = 0; row < diagram.rows; row++) {
    const x = plot.valToPos((diagram.distance[row] ?? 0) / length, "x") - left;
    if (Math.abs(x) > least) continue;
    for (let band = 0; band < diagram.bands; band++) {
      const away = Math.hypot(x, plot.valToPos(diagram.at({ row, band }) / factor, "y") - top);
      if (away < least) [best, least] = [{ row, band }, away];
    }
  }
  return best;
}

function paintGaps(plot: uPlot, gaps: Gap[], carrier: number | undefined, factor: number): void {
  const { ctx, bbox } = plot;
  for (const gap of gaps) {
    const high = plot.valToPos(gap.upper / factor, "y", true);
    const height = plot.valToPos(gap.lower / factor, "y", true) - high;
    if (gap.complete) {
      ctx.fillStyle = themeColour("gap");
      ctx.fillRect(bbox.left, high, bbox.width, height);
    } else if (gap.waves !== "all") hatch(ctx, bbox.left, high, bbox.width, height);
  }
  if (carrier !== undefined) {
    horizontalLine(plot, carrier / factor, "carrier", [7, 5]);
  }
}

/** Lines across a gap that one parity has and the other has not. */
function hatch(ctx: CanvasRenderingContext2D, left: number, top: number, width: number, height: number): void {
  const step = 12 * devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, height);
  ctx.clip();
  ctx.beginPath();
  for (let x = left - height; x < left + width; x += step) {
    ctx.moveTo(x, top + height);
    ctx.lineTo(x + height, top);
  }
  ctx.strokeStyle = themeColour("gap");
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.stroke();
  ctx.restore();
}

function paintMarks(plot: uPlot, diagram: BandDiagram, choice: Choice, layer: Layer): void {
  const point = choice.point.peek();
  const x = plot.valToPos((layer.distance[point.row] ?? 0) / wavevectorUnit(choice, layer).factor, "x", true);
  const frequency = layer.frequency[point.row * diagram.bands + point.band] ?? NaN;
  const y = plot.valToPos(frequency / choice.unit.peek().factor, "y", true);
  dot(plot.ctx, [x, y], "accent", 6);
}
