/** Insertion loss of rows of cells and the waves of the lattice: the view of kind "layers". */

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
import { dot, line, shadeInterval, verticalLine } from "../parts/marks";
import { uncertain } from "../parts/numbers";
import { rounded, suitable, titled, withUnit, type Unit } from "../parts/units";
import { Walk } from "../parts/walk";
import { Mirror, plotted } from "./mirror_data";

const FOOT =
  "Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and " +
  "this share of the value. Waves of the lattice are shown at normal incidence. The field is that of the strongest component on the flat face, over six " +
  "rows; a wave enters them from the left, relative to its largest displacement in the first row.";
const FAST = 10; // frequencies
const ROOM = 1.05; // of an axis, beyond the largest value
const MOST = 60; // dB per row, highest decay that is drawn: beyond it, waves end within the first row

const STILL_HINT = "Fields of the waves are computed with the option --html.";

interface Choice extends Pace {
  line: Signal<number>; // number of the frequency, from 0
  rows: Signal<number>; // number of the curve, from 0
  incident: Signal<string>;
  wave: Signal<number>; // of the lattice, from 0: the least attenuated one
  unit: Signal<Unit>;
  listing: Signal<Listed>;
}

interface Props {
  mirror: Mirror;
  choice: Choice;
}

export function mirrorView(data: Dataset) {
  return <MirrorView data={data} />;
}

function MirrorView({ data }: { data: Dataset }) {
  const mirror = useMemo(() => new Mirror(data), [data]);
  const choice = useMemo<Choice>(
    () => ({
      line: signal(mirror.nearest(mirror.carrier)),
      rows: signal(mirror.rows.length - 1),
      incident: signal(mirror.incident[0] ?? ""),
      wave: signal(0),
      ...startingPace(),
      unit: signal(suitable(mirror.units, Math.max(...mirror.frequency))),
      listing: signal<Listed>("none"),
    }),
    [mirror],
  );
  const keys = useMemo(() => mirrorKeys(mirror, choice), [mirror, choice]);
  return (
    <Frame name="mirror" data={data} keys={keys} foot={FOOT}>
      <div class="pair">
        <section aria-label="Insertion loss">
          <Walk label="Insertion loss. Arrow keys change the frequency and the number of rows.">
            <LossChart mirror={mirror} choice={choice} />
          </Walk>
          <p class="axes">
            <label>
              Incident wave{" "}
              <select value={choice.incident.value} onChange={(event) => (choice.incident.value = event.currentTarget.value)}>
                {mirror.incident.map((kind) => (
                  <option>{kind}</option>
                ))}
              </select>
            </label>
            <UnitSelect title="Frequencies in" units={mirror.units} unit={choice.unit} />
            <span class="legend">
              <span class="of-curve">
                <CurveKey colour="accent" /> {rowsText(mirror.rows[choice.rows.value] ?? 0)}
              </span>
              {mirror.rows.length > 1 && (
                <span class="of-curve">
                  <CurveKey colour="quiet" /> {Math.min(...mirror.rows)} to {rowsText(Math.max(...mirror.rows))}
                </span>
              )}
              {mirror.gap && <span class="of-gap">gap</span>}
              <span class="of-carrier">carrier</span>
            </span>
          </p>
          <LineFacts mirror={mirror} choice={choice} />
          <RowsChart mirror={mirror} choice={choice} />
        </section>
        <section aria-label="Waves of the lattice">
          <WaveChart mirror={mirror} choice={choice} name="decay" />
          <WaveFacts mirror={mirror} choice={choice} />
          {mirror.hasFields ? <WaveField mirror={mirror} choice={choice} /> : <p>{STILL_HINT}</p>}
          <WaveChart mirror={mirror} choice={choice} name="phase" />
        </section>
      </div>
      <Listing listing={choice.listing} keys={keys}>
        <LossTable mirror={mirror} choice={choice} />
        <WaveTable mirror={mirror} choice={choice} />
      </Listing>
    </Frame>
  );
}

function mirrorKeys(mirror: Mirror, choice: Choice): Key[] {
  const bounded = (value: number, count: number) => Math.min(Math.max(value, 0), count - 1);
  const walk = (by: number) => (choice.line.value = bounded(choice.line.value + by, mirror.frequency.length));
  const more = (by: number) => (choice.rows.value = bounded(choice.rows.value + by, mirror.rows.length));
  const steps = (event: KeyboardEvent) => (event.shiftKey ? FAST : 1);
  return [
    {
      keys: "← →",
      effect: "previous or next frequency; ten with Shift",
      actions: { ArrowLeft: (event) => walk(-steps(event)), ArrowRight: (event) => walk(steps(event)) },
    },
    { keys: "↑ ↓", effect: "one more or one less row", actions: { ArrowUp: () => more(1), ArrowDown: () => more(-1) } },
    {
      keys: "i",
      effect: "next incident wave",
      actions: {
        i: () => {
          const next = (mirror.incident.indexOf(choice.incident.value) + 1) % mirror.incident.length;
          choice.incident.value = mirror.incident[next] ?? "";
        },
      },
    },
    {
      keys: "w W",
      effect: "wave of the lattice with the next higher or lower decay",
      actions: {
        w: () => (choice.wave.value = bounded(choice.wave.value + 1, mirror.waves)),
        W: () => (choice.wave.value = bounded(choice.wave.value - 1, mirror.waves)),
      },
    },
    motionKey(choice),
    { keys: "c", effect: "carrier", actions: { c: () => (choice.line.value = mirror.nearest(mirror.carrier)) } },
    ...listingKeys(choice.listing),
  ];
}

/** Paint gap, carrier and the selected frequency. */
function marks({ mirror, choice }: Props) {
  const { factor } = choice.unit.value;
  const selected = (mirror.frequency[choice.line.value] ?? 0) / factor;
  return {
    below: (plot: uPlot) => {
      if (mirror.gap) shadeInterval(plot, [mirror.gap[0] / factor, mirror.gap[1] / factor], "gap");
    },
    above: (plot: uPlot) => {
      verticalLine(plot, mirror.carrier / factor, "carrier", [7, 5]);
      verticalLine(plot, selected, "accent");
    },
    pick: (x: number) => (choice.line.value = mirror.nearest(x * factor)),
  };
}

function useFrequencies({ mirror, choice }: Props): number[] {
  const { factor } = choice.unit.value;
  return useMemo(() => Array.from(mirror.frequency, (value) => value / factor), [mirror, factor]);
}

function LossChart({ mirror, choice }: Props) {
  const [kind, selected] = [choice.incident.value, choice.rows.value];
  const curves = useMemo(
    () =>
      mirror.losses(kind).map((values, k) => ({
        values: plotted(values),
        colour: k === selected ? "accent" : "quiet",
        width: k === selected ? 2.6 : 1,
      })),
    [mirror, kind, selected],
  );
  const finite = mirror.losses(kind).flat().filter(Number.isFinite);
  const [lowest, highest] = [Math.min(0, ...finite), Math.max(1, ...finite)];
  return (
    <Chart
      x={useFrequencies({ mirror, choice })}
      curves={curves}
      titles={[titled("frequency", choice.unit.value), `${mirror.data.title("loss")} / dB`]}
      height={300}
      limits={{ y: [lowest, lowest + ROOM * (highest - lowest)] }}
      {...marks({ mirror, choice })}
    />
  );
}

/** Rows against insertion loss at the selected frequency, with errors. */
function RowsChart({ mirror, choice }: Props) {
  const [kind, at] = [choice.incident.value, choice.line.value];
  const [loss, error] = (["loss", "loss_error"] as const).map((name) => mirror.losses(kind, name).map((curve) => curve[at] ?? NaN));
  const x = useMemo(() => Array.from(mirror.rows), [mirror]);
  const curves = useMemo(() => [{ values: plotted(loss ?? []), colour: "quiet", dash: [2, 4] }], [mirror, kind, at]);
  const highest = Math.max(1, ...x.map((_, k) => (loss?.[k] ?? NaN) + (error?.[k] ?? NaN)).filter(Number.isFinite));
  return (
    <Chart
      key={`${kind} ${at}`}
      x={x}
      curves={curves}
      titles={["rows", `${mirror.data.title("loss")} / dB`]}
      height={200}
      whole
      limits={{ x: [0.5, x.length + 0.5], y: [Math.min(0, ...(loss ?? []).filter(Number.isFinite)), ROOM * highest] }}
      above={(plot) =>
        x.forEach((rows, k) => {
          const [value = NaN, bound = NaN] = [loss?.[k], error?.[k]];
          if (!Number.isFinite(value)) return;
          const place = (of: number): [number, number] => [plot.valToPos(rows, "x", true), plot.valToPos(of, "y", true)];
          line(plot.ctx, place(value - bound), place(value + bound), "ink");
          dot(plot.ctx, place(value), k === choice.rows.value ? "accent" : "quiet");
        })
      }
      pick={(rows) => (choice.rows.value = Math.min(Math.max(Math.round(rows) - 1, 0), x.length - 1))}
    />
  );
}

function WaveChart({ mirror, choice, name }: Props & { name: "decay" | "phase" }) {
  const curves = useMemo(
    () => mirror.ofWaves(name).map((values) => ({ values: plotted(values), colour: "curve-0", points: true })),
    [mirror, name],
  );
  const at = choice.line.value;
  const selected = curves[choice.wave.value]?.values[at];
  const shown = marks({ mirror, choice });
  const highest = Math.min(MOST, ROOM * Math.max(...curves.flatMap(({ values }) => values.map((value) => value ?? 0))));
  return (
    <Chart
      x={useFrequencies({ mirror, choice })}
      curves={curves}
      titles={[titled("frequency", choice.unit.value), `${mirror.data.title(name)} / ${name === "decay" ? "(dB/row)" : "π"}`]}
      height={name === "decay" ? 300 : 200}
      limits={{ y: name === "decay" ? [0, highest] : [0, 1] }}
      below={shown.below}
      above={(plot) => {
        shown.above(plot);
        if (typeof selected !== "number") return;
        dot(plot.ctx, [plot.valToPos((mirror.frequency[at] ?? 0) / choice.unit.value.factor, "x", true), plot.valToPos(selected, "y", true)], "accent");
      }}
      pick={(x, y) => {
        shown.pick(x);
        choice.wave.value = nearestWave(curves.map(({ values }) => values[choice.line.value] ?? NaN), y) ?? choice.wave.value;
      }}
    />
  );
}

/** Number of the finite value that is nearest to another one. */
function nearestWave(values: number[], target: number): number | undefined {
  const finite = values.map((_, wave) => wave).filter((wave) => Number.isFinite(values[wave]));
  return finite.sort((a, b) => Math.abs(values[a]! - target) - Math.abs(values[b]! - target))[0];
}

function WaveField({ mirror, choice }: Props) {
  const { grid, part } = useMemo(() => mirror.fields, [mirror]);
  const wave = useMemo(() => computed(() => mirror.field(choice.wave.value, choice.line.value)), [mirror, choice]);
  const caption = `${mirror.data.header.title}, ${origin(mirror.data)}`;
  const shown = `displacement ${mirror.direction(choice.wave.value, choice.line.value)}; 1 is the largest in the first row`;
  return (
    <>
      <Field grid={grid} part={part} wave={wave} pace={choice} label="Field of the wave, rows from left to right" shown={shown} name="wave" caption={caption} />
      <PaceControls {...choice} />
    </>
  );
}

/** Facts of the selected wave of the lattice. */
function WaveFacts({ mirror, choice }: Props) {
  const [wave, at] = [choice.wave.value, choice.line.value];
  const value = (name: "decay" | "phase" | "decay_error" | "phase_error") => mirror.ofWaves(name)[wave]?.[at] ?? NaN;
  const [decay, phase] = [value("decay"), value("phase")];
  const propagates = Number.isFinite(phase);
  const facts: [string, string][] = [
    ["decay", `${uncertain(decay, value("decay_error"))} dB per row`],
    ["phase", propagates ? `${uncertain(phase, value("phase_error"))} π per row` : ""],
    ["shown displacement", mirror.hasFields ? mirror.direction(wave, at) : ""],
  ];
  return (
    <div class="facts">
      <p id="wave" aria-live="polite">
        Wave {wave + 1} of {mirror.waves} in the lattice at <b>{frequencyText({ mirror, choice })}</b>:{" "}
        <b>{propagates ? "propagates" : "decays"}</b>
      </p>
      <FactList facts={facts} />
    </div>
  );
}

function frequencyText({ mirror, choice }: Props): string {
  const unit = choice.unit.value;
  return withUnit(rounded((mirror.frequency[choice.line.value] ?? 0) / unit.factor), unit);
}

function rowsText(count: number): string {
  return `${count} row${count === 1 ? "" : "s"}`;
}

function CurveKey({ colour }: { colour: string }) {
  return (
    <svg width="34" height="8" aria-hidden="true">
      <line x1="0" x2="34" y1="4" y2="4" stroke-width="2" stroke={`var(--${colour})`} />
    </svg>
  );
}

function lossText(loss: number | undefined, error: number | undefined): string {
  return Number.isFinite(loss) ? `${uncertain(loss ?? NaN, error ?? NaN)} dB` : "does not propagate";
}

function LineFacts({ mirror, choice }: Props) {
  const [kind, at, rows] = [choice.incident.value, choice.line.value, choice.rows.value];
  const [loss, error] = (["loss", "loss_error"] as const).map((name) => mirror.losses(kind, name)[rows]?.[at]);
  const count = mirror.rows[rows] ?? 0;
  return (
    <div class="facts">
      <p id="point" aria-live="polite">
        {kind} at <b>{frequencyText({ mirror, choice })}</b>, {rowsText(count)}: <b>{lossText(loss, error)}</b>
      </p>
      <p class="again">
        The same as a picture, in Python: <code>study.layers().plot("layers", incident="{kind}")</code>
      </p>
    </div>
  );
}

function LossTable({ mirror, choice }: Props) {
  const at = choice.line.value;
  return (
    <div class="wide">
      <table>
        <caption>Insertion loss at {frequencyText({ mirror, choice })}</caption>
        <thead>
          <tr>
            <th scope="col">rows</th>
            {mirror.incident.map((kind) => (
              <th scope="col">incident {kind}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Array.from(mirror.rows, (rows, k) => (
            <tr aria-current={k === choice.rows.value ? "true" : undefined}>
              <td>{rows}</td>
              {mirror.incident.map((kind) => (
                <td>{lossText(mirror.losses(kind)[k]?.[at], mirror.losses(kind, "loss_error")[k]?.[at])}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function WaveTable({ mirror, choice }: Props) {
  const at = choice.line.value;
  const columns = (["decay", "decay_error", "phase", "phase_error"] as const).map((name) => mirror.ofWaves(name));
  return (
    <div class="wide">
      <table>
        <caption>Waves of the lattice at {frequencyText({ mirror, choice })}</caption>
        <thead>
          <tr>
            <th scope="col">decay / (dB/row)</th>
            <th scope="col">phase per row / π</th>
            <th scope="col">show</th>
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: mirror.waves }, (_, wave) => {
            const [decay = NaN, decayError = NaN, phase = NaN, phaseError = NaN] = columns.map((column) => column[wave]?.[at]);
            return (
              <tr aria-current={wave === choice.wave.value ? "true" : undefined}>
                <td>{uncertain(decay, decayError)}</td>
                <td>{Number.isFinite(phase) ? uncertain(phase, phaseError) : "decays"}</td>
                <td>
                  <button type="button" onClick={() => (choice.wave.value = wave)}>
                    wave {wave + 1}
                  </button>
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
