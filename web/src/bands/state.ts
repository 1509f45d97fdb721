/** What the user of a band diagram has chosen. */

import { signal, type Signal } from "@preact/signals";
import { startingPace, type Pace } from "../parts/cycle";
import type { Listed } from "../parts/listing";
import { suitable, type Unit } from "../parts/units";
import type { BandDiagram, Point } from "./diagram_data";
import type { Held } from "./edges";
import type { Layer } from "./layer";

export const MOST_COPIES = 6;
export const LARGEST_SWING = 0.5; // of the period

export interface Choice extends Pace {
  point: Signal<Point>;
  swing: Signal<number>; // largest drawn displacement, as a share of the period
  copies: Signal<[number, number]>; // cells along a1 and a2
  unit: Signal<Unit>;
  wavevectorUnit: Signal<Unit>;
  listing: Signal<Listed>;
  held: Signal<(Held & { layer: Layer }) | null>; // a design to compare with
}

export function startingChoice(diagram: BandDiagram): Choice {
  const gap = diagram.gaps[0];
  return {
    point: signal(gap ? diagram.belowGap(gap) : { row: diagram.corners[1]?.row ?? 0, band: 0 }),
    ...startingPace(),
    swing: signal(0.15),
    copies: signal<[number, number]>([2, 2]),
    unit: signal(suitable(diagram.units, Math.max(...diagram.frequency))),
    wavevectorUnit: signal(diagram.wavevectorUnits[1]!),
    listing: signal<Listed>("none"),
    held: signal(null),
  };
}

export function moved(diagram: BandDiagram, { row, band }: Point, along: number, up: number): Point {
  return {
    row: Math.min(Math.max(row + along, 0), diagram.rows - 1),
    band: Math.min(Math.max(band + up, 0), diagram.bands - 1),
  };
}

/** The lower edge of the gap after that of the current band, the first after the last. */
export function nextGap(diagram: BandDiagram, { band }: Point): Point | undefined {
  const gaps = [...diagram.gaps].filter((gap) => gap.waves === "all").sort((a, b) => a.below - b.below);
  const next = gaps.find((gap) => gap.below - 1 > band) ?? gaps[0];
  return next && diagram.belowGap(next);
}
