/** The keys of the view. */

import type { BandDiagram } from "./diagram_data";
import { LARGEST_SWING, moved, nextGap, type Choice } from "./state";

export const KEYS: [string, string][] = [
  ["← →", "previous or next wavevector; ten with Shift"],
  ["↑ ↓", "next higher or lower band"],
  ["space", "move or stop"],
  ["+ −", "larger or smaller displacement"],
  ["g", "lower edge of the next gap"],
  ["t", "tables"],
  ["?", "this list"],
];
const FAST = 10; // wavevectors
const STEP = 0.05; // of the displacement

/** Elements that use the arrow keys, the space bar or letters themselves. */
const OWN = "input, select, textarea, button, summary, a";

export function keyPressed(event: KeyboardEvent, diagram: BandDiagram, choice: Choice): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if ((event.target as HTMLElement).closest(OWN) !== null && !["?", "g", "t"].includes(event.key)) return;
  if ((event.target as HTMLElement).closest("input, textarea, select") !== null) return;
  const walk = (along: number, up: number) => (choice.point.value = moved(diagram, choice.point.value, along, up));
  const grow = (by: number) =>
    (choice.swing.value = Math.min(Math.max(choice.swing.value + by, 0), LARGEST_SWING));
  const list = (which: "keys" | "table") =>
    (choice.listing.value = choice.listing.value === which ? "none" : which);
  const fast = event.shiftKey ? FAST : 1;
  const actions: Record<string, () => void> = {
    ArrowLeft: () => walk(-fast, 0),
    ArrowRight: () => walk(fast, 0),
    ArrowUp: () => walk(0, 1),
    ArrowDown: () => walk(0, -1),
    " ": () => (choice.playing.value = !choice.playing.value),
    "+": () => grow(STEP),
    "-": () => grow(-STEP),
    g: () => (choice.point.value = nextGap(diagram, choice.point.value) ?? choice.point.value),
    t: () => list("table"),
    "?": () => list("keys"),
  };
  const action = actions[event.key];
  if (action === undefined) return;
  event.preventDefault();
  action();
}
