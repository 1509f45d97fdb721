/** Controls of a motion. */

import type { Signal } from "@preact/signals";

export function PlayButton({ playing }: { playing: Signal<boolean> }) {
  return (
    <button type="button" onClick={() => (playing.value = !playing.value)}>
      {playing.value ? "Stop" : "Move"}
    </button>
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
