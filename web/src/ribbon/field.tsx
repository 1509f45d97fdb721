/** The moving field of a mode over some periods of a ribbon, which runs from left to right. */

import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { onTheme } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import { FilmButtons, filmed } from "../parts/film";
import { origin } from "../parts/frame";
import { Raster } from "../parts/raster";
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
      <FilmButtons canvas={canvas} name="ribbon" caption={`${ribbon.data.header.title}, ${origin(ribbon.data)}`} />
    </div>
  );
}

/** Draw the field while the mode and the size of the canvas change; returns what ends it. */
function kept(canvas: HTMLCanvasElement, ribbon: RibbonModes, choice: Choice): () => void {
  const painter = new FieldPainter(ribbon);
  const raster = Raster.on(canvas, painter.columns, painter.rows);
  if (raster === null) return () => undefined;
  const counted = { frames: 0, painter };
  const draw = () => {
    const mode = choice.mode.peek();
    counted.frames++;
    painter.paint(raster.image, mode, cycle.moment);
    raster.show(true);
    canvas.dataset["shown"] = String(mode);
  };
  const cycle = new Cycle(choice, draw, canvas);
  filmed(canvas, (moment) => cycle.at(moment));
  Object.assign(canvas, { counted }); // for tests
  const stops = [
    raster.follow(painter.width / painter.length, draw),
    effect(() => {
      choice.mode.value;
      draw();
    }),
    onTheme(draw),
  ];
  return () => {
    cycle.end();
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
