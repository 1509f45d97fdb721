/** What a page that can compute adds to a view: a number that the user turns, and the numbers of the design. */

import type { ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { Dataset } from "../dataset";

/** Numbers of a design that is newer than that of the view; each part is null until it is computed. */
export interface Turned {
  certified: Dataset | null; // curves, at first without gaps
  preview: Dataset | null;
  at: number; // value of the number along the preview, SI
}

export interface Host {
  turned: ReadonlySignal<Turned | null>; // null while the design is that of the view
  controls: ComponentChildren;
  design: () => Record<string, string>; // values of the numbers that can be turned, by their titles, as drawn
}
