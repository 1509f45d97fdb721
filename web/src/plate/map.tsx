/** Map of the plate that moves. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ColourScale } from "../parts/colour_scale";
import { onTheme, themeColour } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import { FilmButtons, filmed } from "../parts/film";
import { origin } from "../parts/frame";
import { corners, drawHeld, nameRegion, ON_MAP, strokeLoop, traceFeatures, type Placed } from "../parts/plan";
import { Raster } from "../parts/raster";
import type { Field, PlateResponse } from "./plate_data";
import type { Choice } from "./state";

interface Props {
  plate: PlateResponse;
  choice: Choice;
}

/** A map of each field. One cycle moves them all, so that their phases can be compared. */
export function PlateMaps({ plate, choice }: Props) {
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (place.current === null) return;
    return kept([...place.current.querySelectorAll("canvas")], plate, choice);
  }, [plate, choice]);
  return (
    <div class={plate.fields.length > 1 ? "maps" : ""} ref={place}>
      {plate.fields.map((field) => (
        <PlateMap key={field.title} plate={plate} choice={choice} field={field} />
      ))}
    </div>
  );
}

function PlateMap({ plate, choice, field }: Props & { field: Field }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const limit = size(limitOf(plate, choice, field, choice.line.value));
  const title = field.title || origin(plate.data);
  return (
    <div class="map">
      {field.title && <h2>{field.title}</h2>}
      <canvas ref={canvas} role="img" aria-label={`Map of the moving plate${field.title && `, ${field.title}`}`} />
      <ColourScale colours={plate.colours} ends={[`−${limit}`, limit]}>
        normal displacement{plate.drive}
      </ColourScale>
      <FilmButtons canvas={canvas} name="map" caption={`${plate.data.header.title}, ${title}`} />
    </div>
  );
}

/** Displacement of the last colour at a line, m. */
function limitOf(plate: PlateResponse, choice: Choice, field: Field, line: number): number {
  return plate.largest(line, choice.common.value ? plate.fields : [field]);
}

/** A displacement in metres as a text with a suitable unit. */
export function size(metres: number): string {
  const [unit, factor] = metres >= 1e-6 ? ["µm", 1e6] : metres >= 1e-9 ? ["nm", 1e9] : ["pm", 1e12];
  return `${Number((metres * Number(factor)).toPrecision(3))} ${unit}`;
}

/** Draw the maps while the choices and the sizes of the canvases change; returns what ends it. */
function kept(canvases: HTMLCanvasElement[], plate: PlateResponse, choice: Choice): () => void {
  const { left, right, bottom, top } = plate.extent;
  const maps = plate.fields.flatMap((field, k) => {
    const canvas = canvases[k];
    const raster = canvas === undefined ? null : Raster.on(canvas, field.columns, field.rows);
    return canvas === undefined || raster === null ? [] : [{ field, canvas, raster, counted: { frames: 0 } }];
  });
  const draw = () => {
    for (const map of maps) paint(map);
  };
  const paint = ({ field, canvas, raster, counted }: (typeof maps)[number]) => {
    const line = choice.line.peek();
    counted.frames++;
    // the phase of the first field is that of all: what moves together is up together
    const moment = (plate.fields[0] ?? field).outermost(line) + cycle.moment;
    field.paint(raster.image, line, moment, limitOf(plate, choice, field, line));
    raster.show(!plate.data.has("place")); // measured points are shown as they are
    const placed: Placed = ([x, y]) => [
      (canvas.width * (x - left)) / (right - left),
      (canvas.height * (top - y)) / (top - bottom),
    ];
    drawParts(raster.context, plate, placed, choice.plan.peek());
    canvas.dataset["shown"] = String(line);
  };
  const cycle = new Cycle(choice, draw, ...canvases);
  for (const { canvas, counted } of maps) {
    filmed(canvas, (moment) => cycle.at(moment));
    Object.assign(canvas, { counted }); // for tests
  }
  const stops = [
    ...maps.map(({ raster }) => raster.follow((top - bottom) / (right - left), draw)),
    effect(() => {
      choice.line.value;
      choice.plan.value;
      choice.common.value;
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
