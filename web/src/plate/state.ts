/** What the user of a plate's response has chosen. */

import { signal, type Signal } from "@preact/signals";
import { startingPace, type Pace } from "../parts/cycle";
import { motionKey, type Key } from "../parts/keys";
import { listingKeys, type Listed } from "../parts/listing";
import { suitable, type Unit } from "../parts/units";
import type { PlateResponse, Shown } from "./plate_data";

const FAST = 10; // frequencies

export interface Choice extends Pace {
  line: Signal<number>; // number of the frequency, from 0
  shown: Signal<Shown>;
  plan: Signal<boolean>; // pillars and supports over the map
  common: Signal<boolean>; // one scale of colours for all maps
  unit: Signal<Unit>; // of frequency
  listing: Signal<Listed>;
}

export function startingChoice(plate: PlateResponse): Choice {
  return {
    line: signal(plate.first),
    shown: signal<Shown>(plate.has("level") ? "level" : "contrast"),
    plan: signal(false),
    common: signal(false),
    unit: signal(suitable(plate.units, Math.max(...plate.frequency))),
    ...startingPace(),
    listing: signal<Listed>("none"),
  };
}

export function plateKeys(plate: PlateResponse, choice: Choice): Key[] {
  const last = plate.frequency.length - 1;
  const walk = (by: number) => (choice.line.value = Math.min(Math.max(choice.line.value + by, 0), last));
  const steps = (event: KeyboardEvent) => (event.shiftKey ? FAST : 1);
  const lines = plate.modes.map(({ frequency }) => plate.nearest(frequency)).sort((a, b) => a - b);
  const jump = (line: number | undefined) => {
    if (line !== undefined) choice.line.value = line;
  };
  const { carrier } = plate;
  const modes: Key = {
    keys: "p n",
    effect: "previous or next mode near the carrier",
    actions: {
      p: () => jump(lines.filter((line) => line < choice.line.value).pop()),
      n: () => jump(lines.find((line) => line > choice.line.value)),
    },
  };
  const scale: Key = {
    keys: "s",
    effect: "one scale of colours for both maps, or one for each",
    actions: { s: () => (choice.common.value = !choice.common.value) },
  };
  return [
    {
      keys: "← →",
      effect: "previous or next frequency; ten with Shift",
      actions: { ArrowLeft: (event) => walk(-steps(event)), ArrowRight: (event) => walk(steps(event)) },
    },
    ...(lines.length > 0 ? [modes] : []),
    ...(carrier !== null ? [{ keys: "c", effect: "carrier", actions: { c: () => jump(plate.nearest(carrier)) } }] : []),
    { keys: "g", effect: plate.firstIs, actions: { g: () => jump(plate.first) } },
    ...(plate.fields.length > 1 ? [scale] : []),
    { keys: "l", effect: "pillars and supports", actions: { l: () => (choice.plan.value = !choice.plan.value) } },
    motionKey(choice),
    ...listingKeys(choice.listing),
  ];
}
