/** Map of the plate that moves. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { onTheme, themeColour } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import type { Loop, PlateResponse } from "./plate_data";
import type { Choice } from "./state";

const TALLEST = 0.62; // of the window

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
  const image = new ImageData(plate.columns, plate.rows);
  const small = new OffscreenCanvas(plate.columns, plate.rows);
  const context = canvas.getContext("2d");
  const inner = small.getContext("2d");
  if (context === null || inner === null) return () => undefined;
  const counted = { frames: 0 };
  const draw = () => {
    const line = choice.line.peek();
    counted.frames++;
    plate.paint(image, line, plate.outermost(line) + cycle.moment);
    inner.putImageData(image, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingEnabled = true;
    context.imageSmoothingQuality = "high";
    context.drawImage(small, 0, 0, canvas.width, canvas.height);
    drawParts(context, plate, ([x, y]) => [
      (canvas.width * (x - left)) / (right - left),
      (canvas.height * (top - y)) / (top - bottom),
    ]);
    canvas.dataset["shown"] = String(line);
  };
  const cycle = new Cycle(choice, draw);
  const fit = () => {
    const ratio = (top - bottom) / (right - left);
    const room = canvas.parentElement?.clientWidth ?? 300;
    const width = Math.min(room, (TALLEST * innerHeight) / ratio);
    canvas.style.width = `${width}px`;
    canvas.style.height = `${width * ratio}px`;
    canvas.width = Math.round(width * devicePixelRatio);
    canvas.height = Math.round(width * ratio * devicePixelRatio);
    draw();
  };
  const resized = new ResizeObserver(fit);
  if (canvas.parentElement !== null) resized.observe(canvas.parentElement);
  Object.assign(canvas, { counted }); // for tests
  const stops = [
    effect(() => {
      choice.line.value;
      draw();
    }),
    onTheme(draw),
  ];
  return () => {
    cycle.end();
    resized.disconnect();
    for (const stop of stops) stop();
  };
}

type Placed = (point: [number, number]) => [number, number];

function drawParts(context: CanvasRenderingContext2D, plate: PlateResponse, placed: Placed): void {
  const { plate: border, regions, patches } = plate.parts;
  context.strokeStyle = "#1c2126"; // on the map's colours, which are the same in light and dark
  context.lineWidth = 1.2 * devicePixelRatio;
  for (const loop of Object.values(regions).flat()) stroke(context, loop, placed);
  context.strokeStyle = themeColour("quiet");
  for (const loop of border) stroke(context, loop, placed);
  context.strokeStyle = "#855a12";
  context.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
  for (const [x, y, width, height] of Object.values(patches)) {
    const [across, up] = [width / 2, height / 2];
    const corners: Loop = [[x - across, y - up], [x + across, y - up], [x + across, y + up], [x - across, y + up]];
    stroke(context, corners, placed);
  }
  context.setLineDash([]);
  for (const [name, loops] of Object.entries(regions)) nameRegion(context, name, loops, placed);
}

/** Write the name of a region in the middle of its upper end. */
function nameRegion(context: CanvasRenderingContext2D, name: string, loops: Loop[], placed: Placed): void {
  const corners = loops.flat().map(placed);
  const [across, up] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const size = 13 * devicePixelRatio;
  context.font = `${size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.lineWidth = 3 * devicePixelRatio;
  context.strokeStyle = "#ffffff";
  context.fillStyle = "#1c2126";
  const middle = (Math.min(...across) + Math.max(...across)) / 2;
  const wide = context.measureText(name).width / 2;
  const x = Math.min(Math.max(middle, wide), context.canvas.width - wide);
  const y = Math.min(...up) + 1.3 * size;
  context.strokeText(name, x, y);
  context.fillText(name, x, y);
}

function stroke(context: CanvasRenderingContext2D, loop: Loop, placed: Placed): void {
  context.beginPath();
  loop.forEach((corner, k) => (k === 0 ? context.moveTo(...placed(corner)) : context.lineTo(...placed(corner))));
  context.closePath();
  context.stroke();
}
