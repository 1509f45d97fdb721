/** Map of the plate that moves. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { onTheme, themeColour } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import { FilmButtons, filmed } from "../parts/film";
import { origin } from "../parts/frame";
import { corners, drawHeld, nameRegion, ON_MAP, strokeLoop, traceFeatures, type Placed } from "../parts/plan";
import { Raster } from "../parts/raster";
import type { PlateResponse } from "./plate_data";
import type { Choice } from "./state";

interface Props {
  plate: PlateResponse;
  choice: Choice;
}

export function PlateMap({ plate, choice }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (canvas.current === null) return;
    return kept(canvas.current, plate, choice);
  }, [plate, choice]);
  const middle = Math.floor(plate.colours.length / 2);
  const steps = [0, middle, plate.colours.length - 1].map((k) => `rgb(${(plate.colours[k] ?? []).join(" ")})`);
  return (
    <div class="map">
      <canvas ref={canvas} role="img" aria-label="Map of the moving plate" />
      <p class="scale">
        <span>{`−${size(plate.largest(choice.line.value))}`}</span>
        <span class="bar" style={{ background: `linear-gradient(to right, ${steps.join(", ")})` }} />
        <span>{size(plate.largest(choice.line.value))}</span> normal displacement{plate.drive}
      </p>
      <FilmButtons canvas={canvas} name="map" caption={`${plate.data.header.title}, ${origin(plate.data)}`} />
    </div>
  );
}

/** A displacement in metres as a text with a suitable unit. */
export function size(metres: number): string {
  const [unit, factor] = metres >= 1e-6 ? ["µm", 1e6] : metres >= 1e-9 ? ["nm", 1e9] : ["pm", 1e12];
  return `${Number((metres * Number(factor)).toPrecision(3))} ${unit}`;
}

/** Draw the map while the choices and the size of the canvas change; returns what ends it. */
function kept(canvas: HTMLCanvasElement, plate: PlateResponse, choice: Choice): () => void {
  const { left, right, bottom, top } = plate.extent;
  const raster = Raster.on(canvas, plate.columns, plate.rows);
  if (raster === null) return () => undefined;
  const counted = { frames: 0 };
  const draw = () => {
    const line = choice.line.peek();
    counted.frames++;
    plate.paint(raster.image, line, plate.outermost(line) + cycle.moment);
    raster.show(true);
    const placed: Placed = ([x, y]) => [
      (canvas.width * (x - left)) / (right - left),
      (canvas.height * (top - y)) / (top - bottom),
    ];
    drawParts(raster.context, plate, placed, choice.plan.peek());
    canvas.dataset["shown"] = String(line);
  };
  const cycle = new Cycle(choice, draw);
  filmed(canvas, (moment) => cycle.at(moment));
  Object.assign(canvas, { counted }); // for tests
  const stops = [
    raster.follow((top - bottom) / (right - left), draw),
    effect(() => {
      choice.line.value;
      choice.plan.value;
      draw();
    }),
    onTheme(draw),
  ];
  return () => {
    cycle.end();
    for (const stop of stops) stop();
  };
}

function drawParts(context: CanvasRenderingContext2D, plate: PlateResponse, placed: Placed, whole: boolean): void {
  const { plate: border, regions, patches, features, held } = plate.parts;
  context.strokeStyle = ON_MAP;
  context.lineWidth = 1.2 * devicePixelRatio;
  for (const loop of Object.values(regions).flat()) strokeLoop(context, loop, placed);
  if (whole) {
    context.lineWidth = 0.8 * devicePixelRatio;
    traceFeatures(context, features, placed);
    context.stroke();
    drawHeld(context, held, placed);
  }
  context.lineWidth = 1.2 * devicePixelRatio;
  context.strokeStyle = themeColour("quiet");
  for (const loop of border) strokeLoop(context, loop, placed);
  context.strokeStyle = "#855a12";
  context.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
  for (const [x, y, width, height] of Object.values(patches))
    strokeLoop(context, corners([x, y], [width, height]), placed);
  context.setLineDash([]);
  for (const [name, loops] of Object.entries(regions)) nameRegion(context, name, loops, placed);
}
