/** Saves a moving canvas as a film: one cycle as GIF, or as WebM where the browser can record. */

import { GIFEncoder, applyPalette, quantize } from "gifenc";
import { useState } from "preact/hooks";
import { themeColour } from "./colours";
import { download } from "./download";

const FRAMES = 40; // of a cycle
const PAUSE = 40; // ms between two frames
const WEBM = "video/webm";
const MARGIN = 6; // CSS pixels around the text

const drawers = new WeakMap<HTMLCanvasElement, (moment: number) => void>();

/** Note how a moment of the cycle, from 0 to 1, is drawn on a canvas. */
export function filmed(canvas: HTMLCanvasElement, draw: (moment: number) => void): void {
  drawers.set(canvas, draw);
}

interface Props {
  canvas: { current: HTMLCanvasElement | null };
  name: string; // of the file, without its ending
  caption: string; // on every frame: the origin of the motion
}

export function FilmButtons({ canvas, name, caption }: Props) {
  const [busy, setBusy] = useState("");
  const canRecord = typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(WEBM);
  const save = (kind: string, make: (film: Film) => Promise<Blob>) => async () => {
    if (canvas.current === null) return;
    setBusy(`The ${kind} is made.`);
    await new Promise((next) => setTimeout(next, PAUSE)); // the page shows the words first
    try {
      download(await make(new Film(canvas.current, caption)), `${name}.${kind.toLowerCase()}`);
      setBusy("");
    } catch (reason) {
      setBusy(`The ${kind} cannot be made: ${String(reason)}`);
    }
  };
  return (
    <p class="sides film">
      <span>Save the motion</span>
      <button type="button" onClick={() => void save("GIF", asGif)()}>
        GIF
      </button>
      {canRecord && (
        <button type="button" onClick={() => void save("WebM", asWebm)()}>
          WebM
        </button>
      )}
      <span role="status">{busy}</span>
    </p>
  );
}

/** Frames of a canvas on the page's colour, with the caption below. */
class Film {
  readonly copy = document.createElement("canvas");
  private readonly context: CanvasRenderingContext2D;
  private readonly draw: (moment: number) => void;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly caption: string,
  ) {
    const draw = drawers.get(canvas);
    const context = this.copy.getContext("2d", { willReadFrequently: true });
    if (draw === undefined || context === null) throw new Error("the canvas does not move");
    [this.draw, this.context] = [draw, context];
    [this.copy.width, this.copy.height] = [canvas.width, canvas.height];
  }

  /** Draw a moment of the cycle on the copy. */
  show(moment: number): CanvasRenderingContext2D {
    const { context, copy } = this;
    this.draw(moment);
    context.fillStyle = themeColour("panel");
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(this.canvas, 0, 0); // in the task that drew it: WebGL clears the canvas afterwards
    context.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
    context.fillStyle = themeColour("ink");
    const margin = MARGIN * devicePixelRatio;
    context.fillText(this.caption, margin, copy.height - margin, copy.width - 2 * margin);
    return context;
  }
}

async function asGif(film: Film): Promise<Blob> {
  const { width, height } = film.copy;
  const gif = GIFEncoder();
  let palette: number[][] | undefined;
  for (let k = 0; k < FRAMES; k++) {
    const { data } = film.show(k / FRAMES).getImageData(0, 0, width, height);
    palette ??= quantize(data, 256); // one for all frames, so that no colour flickers
    gif.writeFrame(applyPalette(data, palette), width, height, k === 0 ? { palette, delay: PAUSE } : { delay: PAUSE });
    if (k % 5 === 4) await new Promise((next) => setTimeout(next)); // the page stays alive
  }
  gif.finish();
  return new Blob([gif.bytes()], { type: "image/gif" });
}

async function asWebm(film: Film): Promise<Blob> {
  film.show(0);
  const stream = film.copy.captureStream();
  const recorder = new MediaRecorder(stream, { mimeType: WEBM, videoBitsPerSecond: 8e6 });
  const parts: Blob[] = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const ended = new Promise((stop) => (recorder.onstop = stop));
  recorder.start();
  const start = performance.now();
  for (let k = 0; k < FRAMES; k++) {
    film.show(k / FRAMES);
    const left = start + (k + 1) * PAUSE - performance.now(); // without the time that the frame took
    await new Promise((next) => setTimeout(next, left));
  }
  recorder.stop();
  await ended;
  for (const track of stream.getTracks()) track.stop();
  return new Blob(parts, { type: WEBM });
}
