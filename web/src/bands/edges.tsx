/** The gap at the carrier with its margin, always in sight, and the comparison with a held design. */

import { uncertain } from "../parts/numbers";
import { rounded, withUnit, type Unit } from "../parts/units";
import type { Gap } from "./diagram_data";

/** The complete gap in which a carrier is deepest or to which it is nearest; without a carrier the widest. */
export function gapOf(gaps: Gap[], carrier: number | undefined): Gap | undefined {
  const room = (gap: Gap) => (carrier === undefined ? gap.upper - gap.lower : marginOf(gap, carrier).room);
  return gaps.filter(({ complete }) => complete).sort((a, b) => room(b) - room(a))[0];
}

/** Distance of a carrier inside the nearer edge, Hz, and the error of that edge. */
function marginOf(gap: Gap, carrier: number): { room: number; error: number } {
  const [below, above] = [carrier - gap.lower, gap.upper - carrier];
  return below < above ? { room: below, error: gap.lowerError } : { room: above, error: gap.upperError };
}

/** Edges, width and margin as texts by their titles. */
export function edgeFacts(gaps: Gap[], carrier: number | undefined, unit: Unit): Record<string, string> {
  const gap = gapOf(gaps, carrier);
  const { factor } = unit;
  const number = (value: number, error: number) => uncertain(value / factor, error / factor);
  const text = (value: number, error: number) => withUnit(number(value, error), unit);
  if (gap === undefined) return { gap: "none complete below the last band" };
  const margin = carrier === undefined ? undefined : marginOf(gap, carrier);
  return {
    gap: withUnit(`${number(gap.lower, gap.lowerError)} to ${number(gap.upper, gap.upperError)}`, unit),
    width: text(gap.upper - gap.lower, gap.lowerError + gap.upperError),
    ...(margin && carrier !== undefined
      ? { [`margin at ${withUnit(rounded(carrier / factor), unit)}`]: text(margin.room, margin.error) }
      : {}),
  };
}

interface EdgesProps {
  gaps: Gap[];
  carrier: number | undefined;
  unit: Unit;
}

export function Edges({ gaps, carrier, unit }: EdgesProps) {
  const gap = gapOf(gaps, carrier);
  const isOpen = gap !== undefined && gap.upper - gap.lower > gap.lowerError + gap.upperError;
  return (
    <dl class="edges">
      {Object.entries(edgeFacts(gaps, carrier, unit)).map(([title, value]) => (
        <div>
          <dt>{title}</dt>
          <dd>{value}</dd>
        </div>
      ))}
      {gap !== undefined && !isOpen && (
        <div>
          <dt>narrower than its errors</dt>
          <dd>may be closed</dd>
        </div>
      )}
    </dl>
  );
}

export interface Held {
  gaps: Gap[];
  carrier: number | undefined;
  design: Record<string, string>;
}

interface ComparisonProps {
  held: Held;
  now: Held;
  unit: Unit;
  isPreview: boolean;
  drop: () => void;
}

/** Differences between a held design and the one that is drawn. */
export function Comparison({ held, now, unit, isPreview, drop }: ComparisonProps) {
  const facts = ({ gaps, carrier }: Held) => edgeFacts(gaps, carrier, unit);
  const changed = Object.keys(now.design).filter((title) => now.design[title] !== held.design[title]);
  const rows: [string, string, string][] = [
    ...changed.map((title): [string, string, string] => [title, held.design[title] ?? "", now.design[title] ?? ""]),
    ...[...new Set([...Object.keys(facts(held)), ...Object.keys(facts(now))])].map(
      (title): [string, string, string] => [title, facts(held)[title] ?? "", facts(now)[title] ?? ""],
    ),
  ];
  return (
    <div class="wide" tabIndex={0} role="group" aria-label="Held design and this one">
      <table>
        <caption>Held design and this one</caption>
        <thead>
          <tr>
            <th scope="col">quantity</th>
            <th scope="col">held</th>
            <th scope="col">{isPreview ? "preview" : "this design"}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(([title, before, after]) => (
            <tr>
              <th scope="row">{title}</th>
              <td>{before}</td>
              <td>{after}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <button type="button" onClick={drop}>
        Let go of the held design
      </button>
    </div>
  );
}
