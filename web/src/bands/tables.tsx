/** The numbers of the diagram as tables. */

import { uncertain } from "../parts/numbers";
import { titled, type Unit } from "../parts/units";
import type { BandDiagram } from "./diagram_data";
import type { Choice } from "./state";

export function GapTable({ diagram, unit }: { diagram: BandDiagram; unit: Unit }) {
  const { factor } = unit;
  if (diagram.gaps.length === 0) return <p>The computed bands have no gap.</p>;
  return (
    <div class="wide">
      <table>
        <caption>Gaps</caption>
        <thead>
          <tr>
            <th scope="col">bands</th>
            <th scope="col">where</th>
            <th scope="col">{titled("lower", unit)}</th>
            <th scope="col">{titled("upper", unit)}</th>
          </tr>
        </thead>
        <tbody>
          {diagram.gaps.map((gap) => (
            <tr>
              <td>
                {gap.waves === "all" ? "" : `${gap.waves} `}
                {gap.below}-{gap.below + 1}
              </td>
              <td>{gap.complete ? "everywhere (complete)" : gap.waves === "all" ? `${gap.direction} only` : "everywhere, these waves only"}</td>
              <td>{uncertain(gap.lower / factor, gap.lowerError / factor)}</td>
              <td>{uncertain(gap.upper / factor, gap.upperError / factor)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Modes at the selected wavevector. */
export function ModeTable({ diagram, choice }: { diagram: BandDiagram; choice: Choice }) {
  const { row, band } = choice.point.value;
  const unit = choice.unit.value;
  const { factor } = unit;
  const points = Array.from({ length: diagram.bands }, (_, number) => ({ row, band: number }));
  return (
    <div class="wide">
      <table>
        <caption>Modes at {diagram.place(row)}</caption>
        <thead>
          <tr>
            <th scope="col">band</th>
            <th scope="col">{titled("frequency", unit)}</th>
            <th scope="col">motion</th>
            <th scope="col">symmetry</th>
            <th scope="col">show</th>
          </tr>
        </thead>
        <tbody>
          {points.map((point) => (
            <tr aria-current={point.band === band ? "true" : undefined}>
              <td>{point.band + 1}</td>
              <td>{uncertain(diagram.at(point) / factor, diagram.errorAt(point) / factor)}</td>
              <td>{diagram.nature(point)}</td>
              <td>{diagram.parity(point)}</td>
              <td>
                <button type="button" onClick={() => (choice.point.value = point)}>
                  band {point.band + 1}
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
