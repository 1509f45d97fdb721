/** Canvas of the moving mode, and what keeps it moving. */

import { effect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { onTheme } from "../parts/colours";
import { Cycle } from "../parts/cycle";
import { FilmButtons, filmed } from "../parts/film";
import { origin } from "../parts/frame";
import type { BandDiagram } from "./diagram_data";
import { MovingMode, type Side } from "./moving_mode";
import type { Choice } from "./state";

const SIDES: [Side, string][] = [
  ["oblique", "oblique"],
  ["x", "along x"],
  ["y", "along y"],
  ["z", "from above"],
];

interface Props {
  diagram: BandDiagram;
  choice: Choice;
}

export function Mode({ diagram, choice }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const mode = useRef<MovingMode>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    if (canvas.current === null) return;
    let moving: MovingMode;
    try {
      moving = new MovingMode(diagram.data, canvas.current, colours(diagram));
    } catch {
      setProblem("The mode cannot be drawn, because this browser has no WebGL.");
      return;
    }
    mode.current = moving;
    Object.assign(canvas.current, { moving }); // for tests and for the browser's console
    return kept(moving, diagram, choice);
  }, [diagram, choice]);
  return (
    <div class="mode">
      {problem ? (
        <p role="alert">{problem}</p>
      ) : (
        <canvas ref={canvas} role="img" aria-label="The cell moving in the selected mode" />
      )}
      <p class="scale">
        <span>0</span>
        <span class="bar" style={{ background: gradient(diagram) }} />
        <span>1</span> displacement, relative to the largest
      </p>
      <p class="sides">
        <span id="seen">Seen</span>
        {SIDES.map(([side, words]) => (
          <button type="button" onClick={() => mode.current?.look(side)} aria-describedby="seen">
            {words}
          </button>
        ))}
      </p>
      <FilmButtons canvas={canvas} name="mode" caption={`${diagram.data.header.title}, ${origin(diagram.data)}`} />
    </div>
  );
}

function colours(diagram: BandDiagram): number[][] {
  return diagram.data.header.extra["colours"] as number[][];
}

function gradient(diagram: BandDiagram): string {
  return `linear-gradient(to right, ${colours(diagram).map((rgb) => `rgb(${rgb.join(" ")})`).join(", ")})`;
}

/** Follow the choices and the size of the canvas; returns what ends it. */
function kept(moving: MovingMode, diagram: BandDiagram, choice: Choice): () => void {
  const { canvas } = moving;
  const draw = () => moving.turn(cycle.moment);
  const cycle = new Cycle(choice, draw);
  filmed(canvas, (moment) => cycle.at(moment));
  const resized = new ResizeObserver(() => {
    moving.resize(Math.max(canvas.clientWidth, 1), Math.max(canvas.clientHeight, 1));
    moving.look("oblique");
  });
  moving.resize(Math.max(canvas.clientWidth, 1), Math.max(canvas.clientHeight, 1));
  const stops = [
    effect(() => moving.repeat(choice.copies.value)),
    effect(() => {
      const point = choice.point.value;
      moving.show(point, diagram.phases(point.row));
      canvas.dataset["shown"] = `${point.row},${point.band}`;
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
