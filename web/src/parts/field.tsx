/** The moving field of a wave on the flat face, over some periods from left to right. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Numbers } from "../dataset";
import { ColourScale } from "./colour_scale";
import { onTheme } from "./colours";
import { Cycle, type Pace } from "./cycle";
import { FilmButtons, filmed } from "./film";
import { line } from "./marks";
import { Raster } from "./raster";

/** Fields on one period, a grid of `across` by `along` points for each wave. */
export interface FieldGrid {
  real: Numbers; // in half as many steps as there are colours
  imag: Numbers;
  present: Numbers; // 0 where there is no plate
  across: number;
  along: number;
  width: number; // m, of the grid across
  length: number; // m, of one period
  colours: number[][];
}

/** The part that is drawn. */
export interface FieldPart {
  periods: number; // from left to right
  repeats?: number; // of the grid from bottom to top
  slip?: number; // of the next period upwards, as a share of the grid
}

/** The wave that is drawn: u(next period) = exp(i phase - decay) u. */
export interface FieldWave {
  number: number; // of its field among those of the grid
  phase: number; // rad
  decay: number;
  edges?: number[]; // lines from left to right, as shares of the height from below
}

interface Props {
  grid: FieldGrid;
  part: FieldPart;
  wave: ReadonlySignal<FieldWave>;
  pace: Pace;
  label: string;
  shown: string; // what the colours show, from −1 to 1
  name: string; // of saved films
  caption: string; // on saved films
}

export function Field({ grid, part, wave, pace, label, shown, name, caption }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(
    () => (canvas.current === null ? undefined : kept(canvas.current, new FieldPainter(grid, part), wave, pace)),
    [grid, part, wave, pace],
  );
  return (
    <div class="map">
      <canvas ref={canvas} role="img" aria-label={label} />
      <ColourScale colours={grid.colours} ends={["−1", "1"]}>
        {shown}
      </ColourScale>
      <FilmButtons canvas={canvas} name={name} caption={caption} />
    </div>
  );
}

/** Draw the field while the wave and the size of the canvas change; returns what ends it. */
function kept(canvas: HTMLCanvasElement, painter: FieldPainter, wave: ReadonlySignal<FieldWave>, pace: Pace): () => void {
  const raster = Raster.on(canvas, painter.columns, painter.rows);
  if (raster === null) return () => undefined;
  const counted = { frames: 0, painter };
  const draw = () => {
    counted.frames++;
    painter.paint(raster.image, wave.peek(), cycle.moment);
    raster.show(true);
    for (const edge of wave.peek().edges ?? []) {
      const y = (1 - edge) * canvas.height;
      line(raster.context, [0, y], [canvas.width, y], "quiet", [6, 5]);
    }
    canvas.dataset["shown"] = String(wave.peek().number);
  };
  const cycle = new Cycle(pace, draw, canvas);
  filmed(canvas, (moment) => cycle.at(moment));
  Object.assign(canvas, { counted }); // for tests
  const stops = [
    raster.follow(painter.ratio, draw),
    effect(() => {
      wave.value;
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
  readonly ratio: number; // height over width

  constructor(
    private readonly grid: FieldGrid,
    private readonly part: FieldPart,
  ) {
    const { repeats = 1, periods } = part;
    this.columns = periods * grid.along;
    this.rows = repeats * grid.across;
    this.ratio = (repeats * grid.width) / (periods * grid.length);
  }

  /** Paint a wave at a moment of its cycle, from 0 to 1. */
  paint(image: ImageData, { number, phase, decay }: FieldWave, moment: number): void {
    const { real, imag, present, across, along, colours } = this.grid;
    const middle = (colours.length - 1) / 2;
    const start = number * across * along;
    for (let column = 0; column < this.columns; column++) {
      const period = Math.floor(column / along);
      const angle = 2 * Math.PI * moment + period * phase;
      const size = Math.exp(-period * decay);
      const [cosine, sine] = [size * Math.cos(angle), size * Math.sin(angle)];
      const slip = Math.round(period * (this.part.slip ?? 0) * across);
      for (let row = 0; row < this.rows; row++) {
        const source = (((row - slip) % across) + across) % across;
        const place = source * along + (column % along);
        const value = (real[start + place] ?? 0) * cosine - (imag[start + place] ?? 0) * sine;
        const shade = Math.min(Math.max(Math.round(middle + value), 0), 2 * middle);
        const [red = 0, green = 0, blue = 0] = colours[shade] ?? [];
        const pixel = 4 * ((this.rows - 1 - row) * this.columns + column);
        image.data.set([red, green, blue, present[place] === 0 ? 0 : 255], pixel);
      }
    }
  }
}
