/** A band over the Brillouin zone: contours, and the frequencies of all bands at a wavevector that one picks. */

import { computed, signal, type Signal } from "@preact/signals";
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { ColourScale } from "../parts/colour_scale";
import { themeColour, onTheme } from "../parts/colours";
import { PlayButton } from "../parts/controls";
import { FactList } from "../parts/facts";
import { keyPressed, type Key } from "../parts/keys";
import { signed, tickText, uncertain } from "../parts/numbers";
import { velocityText } from "../parts/velocity";
import { ON_MAP } from "../parts/plan";
import { rounded, titled, withUnit, type Unit } from "../parts/units";
import { Walk } from "../parts/walk";
import type { BandDiagram } from "./diagram_data";
import { Mode } from "./mode";
import { moved, type Choice } from "./state";
import { paintSurface } from "./zone_surface";
import { ZoneSurface, type Wavevector } from "./zone_data";

const LARGEST = 440; // CSS pixels, side of the map
const ROOM = 26; // CSS pixels around the zone, for names of corners
const LEVELS = 8; // about as many contours
const LABELLED = (-5 * Math.PI) / 8; // rad, direction from the middle in which the levels are written
const ARROW = 34; // CSS pixels, length of the arrow of the group velocity

interface ZoneChoice {
  image: Signal<number>; // number of the wavevector among those of the whole zone
}

interface Props {
  diagram: BandDiagram;
  choice: Choice;
}

/** The zone below a diagram, if its bands were computed there. */
export function Zone({ diagram, choice }: Props) {
  if (!diagram.data.has("zone_wavevector")) return null;
  return <ZoneSection diagram={diagram} choice={choice} />;
}

function ZoneSection({ diagram, choice }: Props) {
  const zone = useMemo(() => new ZoneSurface(diagram.data), [diagram]);
  const own = useMemo<ZoneChoice>(
    () => ({ image: signal(zone.highest(choice.point.peek().band)) }),
    [zone, choice],
  );
  const keys = useMemo(() => zoneKeys(diagram, zone, own, choice), [diagram, zone, own, choice]);
  const motion = useMemo(
    () => computed(() => zone.motion(own.image.value, choice.point.value.band)),
    [zone, own, choice],
  );
  const { band } = choice.point.value;
  return (
    <section aria-label="Brillouin zone" class="pair">
      <div>
        <Walk
          label="Brillouin zone. Arrow keys move the wavevector, page keys change the band."
          describedBy="zone-point"
          onKeyDown={(event) => {
            keyPressed(event, keys);
            if (event.defaultPrevented) event.stopPropagation(); // arrows of the diagram mean something else
          }}
        >
          <ZoneMap zone={zone} band={band} own={own} unit={choice.unit.value} />
        </Walk>
        <p class="axes">
          <label>
            Band{" "}
            <select
              value={band + 1}
              onChange={({ currentTarget }) => (choice.point.value = { ...choice.point.value, band: currentTarget.selectedIndex })}
            >
              {Array.from({ length: diagram.bands }, (_, number) => (
                <option>{number + 1}</option>
              ))}
            </select>
          </label>
        </p>
        <Scale zone={zone} diagram={diagram} band={band} unit={choice.unit.value} />
        <ZoneFacts diagram={diagram} zone={zone} own={own} choice={choice} />
      </div>
      {zone.hasModes && (
        <div>
          <Mode data={diagram.data} choice={choice} motion={motion} name="zone-mode" />
          <p class="sides">
            <PlayButton playing={choice.playing} />
          </p>
        </div>
      )}
    </section>
  );
}

function zoneKeys(diagram: BandDiagram, zone: ZoneSurface, own: ZoneChoice, choice: Choice): Key[] {
  const climb = (up: number) => () => (choice.point.value = moved(diagram, choice.point.value, 0, up));
  const go = (x: number, y: number) => () => (own.image.value = zone.next(own.image.value, x, y));
  return [
    {
      keys: "arrows",
      effect: "next wavevector",
      actions: { ArrowLeft: go(-1, 0), ArrowRight: go(1, 0), ArrowUp: go(0, 1), ArrowDown: go(0, -1) },
    },
    { keys: "page up, page down", effect: "next higher or lower band", actions: { PageUp: climb(1), PageDown: climb(-1) } },
  ];
}

function ZoneMap({ zone, band, own, unit }: { zone: ZoneSurface; band: number; own: ZoneChoice; unit: Unit }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = own.image.value;
  const draw = () => {
    if (canvas.current !== null) paintZone(canvas.current, zone, band, image, unit);
  };
  useLayoutEffect(draw);
  useEffect(() => {
    const element = canvas.current?.parentElement;
    if (!element) return;
    const resized = new ResizeObserver(() => latest.current());
    resized.observe(element);
    const stop = onTheme(() => latest.current());
    return () => {
      resized.disconnect();
      stop();
    };
  }, []);
  const latest = useRef(draw);
  latest.current = draw;
  return (
    <div class="map zone">
      <canvas
        ref={canvas}
        role="img"
        aria-label={`Frequency of band ${band + 1} over the zone`}
        onClick={({ offsetX, offsetY, currentTarget }) => {
          const { toWavevector } = placed(currentTarget, zone);
          own.image.value = zone.nearest(toWavevector(offsetX, offsetY));
        }}
      />
    </div>
  );
}

/** Places on the canvas in CSS pixels. */
function placed(canvas: HTMLCanvasElement, zone: ZoneSurface) {
  const side = canvas.clientWidth;
  const scale = (side - 2 * ROOM) / (2 * zone.reach);
  return {
    toPixel: ([x, y]: [number, number]): [number, number] => [side / 2 + scale * x, side / 2 - scale * y],
    toWavevector: (left: number, top: number): [number, number] => [(left - side / 2) / scale, (side / 2 - top) / scale],
  };
}

function paintZone(canvas: HTMLCanvasElement, zone: ZoneSurface, band: number, image: number, unit: Unit): void {
  const side = Math.min(canvas.parentElement?.clientWidth ?? LARGEST, LARGEST);
  if (side === 0) return; // a view that is removed
  canvas.style.width = canvas.style.height = `${side}px`;
  canvas.width = canvas.height = Math.round(side * devicePixelRatio);
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.scale(devicePixelRatio, devicePixelRatio);
  const { toPixel } = placed(canvas, zone);
  paintSurface(context, zone, band, toPixel);
  context.strokeStyle = "#ffffff";
  context.lineWidth = 1;
  context.beginPath();
  const contours = zone.levels(band, LEVELS).map((level) => ({ level, segments: zone.contour(band, level) }));
  for (const [from, to] of contours.flatMap(({ segments }) => segments)) {
    context.moveTo(...toPixel(from));
    context.lineTo(...toPixel(to));
  }
  context.stroke();
  writeLevels(context, contours, toPixel, unit);
  paintCorners(context, zone, toPixel);
  const velocity = zone.hasModes ? zone.velocity(image, band) : undefined;
  if (velocity !== undefined && Math.hypot(...velocity) > zone.velocityError(image, band)) paintArrow(context, toPixel(zone.wavevector(image)), velocity);
  context.beginPath();
  context.arc(...toPixel(zone.wavevector(image)), 5, 0, 2 * Math.PI);
  context.fillStyle = themeColour("accent");
  context.strokeStyle = "#ffffff";
  context.lineWidth = 2;
  context.fill();
  context.stroke();
  canvas.dataset["shown"] = `${image},${band}`;
  Object.assign(canvas, { zone }); // for tests
}

interface Contour {
  level: number; // Hz
  segments: [Wavevector, Wavevector][];
}

/** Write each level on its contour, next to a line that leaves the middle of the zone away from its names. */
function writeLevels(
  context: CanvasRenderingContext2D, contours: Contour[], toPixel: (k: Wavevector) => [number, number], unit: Unit,
): void {
  const taken: [number, number][] = [toPixel([0, 0])];
  context.save();
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = "#ffffff";
  context.strokeStyle = ON_MAP;
  context.lineWidth = 3;
  context.lineJoin = "round";
  for (const { level, segments } of contours) {
    const places = segments.map(([[ax, ay], [bx, by]]): Wavevector => [(ax + bx) / 2, (ay + by) / 2]);
    const away = ([x, y]: Wavevector) => Math.abs(Math.atan2(y, x) - LABELLED);
    const place = places.reduce<Wavevector | null>((best, next) => (best !== null && away(best) <= away(next) ? best : next), null);
    if (place === null) continue;
    const [x, y] = toPixel(place);
    if (taken.some(([left, top]) => Math.abs(left - x) < 34 && Math.abs(top - y) < 14)) continue; // it would cover another
    taken.push([x, y]);
    const words = tickText(Number((level / unit.factor).toPrecision(5)));
    context.strokeText(words, x, y);
    context.fillText(words, x, y);
  }
  context.restore();
}

/** An arrow from a place in the direction of a group velocity, which is at right angles to the contours. */
function paintArrow(context: CanvasRenderingContext2D, [x, y]: [number, number], [vx, vy]: [number, number]): void {
  const speed = Math.hypot(vx, vy);
  const [right, down] = [vx / speed, -vy / speed];
  const at = (along: number, aside: number): [number, number] => [x + along * right - aside * down, y + along * down + aside * right];
  for (const [colour, width] of [["#ffffff", 5], [themeColour("accent"), 2.5]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(...at(ARROW, 0));
    context.moveTo(...at(ARROW - 8, 5));
    context.lineTo(...at(ARROW, 0));
    context.lineTo(...at(ARROW - 8, -5));
    context.stroke();
  }
}

function paintCorners(
  context: CanvasRenderingContext2D,
  zone: ZoneSurface,
  toPixel: (k: [number, number]) => [number, number],
): void {
  context.strokeStyle = themeColour("carrier");
  context.setLineDash([5, 4]);
  context.lineWidth = 1.5;
  context.beginPath();
  for (const corner of Object.values(zone.corners)) context.lineTo(...toPixel(corner));
  context.closePath();
  context.stroke();
  context.setLineDash([]);
  context.font = "15px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 3;
  context.lineJoin = "round";
  const places = Object.values(zone.corners);
  const middle = [0, 1].map((axis) => places.reduce((sum, corner) => sum + (corner[axis] ?? 0), 0) / places.length);
  for (const [label, corner] of Object.entries(zone.corners)) {
    const [x, y] = toPixel(corner);
    const [right, up] = [Math.sign(corner[0] - (middle[0] ?? 0)), Math.sign(corner[1] - (middle[1] ?? 0))];
    const isInside = Math.hypot(...corner) < 1e-6 * zone.reach; // the middle of the zone lies on colours
    context.strokeStyle = isInside ? ON_MAP : themeColour("paper");
    context.fillStyle = isInside ? "#ffffff" : themeColour("ink");
    context.strokeText(label, x + 13 * right, y - 13 * up);
    context.fillText(label, x + 13 * right, y - 13 * up);
  }
}

function Scale({ zone, diagram, band, unit }: { zone: ZoneSurface; diagram: BandDiagram; band: number; unit: Unit }) {
  const [low = "", high = ""] = zone.range(band).map((value) => rounded(Number((value / unit.factor).toPrecision(4))));
  const contours = zone.levels(band, LEVELS);
  const step = ((contours[1] ?? 0) - (contours[0] ?? 0)) / unit.factor;
  return (
    <ColourScale colours={zone.colours} ends={[low, high]}>
      {titled("frequency", unit)} of band {band + 1} of {diagram.bands}
      {contours.length > 1 && `; contours every ${Number(step.toPrecision(4))}`}
    </ColourScale>
  );
}

interface FactsProps extends Props {
  zone: ZoneSurface;
  own: ZoneChoice;
}

function ZoneFacts({ diagram, zone, own, choice }: FactsProps) {
  const [image, along, unit] = [own.image.value, choice.wavevectorUnit.value, choice.unit.value];
  const { band } = choice.point.value;
  const [x, y] = zone.wavevector(image).map((value) => Number((value / along.factor).toFixed(3)));
  const sample = zone.sample(image);
  const frequencyText = (number: number) =>
    uncertain(zone.at(sample, number) / unit.factor, zone.errorAt(sample, number) / unit.factor);
  const [first, second] = zone.phases(sample).map((phase) => Number((phase / Math.PI).toFixed(4)));
  return (
    <div class="facts">
      <p id="zone-point" aria-live="polite">
        Band {band + 1} at {signed(`(${x}, ${y})`)} {along.name}: <b>{withUnit(frequencyText(band), unit)}</b>
      </p>
      {zone.hasModes && (
        <>
          <FactList facts={modeFacts(diagram, zone, image, band)} />
          <p class="again">
            The arrow in the zone is the direction of the group velocity. Bands and modes are computed at {zone.count}{" "}
            wavevectors of the irreducible zone; a click selects the nearest one or its image.
          </p>
        </>
      )}
      <details>
        <summary>Frequencies of all bands at this wavevector</summary>
        <div class="wide">
          <table>
            <caption>Frequencies at this wavevector</caption>
            <thead>
              <tr>
                <th scope="col">band</th>
                <th scope="col">{titled("frequency", unit)}</th>
              </tr>
            </thead>
            <tbody>
              {Array.from({ length: zone.bands }, (_, number) => (
                <tr aria-current={number === band ? "true" : undefined}>
                  <td>{number + 1}</td>
                  <td>{frequencyText(number)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </details>
      <p class="again">
        Its modes as a picture: <code>haptonic bands STUDY --modes-at "{first}, {second}"</code>
      </p>
    </div>
  );
}

function modeFacts(diagram: BandDiagram, zone: ZoneSurface, image: number, band: number): [string, string][] {
  const [{ motion, symmetry }, velocity] = [zone.described(image, band), zone.velocity(image, band)];
  return [
    ["motion", diagram.motion(motion)],
    ["symmetry", symmetry],
    ["group velocity", velocity ? velocityText(velocity, zone.velocityError(image, band)) : "not defined"],
  ];
}
