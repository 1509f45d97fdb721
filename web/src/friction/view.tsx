/** Estimates of friction trials with their intervals: the view of kind "friction". */

import { signal, type Signal } from "@preact/signals";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Dataset } from "../dataset";
import { Frame } from "../parts/frame";
import type { Key } from "../parts/keys";
import { Listing, listingKeys, type Listed } from "../parts/listing";
import { typeset } from "../parts/numbers";
import { Walk } from "../parts/walk";

const FOOT = "Squares are all participants together, discs are single ones; circles are trials.";
const [LINE, TOP, FOOT_ROOM, RIGHT] = [24, 8, 36, 16]; // CSS pixels
const LETTER = 7.2; // width of one, on average
const NARROWEST = 300;

interface Estimate {
  quantity: string;
  name: string;
  value: number;
  low: number;
  high: number;
  note: string;
  whole: boolean;
  trials: number[];
}

interface Choice {
  quantity: Signal<string>;
  row: Signal<number>;
  listing: Signal<Listed>;
}

export function frictionView(data: Dataset) {
  return <FrictionView data={data} />;
}

function FrictionView({ data }: { data: Dataset }) {
  const all = useMemo(() => estimatesOf(data), [data]);
  const quantities = useMemo(() => [...new Set(all.map(({ quantity }) => quantity))], [all]);
  const choice = useMemo(
    (): Choice => ({ quantity: signal(quantities[0] ?? ""), row: signal(0), listing: signal<Listed>("none") }),
    [quantities],
  );
  const keys = useMemo(() => keysOf(all, quantities, choice), [all, quantities, choice]);
  const shown = all.filter(({ quantity }) => quantity === choice.quantity.value);
  const chosen = shown[choice.row.value];
  const sentences = (data.header.extra["sentences"] ?? []) as string[];
  return (
    <Frame name="friction" data={data} keys={keys} foot={FOOT}>
      {sentences.length > 0 && (
        <details>
          <summary>Estimates, tests and assumptions</summary>
          {sentences.map((sentence) => (
            <p>{typeset(sentence)}</p>
          ))}
        </details>
      )}
      <p class="axes">
        <label>
          Quantity{" "}
          <select
            value={choice.quantity.value}
            onChange={(event) => {
              choice.quantity.value = event.currentTarget.value;
              choice.row.value = 0;
            }}
          >
            {quantities.map((quantity) => (
              <option>{quantity}</option>
            ))}
          </select>
        </label>
      </p>
      <Walk label="Estimates. Arrow keys go from one to the next.">
        <Plot estimates={shown} choice={choice} />
      </Walk>
      <div class="facts">
        <p id="point" aria-live="polite">
          {chosen !== undefined && (
            <>
              <b>{chosen.name}</b>: {words(chosen)}
              {chosen.note && `; ${chosen.note}`}
            </>
          )}
        </p>
      </div>
      <Listing listing={choice.listing} keys={keys}>
        {quantities.map((quantity) => (
          <EstimateTable title={quantity} estimates={all.filter((each) => each.quantity === quantity)} />
        ))}
      </Listing>
    </Frame>
  );
}

function Plot({ estimates, choice }: { estimates: Estimate[]; choice: Choice }) {
  const [place, width] = useWidth();
  const left = Math.min(LETTER * Math.max(...estimates.map(({ name }) => name.length), 4) + 12, 0.5 * width);
  const ends = estimates.flatMap(({ value, low, high, trials }) => [value, low, high, ...trials]).filter(Number.isFinite);
  const [least, most] = [Math.min(0, ...ends), Math.max(...ends, 0.01)];
  const at = (value: number) => left + ((value - least) / (most - least)) * (width - left - RIGHT);
  const bottom = TOP + LINE * estimates.length;
  return (
    <div ref={place}>
      <svg class="estimates" width={width} height={bottom + FOOT_ROOM} role="img" aria-label={`${choice.quantity.value}; the table has all numbers`}>
        {ticks(least, most).map((tick) => (
          <>
            <line x1={at(tick)} x2={at(tick)} y1={TOP} y2={bottom} />
            <text x={at(tick)} y={bottom + 16} text-anchor="middle" class="quiet">
              {`${tick}`.replace("-", "−")}
            </text>
          </>
        ))}
        <text x={(left + width) / 2} y={bottom + 32} text-anchor="middle">
          {choice.quantity.value}
        </text>
        {estimates.map((estimate, row) => {
          const y = TOP + LINE * (row + 0.5);
          const { value, low, high, name, whole, trials } = estimate;
          return (
            <g class={whole ? "whole" : ""} onClick={() => (choice.row.value = row)}>
              <rect class={choice.row.value === row ? "chosen" : ""} x="1" y={y - LINE / 2} width={width - 2} height={LINE}
                fill="transparent" />
              <text x={left - 8} y={y + 4} text-anchor="end">
                {name}
              </text>
              {trials.map((trial) => (
                <circle class="trial" cx={at(trial)} cy={y} r="2.5" />
              ))}
              {Number.isFinite(low) && <line class="interval" x1={at(low)} x2={at(high)} y1={y} y2={y} />}
              {Number.isFinite(value) &&
                (whole ? <rect class="mark" x={at(value) - 5} y={y - 5} width="10" height="10" /> : <circle cx={at(value)} cy={y} r="4.5" />)}
            </g>
          );
        })}
      </svg>
    </div>
  );
}

function EstimateTable({ title, estimates }: { title: string; estimates: Estimate[] }) {
  return (
    <div class="wide" tabIndex={0} role="group" aria-label={title}>
      <table>
        <caption>{title}</caption>
        <thead>
          <tr>
            <th scope="col">of</th>
            <th scope="col">value</th>
            <th scope="col">from</th>
            <th scope="col">to</th>
            <th scope="col">note</th>
          </tr>
        </thead>
        <tbody>
          {estimates.map(({ name, value, low, high, note }) => (
            <tr>
              <td>{name}</td>
              <td>{number(value)}</td>
              <td>{number(low)}</td>
              <td>{number(high)}</td>
              <td>{note}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const number = (value: number) => (Number.isFinite(value) ? value.toFixed(3).replace("-", "−") : "-");

const words = ({ value, low, high }: Estimate) =>
  number(value) + (Number.isFinite(low) ? `, from ${number(low)} to ${number(high)}` : "");

function estimatesOf(data: Dataset): Estimate[] {
  const [quantities, names, notes] = ["quantity", "name", "note"].map((name) => data.texts(name));
  const [low, high, whole] = ["low", "high", "whole"].map((name) => data.values(name));
  const conditions = data.texts("trial_condition");
  const trials = new Map<string, number[]>();
  data.values("trial_friction").forEach((value, k) => {
    const condition = conditions[k] ?? "";
    trials.set(condition, [...(trials.get(condition) ?? []), value]);
  });
  return Array.from(data.values("value"), (value, k) => ({
    quantity: quantities?.[k] ?? "",
    name: names?.[k] ?? "",
    note: notes?.[k] ?? "",
    value,
    low: low?.[k] ?? NaN,
    high: high?.[k] ?? NaN,
    whole: whole?.[k] === 1,
    trials: (trials.get(names?.[k] ?? "") ?? []).filter(Number.isFinite),
  }));
}

function keysOf(all: Estimate[], quantities: string[], choice: Choice): Key[] {
  const last = () => all.filter(({ quantity }) => quantity === choice.quantity.peek()).length - 1;
  const walk = (by: number) => () => (choice.row.value = Math.min(Math.max(choice.row.peek() + by, 0), last()));
  const next = () => {
    const place = quantities.indexOf(choice.quantity.peek());
    choice.quantity.value = quantities[(place + 1) % quantities.length] ?? "";
    choice.row.value = 0;
  };
  return [
    { keys: "↑ ↓", effect: "previous or next estimate", actions: { ArrowUp: walk(-1), ArrowDown: walk(1) } },
    { keys: "q", effect: "next quantity", actions: { q: next } },
    ...listingKeys(choice.listing),
  ];
}

/** Round numbers between two ends, about five of them. */
function ticks(low: number, high: number): number[] {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, k) => Number(((first + k) * step).toPrecision(6)));
}

/** An element and its width in CSS pixels, now and later. */
function useWidth() {
  const place = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(NARROWEST);
  useEffect(() => {
    const element = place.current;
    if (element === null) return;
    const resized = new ResizeObserver(() => setWidth(Math.min(Math.max(element.clientWidth, NARROWEST), 960)));
    resized.observe(element);
    return () => resized.disconnect();
  }, []);
  return [place, width] as const;
}
