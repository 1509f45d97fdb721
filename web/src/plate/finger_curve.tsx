/** Friction against the amplitude below the finger, with its interval and the threshold of perception. */

import { effect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { themeColour } from "../parts/colours";
import { horizontalLine, line } from "../parts/marks";
import { axisLook, BETWEEN_PIXELS, kept, leftAxis, widthIn } from "../parts/plot";
import type { End, FingerData } from "./finger_data";
import type { Finger } from "./finger_state";

const percent = (share: number): string => `${(100 * share).toFixed(0)} %`;
const HEIGHT = 250; // CSS pixels
const MICRO = 1e6;
const DRAWN: End[] = ["low", "high", "value"]; // the value lies over its interval

export function FingerCurve({ data, finger }: { data: FingerData; finger: Finger }) {
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (place.current === null) return;
    return drawn(place.current, data, finger);
  }, [data, finger]);
  return (
    <>
      <div class="curves" ref={place} />
      <p class="legend">
        <span class="of-curve">
          <svg width="34" height="8" aria-hidden="true">
            <line x1="0" x2="34" y1="4" y2="4" stroke-width="2" stroke="var(--curve-0)" />
          </svg>{" "}
          model
        </span>
        <span class="of-gap">its interval</span>
        <span class="of-carrier">just noticed, {percent(data.extra.weber)} less friction</span>
      </p>
    </>
  );
}

function drawn(element: HTMLElement, data: FingerData, finger: Finger): () => void {
  const amplitudes = Array.from(data.amplitudes, (value) => value * MICRO);
  const values = () => [amplitudes, ...DRAWN.map((end) => Array.from(finger.law.value[end]))] as uPlot.AlignedData;
  const size = () => ({ width: widthIn(element), height: HEIGHT });
  const line = { ...BETWEEN_PIXELS, width: 0, points: { show: false } };
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, distr: 3 }, y: { range: [0, 1.02] } },
      bands: [{ series: [2, 1], fill: () => themeColour("gap") }],
      axes: [
        {
          ...axisLook(), label: `${data.data.title("table")} / µm`, labelSize: 22, size: 34,
          values: (_, splits) => splits.map((value) => (Number.isInteger(Math.round(1e6 * Math.log10(value)) / 1e6) ? String(value) : "")),
        },
        { ...leftAxis(), label: data.data.title("load_sharing") },
      ],
      series: [{}, line, line, { ...BETWEEN_PIXELS, stroke: () => themeColour("curve-0"), width: 2, points: { show: false } }],
      hooks: { draw: [(u) => paintMarks(u, data, finger)] },
    },
    values(),
    element,
  );
  return kept(plot, element, size, [
    effect(() => plot.setData(values())),
    effect(() => {
      finger.below.value;
      plot.redraw(false, false);
    }),
  ]);
}

function paintMarks(plot: uPlot, data: FingerData, finger: Finger): void {
  const { ctx, bbox, valToPos } = plot;
  const { amplitude, friction } = finger.below.peek();
  const [x, y] = [valToPos(Math.max(amplitude.value * MICRO, 1e-3), "x", true), valToPos(friction.value, "y", true)];
  horizontalLine(plot, 1 - data.extra.weber, "carrier", [7, 5]);
  line(ctx, [x, bbox.top], [x, bbox.top + bbox.height], "accent");
  ctx.save();
  ctx.fillStyle = themeColour("accent");
  ctx.beginPath();
  ctx.arc(x, y, 5 * devicePixelRatio, 0, 2 * Math.PI);
  ctx.fill();
  ctx.restore();
}
