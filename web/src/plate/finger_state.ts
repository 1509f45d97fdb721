/** Place of the finger, drive, force and speed, and what follows from them. */

import { computed, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { Key } from "../parts/keys";
import { listingKeys, type Listed } from "../parts/listing";
import { ENDS, type End, type FingerData, type Law } from "./finger_data";

const FAR = 5; // places with Shift
const FINER = 1.05; // factor of the drive for a key

export interface Finger {
  place: Signal<number>;
  drive: Signal<number>; // V or N
  force: Signal<number>; // number among the forces
  speed: Signal<number>;
  listing: Signal<Listed>;
  law: ReadonlySignal<Law>;
  below: ReadonlySignal<Felt>;
}

/** What is below the finger. */
export interface Felt {
  amplitude: Record<End, number>; // m
  free: number; // m, without a finger
  friction: Record<End, number>;
  reduction: Record<End, number>;
}

export function startingFinger(data: FingerData): Finger {
  const { drive, force, speed } = data.extra;
  const place = signal(loudest(data));
  const chosen = { drive: signal(drive.value), force: signal(data.forces.indexOf(force)), speed: signal(data.speeds.indexOf(speed)) };
  if (chosen.force.peek() < 0) chosen.force.value = 0;
  const law = computed(() => data.law(chosen.force.value, chosen.speed.value));
  const below = computed(() => feltAt(data, law.value, place.value, chosen.drive.value));
  return { place, ...chosen, listing: signal<Listed>("none"), law, below };
}

/** The place with the largest amplitude at which the whole finger lies within the map, if there is one. */
function loudest(data: FingerData): number {
  const radius = data.extra.diameter / 2;
  const isInside = (value: number, lines: number[]) => value - radius >= (lines[0] ?? 0) && value + radius <= (lines.at(-1) ?? 0);
  let [best, most] = [0, -1];
  for (let k = 0; k < data.count; k++) {
    const amplitude = data.amplitude(k, "value", 1);
    const inside = isInside(data.x[k] ?? 0, data.columns) && isInside(data.y[k] ?? 0, data.rows);
    if (amplitude > most && inside) [best, most] = [k, amplitude];
  }
  return best;
}

/** Amplitude and friction at a place; the least friction is with the least damping, as `FrictionOnPlate` has it. */
export function feltAt(data: FingerData, law: Law, place: number, drive: number): Felt {
  const of = (value: (end: End) => number) =>
    Object.fromEntries(ENDS.map((end) => [end, value(end)])) as Record<End, number>;
  const amplitude = of((end) => data.amplitude(place, end, drive));
  const friction = of((end) => data.friction(law[end], amplitude[end]));
  return {
    amplitude,
    free: data.amplitude(place, "free", drive),
    friction,
    reduction: { value: 1 - friction.value, low: 1 - friction.high, high: 1 - friction.low },
  };
}

export function fingerKeys(data: FingerData, finger: Finger): Key[] {
  const walk = (right: number, up: number) => (event: KeyboardEvent) => {
    for (let step = 0; step < (event.shiftKey ? FAR : 1); step++)
      finger.place.value = data.beside(finger.place.peek(), right, up);
  };
  const { low, high } = data.extra.drive;
  const drive = (factor: number) => () =>
    (finger.drive.value = Math.min(Math.max(finger.drive.peek() * factor, low), high));
  const pick = (chosen: Signal<number>, by: number, count: number) => () =>
    (chosen.value = Math.min(Math.max(chosen.peek() + by, 0), count - 1));
  const [forces, speeds] = [data.forces.length, data.speeds.length];
  return [
    {
      keys: "← → ↑ ↓",
      effect: "move the finger; five places with Shift",
      actions: { ArrowLeft: walk(-1, 0), ArrowRight: walk(1, 0), ArrowUp: walk(0, 1), ArrowDown: walk(0, -1) },
    },
    { keys: "+ −", effect: "5 % more or less drive", actions: { "+": drive(FINER), "-": drive(1 / FINER) } },
    {
      keys: "f F",
      effect: "more or less force",
      actions: { f: pick(finger.force, 1, forces), F: pick(finger.force, -1, forces) },
    },
    {
      keys: "s S",
      effect: "faster or slower",
      actions: { s: pick(finger.speed, 1, speeds), S: pick(finger.speed, -1, speeds) },
    },
    ...listingKeys(finger.listing),
  ];
}
