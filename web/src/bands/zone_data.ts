/** Bands over the Brillouin zone with the names that the view uses. */

import type { Dataset, Numbers } from "../dataset";
import { parityText } from "./diagram_data";
import type { Motion, Turn } from "./moving_mode";

export type Wavevector = [number, number]; // rad/m
type Triangle = [number, number, number];

const ROUND = [1, 2, 5, 10]; // steps of contours, times a power of ten
const ROUNDING = 1e-6; // relative, of lengths
const SIDEWAYS = 0.7; // cosine of the largest angle from a direction at which a wavevector counts as lying there

export class ZoneSurface {
  readonly bands: number;
  private readonly triangles: Triangle[];
  private readonly meshes = new Map<number, Triangle[]>(); // by band
  readonly corners: Record<string, Wavevector>; // of the irreducible zone
  readonly colours: number[][];
  readonly reach: number; // rad/m, largest component of a wavevector
  private readonly places: Numbers;
  private readonly samples: Numbers;
  private readonly frequency: Numbers;
  private readonly error: Numbers;

  constructor(private readonly data: Dataset) {
    this.places = data.values("zone_wavevector");
    this.samples = data.values("zone_sample");
    this.frequency = data.values("zone_frequency");
    this.error = data.values("zone_error");
    [, this.bands = 0] = data.shape("zone_frequency");
    const mesh = Array.from(data.values("zone_mesh"));
    this.triangles = Array.from({ length: mesh.length / 3 }, (_, k) => mesh.slice(3 * k, 3 * k + 3) as Triangle);
    this.corners = data.header.extra["zone"] as Record<string, Wavevector>;
    this.colours = data.header.extra["colours"] as number[][];
    this.reach = Math.max(...Array.from(this.places, Math.abs));
  }

  wavevector(image: number): Wavevector {
    return [this.places[2 * image] ?? NaN, this.places[2 * image + 1] ?? NaN];
  }

  sample(image: number): number {
    return this.samples[image] ?? 0;
  }

  phases(sample: number): [number, number] {
    const kappa = this.data.values("zone_kappa");
    return [kappa[2 * sample] ?? NaN, kappa[2 * sample + 1] ?? NaN];
  }

  at(sample: number, band: number): number {
    return this.frequency[sample * this.bands + band] ?? NaN;
  }

  errorAt(sample: number, band: number): number {
    return this.error[sample * this.bands + band] ?? NaN;
  }

  get hasModes(): boolean {
    return this.data.has("zone_mode_real");
  }

  /** The mode of a band at an image: that of its sample, turned or reflected like the wavevector. */
  motion(image: number, band: number): Motion {
    const [turn, isReversed] = this.turned(image);
    const [x, y] = this.wavevector(image);
    const vectors = this.data.header.extra["lattice_vectors"] as [Wavevector, Wavevector];
    const [first, second] = vectors.map(([ax, ay]) => x * ax + y * ay);
    return { of: "zone", row: this.sample(image), band, kappa: [first ?? 0, second ?? 0], turn, isReversed };
  }

  /** Group velocity at an image, m/s; undefined for a rigid-body motion. */
  velocity(image: number, band: number): Wavevector | undefined {
    const k = 2 * (this.sample(image) * this.bands + band);
    const [vx, vy] = [this.data.values("zone_velocity")[k] ?? NaN, this.data.values("zone_velocity")[k + 1] ?? NaN];
    const [[[xx, xy], [yx, yy]], isReversed] = this.turned(image);
    const sign = isReversed ? -1 : 1;
    return Number.isFinite(vx) && Number.isFinite(vy) ? [sign * (xx * vx + xy * vy), sign * (yx * vx + yy * vy)] : undefined;
  }

  /** Length of the error of the group velocity, m/s. */
  velocityError(image: number, band: number): number {
    return this.data.values("zone_velocity_error")[this.sample(image) * this.bands + band] ?? NaN;
  }

  /** Number of the motion of a mode, and its symmetry in words. */
  described(image: number, band: number): { motion: number | undefined; symmetry: string } {
    const sample = this.sample(image);
    const value = (name: string) => this.data.values(name)[sample * this.bands + band];
    const mirror = "the mirror of the wavevector";
    return { motion: value("zone_character"), symmetry: parityText(value("zone_parity"), mirror, value("zone_middle_parity")) };
  }

  /** Turn of the plane from a sample to an image, and whether time runs backwards there. */
  private turned(image: number): [Turn, boolean] {
    const copy = Math.floor(image / this.count);
    const turn = (this.data.header.extra["zone_turns"] as Turn[])[copy];
    if (turn === undefined) throw new Error(`the zone has no copy ${copy}`);
    return [turn, (this.data.header.extra["zone_signs"] as number[])[copy] === -1];
  }

  /** Triangles between the wavevectors; of each square, the diagonal along which the band changes less is their edge,
   *  so that a contour along it has no teeth. */
  mesh(band: number): Triangle[] {
    const known = this.meshes.get(band);
    if (known !== undefined) return known;
    const mesh = [...this.triangles];
    const change = (a: number, b: number) => Math.abs(this.at(this.sample(a), band) - this.at(this.sample(b), band));
    const length = (a: number, b: number) => Math.hypot(...[0, 1].map((k) => (this.wavevector(a)[k] ?? 0) - (this.wavevector(b)[k] ?? 0)));
    const beside = new Map<string, [number, number]>(); // edge -> its first triangle and the corner opposite to it
    const isTurned = new Set<number>();
    this.triangles.forEach((triangle, number) =>
      triangle.forEach((corner, k) => {
        const [a = 0, b = 0] = [triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
        const edge = `${Math.min(a, b)} ${Math.max(a, b)}`;
        const [other, opposite] = beside.get(edge) ?? [-1, -1];
        beside.set(edge, [number, corner]);
        if (other < 0 || isTurned.has(number) || isTurned.has(other)) return;
        if (length(corner, opposite) > (1 + ROUNDING) * length(a, b) || change(corner, opposite) >= change(a, b)) return;
        [mesh[number], mesh[other]] = [[corner, opposite, a], [corner, opposite, b]];
        isTurned.add(number).add(other);
      }),
    );
    this.meshes.set(band, mesh);
    return mesh;
  }

  range(band: number): [number, number] {
    const values = Array.from({ length: this.frequency.length / this.bands }, (_, sample) => this.at(sample, band));
    return [Math.min(...values), Math.max(...values)];
  }

  /** Round levels of a band, without those that lie within the errors of its lowest or highest frequency. */
  levels(band: number, count: number): number[] {
    const [low, high] = this.range(band);
    const errors = Array.from({ length: this.count }, (_, sample) => this.errorAt(sample, band));
    const error = Math.max(...errors);
    return levelsBetween(low, high, count).filter((level) => level - low > error && high - level > error);
  }

  /** Number of samples in the irreducible zone. */
  get count(): number {
    return this.frequency.length / this.bands;
  }

  /** The image of the sample with the highest frequency of a band. */
  highest(band: number): number {
    return this.all.reduce((best, image) => (this.at(this.sample(image), band) > this.at(this.sample(best), band) ? image : best), 0);
  }

  nearest([x, y]: Wavevector): number {
    const away = (image: number) => Math.hypot(this.wavevector(image)[0] - x, this.wavevector(image)[1] - y);
    return this.all.reduce((best, image) => (away(image) < away(best) ? image : best), 0);
  }

  /** The next wavevector in a direction; the same at the border of the zone. */
  next(image: number, toX: number, toY: number): number {
    const [x, y] = this.wavevector(image);
    let [best, least] = [image, Infinity];
    for (const other of this.all) {
      const [right, up] = [this.wavevector(other)[0] - x, this.wavevector(other)[1] - y];
      const away = Math.hypot(right, up);
      const ahead = (right * toX + up * toY) / away;
      if (away > 1e-9 * this.reach && ahead > SIDEWAYS && away / ahead ** 2 < least) [best, least] = [other, away / ahead ** 2];
    }
    return best;
  }

  /** Line segments on which a band has a frequency, linear in each triangle. */
  contour(band: number, level: number): [Wavevector, Wavevector][] {
    const segments: [Wavevector, Wavevector][] = [];
    for (const triangle of this.mesh(band)) {
      const ends: Wavevector[] = [];
      triangle.forEach((image, k) => {
        const other = triangle[(k + 1) % 3] ?? 0;
        const [from, to] = [this.at(this.sample(image), band), this.at(this.sample(other), band)];
        if (from < level === to < level) return;
        const share = (level - from) / (to - from);
        const [a, b] = [this.wavevector(image), this.wavevector(other)];
        ends.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
      });
      if (ends[0] && ends[1]) segments.push([ends[0], ends[1]]);
    }
    return segments;
  }

  private get all(): number[] {
    return Array.from(this.samples, (_, image) => image);
  }
}

/** Round levels within an interval. */
function levelsBetween(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [];
  const power = 10 ** Math.floor(Math.log10((high - low) / count));
  const step = power * (ROUND.find((factor) => factor * power * count >= high - low) ?? 10);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
}
