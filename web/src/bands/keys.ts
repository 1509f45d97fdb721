/** The keys of the view of bands. */

import { motionKey, type Key } from "../parts/keys";
import { listingKeys } from "../parts/listing";
import type { BandDiagram } from "./diagram_data";
import { LARGEST_SWING, moved, nextGap, type Choice } from "./state";

const FAST = 10; // wavevectors
const STEP = 0.05; // of the displacement

export function bandsKeys(diagram: BandDiagram, choice: Choice, hold?: () => void): Key[] {
  const walk = (along: number, up: number) => (choice.point.value = moved(diagram, choice.point.value, along, up));
  const grow = (by: number) =>
    (choice.swing.value = Math.min(Math.max(choice.swing.value + by, 0), LARGEST_SWING));
  const steps = (event: KeyboardEvent) => (event.shiftKey ? FAST : 1);
  return [
    {
      keys: "← →",
      effect: "previous or next wavevector; ten with Shift",
      actions: { ArrowLeft: (event) => walk(-steps(event), 0), ArrowRight: (event) => walk(steps(event), 0) },
    },
    {
      keys: "↑ ↓",
      effect: "next higher or lower band",
      actions: { ArrowUp: () => walk(0, 1), ArrowDown: () => walk(0, -1) },
    },
    motionKey(choice),
    {
      keys: "+ −",
      effect: "larger or smaller displacement",
      actions: { "+": () => grow(STEP), "-": () => grow(-STEP) },
    },
    {
      keys: "g",
      effect: "lower edge of the next gap",
      actions: { g: () => (choice.point.value = nextGap(diagram, choice.point.value) ?? choice.point.value) },
    },
    ...(hold ? [{ keys: "h", effect: "hold this design, or let it go", actions: { h: hold } }] : []),
    ...listingKeys(choice.listing),
  ];
}
