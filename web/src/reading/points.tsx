/** Points of a scan over the outlines of its plate. */

import type { Drawing, Loop, Point } from "../parts/plan";

const MARGIN = 0.06; // of the larger side

interface Props {
  points: Point[]; // m
  drawing: Drawing | null;
}

/** A plan in millimetres, with y upwards; the first and the last point are named. */
export function PointPlan({ points, drawing }: Props) {
  const outline = drawing?.plate.flat() ?? [];
  const [left, right, bottom, top] = bounds([...points, ...outline]);
  const size = Math.max(right - left, top - bottom, 1e-6);
  const [margin, letter] = [MARGIN * size, 0.045 * size];
  const box = [left - margin, -top - margin, right - left + 2 * margin, top - bottom + 2 * margin];
  const [first, last] = [points[0], points.at(-1)];
  return (
    <svg class="points" viewBox={box.map((value) => 1e3 * value).join(" ")} role="img" aria-label={words(points, drawing)}>
      {drawing !== null && (
        <>
          <path d={drawing.plate.map(path).join("")} class="plate" />
          <path d={Object.values(drawing.regions).flat().map(path).join("")} class="region" />
        </>
      )}
      <path d={points.map(([x, y]) => `M${milli(x)} ${milli(-y)}h1e-4`).join("")} class="places" />
      {first !== undefined && <path d={`M${milli(first[0])} ${milli(-first[1])}h1e-4`} class="first" />}
      <g font-size={1e3 * letter}>
        {Object.entries(drawing?.regions ?? {}).map(([name, loops]) => {
          const [low, high, , up] = bounds(loops.flat());
          return (
            <text x={milli((low + high) / 2)} y={milli(1.2 * letter - up)} text-anchor="middle">
              {name}
            </text>
          );
        })}
        {first !== undefined && <Numbered at={first} letter={letter} words="1" />}
        {last !== undefined && points.length > 1 && <Numbered at={last} letter={letter} words={`${points.length}`} />}
        <text x={milli(right + margin)} y={milli(-bottom + 0.9 * margin)} text-anchor="end" class="quiet">
          x →
        </text>
        <text x={milli(left - 0.9 * margin)} y={milli(-top - 0.2 * margin)} class="quiet">
          y ↑
        </text>
      </g>
    </svg>
  );
}

function Numbered({ at: [x, y], letter, words }: { at: Point; letter: number; words: string }) {
  return (
    <text x={milli(x + 0.3 * letter)} y={milli(-y - 0.3 * letter)} class="number">
      {words}
    </text>
  );
}

const milli = (metres: number) => Number((1e3 * metres).toFixed(4));

const path = (loop: Loop) => `M${loop.map(([x, y]) => `${milli(x)} ${milli(-y)}`).join("L")}Z`;

function bounds(points: Point[]): [number, number, number, number] {
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [x, y] of points) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [bottom, top] = [Math.min(bottom, y), Math.max(top, y)];
  }
  return [left, right, bottom, top];
}

function words(points: Point[], drawing: Drawing | null): string {
  const [left, right, bottom, top] = bounds(points);
  const range = (low: number, high: number) => `${Number((1e3 * low).toPrecision(4))} to ${Number((1e3 * high).toPrecision(4))} mm`;
  const over = drawing === null ? "" : " over the outline of the plate";
  return `${points.length} points${over}: x from ${range(left, right)}, y from ${range(bottom, top)}`;
}
