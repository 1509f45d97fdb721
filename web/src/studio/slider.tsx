/** The slider beside the diagram. */

import type { Host } from "../parts/host";
import { shownJob } from "./jobs";
import { canTurn, isPrepared, knob, knobs, move, release, select, settle, turned, turnedTo, written } from "./turn";

export const host: Host = {
  turned,
  controls: <Turn />,
  design: () =>
    Object.fromEntries(
      knobs.value.map((of) => [of.title, written(of, of === knob.value ? (turnedTo.value ?? of.value) : of.value)]),
    ),
};

function Turn() {
  const of = knob.value;
  if (of === undefined)
    return (
      <p class="quiet">
        {shownJob.value?.archived ? "Compute this again to turn its numbers." : "Sliders for its numbers follow in a moment."}
      </p>
    );
  const value = turnedTo.value ?? of.value;
  return (
    <div class="turning" data-prepared={isPrepared.value}>
      <label>
        Turn{" "}
        <select value={of.path} disabled={turnedTo.value !== null} onChange={(event) => select(event.currentTarget.value)}>
          {knobs.value.map(({ path, title }) => (
            <option value={path}>{title}</option>
          ))}
        </select>
      </label>
      <input
        type="range"
        aria-label={of.unit ? `${of.title}, ${of.unit}` : of.title}
        aria-valuetext={written(of, value)}
        min={of.low}
        max={of.high}
        step={of.step}
        value={value}
        disabled={!canTurn.value}
        onInput={(event) => move(of, Number(event.currentTarget.value))}
        onPointerUp={settle}
        onChange={(event) => release(of, Number(event.currentTarget.value))}
      />
      <output>{written(of, value)}</output>
      {canTurn.value ? (
        !isPrepared.value && <span class="quiet state">Its preview follows in a moment.</span>
      ) : (
        <span class="quiet state">The study has changed: compute it first.</span>
      )}
    </div>
  );
}
