/** Painting of a plate: its palette, tools and drawing, and what the map means. */

import { effect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { onTheme } from "../../parts/colours";
import { keyPressed } from "../../parts/keys";
import { KeyTable } from "../../parts/listing";
import { painting } from "../jobs";
import type { Tables } from "../server";
import { broken, change, pathOf, problems, redo, remarks, undo, values } from "../study";
import { drawPlate, sceneOf, sizeOf, colourOf, type Scene } from "./canvas";
import { Facts, Forecasts } from "./facts";
import { followPointer, paintKeys } from "./gestures";
import { resized, type Border } from "./grid";
import {
  across, addTile, anchor, chosen, CLAMP, clamped, commit, cursor, grid, letterOf, parts, selected, table,
  tiles, tool, up, type Tool,
} from "./state";

const TOOLS: Record<Tool, string> = {
  brush: "Brush", line: "Line", rectangle: "Rectangle", fill: "Fill", move: "Move parts",
};
const BORDERS: Border[] = ["left", "right", "above", "below"];
const EMPTY: Scene = { x: [0, 1], y: [0, 1], scale: 1 };

export function Paint({ first }: { first: Tables }) {
  if (Object.keys(values.value).length === 0) return null;
  if (table.value === null)
    return (
      <p class="paint">
        <button type="button" class="minor" disabled={broken.value} onClick={() => change(["plate"], first)}>
          Begin a plate
        </button>{" "}
        <span class="quiet">of this cell, and paint its map</span>
      </p>
    );
  return (
    <details class="section paint" open={painting.value} onToggle={(event) => (painting.value = event.currentTarget.open)}>
      <summary>
        Map of the plate <span class="quiet">painted with tiles; parts are dragged</span>
      </summary>
      {grid.value === null ? (
        <p class="problem">The map can be painted when it has letters, and all its lines are equally long.</p>
      ) : (
        <Board />
      )}
    </details>
  );
}

function Board() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const scene = useRef(EMPTY);
  const [keys] = useState(() => paintKeys(() => scene.current));
  useEffect(() => {
    const place = canvas.current;
    if (place === null) return;
    const draw = () => {
      const map = grid.peek();
      if (map === null) return;
      scene.current = sceneOf(map, place.parentElement?.clientWidth ?? 300);
      const [width, height] = sizeOf(scene.current);
      const [wide, high] = [width, height].map((length) => Math.round(length * devicePixelRatio));
      if (place.width !== wide || place.height !== high) {
        [place.width, place.height] = [wide ?? 0, high ?? 0];
        [place.style.width, place.style.height] = [`${width}px`, `${height}px`];
      }
      drawPlate(place, scene.current, document.activeElement === place);
    };
    const resizes = new ResizeObserver(draw);
    if (place.parentElement !== null) resizes.observe(place.parentElement);
    place.addEventListener("focus", draw);
    place.addEventListener("blur", draw);
    const stops = [
      followPointer(place, () => scene.current),
      onTheme(draw),
      effect(() => {
        // everything that is drawn
        void [grid.value, parts.value, tool.value, cursor.value, anchor.value, selected.value, clamped.value, tiles.value];
        draw();
      }),
    ];
    return () => {
      resizes.disconnect();
      for (const stop of stops) stop();
    };
  }, []);
  return (
    <div class="inside">
      <Palette />
      <Tools />
      <div class="board">
        <canvas
          ref={canvas}
          tabIndex={0}
          role="application"
          aria-label="Map of the plate. Arrow keys move, the space bar paints, digits choose a tile."
          aria-describedby="paint-place"
          onKeyDown={(event) => {
            if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z") {
              event.preventDefault();
              (event.shiftKey ? redo : undo)();
            } else keyPressed(event, keys);
          }}
        />
        <div class="beside">
          <Where />
          <Facts />
          <Sizes />
          <Complaints />
          <Forecasts />
        </div>
      </div>
      <details>
        <summary>Keys on the map</summary>
        <KeyTable keys={keys} />
      </details>
    </div>
  );
}

function Palette() {
  const [name, setName] = useState("");
  return (
    <div class="row palette" role="group" aria-label="Tiles">
      {tiles.value.map(({ letter, name: words }) => (
        <button
          type="button" class="minor" aria-pressed={letter === letterOf() && tool.value !== "move"}
          onClick={() => {
            chosen.value = letter;
            if (tool.peek() === "move") tool.value = "brush";
          }}
        >
          <span class="swatch" style={{ background: letter === "." ? "none" : `var(--${colourOf(letter)})` }} aria-hidden="true" />
          <code>{letter}</code> {words}
        </button>
      ))}
      <form
        class="row"
        onSubmit={(event) => {
          event.preventDefault();
          addTile(name.trim());
          setName("");
        }}
      >
        <input
          aria-label="Name of a new region or lattice" placeholder="new tile" size={9} value={name}
          onInput={(event) => setName(event.currentTarget.value)}
        />
        <button type="submit" class="minor" disabled={name.trim() === ""}>
          Add
        </button>
      </form>
    </div>
  );
}

function Tools() {
  const mirrors = [
    { signal: across, words: "mirror left and right" },
    { signal: up, words: "mirror top and bottom" },
  ];
  return (
    <div class="row" role="group" aria-label="Tools">
      {Object.entries(TOOLS).map(([name, words]) => (
        <button type="button" class="minor" aria-pressed={tool.value === name} onClick={() => (tool.value = name as Tool)}>
          {words}
        </button>
      ))}
      {mirrors.map(({ signal, words }) => (
        <label class="check">
          <input type="checkbox" checked={signal.value} onChange={(event) => (signal.value = event.currentTarget.checked)} />
          {words}
        </label>
      ))}
    </div>
  );
}

/** The tile below the cursor or the part that is selected, also for those who cannot see the drawing. */
function Where() {
  const part = parts.value.find(({ steps }) => pathOf(steps) === selected.value);
  const millimetres = (value: number) => Number((1e3 * value).toPrecision(6));
  const [row, column] = cursor.value;
  const letter = grid.value?.[row]?.[column];
  const name = tiles.value.find((tile) => tile.letter === letter)?.name ?? "";
  const sized = part !== undefined && part.size.length > 0 ? `, ${part.size.slice(0, 2).map(millimetres).join(" x ")} mm` : "";
  const words =
    tool.value !== "move"
      ? `Row ${row + 1} from above, column ${column + 1}: ${letter ?? ""} ${name}${anchor.value === null ? "" : "; the first end is chosen"}`
      : part !== undefined
        ? `${part.name}: centre at ${part.centre.map(millimetres).join(" and ")} mm on the plate${sized}`
        : selected.value === CLAMP && clamped.value !== null
          ? `Corners supported over ${millimetres(clamped.value)} mm`
          : "Select a part in the drawing, or with the key n.";
  return (
    <p id="paint-place" class="small" aria-live="polite">
      {words}
    </p>
  );
}

function Sizes() {
  const change = (border: Border, larger: boolean) => {
    const map = grid.peek();
    if (map !== null) commit(resized(map, border, larger));
  };
  return (
    <div class="row" role="group" aria-label="Size of the map">
      {BORDERS.map((border) => (
        <span>
          {border}{" "}
          <button type="button" class="minor" aria-label={`Add a line ${border}`} onClick={() => change(border, true)}>
            +
          </button>{" "}
          <button type="button" class="minor" aria-label={`Remove a line ${border}`} onClick={() => change(border, false)}>
            −
          </button>
        </span>
      ))}
    </div>
  );
}

/** Problems and remarks of the plate, which the list below the text has too. */
function Complaints() {
  const isHere = ({ path }: { path: string }) => path === "plate" || path.startsWith("plate.");
  return (
    <div aria-live="polite">
      {problems.value.filter(isHere).map(({ path, cause, next_step }) => (
        <p class="problem">
          <code>{path}</code>: {cause}; {next_step}
        </p>
      ))}
      {remarks.value.filter(isHere).map(({ path, text }) => (
        <p class="doubt">
          <code>{path}</code>: {text}
        </p>
      ))}
    </div>
  );
}
