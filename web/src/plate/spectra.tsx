/** Velocities or contrasts of the regions against frequency, with the frequency that is shown. */

import { effect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { themeColour } from "../parts/colours";
import { shadeInterval, verticalLine } from "../parts/marks";
import { powerOfTen, tickText } from "../parts/numbers";
import { axisLook, BETWEEN_PIXELS, kept, leftAxis, onClick, widthIn, within } from "../parts/plot";
import { titled } from "../parts/units";
import type { PlateResponse } from "./plate_data";
import type { Choice } from "./state";

export const DASHES = [[], [8, 4], [2, 3], [10, 3, 2, 3]]; // curves differ by more than colour
export const COLOURS = 4; // --curve-0 to --curve-3 of the theme
const HEIGHT = 300; // CSS pixels

interface Props {
  plate: PlateResponse;
  choice: Choice;
}

export function Spectra({ plate, choice }: Props) {
  const place = useRef<HTMLDivElement>(null);
  const shown = choice.shown.value;
  useLayoutEffect(() => {
    if (place.current === null) return;
    return drawn(place.current, plate, choice);
  }, [plate, choice, shown]);
  return <div class="curves" ref={place} />;
}

function drawn(element: HTMLElement, plate: PlateResponse, choice: Choice): () => void {
  const shown = choice.shown.peek();
  const curves = plate.curves(shown);
  const unit = plate.data.unit(shown);
  const factor = () => choice.unit.peek().factor;
  const data = (): uPlot.AlignedData => [
    Array.from(plate.frequency, (value) => value / factor()),
    ...curves.map(({ values }) => values),
  ];
  const size = () => ({ width: widthIn(element), height: HEIGHT });
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: false },
      cursor: { points: { show: false }, y: false, drag: { x: true, y: false } },
      scales: { x: { time: false }, y: { distr: shown === "level" ? 3 : 1 } },
      axes: [
        { ...axisLook(), label: "frequency", labelSize: 22, size: 34 },
        {
          ...leftAxis(),
          label: titled(plate.data.title(shown), { name: unit, factor: 1 }),
          values: (_, splits) => splits.map((value) => (value === null ? "" : written(value, shown === "level"))),
        },
      ],
      series: [
        {},
        ...curves.map((_, k) => ({
          ...BETWEEN_PIXELS,
          stroke: () => themeColour(`curve-${k % COLOURS}`),
          dash: DASHES[k % DASHES.length] ?? [],
          width: 1.4,
          points: { show: false },
        })),
      ],
      hooks: { drawClear: [(u) => within(u, () => paintGap(u, plate, factor()))], draw: [(u) => paintLine(u, plate, choice)] },
    },
    data(),
    element,
  );
  onClick(plot, (left) => (choice.line.value = plate.nearest(factor() * plot.posToVal(left, "x"))));
  return kept(plot, element, size, [
    effect(() => {
      const label = plot.axes[0];
      if (label !== undefined) label.label = titled("frequency", choice.unit.value);
      plot.setData(data(), true);
    }),
    effect(() => {
      choice.line.value;
      plot.redraw(false, false);
    }),
  ]);
}

/** A tick: powers of ten on a logarithmic scale, else the number. */
function written(value: number, logarithmic: boolean): string {
  if (!logarithmic) return tickText(value);
  const power = Math.log10(value);
  return Math.abs(power - Math.round(power)) < 1e-9 ? powerOfTen(Math.round(power)) : "";
}

function paintGap(plot: uPlot, plate: PlateResponse, factor: number): void {
  if (plate.gap !== null) shadeInterval(plot, [plate.gap[0] / factor, plate.gap[1] / factor], "gap");
}

function paintLine(plot: uPlot, plate: PlateResponse, choice: Choice): void {
  const { factor } = choice.unit.peek();
  if (plate.carrier !== null) verticalLine(plot, plate.carrier / factor, "carrier", [7, 5]);
  verticalLine(plot, (plate.frequency[choice.line.peek()] ?? 0) / factor, "accent");
}
