/** Numbers of a mirror with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import type { FieldGrid, FieldPart, FieldWave } from "../parts/field";
import { frequencyUnits, type Unit } from "../parts/units";

const DRAWN = 6; // rows
const REPEATS = 2; // periods along the rows
const DIRECTIONS = ["across the rows", "along the rows", "normal to the plate"];

export class Mirror {
  readonly frequency: Numbers;
  readonly rows: Numbers; // numbers of rows
  readonly incident: string[]; // kinds of incident waves that propagate at some frequency
  readonly waves: number; // of the lattice at each frequency
  readonly carrier: number;
  readonly gap: [number, number] | null;
  readonly units: Unit[]; // of frequency
  private readonly kinds: string[];

  constructor(readonly data: Dataset) {
    this.frequency = data.values("frequency");
    this.rows = data.values("rows");
    this.kinds = data.texts("incident");
    this.incident = this.kinds.filter((kind) => this.losses(kind).flat().some(Number.isFinite));
    [this.waves = 0] = data.shape("decay");
    this.carrier = Number(data.header.extra["carrier"]);
    this.gap = data.header.extra["gap"] as [number, number] | null;
    this.units = frequencyUnits(data);
  }

  nearest(frequency: number): number {
    const away = Array.from(this.frequency, (value) => Math.abs(value - frequency));
    return away.indexOf(Math.min(...away));
  }

  /** Insertion losses, or their errors, by number of rows and frequency, dB. */
  losses(kind: string, name: "loss" | "loss_error" = "loss"): number[][] {
    const first = this.kinds.indexOf(kind) * this.rows.length;
    return Array.from(this.rows, (_, k) => this.curve(name, first + k));
  }

  /** Decay (dB per row) or phase (π) of each wave of the lattice at each frequency, or their errors. */
  ofWaves(name: "decay" | "phase" | "decay_error" | "phase_error"): number[][] {
    return Array.from({ length: this.waves }, (_, wave) => this.curve(name, wave));
  }

  get hasFields(): boolean {
    return this.data.has("wave_real");
  }

  /** Fields of the waves, and the part of the rows that is drawn. */
  get fields(): { grid: FieldGrid; part: FieldPart } {
    const { data } = this;
    const [, , across = 0, along = 0] = data.shape("wave_real");
    const [high, wide] = [spacing(data.values("across")), spacing(data.values("along"))];
    const values = { real: data.values("wave_real"), imag: data.values("wave_imag"), present: data.values("present") };
    const colours = data.header.extra["colours"] as number[][];
    const slip = data.values("slab_slip")[0] ?? 0;
    return {
      grid: { ...values, across, along, width: high * across, length: wide * along, colours },
      part: { periods: Math.ceil(DRAWN / (data.values("slab_rows")[0] ?? 1)), repeats: REPEATS, slip },
    };
  }

  /** The field of a wave of the lattice at a frequency. */
  field(wave: number, line: number): FieldWave {
    const number = wave * this.frequency.length + line;
    return {
      number,
      phase: this.data.values("slab_phase")[number] ?? 0,
      decay: this.data.values("slab_decay")[number] ?? 0,
    };
  }

  direction(wave: number, line: number): string {
    return DIRECTIONS[this.data.values("wave_component")[wave * this.frequency.length + line] ?? 2] ?? "";
  }

  private curve(name: string, number: number): number[] {
    const count = this.frequency.length;
    return Array.from(this.data.values(name).subarray(number * count, (number + 1) * count));
  }
}

/** Values for a plot: null where there is none. */
export function plotted(values: number[]): (number | null)[] {
  return values.map((value) => (Number.isFinite(value) ? value : null));
}

function spacing(positions: Numbers): number {
  return (positions[1] ?? 0) - (positions[0] ?? 0);
}
