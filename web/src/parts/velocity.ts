/** Velocities in the plane of the plate as texts. */

import { signed, uncertain } from "./numbers";

/** Speed with the length of its error, m/s, and the direction of a velocity where it is known. */
export function velocityText([x, y]: [number, number], error?: number): string {
  const speed = Math.hypot(x, y);
  if (error === undefined) return `${speed.toPrecision(3)} m/s`;
  const direction = speed > error ? ` at ${signed(String(Math.round((Math.atan2(y, x) * 180) / Math.PI) || 0))}° from x` : "";
  return `${uncertain(speed, error)} m/s${direction}`;
}
