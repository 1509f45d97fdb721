/** Band diagram and moving mode: the view of kind "bands". */

import { computed } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Dataset } from "../dataset";
import { PaceSlider, PlayButton, UnitSelect } from "../parts/controls";
import { FactList } from "../parts/facts";
import { Frame } from "../parts/frame";
import type { Host } from "../parts/host";
import { Listing } from "../parts/listing";
import { uncertain } from "../parts/numbers";
import { withUnit } from "../parts/units";
import { velocityText } from "../parts/velocity";
import { Walk } from "../parts/walk";
import { Curves } from "./curves";
import { BandDiagram } from "./diagram_data";
import { Comparison, Edges } from "./edges";
import { bandsKeys } from "./keys";
import { layerOfDiagram, newerThan, type Layer } from "./layer";
import { Mode } from "./mode";
import { UNTURNED, type Motion } from "./moving_mode";
import { LARGEST_SWING, MOST_COPIES, startingChoice, type Choice } from "./state";
import { GapTable, ModeTable } from "./tables";
import { Zone } from "./zone";

export function bandsView(data: Dataset, host?: Host) {
  return <BandsView data={data} host={host} />;
}

const FOOT =
  "Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of " +
  "the model.";

function BandsView({ data, host }: { data: Dataset; host: Host | undefined }) {
  const diagram = useMemo(() => new BandDiagram(data), [data]);
  // the choices stay when a newer result has as many modes
  const choice = useMemo(() => startingChoice(diagram), [diagram.rows, diagram.bands]);
  const motion = useMemo(() => motionOfPath(diagram, choice), [diagram, choice]);
  const newer = useMemo(() => newerThan(host?.turned), [host]);
  const hold = () => {
    const drawn = newer.layer.peek() ?? layerOfDiagram(diagram);
    if (choice.held.value !== null) choice.held.value = null;
    else if (!drawn.areGapsPreview && !newer.isWaiting.peek())
      choice.held.value = { layer: drawn, gaps: drawn.gaps, carrier: diagram.carrier, design: host?.design() ?? {} };
  };
  const keys = useMemo(() => bandsKeys(diagram, choice, host && hold), [diagram, choice, host]);
  const layer = newer.layer.value;
  const kind = newer.isWaiting.value ? "earlier design" : kindOf(layer);
  const isOld = newer.isWaiting.value || layer !== null; // sentences and modes are those of the view's design
  const held = choice.held.value;
  const { carrier } = diagram;
  const unit = diagram.units.find(({ name }) => name === choice.unit.value.name) ?? choice.unit.value;
  const gaps = (layer ?? diagram).gaps;
  return (
    <Frame name="bands" data={data} keys={keys} foot={FOOT} isOld={isOld}>
      <div class="insight">
        {host?.controls}
        <span class={`kind ${kind}`}>{kind}</span>
        {host && (
          <button type="button" class="minor" aria-label="Hold this design" aria-pressed={held !== null}
            disabled={kind !== "certified" && held === null} onClick={hold}>
            Hold
          </button>
        )}
        {kind === "earlier design" ? (
          <p>{host?.turned.value?.preview ? "Too far for a preview." : "No preview yet."} Certified curves follow.</p>
        ) : (
          <Edges gaps={gaps} carrier={carrier} unit={unit} />
        )}
      </div>
      <div class="pair">
        <section aria-label="Band diagram">
          <Walk label="Band diagram. Arrow keys move along the path and between bands.">
            <Curves diagram={diagram} choice={choice} newer={newer} />
          </Walk>
          <p class="axes">
            <UnitSelect title="Frequencies in" units={diagram.units} unit={choice.unit} />
            <UnitSelect title="Wavevectors in" units={diagram.wavevectorUnits} unit={choice.wavevectorUnit} />
            <Legend diagram={diagram} isPreview={kind === "preview"} isHeld={held !== null} />
          </p>
          {held !== null && host && kind !== "earlier design" && (
            <Comparison held={held} now={{ gaps, carrier, design: host.design() }} unit={unit} isPreview={kind !== "certified"}
              drop={hold} />
          )}
        </section>
        <section aria-label="Mode">
          <Mode data={data} choice={choice} motion={motion} name="mode" />
          <PointFacts diagram={diagram} choice={choice} isOld={isOld} />
          <MotionControls choice={choice} />
        </section>
      </div>
      <Zone diagram={diagram} choice={choice} />
      <Listing listing={choice.listing} keys={keys}>
        <GapTable diagram={diagram} unit={choice.unit.value} />
        <ModeTable diagram={diagram} choice={choice} />
      </Listing>
    </Frame>
  );
}

/** How exact the curves and the gaps of a layer are; without one they are those of the result. */
function kindOf(layer: Layer | null) {
  if (layer === null || !layer.areGapsPreview) return "certified";
  return layer.isPreview ? "preview" : "preview of gaps";
}

/** Motion of the selected mode of the diagram. */
function motionOfPath(diagram: BandDiagram, choice: Choice) {
  return computed((): Motion => {
    const { row, band } = choice.point.value;
    return { of: "path", row, band, kappa: diagram.phases(row), turn: UNTURNED, isReversed: false };
  });
}

interface LegendProps {
  diagram: BandDiagram;
  isPreview: boolean;
  isHeld: boolean;
}

function Legend({ diagram, isPreview, isHeld }: LegendProps) {
  return (
    <span class="legend">
      {diagram.gaps.some((gap) => gap.complete) && <span class="of-gap">complete gap</span>}
      {diagram.gaps.some((gap) => gap.waves !== "all") && (
        <span class="of-parity">gap of one parity</span>
      )}
      {diagram.carrier !== undefined && <span class="of-carrier">carrier</span>}
      {isPreview && <span class="of-preview">preview with its error</span>}
      {isHeld && <span class="of-held">held design</span>}
    </span>
  );
}

/** Facts of the selected mode, spoken by a screen reader when another mode is selected. */
function PointFacts({ diagram, choice, isOld }: { diagram: BandDiagram; choice: Choice; isOld: boolean }) {
  const point = choice.point.value;
  const unit = choice.unit.value;
  const velocity = diagram.velocity(point);
  const facts: [string, string][] = [
    ["motion", diagram.nature(point)],
    ["symmetry", diagram.parity(point)],
    ["group velocity", velocity ? velocityText(velocity, diagram.velocityError(point)) : "not defined"],
  ];
  const place = diagram.place(point.row);
  return (
    <div class="facts">
      <p id="point" aria-live="polite">
        Band {point.band + 1} at {place}
        {isOld && ", earlier design"}: <b>{withUnit(uncertain(diagram.at(point) / unit.factor, diagram.errorAt(point) / unit.factor), unit)}</b>
      </p>
      <FactList facts={facts} />
      <p class="again">
        The same mode as a picture: <code>haptonic bands STUDY --modes-at "{place}"</code> or, in Python,{" "}
        <code>study.bands(modes_at="{place}").plot("modes")</code>
      </p>
    </div>
  );
}

function MotionControls({ choice }: { choice: Choice }) {
  const [m, n] = choice.copies.value;
  return (
    <div class="controls">
      <PlayButton playing={choice.playing} />
      <label>
        largest displacement, share of the period: {choice.swing.value.toFixed(2)}
        <input
          type="range" min="0" max={LARGEST_SWING} step="0.01" value={choice.swing.value}
          onInput={(event) => (choice.swing.value = Number(event.currentTarget.value))}
        />
      </label>
      <PaceSlider pace={choice.pace} />
      <label>
        cells along a1
        <input
          type="number" min="1" max={MOST_COPIES} value={m}
          onChange={(event) => (choice.copies.value = [limited(event.currentTarget.value), n])}
        />
      </label>
      <label>
        cells along a2
        <input
          type="number" min="1" max={MOST_COPIES} value={n}
          onChange={(event) => (choice.copies.value = [m, limited(event.currentTarget.value)])}
        />
      </label>
    </div>
  );
}

function limited(text: string): number {
  const count = Math.round(Number(text));
  return Number.isFinite(count) ? Math.min(Math.max(count, 1), MOST_COPIES) : 1;
}
