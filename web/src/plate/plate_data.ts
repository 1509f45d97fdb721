/** Numbers of a plate's response with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import type { Drawing } from "../parts/plan";
import { frequencyUnits, type Unit } from "../parts/units";

export interface Curve {
  name: string;
  values: (number | null)[]; // one for each frequency
}

export interface Mode {
  frequency: number; // Hz
  name: string;
  quality: number;
}

export type Shown = "level" | "contrast";

/** A moving field: displacements in steps, and the number of the displacement that each place of the map shows. */
export class Field {
  readonly largestStep: number;
  private readonly real: Numbers;
  private readonly imag: Numbers;
  private readonly step: Numbers;
  private readonly count: number; // of displacements at a frequency

  constructor(
    data: Dataset,
    name: string,
    readonly title: string, // empty for the only field of a view
    readonly columns: number,
    readonly rows: number,
    private readonly places: Int32Array, // row by row from below, -1 without a displacement
    private readonly colours: number[][],
  ) {
    this.real = data.values(`${name}_real`);
    this.imag = data.values(`${name}_imag`);
    this.step = data.values(`${name}_step`);
    this.count = data.shape(`${name}_real`).slice(1).reduce((a, b) => a * b, 1);
    this.largestStep = (colours.length - 1) / 2;
  }

  /** Largest displacement at a line, m. */
  largest(line: number): number {
    return (this.step[line] ?? 0) * this.largestStep;
  }

  /** Colours of the displacement at a moment of the cycle, from the upper row to the lower one; `most` (m) has the
   *  last colour. */
  paint(image: ImageData, line: number, moment: number, most: number): void {
    const scale = most > 0 ? this.largest(line) / most : 0;
    const [cosine, sine] = [scale * Math.cos(2 * Math.PI * moment), scale * Math.sin(2 * Math.PI * moment)];
    const middle = this.largestStep;
    const start = line * this.count;
    for (let row = 0; row < this.rows; row++)
      for (let column = 0; column < this.columns; column++) {
        const place = this.places[row * this.columns + column] ?? -1;
        const value = (this.real[start + place] ?? 0) * cosine - (this.imag[start + place] ?? 0) * sine;
        const shade = Math.min(Math.max(Math.round(middle + value), 0), 2 * middle);
        const [red = 0, green = 0, blue = 0] = this.colours[shade] ?? [];
        const pixel = 4 * ((this.rows - 1 - row) * this.columns + column);
        image.data[pixel] = red;
        image.data[pixel + 1] = green;
        image.data[pixel + 2] = blue;
        image.data[pixel + 3] = place < 0 ? 0 : 255;
      }
  }

  /** The moment of the cycle at which the largest displacement is farthest out. */
  outermost(line: number): number {
    const start = line * this.count;
    let [best, most] = [0, -1];
    for (let k = start; k < start + this.count; k++) {
      const size = Math.hypot(this.real[k] ?? 0, this.imag[k] ?? 0);
      if (size > most) [best, most] = [k, size];
    }
    return -Math.atan2(this.imag[best] ?? 0, this.real[best] ?? 0) / (2 * Math.PI);
  }
}

export class PlateResponse {
  readonly frequency: Numbers;
  readonly fields: Field[]; // the first one gives the phase of all
  readonly gap: [number, number] | null;
  readonly carrier: number | null;
  readonly drive: string; // " at 60 V"
  readonly firstIs: string; // what is at the line that is shown first
  readonly python: string; // expression for the result
  readonly parts: Drawing; // drawn over the map
  readonly modes: Mode[];
  readonly colours: number[][];
  readonly units: Unit[]; // of frequency

  constructor(readonly data: Dataset) {
    const { extra } = data.header;
    this.frequency = data.values("frequency");
    this.gap = extra["gap"] as [number, number] | null;
    this.carrier = extra["carrier"] as number | null;
    this.drive = String(extra["drive"]);
    this.firstIs = String(extra["first_is"]);
    this.python = String(extra["python"]);
    this.parts = extra as unknown as Drawing;
    this.colours = extra["colours"] as number[][];
    this.units = frequencyUnits(data);
    const places = placesOf(data);
    const [rows = 0, columns = 0] = data.shape(data.has("place") ? "place" : "present");
    this.fields = Object.entries(extra["maps"] as Record<string, string>).map(
      ([name, title]) => new Field(data, name, title, columns, rows, places, this.colours),
    );
    const has = data.has("mode_frequency");
    const [frequency, quality] = has ? [data.values("mode_frequency"), data.values("mode_quality")] : [[], []];
    this.modes = Array.from(frequency, (value, k) => ({
      frequency: value,
      name: data.texts("mode_name")[k] ?? "",
      quality: quality[k] ?? NaN,
    }));
  }

  /** True if the lines reach a frequency, or a part of an interval, Hz. */
  covers(low: number, high = low): boolean {
    return (this.frequency[0] ?? Infinity) <= high && low <= (this.frequency[this.frequency.length - 1] ?? -Infinity);
  }

  /** The line nearest to a frequency, Hz. */
  nearest(frequency: number): number {
    let best = 0;
    this.frequency.forEach((value, k) => {
      if (Math.abs(value - frequency) < Math.abs((this.frequency[best] ?? 0) - frequency)) best = k;
    });
    return best;
  }

  /** Line of the map that is shown first. */
  get first(): number {
    return this.nearest(Number(this.data.header.extra["first"]));
  }

  /** Largest displacement at a line, m, of a field or of all of them. */
  largest(line: number, fields = this.fields): number {
    return Math.max(...fields.map((field) => field.largest(line)));
  }

  /** Ends of the map, m: half a step beyond the outer points. */
  get extent(): { left: number; right: number; bottom: number; top: number } {
    const [x, y] = [this.data.values("x"), this.data.values("y")];
    const [across, up] = [half(x), half(y)];
    return {
      left: (x[0] ?? 0) - across,
      right: (x[x.length - 1] ?? 0) + across,
      bottom: (y[0] ?? 0) - up,
      top: (y[y.length - 1] ?? 0) + up,
    };
  }

  has(shown: Shown): boolean {
    return this.data.has(shown);
  }

  /** Velocities of the regions, or contrasts of the driven region, against frequency. */
  curves(shown: Shown): Curve[] {
    if (!this.data.has(shown)) return [];
    const values = this.data.values(shown);
    const names = this.data.texts(shown === "level" ? "region" : "pair");
    const count = this.frequency.length;
    return names.map((name, k) => ({
      name,
      values: Array.from(values.subarray(k * count, (k + 1) * count), (value) =>
        Number.isFinite(value) && (shown === "contrast" || value > 0) ? value : null,
      ),
    }));
  }
}

/** Number of the displacement that each place shows: as listed, or in their order where the plate is. */
function placesOf(data: Dataset): Int32Array {
  if (data.has("place")) return Int32Array.from(data.values("place"));
  return Int32Array.from(data.values("present"), (there, k) => (there === 0 ? -1 : k));
}

function half(middles: Numbers): number {
  return middles.length > 1 ? 0.5 * ((middles[1] ?? 0) - (middles[0] ?? 0)) : 0.5e-3;
}
