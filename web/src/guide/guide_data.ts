/** Numbers of waveguides between two mirrors with the names that the view uses. */

import type { Dataset } from "../dataset";
import type { FieldGrid, FieldPart, FieldWave } from "../parts/field";
import { frequencyUnits, type Unit } from "../parts/units";

const DRAWN = 12; // periods along the strip

export class Waveguides {
  readonly count: number;
  readonly best: number; // the one nearest to the carrier
  readonly mode: string; // nodal lines across and intervals along, such as "0x17"
  readonly ends: string;
  readonly frequencyError: number; // relative, of the lattice
  readonly units: Unit[]; // of frequency
  readonly fields: { grid: FieldGrid; part: FieldPart };
  readonly period: number; // m, along the strip

  constructor(readonly data: Dataset) {
    const { extra, attrs } = data.header;
    [this.count = 0] = data.shape("frequency");
    this.best = Number(extra["best"]);
    this.mode = String(attrs["mode"]);
    this.ends = String(attrs["ends"]);
    this.frequencyError = Number(attrs["relative_frequency_error"]);
    this.units = frequencyUnits(data);
    this.period = Number(attrs["period"]);
    const [, across = 0, along = 0] = data.shape("mode_real");
    const [first = 0, second = 0] = data.values("across");
    this.fields = {
      grid: {
        real: data.values("mode_real"),
        imag: data.values("mode_imag"),
        present: data.values("present"),
        across,
        along,
        width: (second - first) * across,
        length: this.period,
        colours: extra["colours"] as number[][],
      },
      part: { periods: DRAWN },
    };
  }

  value(name: string, guide: number): number {
    return this.data.values(name)[guide] ?? NaN;
  }

  wave(guide: number): FieldWave {
    const half = (0.5 * this.value("width", guide)) / this.fields.grid.width;
    return { number: guide, phase: this.value("phase", guide), decay: 0, edges: [0.5 - half, 0.5 + half] };
  }

  /** Root mean square of the displacement over a period, from one side to the other, its peak 1. */
  profile(guide: number): { position: number[]; size: number[] } {
    const { real, imag, across, along } = this.fields.grid;
    const size = Array.from({ length: across }, (_, row) => {
      const start = (guide * across + row) * along;
      let sum = 0;
      for (let k = start; k < start + along; k++) sum += (real[k] ?? 0) ** 2 + (imag[k] ?? 0) ** 2;
      return Math.sqrt(sum);
    });
    const peak = Math.max(...size);
    return { position: Array.from(this.data.values("across")), size: size.map((value) => value / peak) };
  }
}
