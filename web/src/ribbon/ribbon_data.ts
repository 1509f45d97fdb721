/** Numbers of a ribbon with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import type { FieldGrid, FieldPart, FieldWave } from "../parts/field";
import { uncertain } from "../parts/numbers";
import { frequencyUnits, wavevectorUnits, type Unit } from "../parts/units";

const LONG = 1.6; // length of the drawn part over its width
const MOST = 30; // periods
const DIRECTIONS = ["across the ribbon", "along the ribbon", "normal to the plate"];

export class RibbonModes {
  readonly frequency: Numbers;
  readonly error: Numbers;
  readonly phase: Numbers; // rad per period
  readonly velocity: Numbers; // group velocity, m/s
  readonly share: Numbers; // of the energy in the guide
  readonly phases: Numbers; // at which modes were computed, rad
  readonly period: number; // m
  readonly range: [number, number]; // Hz
  readonly carrier: number | null;
  readonly place: string; // where `share` counts the energy
  readonly units: Unit[]; // of frequency
  readonly wavevectorUnits: Unit[];
  readonly shares: number[][]; // colours of the share
  /** Modes at each phase, lowest first. */
  private readonly atPhase: number[][];

  constructor(readonly data: Dataset) {
    const { extra, attrs } = data.header;
    this.frequency = data.values("frequency");
    this.error = data.values("frequency_error");
    this.phase = data.values("phase");
    this.velocity = data.values("group_velocity");
    this.share = data.values("guide_share");
    this.phases = data.values("wavevector_phase");
    this.period = Number(attrs["period"]);
    this.range = extra["range"] as [number, number];
    this.carrier = extra["carrier"] as number | null;
    this.place = attrs["kind"] === "strip" ? "the outermost columns" : `the ${attrs["kind"]}`;
    this.units = frequencyUnits(data);
    this.wavevectorUnits = wavevectorUnits(this.period);
    this.shares = extra["shares"] as number[][];
    this.atPhase = Array.from(this.phases, (phase) =>
      this.all.filter((mode) => this.phase[mode] === phase).sort((a, b) => this.at(a) - this.at(b)),
    );
  }

  get all(): number[] {
    return Array.from(this.frequency, (_, mode) => mode);
  }

  get hasFields(): boolean {
    return this.data.has("mode_real");
  }

  /** Fields of the modes, and the part of the ribbon that is drawn. */
  get fields(): { grid: FieldGrid; part: FieldPart } {
    const { data, period } = this;
    const [, across = 0, along = 0] = data.shape("mode_real");
    const position = data.values("across");
    const width = ((position[1] ?? 0) - (position[0] ?? 0)) * across;
    const values = { real: data.values("mode_real"), imag: data.values("mode_imag"), present: data.values("present") };
    return {
      grid: { ...values, across, along, width, length: period, colours: data.header.extra["colours"] as number[][] },
      part: { periods: Math.min(MOST, Math.max(2, Math.round((LONG * width) / period))) },
    };
  }

  wave(mode: number): FieldWave {
    return { number: mode, phase: this.phase[mode] ?? 0, decay: 0 };
  }

  at(mode: number): number {
    return this.frequency[mode] ?? NaN;
  }

  wavevector(mode: number): number {
    return (this.phase[mode] ?? 0) / this.period;
  }

  isGuided(mode: number): boolean {
    return this.data.values("guided")[mode] === 1;
  }

  /** Decay with its error, dB per row; empty without one. */
  decay(mode: number): string {
    const [decay, error] = ["decay", "decay_error"].map((name) => this.data.values(name)[mode] ?? NaN) as [number, number];
    return Number.isFinite(decay) ? uncertain(decay, error) : "";
  }

  /** Group velocity with its error, m/s. */
  speed(mode: number): string {
    return uncertain(this.velocity[mode] ?? NaN, this.data.values("group_velocity_error")[mode] ?? NaN);
  }

  direction(mode: number): string {
    return DIRECTIONS[this.data.values("mode_component")[mode] ?? 2] ?? "";
  }

  /** The guided mode nearest to the carrier, or to the middle of the range. */
  get first(): number {
    const [low, high] = this.range;
    const target = this.carrier !== null && this.carrier > low && this.carrier < high ? this.carrier : (low + high) / 2;
    const guided = this.all.filter((mode) => this.isGuided(mode));
    return nearest(guided.length > 0 ? guided : this.all, (mode) => this.at(mode), target);
  }

  /** Modes at the phase of a mode, lowest first. */
  beside(mode: number): number[] {
    return this.atPhase[this.row(mode)] ?? [];
  }

  /** The mode next in frequency at a phase some steps away. */
  moved(mode: number, along: number, up: number): number {
    const here = this.beside(mode);
    if (up !== 0) return here[Math.min(Math.max(here.indexOf(mode) + up, 0), here.length - 1)] ?? mode;
    const filled = this.atPhase.map((_, row) => row).filter((row) => (this.atPhase[row] ?? []).length > 0);
    const place = Math.min(Math.max(filled.indexOf(this.row(mode)) + along, 0), filled.length - 1);
    return nearest(this.atPhase[filled[place] ?? 0] ?? [], (other) => this.at(other), this.at(mode));
  }

  /** Guided modes in the order of phase and frequency. */
  get guided(): number[] {
    return this.atPhase.flat().filter((mode) => this.isGuided(mode));
  }

  /** Lower and upper edges over the phases of each bulk band of each crystal, Hz. */
  bulk(): { crystal: number; lower: number[]; upper: number[] }[] {
    const [crystals = 0, rows = 0, bands = 0] = this.data.shape("bulk_lower");
    const [lower, upper] = [this.data.values("bulk_lower"), this.data.values("bulk_upper")];
    return Array.from({ length: crystals * bands }, (_, k) => {
      const [crystal, band] = [Math.floor(k / bands), k % bands];
      const edge = (values: Numbers) =>
        Array.from({ length: rows }, (_, row) => values[(crystal * rows + row) * bands + band] ?? NaN);
      return { crystal, lower: edge(lower), upper: edge(upper) };
    });
  }

  private row(mode: number): number {
    return Array.from(this.phases).indexOf(this.phase[mode] ?? NaN);
  }
}

function nearest(modes: number[], value: (mode: number) => number, target: number): number {
  return modes.reduce((best, mode) => (Math.abs(value(mode) - target) < Math.abs(value(best) - target) ? mode : best), modes[0] ?? 0);
}
