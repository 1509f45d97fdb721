/** Waves along a ribbon: projected bands, modes and their fields. The view of kind "ribbon". */

import { computed, signal, type Signal } from "@preact/signals";
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Dataset } from "../dataset";
import { onTheme } from "../parts/colours";
import { PaceControls, UnitSelect } from "../parts/controls";
import { startingPace, type Pace } from "../parts/cycle";
import { FactList } from "../parts/facts";
import { Field } from "../parts/field";
import { Frame, origin } from "../parts/frame";
import { motionKey, type Key } from "../parts/keys";
import { Listing, listingKeys, type Listed } from "../parts/listing";
import { uncertain } from "../parts/numbers";
import { rounded, suitable, titled, withUnit, type Unit } from "../parts/units";
import { Walk } from "../parts/walk";
import { colour, Diagram } from "./diagram";
import { RibbonModes } from "./ribbon_data";

const FOOT =
  "Errors of frequencies bound the distance to the exact ones of the model, those of velocity and decay are estimates. The field is that of the strongest component on " +
  "the flat face, relative to its largest displacement.";
const STILL_HINT = "Fields of the modes are computed with the option --html.";

export interface Choice extends Pace {
  mode: Signal<number>;
  unit: Signal<Unit>; // of frequency
  wavevectorUnit: Signal<Unit>;
  listing: Signal<Listed>;
}

interface Props {
  ribbon: RibbonModes;
  choice: Choice;
}

export function ribbonView(data: Dataset) {
  return <RibbonView data={data} />;
}

function RibbonView({ data }: { data: Dataset }) {
  const ribbon = useMemo(() => new RibbonModes(data), [data]);
  const choice = useMemo<Choice>(
    () => ({
      mode: signal(ribbon.first),
      unit: signal(suitable(ribbon.units, ribbon.range[1])),
      wavevectorUnit: signal(ribbon.wavevectorUnits[1]!),
      ...startingPace(),
      listing: signal<Listed>("none"),
    }),
    [ribbon],
  );
  const keys = useMemo(() => ribbonKeys(ribbon, choice), [ribbon, choice]);
  if (ribbon.all.length === 0) return <Frame name="ribbon" data={data} keys={[]} foot={FOOT} children={null} />;
  return (
    <Frame name="ribbon" data={data} keys={keys} foot={FOOT}>
      <div class="pair">
        <section aria-label="Projected bands">
          <Walk label="Projected bands. Arrow keys move between wavevectors and modes.">
            <Diagram ribbon={ribbon} choice={choice} />
          </Walk>
          <p class="axes">
            <UnitSelect title="Frequencies in" units={ribbon.units} unit={choice.unit} />
            <UnitSelect title="Wavevectors in" units={ribbon.wavevectorUnits} unit={choice.wavevectorUnit} />
          </p>
          <Legend ribbon={ribbon} />
        </section>
        <section aria-label="Mode">
          {ribbon.hasFields ? <ModeField ribbon={ribbon} choice={choice} /> : <p>{STILL_HINT}</p>}
          <ModeFacts ribbon={ribbon} choice={choice} />
          {ribbon.hasFields && <PaceControls {...choice} />}
        </section>
      </div>
      <Listing listing={choice.listing} keys={keys}>
        <ModeTable ribbon={ribbon} choice={choice} />
      </Listing>
    </Frame>
  );
}

function ribbonKeys(ribbon: RibbonModes, choice: Choice): Key[] {
  const walk = (along: number, up: number) => (choice.mode.value = ribbon.moved(choice.mode.value, along, up));
  const next = (by: number) => {
    const { guided } = ribbon;
    if (guided.length === 0) return;
    const place = guided.indexOf(choice.mode.value);
    choice.mode.value = guided[(place + by + guided.length) % guided.length] ?? choice.mode.value;
  };
  return [
    {
      keys: "← →",
      effect: "mode of about this frequency at the previous or next wavevector",
      actions: { ArrowLeft: () => walk(-1, 0), ArrowRight: () => walk(1, 0) },
    },
    {
      keys: "↑ ↓",
      effect: "next higher or lower mode at this wavevector",
      actions: { ArrowUp: () => walk(0, 1), ArrowDown: () => walk(0, -1) },
    },
    { keys: "p n", effect: "previous or next guided mode", actions: { p: () => next(-1), n: () => next(1) } },
    motionKey(choice),
    ...listingKeys(choice.listing),
  ];
}

function ModeField({ ribbon, choice }: Props) {
  const { grid, part } = useMemo(() => ribbon.fields, [ribbon]);
  const wave = useMemo(() => computed(() => ribbon.wave(choice.mode.value)), [ribbon, choice]);
  const caption = `${ribbon.data.header.title}, ${origin(ribbon.data)}`;
  const shown = `displacement ${ribbon.direction(choice.mode.value)}; 1 is the largest`;
  return <Field grid={grid} part={part} wave={wave} pace={choice} label="Field of the mode" shown={shown} name="ribbon" caption={caption} />;
}

function Legend({ ribbon }: { ribbon: RibbonModes }) {
  const [, setTheme] = useState(0);
  useEffect(() => onTheme(() => setTheme((count) => count + 1)), []);
  const steps = [0, 0.25, 0.5, 0.75, 1].map((share) => colour(ribbon.shares, share));
  return (
    <p class="scale legend">
      <span class="plain">0 %</span>
      <span class="bar" style={{ background: `linear-gradient(to right, ${steps.join(", ")})` }} />
      <span class="plain">100 %</span>
      <span class="plain">of the energy in {ribbon.place}; guided modes are thick; shaded: bulk bands</span>
      {ribbon.carrier !== null && <span class="of-carrier">carrier</span>}
    </p>
  );
}

function wavevectorText(ribbon: RibbonModes, mode: number, { factor, name }: Unit): string {
  return `${Number((ribbon.wavevector(mode) / factor).toPrecision(4))} ${name}`;
}

function percent(share: number | undefined): string {
  return `${(100 * (share ?? NaN)).toFixed(1)} %`;
}

function frequencyText(ribbon: RibbonModes, mode: number, { factor }: Unit): string {
  return uncertain(ribbon.at(mode) / factor, (ribbon.error[mode] ?? NaN) / factor);
}

function ModeFacts({ ribbon, choice }: Props) {
  const [mode, unit, along] = [choice.mode.value, choice.unit.value, choice.wavevectorUnit.value];
  const decay = ribbon.decay(mode);
  const facts: [string, string][] = [
    ["group velocity", `${ribbon.speed(mode)} m/s`],
    [`energy in ${ribbon.place}`, percent(ribbon.share[mode])],
    ["decay", decay && `${decay} dB per row`],
    ["shown displacement", ribbon.hasFields ? ribbon.direction(mode) : ""],
  ];
  return (
    <div class="facts">
      <p id="point" aria-live="polite">
        {ribbon.isGuided(mode) ? "Guided mode" : "Mode"} at {wavevectorText(ribbon, mode, along)}:{" "}
        <b>{withUnit(frequencyText(ribbon, mode, unit), unit)}</b>
      </p>
      <FactList facts={facts} />
    </div>
  );
}

/** Modes at the wavevector of the selected one. */
function ModeTable({ ribbon, choice }: Props) {
  const [selected, unit, along] = [choice.mode.value, choice.unit.value, choice.wavevectorUnit.value];
  return (
    <div class="wide">
      <table>
        <caption>
          Modes at {wavevectorText(ribbon, selected, along)}
        </caption>
        <thead>
          <tr>
            {[titled("frequency", unit), "guided", `energy in ${ribbon.place}`, "decay / (dB/row)", "show"].map((title) => (
              <th scope="col">{title}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {ribbon.beside(selected).map((mode) => (
            <tr aria-current={mode === selected ? "true" : undefined}>
              <td>{frequencyText(ribbon, mode, unit)}</td>
              <td>{ribbon.isGuided(mode) ? "yes" : "no"}</td>
              <td>{percent(ribbon.share[mode])}</td>
              <td>{ribbon.decay(mode) || "-"}</td>
              <td>
                <button type="button" onClick={() => (choice.mode.value = mode)}>
                  {withUnit(rounded(ribbon.at(mode) / unit.factor), unit)}
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
