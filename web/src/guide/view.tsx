/** Waveguides between two mirrors: their sizes, and the field of the mode of the selected one. The view of kind "guides". */

import { computed, signal, type Signal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type uPlot from "uplot";
import type { Dataset } from "../dataset";
import { Chart } from "../parts/chart";
import { PaceControls, UnitSelect } from "../parts/controls";
import { startingPace, type Pace } from "../parts/cycle";
import { FactList } from "../parts/facts";
import { Field } from "../parts/field";
import { Frame, origin } from "../parts/frame";
import { motionKey, type Key } from "../parts/keys";
import { Listing, listingKeys, type Listed } from "../parts/listing";
import { dot, shadeInterval, verticalLine } from "../parts/marks";
import { uncertain } from "../parts/numbers";
import { suitable, titled, withUnit, type Unit } from "../parts/units";
import { Walk } from "../parts/walk";
import { Waveguides } from "./guide_data";

interface Choice extends Pace {
  guide: Signal<number>;
  unit: Signal<Unit>;
  listing: Signal<Listed>;
}

interface Props {
  guides: Waveguides;
  choice: Choice;
}

export function guidesView(data: Dataset) {
  return <GuidesView data={data} />;
}

function GuidesView({ data }: { data: Dataset }) {
  const guides = useMemo(() => new Waveguides(data), [data]);
  const choice = useMemo<Choice>(
    () => ({
      guide: signal(guides.best),
      unit: signal(suitable(guides.units, guides.value("frequency", guides.best))),
      ...startingPace(),
      listing: signal<Listed>("none"),
    }),
    [guides],
  );
  const keys = useMemo(() => guidesKeys(guides, choice), [guides, choice]);
  const wave = useMemo(() => computed(() => guides.wave(choice.guide.value)), [guides, choice]);
  const { grid, part } = guides.fields;
  return (
    <Frame name="guides" data={data} keys={keys} foot={footOf(guides)}>
      <div class="pair">
        <section aria-label="Waveguides">
          <Walk label="Waveguides. Arrow keys select another length.">
            {guides.count > 1 && <SizeChart guides={guides} choice={choice} />}
            <ProfileChart guides={guides} choice={choice} />
          </Walk>
          <p class="axes">
            <UnitSelect title="Frequencies in" units={guides.units} unit={choice.unit} />
          </p>
          <GuideFacts guides={guides} choice={choice} />
        </section>
        <section aria-label="Mode">
          <Field
            grid={grid} part={part} wave={wave} pace={choice}
            label="Field of the guided mode, the strip from left to right between rows of the lattice"
            shown="normal displacement; 1 is the largest; dashed: edges of the strip"
            name="waveguide" caption={`${data.header.title}, ${origin(data)}`}
          />
          <PaceControls {...choice} />
        </section>
      </div>
      <Listing listing={choice.listing} keys={keys}>
        <GuideTable guides={guides} choice={choice} />
      </Listing>
    </Frame>
  );
}

function footOf(guides: Waveguides): string {
  const share = (100 * guides.frequencyError).toPrecision(2);
  return (
    `Frequencies of the lattice have errors of up to ${share} %, which move all frequencies of the waveguides alike; the ` +
    `conditions at their ${guides.ends} ends are approximate. The field is the displacement normal to the flat face, of a ` +
    "wave that travels to the left; two opposite ones form the mode of the strip. Dashed lines are the edges of the strip."
  );
}

function guidesKeys(guides: Waveguides, choice: Choice): Key[] {
  const go = (by: number) => () => (choice.guide.value = Math.min(Math.max(choice.guide.value + by, 0), guides.count - 1));
  return [
    {
      keys: "← →",
      effect: "next shorter or longer waveguide",
      actions: { ArrowLeft: go(-1), ArrowRight: go(1) },
    },
    { keys: "b", effect: "waveguide nearest to the carrier", actions: { b: () => (choice.guide.value = guides.best) } },
    motionKey(choice),
    ...listingKeys(choice.listing),
  ];
}

/** Width against length of the compared waveguides. */
function SizeChart({ guides, choice }: Props) {
  const every = useMemo(() => Array.from({ length: guides.count }, (_, guide) => guide), [guides]);
  const [x, y] = useMemo(
    () => ["length", "width"].map((name) => every.map((guide) => 1e3 * guides.value(name, guide))) as [number[], number[]],
    [guides, every],
  );
  const curves = useMemo(() => [{ values: y, colour: "quiet", dash: [2, 4] }], [y]);
  const around = (values: number[], room: number): [number, number] => [Math.min(...values) - room, Math.max(...values) + room];
  const chosen = choice.guide.value;
  const paint = (plot: uPlot) => {
    for (const guide of every) {
      const place: [number, number] = [plot.valToPos(x[guide] ?? 0, "x", true), plot.valToPos(y[guide] ?? 0, "y", true)];
      dot(plot.ctx, place, guide === chosen ? "accent" : "quiet", guide === chosen ? 6 : 4);
    }
  };
  const room = 0.08 * (Math.max(...y) - Math.min(...y)) || 1;
  return (
    <Chart
      x={x} curves={curves} titles={["length / mm", "width / mm"]} height={240}
      limits={{ x: around(x, 500 * guides.period), y: around(y, room) }}
      above={paint}
      pick={(at) => (choice.guide.value = nearest(x, at))}
    />
  );
}

function nearest(values: number[], target: number): number {
  return values.reduce((best, value, k) => (Math.abs(value - target) < Math.abs((values[best] ?? NaN) - target) ? k : best), 0);
}

/** Size of the mode across the strip and the rows beside it. */
function ProfileChart({ guides, choice }: Props) {
  const guide = choice.guide.value;
  const { position, size } = useMemo(() => guides.profile(guide), [guides, guide]);
  const x = useMemo(() => position.map((value) => 1e3 * value), [position]);
  const curves = useMemo(() => [{ values: size, colour: "accent", width: 2 }], [size]);
  const half = 500 * guides.value("width", guide);
  return (
    <Chart
      key={guide}
      x={x} curves={curves} titles={["from the middle of the strip / mm", "rms over its peak"]} height={220}
      limits={{ x: [x[0] ?? 0, x[x.length - 1] ?? 1], y: [0, 1.05] }}
      below={(plot) => {
        shadeInterval(plot, [x[0] ?? 0, -half], "panel");
        shadeInterval(plot, [half, x[x.length - 1] ?? 0], "panel");
      }}
      above={(plot) => [-half, half].forEach((edge) => verticalLine(plot, edge, "ink", [4, 4]))}
    />
  );
}

function GuideFacts({ guides, choice }: Props) {
  const [guide, unit] = [choice.guide.value, choice.unit.value];
  const millimetres = (name: string, digits: number) => `${(1e3 * guides.value(name, guide)).toFixed(digits)} mm`;
  const facts: [string, string][] = [
    ["width", millimetres("width", 2)],
    ["length", `${millimetres("length", 1)}, ${guides.value("rows", guide)} cells`],
    ["distance of nodal lines", millimetres("nodal_spacing", 3)],
    ["amplitude at the edge", `${(100 * guides.value("amplitude_at_edge", guide)).toFixed(1)} % of the peak`],
    ["decay in the lattice", `${decayText(guides, guide)} dB per row`],
  ];
  return (
    <div class="facts">
      <p id="point" aria-live="polite">
        Mode {guides.mode}, {guides.value("rows", guide)} cells long: <b>{withUnit(frequencyText(guides, guide, unit), unit)}</b>
      </p>
      <FactList facts={facts} />
    </div>
  );
}

/** Frequency with the error of the lattice's frequencies. */
function frequencyText(guides: Waveguides, guide: number, { factor }: Unit): string {
  const frequency = guides.value("frequency", guide) / factor;
  return uncertain(frequency, guides.frequencyError * frequency);
}

const decayText = (guides: Waveguides, guide: number) => uncertain(guides.value("decay", guide), guides.value("decay_error", guide));

function GuideTable({ guides, choice }: Props) {
  const unit = choice.unit.value;
  return (
    <div class="wide">
      <table>
        <caption>Waveguides for mode {guides.mode}</caption>
        <thead>
          <tr>
            {["cells", "length / mm", "width / mm", titled("frequency", unit), "decay / (dB/row)", "edge / peak", "show"].map((title) => (
              <th scope="col">{title}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: guides.count }, (_, guide) => (
            <tr aria-current={guide === choice.guide.value ? "true" : undefined}>
              <td>{guides.value("rows", guide)}</td>
              <td>{(1e3 * guides.value("length", guide)).toFixed(1)}</td>
              <td>{(1e3 * guides.value("width", guide)).toFixed(2)}</td>
              <td>{frequencyText(guides, guide, unit)}</td>
              <td>{decayText(guides, guide)}</td>
              <td>{guides.value("amplitude_at_edge", guide).toFixed(3)}</td>
              <td>
                <button type="button" onClick={() => (choice.guide.value = guide)}>
                  {guides.value("rows", guide)} cells
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
