/** Colours of a band over the Brillouin zone: frequencies are linear between its wavevectors, in each pixel. */

import type { Wavevector, ZoneSurface } from "./zone_data";

type ToPixel = (wavevector: Wavevector) => [number, number]; // CSS pixels

interface Picture {
  of: string; // band and size
  surface: OffscreenCanvas;
}

const pictures = new WeakMap<ZoneSurface, Picture>(); // the latest of each zone: a moved mark does not change it

/** Paint a band on a square canvas. */
export function paintSurface(context: CanvasRenderingContext2D, zone: ZoneSurface, band: number, toPixel: ToPixel): void {
  const side = context.canvas.width;
  const of = `${band} ${side}`;
  let picture = pictures.get(zone);
  if (picture?.of !== of) {
    picture = { of, surface: surfaceOf(zone, band, side, toPixel) };
    pictures.set(zone, picture);
  }
  context.save();
  context.resetTransform();
  context.drawImage(picture.surface, 0, 0);
  context.restore();
}

function surfaceOf(zone: ZoneSurface, band: number, side: number, toPixel: ToPixel): OffscreenCanvas {
  const surface = new OffscreenCanvas(side, side);
  const image = new ImageData(side, side);
  const [low, high] = zone.range(band);
  const last = zone.colours.length - 1;
  for (const triangle of zone.mesh(band)) {
    const corners = triangle.map((corner) => toPixel(zone.wavevector(corner)).map((value) => value * devicePixelRatio));
    const levels = triangle.map((corner) => ((zone.at(zone.sample(corner), band) - low) / (high - low || 1)) * last);
    fill(image, corners as Corners, levels as [number, number, number], zone.colours);
  }
  surface.getContext("2d")?.putImageData(image, 0, 0);
  return surface;
}

type Corners = [[number, number], [number, number], [number, number]]; // pixels of the canvas

const EDGE = 1e-6; // share by which the middle of a pixel may lie outside a triangle due to rounding

/** Fill a triangle with colours whose numbers are linear between its corners. */
function fill(image: ImageData, [a, b, c]: Corners, [atA, atB, atC]: [number, number, number], colours: number[][]): void {
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (area === 0) return;
  const ends = (axis: 0 | 1): [number, number] => [
    Math.max(Math.floor(Math.min(a[axis], b[axis], c[axis])), 0),
    Math.min(Math.ceil(Math.max(a[axis], b[axis], c[axis])), image.width),
  ];
  const [[left, right], [top, bottom]] = [ends(0), ends(1)];
  for (let row = top; row < bottom; row++)
    for (let column = left; column < right; column++) {
      const [x, y] = [column + 0.5 - a[0], row + 0.5 - a[1]];
      const second = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) / area;
      const third = ((b[0] - a[0]) * y - x * (b[1] - a[1])) / area;
      if (second < -EDGE || third < -EDGE || second + third > 1 + EDGE) continue;
      const level = Math.min(Math.max(atA + second * (atB - atA) + third * (atC - atA), 0), colours.length - 1);
      const [lower, upper, share] = [colours[Math.floor(level)] ?? [], colours[Math.ceil(level)] ?? [], level % 1];
      const pixel = 4 * (row * image.width + column);
      for (let k = 0; k < 3; k++) image.data[pixel + k] = (1 - share) * (lower[k] ?? 0) + share * (upper[k] ?? 0);
      image.data[pixel + 3] = 255;
    }
}
