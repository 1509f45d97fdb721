/** Map of the reduction of friction, over which a finger is moved. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ColourScale } from "../parts/colour_scale";
import { onTheme, themeColour } from "../parts/colours";
import { corners, nameRegion, ON_MAP, strokeLoop, type Placed, type Point } from "../parts/plan";
import { Raster } from "../parts/raster";
import type { FingerData } from "./finger_data";
import type { Finger } from "./finger_state";

export function FingerMap({ data, finger }: { data: FingerData; finger: Finger }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (canvas.current === null) return;
    return kept(canvas.current, data, finger);
  }, [data, finger]);
  return (
    <div class="map">
      <canvas ref={canvas} role="img" aria-label="Map of the reduction of friction" />
      <ColourScale colours={data.extra.colours} ends={["0", "100 %"]}>
        less friction below a finger with its middle there, model
      </ColourScale>
    </div>
  );
}

/** Draw the map while the choices and the size of the canvas change; returns what ends it. */
function kept(canvas: HTMLCanvasElement, data: FingerData, finger: Finger): () => void {
  const [columns, rows] = [data.columns, data.rows];
  const raster = Raster.on(canvas, columns.length, rows.length);
  if (raster === null) return () => undefined;
  const { image, context } = raster;
  const [across, up] = [columns, rows].map((lines) => ends(lines)) as [Point, Point];
  const placed: Placed = ([x, y]) => [
    (canvas.width * (x - across[0])) / (across[1] - across[0]),
    (canvas.height * (up[1] - y)) / (up[1] - up[0]),
  ];
  const paint = () => {
    const { colours } = data.extra;
    const [law, drive] = [finger.law.peek(), finger.drive.peek()];
    rows.forEach((_, row) =>
      columns.forEach((_, column) => {
        const place = data.placeIn(row, column);
        const pixel = 4 * ((rows.length - 1 - row) * columns.length + column);
        image.data[pixel + 3] = place === null ? 0 : 255;
        if (place === null) return;
        const less = 1 - data.friction(law.value, data.amplitude(place, "value", drive));
        const colour = colours[Math.round(Math.min(Math.max(less, 0), 1) * (colours.length - 1))] ?? [];
        colour.forEach((value, k) => (image.data[pixel + k] = value));
      }),
    );
  };
  const draw = () => {
    raster.show(true);
    drawPlan(context, data, placed);
    drawFinger(context, data, finger.place.peek(), placed);
    canvas.dataset["shown"] = String(finger.place.peek());
  };
  const stops = [
    raster.follow((up[1] - up[0]) / (across[1] - across[0]), draw),
    effect(() => {
      void [finger.law.value, finger.drive.value];
      paint();
      draw();
    }),
    effect(() => {
      finger.place.value;
      draw();
    }),
    onTheme(draw),
    dragged(canvas, ([left, top]) => {
      const point: Point = [across[0] + left * (across[1] - across[0]), up[1] - top * (up[1] - up[0])];
      finger.place.value = data.nearest(point);
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

/** Ends of the map along an axis: half a step beyond the outer places. */
function ends(lines: number[]): Point {
  const [first = 0, second = first + 1e-3] = lines;
  const half = (second - first) / 2;
  return [first - half, (lines.at(-1) ?? 0) + half];
}

function drawPlan(context: CanvasRenderingContext2D, { extra }: FingerData, placed: Placed): void {
  context.lineWidth = 1.2 * devicePixelRatio;
  context.strokeStyle = "#ffffff";
  for (const loop of Object.values(extra.regions).flat()) strokeLoop(context, loop, placed);
  context.strokeStyle = themeColour("quiet");
  for (const loop of extra.plate) strokeLoop(context, loop, placed);
  context.strokeStyle = "#ffffff";
  context.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
  for (const [x, y, width, height] of Object.values(extra.patches))
    strokeLoop(context, corners([x, y], [width, height]), placed);
  context.setLineDash([]);
  for (const [name, loops] of Object.entries(extra.regions)) nameRegion(context, name, loops, placed);
}

/** The disc below the finger, with a dark and a light rim. */
function drawFinger(context: CanvasRenderingContext2D, data: FingerData, place: number, placed: Placed): void {
  const centre: Point = [data.x[place] ?? 0, data.y[place] ?? 0];
  const [x, y] = placed(centre);
  const radius = placed([centre[0] + data.extra.diameter / 2, centre[1]])[0] - x;
  for (const [colour, width] of [["#ffffff", 5], [ON_MAP, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width * devicePixelRatio;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.moveTo(x - 4 * devicePixelRatio, y);
    context.lineTo(x + 4 * devicePixelRatio, y);
    context.moveTo(x, y - 4 * devicePixelRatio);
    context.lineTo(x, y + 4 * devicePixelRatio);
    context.stroke();
  }
}

/** Follow the pressed pointer, in shares of the canvas from its upper left corner. */
function dragged(canvas: HTMLCanvasElement, moved: (share: Point) => void): () => void {
  const follow = (event: PointerEvent) => {
    if (event.type === "pointerdown") canvas.setPointerCapture(event.pointerId);
    else if (event.buttons === 0) return;
    const box = canvas.getBoundingClientRect();
    moved([(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height]);
  };
  canvas.addEventListener("pointerdown", follow);
  canvas.addEventListener("pointermove", follow);
  return () => {
    canvas.removeEventListener("pointerdown", follow);
    canvas.removeEventListener("pointermove", follow);
  };
}
