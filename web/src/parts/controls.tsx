/** Controls that views share: units, and the motion. */

import type { Signal } from "@preact/signals";
import type { Pace } from "./cycle";
import { useEffect } from "preact/hooks";
import { shownUnits, type Unit } from "./units";

export function UnitSelect({ title, units, unit }: { title: string; units: Unit[]; unit: Signal<Unit> }) {
  const { value } = unit;
  const si = units[0]?.name ?? "";
  useEffect(() => {
    shownUnits.value = { ...shownUnits.peek(), [si]: value };
  }, [si, value]);
  useEffect(
    () => () => {
      const { [si]: _, ...others } = shownUnits.peek();
      shownUnits.value = others;
    },
    [si],
  );
  return (
    <label>
      {title}{" "}
      <select
        value={value.name}
        onChange={({ currentTarget }) => (unit.value = units[currentTarget.selectedIndex] ?? unit.value)}
      >
        {units.map(({ name }) => (
          <option>{name}</option>
        ))}
      </select>
    </label>
  );
}

export function PlayButton({ playing }: { playing: Signal<boolean> }) {
  return (
    <button type="button" onClick={() => (playing.value = !playing.value)}>
      {playing.value ? "Stop" : "Move"}
    </button>
  );
}

/** Start, stop and pace of a motion. */
export function PaceControls({ playing, pace }: Pace) {
  return (
    <div class="controls">
      <PlayButton playing={playing} />
      <PaceSlider pace={pace} />
    </div>
  );
}

export function PaceSlider({ pace }: { pace: Signal<number> }) {
  return (
    <label>
      pace, cycles per second: {pace.value.toFixed(1)}
      <input
        type="range" min="0.1" max="3" step="0.1" value={pace.value}
        onInput={(event) => (pace.value = Number(event.currentTarget.value))}
      />
    </label>
  );
}
