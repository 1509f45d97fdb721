/** Units of frequencies and wavevectors. A view may show each quantity in any of its units. */

import { signal } from "@preact/signals";
import type { Dataset } from "../dataset";

export interface Unit {
  name: string;
  factor: number; // of the SI unit
  relative?: boolean; // the name is the quantity itself, such as "ωa/(2πcₜ)"
}

const SI_PREFIXES: Unit[] = [
  { name: "Hz", factor: 1 },
  { name: "kHz", factor: 1e3 },
  { name: "MHz", factor: 1e6 },
];
const LONGEST = 1e4; // in its unit, the largest frequency has at most four digits before its point

/** Units that the view on the page has chosen, by the SI unit of their quantity. */
export const shownUnits = signal<Record<string, Unit>>({});

/** Units of frequency: with pitch a and the speed of shear waves of an isotropic plate, also ωa/(2πcₜ) = f a/cₜ. */
export function frequencyUnits(data: Dataset): Unit[] {
  const { pitch_m: pitch, shear_speed_m_per_s: speed } = data.header.attrs;
  if (typeof pitch !== "number" || typeof speed !== "number") return SI_PREFIXES;
  return [...SI_PREFIXES, { name: "ωa/(2πcₜ)", factor: speed / pitch, relative: true }];
}

/** The unit that suits a diagram up to a frequency, Hz. */
export function suitable(units: Unit[], largest: number): Unit {
  const fitting = units.find(({ factor, relative }) => !relative && largest < LONGEST * factor);
  return fitting ?? units[0]!;
}

/** Units of wavevectors for a period a, m. */
export function wavevectorUnits(period: number): Unit[] {
  return [
    { name: "rad/m", factor: 1 },
    { name: "π/a", factor: Math.PI / period },
    { name: "2π/a", factor: (2 * Math.PI) / period },
  ];
}

const WITH_PREFIX = /^[mN](?=$|\/)/; // metres and newtons, also per second or volt
const SMALLER: [string, number][] = [["", 1], ["m", 1e-3], ["µ", 1e-6], ["n", 1e-9]];

/** An SI unit with the prefix that leaves a digit before the point of the largest value. */
export function prefixed(name: string, largest: number): Unit {
  const fits = SMALLER.find(([, factor]) => WITH_PREFIX.test(name) && largest >= factor);
  const [prefix, factor] = fits ?? ["", 1];
  return { name: prefix + name, factor };
}

/** A number in its unit as a text: "52.1 kHz", or "ωa/(2πcₜ) = 0.117". */
export function withUnit(text: string, { name, relative }: Unit): string {
  return relative ? `${name} = ${text}` : `${text} ${name}`;
}

/** Title of an axis or a column. */
export function titled(title: string, { name, relative }: Unit): string {
  if (relative) return name;
  return `${title} / ${name.includes("/") ? `(${name})` : name}`;
}

/** A number without a bound of its error, with at most six digits. */
export function rounded(value: number): string {
  return `${Number(value.toPrecision(6))}`;
}
