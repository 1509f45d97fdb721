/** Curves of a layer: dashed with the band of their errors in a preview, dotted for a held design. */

import type uPlot from "uplot";
import { themeColour } from "../parts/colours";
import type { BandDiagram } from "./diagram_data";
import type { Layer } from "./layer";

export type Look = "preview" | "certified" | "held";

const LOOKS: Record<Look, { colour: string; dash: number[]; width: number }> = {
  preview: { colour: "accent", dash: [5, 3], width: 1.6 },
  certified: { colour: "ink", dash: [], width: 1.6 },
  held: { colour: "curve-1", dash: [1.5, 3], width: 1.5 },
};

/** Paint with frequencies over a factor, and the path over `length`. */
export function paintLayer(
  plot: uPlot, diagram: BandDiagram, layer: Layer, factor: number, length: number, look: Look,
): void {
  const { ctx } = plot;
  const { colour, dash, width } = LOOKS[look];
  const across = Array.from(layer.distance, (distance) => plot.valToPos(distance / length, "x", true));
  const up = (k: number, sign: number) => {
    const value = (layer.frequency[k] ?? NaN) + sign * (layer.error[k] ?? NaN);
    return plot.valToPos(value / factor, "y", true);
  };
  const line = (band: number, sign: number, backwards = false) => {
    for (let row = 0; row < diagram.rows; row++) {
      const at = backwards ? diagram.rows - 1 - row : row;
      ctx.lineTo(across[at] ?? 0, up(at * diagram.bands + band, sign));
    }
  };
  ctx.save();
  ctx.fillStyle = ctx.strokeStyle = themeColour(colour);
  ctx.lineWidth = width * devicePixelRatio;
  ctx.setLineDash(dash.map((length) => length * devicePixelRatio));
  for (let band = 0; band < diagram.bands; band++) {
    if (look === "preview") {
      ctx.globalAlpha = 0.2;
      ctx.beginPath();
      line(band, 1);
      line(band, -1, true);
      ctx.fill();
      ctx.globalAlpha = 1;
    }
    ctx.beginPath();
    line(band, 0);
    ctx.stroke();
  }
  if (look === "held")
    for (const gap of layer.gaps.filter(({ complete }) => complete))
      for (const edge of [gap.lower, gap.upper]) {
        const y = plot.valToPos(edge / factor, "y", true);
        ctx.beginPath();
        ctx.moveTo(plot.bbox.left, y);
        ctx.lineTo(plot.bbox.left + plot.bbox.width, y);
        ctx.stroke();
      }
  ctx.restore();
}
