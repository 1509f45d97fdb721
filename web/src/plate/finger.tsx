/** A finger that is moved over a vibrating plate: the view of kind "finger". */

import type { Signal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Dataset, Numbers } from "../dataset";
import { FactList } from "../parts/facts";
import { Frame } from "../parts/frame";
import { Listing } from "../parts/listing";
import { Walk } from "../parts/walk";
import { FingerCurve } from "./finger_curve";
import { FingerData, noticed, type End } from "./finger_data";
import { FingerMap } from "./finger_map";
import { fingerKeys, startingFinger, type Finger } from "./finger_state";
import { size } from "./map";

const FOOT =
  "All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, " +
  "at the nearest computed place.";
const STEPS = 500; // of the drive's slider

export function fingerView(data: Dataset) {
  return <FingerView dataset={data} />;
}

interface Props {
  data: FingerData;
  finger: Finger;
}

function FingerView({ dataset }: { dataset: Dataset }) {
  const data = useMemo(() => new FingerData(dataset), [dataset]);
  const finger = useMemo(() => startingFinger(data), [data]);
  const keys = useMemo(() => fingerKeys(data, finger), [data, finger]);
  return (
    <Frame name="finger" data={dataset} keys={keys} foot={FOOT}>
      <div class="pair">
        <section aria-label="Map">
          <Walk label="Finger on the plate. Arrow keys move it." describedBy="felt">
            <FingerMap data={data} finger={finger} />
          </Walk>
        </section>
        <section aria-label="Friction">
          <Below data={data} finger={finger} />
          <FingerCurve data={data} finger={finger} />
          <Sliders data={data} finger={finger} />
        </section>
      </div>
      <Listing listing={finger.listing} keys={keys}>
        <Parameters data={data} />
      </Listing>
    </Frame>
  );
}

/** A number in a unit with a suitable prefix. */
function written(value: number, unit: string): string {
  const size = Math.abs(value);
  const [prefix, factor] = size >= 1 || size === 0 ? ["", 1] : size >= 1e-3 ? ["m", 1e3] : ["µ", 1e6];
  return `${Number((value * Number(factor)).toPrecision(3))} ${prefix}${unit}`;
}

const percent = (share: number): string => `${(100 * share).toFixed(0)} %`;

function Below({ data, finger }: Props) {
  const { amplitude, free, friction, reduction } = finger.below.value;
  const place = finger.place.value;
  const { weber, frequency, drive, diameter } = data.extra;
  const interval = (of: Record<End, number>, text: (value: number) => string, [low, high]: [End, End]) =>
    `${text(of.value)} (${text(of[low])} to ${text(of[high])})`;
  const ratio = (value: number) => value.toFixed(2);
  return (
    <div class="facts">
      <p id="felt" aria-live="polite">
        <b>{data.region(place)}</b>, x = {written(data.x[place] ?? 0, "m")}, y = {written(data.y[place] ?? 0, "m")}:{" "}
        <b>{noticed(reduction, weber)}</b>
      </p>
      <FactList
        facts={[
          ["μ/μ₀, model", interval(friction, ratio, ["low", "high"])],
          ["less friction", interval(reduction, percent, ["low", "high"])],
          ["amplitude below the finger", interval(amplitude, size, ["high", "low"])],
          ["without a finger", size(free)],
        ]}
      />
      <p class="again">
        Just noticed: {percent(weber)} less friction. The finger covers {written(diameter, "m")};{" "}
        {Number((frequency / 1e3).toFixed(3))} kHz. The same in the study:{" "}
        <code>
          touch = {"{"} force = "{written(data.forces[finger.force.value] ?? 0, "N")}", speed = "
          {written(data.speeds[finger.speed.value] ?? 0, "m/s")}"
          {drive.unit === "V" ? `, voltage = "${written(finger.drive.value, "V")}"` : ""} {"}"}
        </code>
      </p>
    </div>
  );
}

function Sliders({ data, finger }: Props) {
  const { low, high, title, unit } = data.extra.drive;
  return (
    <div class="controls">
      <label class="long">
        Drive, {title.toLowerCase()}: {written(finger.drive.value, unit)}
        <input
          type="range" min={low} max={high} step={(high - low) / STEPS || 1} value={finger.drive.value}
          aria-valuetext={written(finger.drive.value, unit)}
          onInput={(event) => (finger.drive.value = Number(event.currentTarget.value))}
        />
      </label>
      <Steps title={data.data.title("force")} unit="N" values={data.forces} chosen={finger.force} />
      <Steps title={data.data.title("speed")} unit="m/s" values={data.speeds} chosen={finger.speed} />
    </div>
  );
}

/** A slider over computed values. */
function Steps({ title, unit, values, chosen }: { title: string; unit: string; values: Numbers; chosen: Signal<number> }) {
  const words = written(values[chosen.value] ?? 0, unit);
  return (
    <label class="long">
      {title}: {words}
      <input
        type="range" min="0" max={values.length - 1} step="1" value={chosen.value} aria-valuetext={words}
        onInput={(event) => (chosen.value = Number(event.currentTarget.value))}
      />
    </label>
  );
}

function Parameters({ data }: { data: FingerData }) {
  return (
    <div class="wide">
      <table>
        <caption>Numbers of the models</caption>
        <thead>
          <tr>
            {["number", "value", "plausible", "origin", "source"].map((head) => (
              <th scope="col">{head}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {data.extra.parameters.map(({ title, value, plausible, mark, source }) => (
            <tr>
              {[title, value, plausible, mark, source].map((cell) => (
                <td>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <dl>
        {Object.entries(data.extra.models).map(([name, words]) => (
          <div>
            <dt>Model of {name}</dt>
            <dd>{words}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}
