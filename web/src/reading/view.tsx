/** How measured files were read: points and a curve. The view of kind "reading". */

import { useMemo } from "preact/hooks";
import type { Dataset } from "../dataset";
import { Chart, type ChartCurve } from "../parts/chart";
import type { Drawing, Point } from "../parts/plan";
import { frequencyUnits, prefixed, suitable, titled, type Unit } from "../parts/units";
import { PointPlan } from "./points";

const HEIGHT = 260; // CSS pixels
const DASHES = [[], [8, 4]]; // curves differ by more than colour

export function readingView(data: Dataset) {
  return <ReadingView data={data} />;
}

function ReadingView({ data }: { data: Dataset }) {
  const { points, drawing, curves, unit, axis, names, title } = useMemo(() => contents(data), [data]);
  const along = data.values(axis);
  const x = useMemo(() => Array.from(along, (value) => value / unit.factor), [data]);
  return (
    <div class="reading">
      {points.length > 0 && <PointPlan points={points} drawing={drawing} />}
      {x.length > 1 && (
        <div>
          <Chart x={x} curves={curves} titles={[titled(data.title(axis), unit), title]} height={HEIGHT} />
          {names.length > 1 && (
            <p class="legend">
              {names.map((name, k) => (
                <span class="of-curve">
                  <svg width="34" height="8" aria-hidden="true">
                    <line x1="0" x2="34" y1="4" y2="4" stroke-width="2" stroke={`var(--curve-${k})`}
                      stroke-dasharray={(DASHES[k % DASHES.length] ?? []).join(" ")} />
                  </svg>{" "}
                  {data.title(name)}
                </span>
              ))}
            </p>
          )}
        </div>
      )}
    </div>
  );
}

function contents(data: Dataset) {
  const { extra, variables } = data.header;
  const axis = String(extra["axis"]);
  const names = Object.keys(variables).filter((name) => name !== axis && variables[name]?.dims[0] === axis);
  const sizes = names.flatMap((name) => Array.from(data.values(name), Math.abs)).filter(Number.isFinite);
  const ordinate = prefixed(data.unit(names[0] ?? axis), sizes.reduce((a, b) => Math.max(a, b), 0));
  const curves = names.map((name, k): ChartCurve => ({
    values: Array.from(data.values(name), (value) => (Number.isFinite(value) ? value / ordinate.factor : null)),
    colour: `curve-${k}`,
    dash: DASHES[k % DASHES.length] ?? [],
  }));
  const y = data.has("y") ? data.values("y") : [];
  const points = data.has("x") ? Array.from(data.values("x"), (x, k): Point => [x, y[k] ?? 0]) : [];
  const own: Unit = { name: data.unit(axis), factor: 1 };
  const unit = own.name === "Hz" ? suitable(frequencyUnits(data), Math.max(...data.values(axis))) : own;
  const title = titled(names.length === 1 ? data.title(names[0] ?? axis) : "force", ordinate); // of the only curve, or of several
  return { points, drawing: extra["drawing"] as Drawing | null, curves, unit, axis, names, title };
}
