/** Numbers of a band diagram with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import { frequencyUnits, wavevectorUnits, type Unit } from "../parts/units";

export interface Gap {
  below: number; // number of the band below, from 1
  lower: number;
  upper: number;
  lowerError: number;
  upperError: number;
  complete: boolean;
  direction: string;
  waves: string;
}

export interface Point {
  row: number; // number of the wavevector, from 0
  band: number; // number of the band, from 0
}

export class BandDiagram {
  readonly distance: Numbers;
  readonly frequency: Numbers;
  readonly error: Numbers;
  readonly rows: number;
  readonly bands: number;
  readonly gaps: Gap[];
  readonly corners: { label: string; row: number }[];
  readonly carrier: number | undefined;
  readonly top: number; // upper end of the axis of frequencies, Hz
  readonly units: Unit[]; // of frequency
  readonly pitch: number; // m
  readonly wavevectorUnits: Unit[];
  private readonly names: string[];

  constructor(readonly data: Dataset) {
    this.distance = data.values("distance");
    this.frequency = data.values("frequency");
    this.error = data.values("frequency_error");
    [this.rows = 0, this.bands = 0] = data.shape("frequency");
    this.names = data.parsed<string[]>("character_names");
    const labels = data.parsed<string[]>("path_labels");
    const rows = data.parsed<number[]>("path_corners");
    this.corners = labels.map((label, k) => ({ label, row: rows[k] ?? 0 }));
    const carrier = data.header.attrs["carrier_hz"];
    this.carrier = typeof carrier === "number" ? carrier : undefined;
    this.top = Number(data.header.extra["top"]);
    this.units = frequencyUnits(data);
    this.pitch = pitchOf(data);
    this.wavevectorUnits = wavevectorUnits(this.pitch);
    this.gaps = readGaps(data);
  }

  /** Frequencies along each branch, a row for each wavevector, null where the branch has no mode. */
  branches(): (number | null)[][] {
    const branch = this.data.values("branch");
    const curves = new Map<number, (number | null)[]>();
    branch.forEach((number, k) => {
      const curve = curves.get(number) ?? Array<number | null>(this.rows).fill(null);
      curve[Math.floor(k / this.bands)] = this.frequency[k] ?? null;
      curves.set(number, curve);
    });
    return [...curves.values()];
  }

  at({ row, band }: Point): number {
    return this.frequency[row * this.bands + band] ?? NaN;
  }

  errorAt({ row, band }: Point): number {
    return this.error[row * this.bands + band] ?? NaN;
  }

  /** Name of a mode after its motion. */
  nature({ row, band }: Point): string {
    return this.motion(this.data.values("character")[row * this.bands + band]);
  }

  /** Name of the motion of a number. */
  motion(number: number | undefined): string {
    return this.names[number ?? -1] ?? "";
  }

  /** Behaviour of a mode under the mirrors, in words; empty without a mirror. */
  parity({ row, band }: Point): string {
    const k = row * this.bands + band;
    return parityText(this.data.values("parity")[k], "the mirror of the path", this.data.values("middle_parity")[k]);
  }

  /** Group velocity along x and y, m/s; undefined for a rigid-body motion. */
  velocity({ row, band }: Point): [number, number] | undefined {
    const values = this.data.values("group_velocity");
    const k = 2 * (row * this.bands + band);
    const [x, y] = [values[k] ?? NaN, values[k + 1] ?? NaN];
    return Number.isFinite(x) && Number.isFinite(y) ? [x, y] : undefined;
  }

  /** Length of the error of the group velocity, m/s; undefined in runs of earlier versions. */
  velocityError({ row, band }: Point): number | undefined {
    return this.data.has("group_velocity_error") ? this.data.values("group_velocity_error")[row * this.bands + band] : undefined;
  }

  /** Phases k . a1 and k . a2 of a wavevector, rad. */
  phases(row: number): [number, number] {
    const kappa = this.data.values("kappa");
    return [kappa[2 * row] ?? 0, kappa[2 * row + 1] ?? 0];
  }

  /** Name of a wavevector as `--modes-at` takes it: a corner, or a share of a segment. */
  place(row: number): string {
    const corner = this.corners.find((each) => each.row === row);
    if (corner !== undefined) return corner.label;
    const after = this.corners.findIndex((each) => each.row > row);
    const [start, stop] = [this.corners[after - 1], this.corners[after]];
    if (start === undefined || stop === undefined) return "";
    const share = (row - start.row) / (stop.row - start.row);
    return `${Number(share.toFixed(3))} of ${start.label}-${stop.label}`;
  }

  /** The mode nearest to the lower edge of a gap. */
  belowGap(gap: Gap): Point {
    const band = gap.below - 1;
    let best = 0;
    for (let row = 1; row < this.rows; row++)
      if (this.at({ row, band }) > this.at({ row: best, band })) best = row;
    return { row: best, band };
  }
}

/** Pitch of the lattice of a dataset of bands, m. */
export const pitchOf = (data: Dataset): number => Number(data.header.attrs["pitch_m"]);

/** Gaps of a dataset of bands. */
export function readGaps(data: Dataset): Gap[] {
  if (!data.has("gap_below")) return [];
  const numbers = (name: string) => data.values(name);
  return Array.from(numbers("gap_below"), (below, k) => ({
    below,
    lower: numbers("gap_lower")[k] ?? NaN,
    upper: numbers("gap_upper")[k] ?? NaN,
    lowerError: numbers("gap_lower_error")[k] ?? NaN,
    upperError: numbers("gap_upper_error")[k] ?? NaN,
    complete: numbers("gap_complete")[k] === 1,
    direction: data.texts("gap_direction")[k] ?? "",
    waves: data.texts("gap_waves")[k] ?? "",
  }));
}

/** Parities, 1 or -1, under a mirror and about the middle plane; any other number stands for no mirror. */
export function parityText(sign: number | undefined, mirror: string, middle: number | undefined): string {
  const under = ["even", "odd"][signIndex(sign)];
  const about = ["symmetric", "antisymmetric"][signIndex(middle)];
  return [under && `${under} under ${mirror}`, about && `${about} about the plate's middle plane`]
    .filter(Boolean)
    .join(", ");
}

function signIndex(sign: number | undefined): number {
  return sign === 1 ? 0 : sign === -1 ? 1 : -1;
}
