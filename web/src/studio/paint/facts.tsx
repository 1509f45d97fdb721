/** Sizes, counts and mass of a plate, and the estimated costs of its commands. */

import { computed } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { FactList } from "../../parts/facts";
import { jobs } from "../jobs";
import { problems, text } from "../study";
import { server, type Forecast } from "../server";
import { ABSENT } from "./grid";
import { drawing, grid, isPending, tiles } from "./state";

const PAUSE = 800; // ms after the last change before costs are estimated

/** True while curves of a turned number are computed; an estimate would take a core from them. */
const isTurning = computed(() => jobs.value.some(({ state, turned }) => state === "running" && turned));

/** A number with three digits, without a power of ten. */
const short = (value: number): string => String(Number(value.toPrecision(3)));

export function Facts() {
  const [map, plan] = [grid.value, drawing.value];
  if (map === null) return null;
  const counts = new Map<string, number>();
  for (const letter of map.flat()) counts.set(letter, (counts.get(letter) ?? 0) + 1);
  const fits = plan !== null && plan.x.length === (map[0]?.length ?? 0) + 1 && plan.y.length === map.length + 1;
  const isOld = isPending.value || problems.value.length > 0;
  const facts: [string, string][] = [
    ...tiles.value
      .filter(({ letter }) => letter !== ABSENT)
      .map(({ letter, name }): [string, string] => [name, `${counts.get(letter) ?? 0} tiles`]),
    ["map", `${map[0]?.length} x ${map.length} tiles`],
  ];
  if (plan !== null && fits) {
    facts.push(["size", `${short(1e3 * (plan.x.at(-1) ?? 0))} x ${short(1e3 * (plan.y.at(-1) ?? 0))} mm`]);
    facts.push(["contents", plan.contents]);
    if (plan.mass !== null) facts.push(["mass without patches", `${short(1e3 * plan.mass)} g`]);
  }
  return (
    <div class="facts">
      <FactList facts={facts} />
      {isOld && <p class="quiet">Size, contents and mass are those of the last map that could be built.</p>}
      {!isOld && plan?.remarks.map((sentence) => <p class="doubt">{sentence}</p>)}
    </div>
  );
}

export function Forecasts() {
  const [costs, setCosts] = useState<{ of: string; costs: Forecast[] } | null>(null);
  const wanted = useRef<string | null>(null); // text that waits while another is estimated
  const isBusy = useRef(false);
  const current = text.value;
  const waits = isTurning.value;
  useEffect(() => {
    if (waits) return;
    const timer = setTimeout(async () => {
      wanted.current = current;
      if (isBusy.current) return;
      isBusy.current = true;
      while (wanted.current !== null) {
        const of: string = wanted.current;
        wanted.current = null;
        try {
          setCosts({ of, ...(await server.forecast(of)) });
        } catch {
          // the page reports a server that does not answer
        }
      }
      isBusy.current = false;
    }, PAUSE);
    return () => clearTimeout(timer);
  }, [current, waits]);
  const isOld = costs === null || costs.of !== current;
  return (
    <details open>
      <summary>
        Estimated costs <span class="quiet">as orders of magnitude</span>
      </summary>
      {isOld ? (
        <p class="quiet">Estimated again after a moment without changes.</p>
      ) : costs.costs.length === 0 ? (
        <p class="quiet">Not estimated, because the study has a problem.</p>
      ) : (
        <table>
          <thead>
            <tr>
              <th scope="col">command</th>
              <th scope="col">processor time</th>
              <th scope="col">memory</th>
            </tr>
          </thead>
          <tbody>
            {costs.costs.map(({ command, time, memory, refusal }) => (
              <tr>
                <td>haptonic {command}</td>
                <td>{refusal ? `refused: ${refusal}` : time}</td>
                <td>{refusal ? "" : memory}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </details>
  );
}
