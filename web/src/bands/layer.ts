/** Curves and gaps of another design than that of the view: a preview, a certified result, a held design. */

import { computed, type ReadonlySignal } from "@preact/signals";
import type { Dataset, Numbers } from "../dataset";
import type { Turned } from "../parts/host";
import { pitchOf, readGaps, type BandDiagram, type Gap } from "./diagram_data";

const TOO_FAR = 0.2; // relative error from which a preview is not shown
const LEAST = 0.1; // of the highest frequency; below it, errors are compared with this share

export interface Layer {
  isPreview: boolean;
  areGapsPreview: boolean; // also of certified curves, until their gaps are certified
  distance: ArrayLike<number>; // length of the path up to each wavevector, rad/m
  pitch: number; // m
  frequency: ArrayLike<number>; // of each band at each wavevector, Hz
  error: ArrayLike<number>;
  gaps: Gap[];
}

/** The newer numbers as a layer; null if there are none, or if the errors of the preview are too large. */
function layerOf({ certified, preview, at }: Turned): Layer | null {
  const previewed = preview && previewAt(preview, at);
  if (certified === null) return previewed;
  const hasGaps = certified.has("gap_lower");
  if (!hasGaps && previewed === null) return null;
  return {
    isPreview: false,
    areGapsPreview: !hasGaps,
    distance: certified.values("distance"),
    pitch: pitchOf(certified),
    frequency: certified.values("frequency"),
    error: certified.values("frequency_error"),
    gaps: hasGaps ? readGaps(certified) : (previewed?.gaps ?? []),
  };
}

/** What replaces the curves of the diagram. */
export interface Newer {
  layer: ReadonlySignal<Layer | null>;
  isWaiting: ReadonlySignal<boolean>; // the design is newer than the diagram, and there is no layer of it
}

export function newerThan(turned: ReadonlySignal<Turned | null> | undefined): Newer {
  const layer = computed(() => (turned?.value ? layerOf(turned.value) : null));
  return { layer, isWaiting: computed(() => Boolean(turned?.value) && layer.value === null) };
}

export const layerOfDiagram = ({ distance, pitch, frequency, error, gaps }: BandDiagram): Layer => ({
  isPreview: false,
  areGapsPreview: false,
  distance,
  pitch,
  frequency,
  error,
  gaps,
});

/** A preview between two nodes, as `haptonic.design.preview.DesignLine.dataset` describes it. */
function previewAt(data: Dataset, at: number): Layer | null {
  const nodes = data.values("value");
  const last = nodes.length - 1;
  if (at < (nodes[0] ?? NaN) * (1 - 1e-9) || at > (nodes[last] ?? NaN) * (1 + 1e-9)) return null;
  const after = Math.max(1, nodes.findIndex((node) => node >= at));
  const [low, high] = [nodes[after - 1] ?? 0, nodes[after] ?? 1];
  const apart = high - low;
  const share = Math.min(Math.max((at - low) / apart, 0), 1);
  const between = (name: string): [Float64Array, Float64Array] => {
    const count = data.values(name).length / nodes.length;
    const both = (variable: string): [Numbers, Numbers] => {
      const values = data.values(variable);
      return [values.subarray((after - 1) * count, after * count), values.subarray(after * count, (after + 1) * count)];
    };
    const [[v0, v1], [e0, e1], [b0, b1]] = [both(name), both(`${name}_error`), both(`${name}_bend`)];
    const mixed = (a: Numbers, b: Numbers, k: number) => (1 - share) * (a[k] ?? NaN) + share * (b[k] ?? NaN);
    const bent = apart * share * (1 - share);
    return [
      Float64Array.from(v0, (_, k) => mixed(v0, v1, k)),
      Float64Array.from(v0, (_, k) => mixed(e0, e1, k) + bent * ((b0[k] ?? NaN) + (b1[k] ?? NaN))),
    ];
  };
  const [frequency, error] = between("frequency");
  const top = LEAST * Math.max(...frequency);
  if (frequency.some((value, k) => !((error[k] ?? NaN) <= TOO_FAR * Math.max(value, top)))) return null;
  const [edge, doubt] = between("edge");
  const pairs = edge.length / 2;
  const gaps = Array.from({ length: pairs }, (_, pair): Gap => ({
    below: pair + 1,
    lower: edge[pair] ?? NaN,
    upper: edge[pairs + pair] ?? NaN,
    lowerError: doubt[pair] ?? NaN,
    upperError: doubt[pairs + pair] ?? NaN,
    complete: true,
    direction: "all",
    waves: "all",
  }));
  const pair = (name: string, row: number) => {
    const values = data.values(name);
    const count = values.length / nodes.length;
    return [values[(after - 1) * count + row] ?? NaN, values[after * count + row] ?? NaN] as const;
  };
  const distance = Float64Array.from({ length: data.values("distance").length / nodes.length }, (_, row) => {
    const [before, behind] = pair("distance", row);
    return before === 0 ? 0 : 1 / ((1 - share) / before + share / behind);
  });
  const [narrow, wide] = pair("pitch", 0);
  const pitch = (1 - share) * narrow + share * wide;
  const open = gaps.filter(({ lower, upper }) => upper > lower);
  return { isPreview: true, areGapsPreview: true, distance, pitch, frequency, error, gaps: open };
}
