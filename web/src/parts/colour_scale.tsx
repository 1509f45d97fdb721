/** A bar of colours between two numbers. */

import type { ComponentChildren } from "preact";

interface Props {
  colours: number[][];
  ends: [string, string];
  children: ComponentChildren; // what the colours show
}

export function ColourScale({ colours, ends: [low, high], children }: Props) {
  const steps = [0, 0.25, 0.5, 0.75, 1].map((share) => `rgb(${(colours[Math.round(share * (colours.length - 1))] ?? []).join(" ")})`);
  return (
    <p class="scale">
      <span>{low}</span>
      <span class="bar" style={{ background: `linear-gradient(to right, ${steps.join(", ")})` }} />
      <span>{high}</span> {children}
    </p>
  );
}
