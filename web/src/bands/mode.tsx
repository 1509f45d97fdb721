/** Canvas of the moving mode, and what keeps it moving. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { onTheme } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import { FilmButtons, filmed } from "../parts/film";
import { origin } from "../parts/frame";
import type { Dataset } from "../dataset";
import { MovingMode, type Motion, type Side } from "./moving_mode";
import type { Choice } from "./state";

const SIDES: [Side, string][] = [
  ["oblique", "oblique"],
  ["x", "along x"],
  ["y", "along y"],
  ["z", "from above"],
];

interface Props {
  data: Dataset;
  choice: Choice;
  motion: ReadonlySignal<Motion>;
  name: string; // of saved films
}

export function Mode({ data, choice, motion, name }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const mode = useRef<MovingMode>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    if (canvas.current === null) return;
    let moving: MovingMode;
    try {
      moving = new MovingMode(data, canvas.current, colours(data));
    } catch {
      setProblem("The mode cannot be drawn, because this browser has no WebGL.");
      return;
    }
    mode.current = moving;
    Object.assign(canvas.current, { moving }); // for tests and for the browser's console
    return kept(moving, motion, choice);
  }, [data, choice, motion]);
  return (
    <div class="mode">
      {problem ? (
        <p role="alert">{problem}</p>
      ) : (
        <canvas ref={canvas} role="img" aria-label="The cell moving in the selected mode" />
      )}
      <p class="scale">
        <span>0</span>
        <span class="bar" style={{ background: gradient(data) }} />
        <span>1</span> displacement, relative to the largest
      </p>
      <p class="sides">
        <span id={`seen-${name}`}>Seen</span>
        {SIDES.map(([side, words]) => (
          <button type="button" onClick={() => mode.current?.look(side)} aria-describedby={`seen-${name}`}>
            {words}
          </button>
        ))}
      </p>
      <FilmButtons canvas={canvas} name={name} caption={`${data.header.title}, ${origin(data)}`} />
    </div>
  );
}

function colours(data: Dataset): number[][] {
  return data.header.extra["colours"] as number[][];
}

function gradient(data: Dataset): string {
  return `linear-gradient(to right, ${colours(data).map((rgb) => `rgb(${rgb.join(" ")})`).join(", ")})`;
}

/** Follow the choices and the size of the canvas; returns what ends it. */
function kept(moving: MovingMode, motion: ReadonlySignal<Motion>, choice: Choice): () => void {
  const { canvas } = moving;
  const draw = () => moving.turn(cycle.moment);
  const cycle = new Cycle(choice, draw, canvas);
  filmed(canvas, (moment) => cycle.at(moment));
  const resized = new ResizeObserver(() => {
    moving.resize(Math.max(canvas.clientWidth, 1), Math.max(canvas.clientHeight, 1));
    moving.look("oblique");
  });
  moving.resize(Math.max(canvas.clientWidth, 1), Math.max(canvas.clientHeight, 1));
  const stops = [
    effect(() => moving.repeat(choice.copies.value)),
    effect(() => {
      moving.show(motion.value);
      canvas.dataset["shown"] = `${motion.value.row},${motion.value.band}`;
      draw();
    }),
    effect(() => {
      moving.swing = choice.swing.value;
      draw();
    }),
    onTheme(() => {
      moving.colourLines();
      moving.draw();
    }),
  ];
  resized.observe(canvas);
  return () => {
    cycle.end();
    resized.disconnect();
    for (const stop of stops) stop();
    moving.dispose();
  };
}
