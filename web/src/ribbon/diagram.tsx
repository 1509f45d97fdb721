/** Frequency against wavevector along a ribbon: bulk bands shaded, modes as strokes with the slope of the group velocity. */

import { useMemo } from "preact/hooks";
import type uPlot from "uplot";
import { Chart } from "../parts/chart";
import { dot, horizontalLine } from "../parts/marks";
import { themeColour } from "../parts/colours";
import { titled } from "../parts/units";
import type { RibbonModes } from "./ribbon_data";
import type { Choice } from "./view";

const REACH = 40; // CSS pixels, largest distance of a click from the mode that it picks
const SHARE = 0.42; // of the distance of two phases, half length of a stroke

interface Props {
  ribbon: RibbonModes;
  choice: Choice;
}

export function Diagram({ ribbon, choice }: Props) {
  const [unit, along] = [choice.unit.value, choice.wavevectorUnit.value];
  const selected = choice.mode.value;
  const x = useMemo(
    () => Array.from(ribbon.phases, (phase) => phase / ribbon.period / along.factor),
    [ribbon, along],
  );
  const limits = useMemo(() => {
    const [low, high] = ribbon.range;
    const ends: [number, number] = [0, Math.PI / ribbon.period / along.factor];
    return { x: ends, y: [low / unit.factor, high / unit.factor] as [number, number] };
  }, [ribbon, along, unit]);
  const place = (plot: uPlot, mode: number, canvas = false): [number, number] => [
    plot.valToPos(ribbon.wavevector(mode) / along.factor, "x", canvas),
    plot.valToPos(ribbon.at(mode) / unit.factor, "y", canvas),
  ];
  return (
    <Chart
      x={x}
      curves={NONE}
      titles={[titled("wavevector along the ribbon", along), titled("frequency", unit)]}
      height={420}
      limits={limits}
      below={(plot) => paintBulk(plot, ribbon, x, unit.factor)}
      above={(plot) => {
        paintModes(plot, ribbon, unit.factor, along.factor);
        if (ribbon.carrier !== null) horizontalLine(plot, ribbon.carrier / unit.factor, "carrier", [7, 5]);
        dot(plot.ctx, place(plot, selected, true), "accent");
      }}
      pick={(atX, atY, plot) => {
        const [left, top] = [plot.valToPos(atX, "x"), plot.valToPos(atY, "y")];
        const away = (mode: number) => Math.hypot(place(plot, mode)[0] - left, place(plot, mode)[1] - top);
        const best = ribbon.all.reduce((least, mode) => (away(mode) < away(least) ? mode : least), 0);
        if (away(best) < REACH) choice.mode.value = best;
      }}
    />
  );
}

const NONE: never[] = []; // all is painted

function paintBulk(plot: uPlot, ribbon: RibbonModes, x: number[], factor: number): void {
  const { ctx } = plot;
  ctx.save();
  ctx.globalAlpha = 0.4;
  for (const { crystal, lower, upper } of ribbon.bulk()) {
    ctx.fillStyle = themeColour(crystal === 0 ? "rule" : `curve-${crystal}`);
    ctx.beginPath();
    const at = (edge: number[], k: number) =>
      ctx.lineTo(plot.valToPos(x[k] ?? 0, "x", true), plot.valToPos((edge[k] ?? 0) / factor, "y", true));
    x.forEach((_, k) => at(upper, k));
    x.forEach((_, k) => at(lower, x.length - 1 - k));
    ctx.fill();
  }
  ctx.restore();
}

function paintModes(plot: uPlot, ribbon: RibbonModes, factor: number, along: number): void {
  const { ctx } = plot;
  const step = ribbon.phases.length > 1 ? (ribbon.phases[1] ?? 0) - (ribbon.phases[0] ?? 0) : 0.1;
  const half = (SHARE * step) / ribbon.period; // rad/m
  ctx.save();
  for (const mode of ribbon.all) {
    const rise = ((ribbon.velocity[mode] ?? 0) * half) / (2 * Math.PI); // Hz
    const end = (side: number): [number, number] => [
      plot.valToPos((ribbon.wavevector(mode) + side * half) / along, "x", true),
      plot.valToPos((ribbon.at(mode) + side * rise) / factor, "y", true),
    ];
    const share = ribbon.share[mode] ?? 0;
    ctx.strokeStyle = colour(ribbon.shares, share);
    ctx.lineWidth = (ribbon.isGuided(mode) ? 3 : 1.4) * devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(...end(-1));
    ctx.lineTo(...end(1));
    ctx.stroke();
  }
  ctx.restore();
}

/** Colour of a share, from none to all: the larger the share, the more it differs from the paper. */
export function colour(shades: number[][], share: number): string {
  const place = matchMedia("(prefers-color-scheme: dark)").matches ? share : 1 - share;
  const shade = shades[Math.round(Math.min(Math.max(place, 0), 1) * (shades.length - 1))] ?? [];
  return `rgb(${shade.join(" ")})`;
}
