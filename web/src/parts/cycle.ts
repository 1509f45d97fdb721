/** The moment of a vibration that is drawn, and what moves it on. */

import { effect, signal, type Signal } from "@preact/signals";

export interface Pace {
  playing: Signal<boolean>;
  pace: Signal<number>; // drawn cycles in a second
}

/** True if the system asks for little motion. */
function wantsStill(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** A motion that a view begins with. */
export const startingPace = (): Pace => ({ playing: signal(!wantsStill()), pace: signal(0.7) });

export class Cycle {
  moment = 0; // of the cycle, from 0 to 1
  private frame = 0;
  private readonly stop: () => void;
  private readonly hidden = new Set<Element>();
  private readonly seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries)
      if (isIntersecting) this.hidden.delete(target);
      else this.hidden.add(target);
  });

  /** Call `draw` for every frame while the vibration plays and one of the canvases is in sight. */
  constructor(
    { playing, pace }: Pace,
    private readonly draw: () => void,
    ...canvases: HTMLCanvasElement[]
  ) {
    for (const canvas of canvases) this.seen.observe(canvas);
    let before = 0;
    const step = (now: number) => {
      if (before > 0) this.moment = (this.moment + ((now - before) / 1000) * pace.peek()) % 1;
      before = now;
      if (!document.hidden && this.hidden.size < canvases.length) draw();
      this.frame = requestAnimationFrame(step);
    };
    this.stop = effect(() => {
      cancelAnimationFrame(this.frame);
      before = 0;
      if (playing.value) this.frame = requestAnimationFrame(step);
    });
  }

  /** Draw a moment of the cycle. */
  at(moment: number): void {
    this.moment = moment;
    this.draw();
  }

  end(): void {
    cancelAnimationFrame(this.frame);
    this.seen.disconnect();
    this.stop();
  }
}
