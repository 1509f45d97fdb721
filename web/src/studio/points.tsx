/** The panel of computed designs: their plot, the selected one, and a table. */

import { useEffect, useRef } from "preact/hooks";
import { keyPressed, type Key } from "../parts/keys";
import { Walk } from "../parts/walk";
import { shown } from "./jobs";
import { across, at, axes, drawn, group, groups, horizontal, ORDER, points, selected, written } from "./points_data";
import { marksOf, plotPoints } from "./points_plot";
import { openDesign } from "./study";

const MOST_ROWS = 500;

function step(by: number): void {
  const title = horizontal.peek();
  const order = [...drawn.peek()].sort((a, b) => at(points.peek()[a]!, a, title) - at(points.peek()[b]!, b, title));
  const now = selected.peek() === null ? -1 : order.indexOf(selected.peek()!);
  selected.value = order[Math.min(Math.max(now + by, 0), order.length - 1)] ?? null;
}

const open = (place: number | null) => {
  if (place !== null && shown.peek() !== null) void openDesign(shown.peek()!, place);
};

export const pointsKeys: Key[] = [
  { keys: "← →", effect: "previous or next design", actions: { ArrowLeft: () => step(-1), ArrowRight: () => step(1) } },
  { keys: "Enter", effect: "open the design in the text", actions: { Enter: () => open(selected.peek()) } },
];

export function Points() {
  const count = points.value.length;
  if (count === 0) return null;
  return (
    <details class="section" open>
      <summary>
        Computed designs <span class="quiet">{count}</span>
      </summary>
      <div class="row">
        {groups.value.length > 1 && (
          <label>
            Part
            <select value={group.value} onChange={(event) => (group.value = event.currentTarget.value)}>
              <option value="">all</option>
              {groups.value.map((name) => (
                <option>{name}</option>
              ))}
            </select>
          </label>
        )}
        <label>
          Horizontal axis
          <select value={horizontal.value} onChange={(event) => (across.value = event.currentTarget.value)}>
            {[...axes.value, ORDER].map((title) => (
              <option>{title}</option>
            ))}
          </select>
        </label>
        <Legend />
      </div>
      <Walk
        label="Computed designs. Arrow keys select a design, Enter opens it."
        describedBy="selected-design"
        onKeyDown={(event) => keyPressed(event, pointsKeys)}
      >
        <Plot />
      </Walk>
      <Selected />
      <details class="further">
        <summary>Designs as a table</summary>
        <DesignTable />
      </details>
    </details>
  );
}

function Plot() {
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => (place.current === null ? undefined : plotPoints(place.current)), []);
  return <div class="curves" ref={place} />;
}

function Legend() {
  const { list, titles } = marksOf();
  const empty = drawn.value.filter((place) => points.value[place]?.results.length === 0).length;
  return (
    <span class="quiet legend">
      {titles.map((title, k) => (
        <span class="of-mark" style={{ "--mark": `var(--curve-${k % 4})`, "--round": k % 2 ? "0" : "50%" }}>
          {title}
        </span>
      ))}
      {list.some(({ error }) => error === null) && <span class="of-hollow">hollow: preview, without an error</span>}
      {empty > 0 && <span>{empty} of {drawn.value.length} without a result are not in the plot</span>}
    </span>
  );
}

function Selected() {
  const place = selected.value;
  const point = place === null ? undefined : points.value[place];
  if (point === undefined)
    return (
      <p id="selected-design" class="quiet">
        Select a design with a click or the arrow keys.
      </p>
    );
  const facts = [
    ...point.varied.map((each) => [each.title, written(each, false)]),
    ...point.results.map((each) => [each.title, written(each, true)]),
  ];
  return (
    <div class="facts">
      <p id="selected-design" aria-live="polite">
        Design {place! + 1}{groups.value.length > 1 && `, ${point.group}`}: {facts.map(([title, text]) => `${title} ${text}`).join(", ")}
        {point.results.length === 0 && ", no result"}.{" "}
        <button type="button" onClick={() => open(place)}>
          Open as a design
        </button>
      </p>
    </div>
  );
}

function DesignTable() {
  const places = drawn.value.slice(0, MOST_ROWS);
  const heads = (part: "varied" | "results") => [
    ...new Set(places.flatMap((place) => points.value[place]![part].map(({ title }) => title))),
  ];
  const [varied, results] = [heads("varied"), heads("results")];
  const cell = (place: number, part: "varied" | "results", title: string) => {
    const number = points.value[place]![part].find((each) => each.title === title);
    return <td class="number">{number === undefined ? "-" : written(number, part === "results")}</td>;
  };
  return (
    <div class="wide" tabIndex={0} role="group" aria-label="Computed designs">
      <table>
        <thead>
          <tr>
            <th scope="col">design</th>
            <th scope="col">part</th>
            {[...varied, ...results].map((head) => (
              <th scope="col">{head}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {places.map((place) => (
            <tr aria-current={selected.value === place ? "true" : undefined}>
              <td>
                <button type="button" class="minor" onClick={() => open(place)}>
                  Open {place + 1}
                </button>
              </td>
              <td>{points.value[place]!.group}</td>
              {varied.map((title) => cell(place, "varied", title))}
              {results.map((title) => cell(place, "results", title))}
            </tr>
          ))}
        </tbody>
      </table>
      {drawn.value.length > MOST_ROWS && <p class="quiet">and {drawn.value.length - MOST_ROWS} more</p>}
    </div>
  );
}
