/** The table of views by kind, and their drawing into an element. */

import { render, type ComponentChildren } from "preact";
import { bandsView } from "./bands/view";
import type { Dataset } from "./dataset";
import { guidesView } from "./guide/view";
import { fingerView } from "./plate/finger";
import { frictionView } from "./friction/view";
import { mirrorView } from "./mirror/view";
import type { Host } from "./parts/host";
import { plateView, scanView } from "./plate/view";
import { readingView } from "./reading/view";
import { ribbonView } from "./ribbon/view";
import uplot from "uplot/dist/uPlot.min.css";
import style from "./style.css";

const VIEWS: Record<string, (data: Dataset, host?: Host) => ComponentChildren> = {
  bands: bandsView,
  layers: mirrorView,
  plate: plateView,
  scan: scanView,
  finger: fingerView,
  ribbon: ribbonView,
  friction: frictionView,
  reading: readingView,
  guides: guidesView,
};

/** Draw a view into an element, or newer data into the view that is there; the returned function removes it. */
export function show(data: Dataset, element: HTMLElement, host?: Host): () => void {
  const make = VIEWS[data.header.kind];
  if (make === undefined) throw new Error(`this version has no view "${data.header.kind}"`);
  addStyle();
  element.classList.add("haptonic", "view");
  render(make(data, host), element);
  return () => render(null, element);
}

/** Add the style of the views to the page, once; it concerns elements of class "haptonic", not the rest of a page. */
export function addStyle(): void {
  if (document.getElementById("haptonic-style") !== null) return;
  const sheet = document.createElement("style");
  sheet.id = "haptonic-style";
  sheet.textContent = `${uplot}:where(.haptonic) { ${style} }`; // specificity 0, so the studio can change it
  document.head.append(sheet);
}
