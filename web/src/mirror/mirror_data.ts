/** Numbers of a mirror with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import { frequencyUnits, type Unit } from "../parts/units";

export type Quantity = "loss" | "decay" | "phase";

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

  private curve(name: string, number: number): number[] {
    const count = this.frequency.length;
    return Array.from(this.data.values(name).subarray(number * count, (number + 1) * count));
  }
}

/** Values for a plot: null where there is none. */
export function plotted(values: number[]): (number | null)[] {
  return values.map((value) => (Number.isFinite(value) ? value : null));
}
