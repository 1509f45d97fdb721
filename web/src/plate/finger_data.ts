/** Numbers of a finger on a vibrating plate, with the law of friction that `haptonic.friction` tabulates. */

import type { Dataset, Numbers } from "../dataset";
import type { Drawing, Point } from "../parts/plan";

export type End = "value" | "low" | "high";
export const ENDS: End[] = ["value", "low", "high"];

interface Drive {
  title: string;
  unit: string;
  value: number;
  low: number;
  high: number;
}

export interface Parameter {
  title: string;
  value: string;
  plausible: string;
  mark: string;
  source: string;
}

interface Extra extends Drawing {
  weber: number; // reduction that is just noticed
  frequency: number; // Hz
  diameter: number; // of the finger, m
  drive: Drive;
  force: number; // of the study, N
  speed: number;
  parameters: Parameter[];
  models: Record<string, string>; // where each is valid
  colours: number[][];
}

/** μ/μ₀ at the amplitudes of the tables, for one force and one speed. */
export type Law = Record<End, Float64Array>;

export class FingerData {
  readonly extra: Extra;
  readonly forces: Numbers;
  readonly speeds: Numbers;
  readonly amplitudes: Numbers; // of the tables, m
  readonly x: Numbers;
  readonly y: Numbers;
  readonly columns: number[]; // different x and y of the places, ascending
  readonly rows: number[];
  private readonly cells: Int32Array; // number of the place by row and column, -1 without one

  constructor(readonly data: Dataset) {
    this.extra = data.header.extra as unknown as Extra;
    this.forces = data.values("force");
    this.speeds = data.values("speed");
    this.amplitudes = data.values("table");
    this.x = data.values("x");
    this.y = data.values("y");
    this.columns = [...new Set(this.x)].sort((a, b) => a - b);
    this.rows = [...new Set(this.y)].sort((a, b) => a - b);
    this.cells = new Int32Array(this.columns.length * this.rows.length).fill(-1);
    const [column, row] = [this.columns, this.rows].map((lines) => new Map(lines.map((line, k) => [line, k])));
    this.x.forEach((x, k) => {
      this.cells[(row?.get(this.y[k] ?? 0) ?? 0) * this.columns.length + (column?.get(x) ?? 0)] = k;
    });
  }

  get count(): number {
    return this.x.length;
  }

  /** The place in a row and a column; null without one. */
  placeIn(row: number, column: number): number | null {
    if (column < 0 || column >= this.columns.length) return null;
    const place = this.cells[row * this.columns.length + column] ?? -1;
    return place < 0 ? null : place;
  }

  nearest([x, y]: Point): number {
    let [best, least] = [0, Infinity];
    for (let k = 0; k < this.count; k++) {
      const away = ((this.x[k] ?? 0) - x) ** 2 + ((this.y[k] ?? 0) - y) ** 2;
      if (away < least) [best, least] = [k, away];
    }
    return best;
  }

  /** The next place in a direction; the same place at the end of the plate. */
  beside(place: number, right: number, up: number): number {
    const [row, column] = [this.rows.indexOf(this.y[place] ?? 0), this.columns.indexOf(this.x[place] ?? 0)];
    return this.placeIn(row + up, column + right) ?? place;
  }

  region(place: number): string {
    return this.data.texts("region")[place] || "a lattice";
  }

  /** Amplitude below the finger, m: for the damping of its value, its low or its high end, or without a finger. */
  amplitude(place: number, load: End | "free", drive: number): number {
    const row = this.data.texts("load").indexOf(load);
    return drive * (this.data.values("amplitude")[row * this.count + place] ?? 0);
  }

  /** Law of a force and a speed, given by their numbers; joined as `FrictionLaw.of` does. */
  law(force: number, speed: number): Law {
    const count = this.amplitudes.length;
    const names = this.data.texts("end");
    const rows = (name: string, number: number) => {
      const values = this.data.values(name);
      return (end: End) => {
        const start = (number * names.length + names.indexOf(end)) * count;
        return values.subarray(start, start + count);
      };
    };
    const [shared, intermittent] = [rows("load_sharing", force), rows("intermittent", speed)];
    const own = [shared("value"), intermittent("value")];
    const outermost = (end: End, most: (...values: number[]) => number) => {
      const ends = [shared(end), intermittent(end), ...own];
      return Float64Array.from(ends[0] ?? [], (_, k) => {
        const known = ends.map((values) => values[k] ?? NaN).filter((value) => !Number.isNaN(value));
        return known.length > 0 ? most(...known) : NaN;
      });
    };
    const value = Float64Array.from(own[0] ?? [], (first, k) => (Number.isNaN(first) ? (own[1]?.[k] ?? NaN) : first));
    return { value, low: outermost("low", Math.min), high: outermost("high", Math.max) };
  }

  /** μ/μ₀ at an amplitude, m; constant outside the tables. */
  friction(values: Float64Array, amplitude: number): number {
    const [first = 1, last = 1] = [this.amplitudes[0], this.amplitudes.at(-1)];
    const most = values.length - 1;
    const share = (Math.log(Math.max(amplitude, first) / first) / Math.log(last / first)) * most;
    const k = Math.min(Math.floor(share), most - 1);
    const within = Math.min(share - k, 1);
    return (values[k] ?? NaN) * (1 - within) + (values[k + 1] ?? NaN) * within;
  }
}

/** What people feel of a reduction with its interval. */
export function noticed(reduction: Record<End, number>, threshold: number): string {
  if (reduction.low > threshold) return "noticed, also at the lower limit";
  if (reduction.value > threshold) return "probably noticed, but not at the lower limit";
  if (reduction.high > threshold) return "probably not noticed, except at the upper limit";
  return "not noticed, even at the upper limit";
}
