/** The moving field of a mode over some periods of a ribbon, which runs from left to right. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { onTheme } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import type { RibbonModes } from "./ribbon_data";
import type { Choice } from "./view";

const LONG = 1.6; // length of the drawn part over its width
const MOST = 30; // periods

interface Props {
  ribbon: RibbonModes;
  choice: Choice;
}

export function Field({ ribbon, choice }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => (canvas.current === null ? undefined : kept(canvas.current, ribbon, choice)), [ribbon, choice]);
  return (
    <div class="map">
      <canvas ref={canvas} role="img" aria-label="Field of the mode" />
    </div>
  );
}

/** Draw the field while the mode and the size of the canvas change; returns what ends it. */
function kept(canvas: HTMLCanvasElement, ribbon: RibbonModes, choice: Choice): () => void {
  const painter = new FieldPainter(ribbon);
  const { columns, rows } = painter;
  const image = new ImageData(columns, rows);
  const small = new OffscreenCanvas(columns, rows);
  const [context, inner] = [canvas.getContext("2d"), small.getContext("2d")];
  if (context === null || inner === null) return () => undefined;
  const counted = { frames: 0, painter };
  const draw = () => {
    const mode = choice.mode.peek();
    counted.frames++;
    painter.paint(image, mode, cycle.moment);
    inner.putImageData(image, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingQuality = "high";
    context.drawImage(small, 0, 0, canvas.width, canvas.height);
    canvas.dataset["shown"] = String(mode);
  };
  const cycle = new Cycle(choice, draw);
  const fit = () => {
    const width = canvas.parentElement?.clientWidth ?? 300;
    const height = (width * painter.width) / painter.length;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.width = Math.round(width * devicePixelRatio);
    canvas.height = Math.round(height * devicePixelRatio);
    draw();
  };
  const resized = new ResizeObserver(fit);
  if (canvas.parentElement !== null) resized.observe(canvas.parentElement);
  Object.assign(canvas, { counted }); // for tests
  const stops = [
    effect(() => {
      choice.mode.value;
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

class FieldPainter {
  readonly columns: number;
  readonly rows: number;
  readonly width: number; // m
  readonly length: number; // m
  private readonly along: number; // points along a period

  constructor(private readonly ribbon: RibbonModes) {
    const [, across = 0, along = 0] = ribbon.data.shape("mode_real");
    const position = ribbon.data.values("across");
    this.width = ((position[1] ?? 0) - (position[0] ?? 0)) * across;
    const periods = Math.min(MOST, Math.max(2, Math.round((LONG * this.width) / ribbon.period)));
    this.length = periods * ribbon.period;
    this.columns = periods * along;
    this.rows = across;
    this.along = along;
  }

  /** Paint a mode at a moment of its cycle, from 0 to 1: u(y + period) = exp(i phase) u(y). */
  paint(image: ImageData, mode: number, moment: number): void {
    const { data, colours, phase } = this.ribbon;
    const [real, imag, present] = [data.values("mode_real"), data.values("mode_imag"), data.values("present")];
    const middle = (colours.length - 1) / 2;
    const start = mode * this.rows * this.along;
    for (let column = 0; column < this.columns; column++) {
      const period = Math.floor(column / this.along);
      const angle = 2 * Math.PI * moment + period * (phase[mode] ?? 0);
      const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
      for (let row = 0; row < this.rows; row++) {
        const place = row * this.along + (column % this.along);
        const value = (real[start + place] ?? 0) * cosine - (imag[start + place] ?? 0) * sine;
        const shade = Math.min(Math.max(Math.round(middle + value), 0), 2 * middle);
        const [red = 0, green = 0, blue = 0] = colours[shade] ?? [];
        const pixel = 4 * ((this.rows - 1 - row) * this.columns + column);
        image.data.set([red, green, blue, present[place] === 0 ? 0 : 255], pixel);
      }
    }
  }
}
