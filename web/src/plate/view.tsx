/** Spectra of a plate and its maps that move: the views of kind "plate" and "scan". */

import { useMemo } from "preact/hooks";
import type { Dataset } from "../dataset";
import { PaceSlider, PlayButton, UnitSelect } from "../parts/controls";
import { Frame } from "../parts/frame";
import { Listing } from "../parts/listing";
import { signed } from "../parts/numbers";
import { rounded, withUnit, type Unit } from "../parts/units";
import { Walk } from "../parts/walk";
import { PlateMaps, size } from "./map";
import { PlateResponse, type Shown } from "./plate_data";
import { COLOURS, DASHES, Spectra } from "./spectra";
import { plateKeys, startingChoice, type Choice } from "./state";

const FOOT =
  "The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.";
const SCAN_FOOT =
  "Each point of the scan is a square of the map. Measurement and model move with the phase of the drive.";
const SHOWN: Shown[] = ["level", "contrast"];

export function plateView(data: Dataset) {
  return <PlateView data={data} foot={FOOT} />;
}

export function scanView(data: Dataset) {
  return <PlateView data={data} foot={SCAN_FOOT} />;
}

interface Props {
  plate: PlateResponse;
  choice: Choice;
}

function PlateView({ data, foot }: { data: Dataset; foot: string }) {
  const plate = useMemo(() => new PlateResponse(data), [data]);
  const choice = useMemo(() => startingChoice(plate), [plate]);
  const keys = useMemo(() => plateKeys(plate, choice), [plate, choice]);
  const available = SHOWN.filter((shown) => plate.has(shown));
  return (
    <Frame name="plate" data={data} keys={keys} foot={foot}>
      <div class={plate.fields.length > 1 ? "" : "pair"}>
        <section aria-label="Spectra">
          {available.length > 0 && plate.frequency.length > 1 && (
            <>
              <Walk label="Spectra. Arrow keys change the frequency.">
                <Spectra plate={plate} choice={choice} />
              </Walk>
              <Legend plate={plate} choice={choice} />
              <p class="axes">
                <label>
                  Curves{" "}
                  <select
                    value={choice.shown.value}
                    onChange={(event) => (choice.shown.value = event.currentTarget.value as Shown)}
                  >
                    {available.map((shown) => (
                      <option value={shown}>{plate.data.title(shown)}</option>
                    ))}
                  </select>
                </label>
                <UnitSelect title="Frequencies in" units={plate.units} unit={choice.unit} />
              </p>
            </>
          )}
          <LineFacts plate={plate} choice={choice} />
        </section>
        <section aria-label="Map">
          <PlateMaps plate={plate} choice={choice} />
          <div class="controls">
            <PlayButton playing={choice.playing} />
            <FrequencySlider plate={plate} choice={choice} />
            <PaceSlider pace={choice.pace} />
            <label class="check">
              <input
                type="checkbox" checked={choice.plan.value}
                onChange={(event) => (choice.plan.value = event.currentTarget.checked)}
              />
              pillars and supports
            </label>
            {plate.fields.length > 1 && (
              <label class="check">
                <input
                  type="checkbox" checked={choice.common.value}
                  onChange={(event) => (choice.common.value = event.currentTarget.checked)}
                />
                one scale of colours for both maps
              </label>
            )}
          </div>
        </section>
      </div>
      <Listing listing={choice.listing} keys={keys}>
        <LevelTable plate={plate} choice={choice} />
        <ModeTable plate={plate} choice={choice} />
      </Listing>
    </Frame>
  );
}

function Legend({ plate, choice }: Props) {
  return (
    <p class="legend">
      {plate.curves(choice.shown.value).map(({ name }, k) => (
        <span class="of-curve">
          <svg width="34" height="8" aria-hidden="true">
            <line
              x1="0" x2="34" y1="4" y2="4" stroke-width="2"
              stroke={`var(--curve-${k % COLOURS})`} stroke-dasharray={(DASHES[k % DASHES.length] ?? []).join(" ")}
            />
          </svg>{" "}
          {name}
        </span>
      ))}
      {plate.gap !== null && plate.covers(...plate.gap) && <span class="of-gap">gap</span>}
      {plate.carrier !== null && plate.covers(plate.carrier) && <span class="of-carrier">carrier</span>}
    </p>
  );
}

function frequencyText(frequency: number, unit: Unit): string {
  return withUnit(rounded(frequency / unit.factor), unit);
}

function LineFacts({ plate, choice }: Props) {
  const line = choice.line.value;
  const frequency = plate.frequency[line] ?? 0;
  const contrasts = plate.curves("contrast");
  return (
    <div class="facts">
      <p id="point" aria-live="polite">
        <b>{frequencyText(frequency, choice.unit.value)}</b>: up to {size(plate.largest(line))}
        {plate.drive}
        {contrasts.map(({ name, values }) => `; ${name} ${signed(values[line]?.toFixed(1) ?? "-")} dB`).join("")}
      </p>
      <p class="again">
        The same map as a picture, in Python: <code>{`${plate.python}.plot("maps", frequency=${Number(frequency.toFixed(3))})`}</code>
      </p>
    </div>
  );
}

function FrequencySlider({ plate, choice }: Props) {
  const last = plate.frequency.length - 1;
  const line = choice.line.value;
  return (
    <label class="long">
      frequency: {frequencyText(plate.frequency[line] ?? 0, choice.unit.value)}
      <input
        type="range" min="0" max={last} step="1" value={line} disabled={last === 0}
        aria-valuetext={frequencyText(plate.frequency[line] ?? 0, choice.unit.value)}
        onInput={(event) => (choice.line.value = Number(event.currentTarget.value))}
      />
    </label>
  );
}

function LevelTable({ plate, choice }: Props) {
  const line = choice.line.value;
  const rows = SHOWN.flatMap((shown) =>
    plate.curves(shown).map(({ name, values }) => [
      plate.data.title(shown),
      name,
      `${signed(values[line]?.toPrecision(3) ?? "-")} ${plate.data.unit(shown)}`,
    ]),
  );
  for (const field of plate.fields.length > 1 ? plate.fields : [])
    rows.push(["largest displacement", field.title, `${size(field.largest(line))}${plate.drive}`]);
  if (plate.data.has("agreement"))
    rows.push([plate.data.title("agreement"), "both maps", (plate.data.values("agreement")[line] ?? 0).toFixed(3)]);
  return (
    <div class="wide">
      <table>
        <caption>Regions at {frequencyText(plate.frequency[line] ?? 0, choice.unit.value)}</caption>
        <tbody>
          {rows.map((cells) => (
            <tr>
              {cells.map((cell) => (
                <td>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function ModeTable({ plate, choice }: Props) {
  if (plate.modes.length === 0) return null;
  return (
    <div class="wide">
      <table>
        <caption>Modes near the carrier</caption>
        <thead>
          <tr>
            <th scope="col">frequency</th>
            <th scope="col">nodal lines</th>
            <th scope="col">Q</th>
            <th scope="col">show</th>
          </tr>
        </thead>
        <tbody>
          {plate.modes.map(({ frequency, name, quality }) => (
            <tr>
              <td>{frequencyText(frequency, choice.unit.value)}</td>
              <td>{name}</td>
              <td>{quality.toFixed(0)}</td>
              <td>
                <button type="button" onClick={() => (choice.line.value = plate.nearest(frequency))}>
                  {frequencyText(plate.frequency[plate.nearest(frequency)] ?? 0, choice.unit.value)}
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
