/** First result of a page without a plate: the chosen analysis of the study that is opened, if it takes seconds. */

import { effect } from "@preact/signals";
import { analysis, isWrong, missing, usesStudy, wanted } from "./chosen";
import { isFollowed, running, shown } from "./jobs";
import { server } from "./server";
import { loaded, plate, react } from "./study";

const QUICK = "seconds"; // the shortest class of the estimated time

export function followOpenings(): void {
  let examined = 0; // number of the study that was examined last
  effect(() => {
    if (!isFollowed.value || loaded.value === examined) return;
    examined = loaded.value;
    void react(computeIfQuick);
  });
}

/** Compute the chosen analysis if the page shows no result and no map, and nothing is computed. */
async function computeIfQuick(): Promise<void> {
  const isIdle = () => shown.peek() === null && plate.peek() === null && running() === undefined;
  const asked = wanted.peek();
  if (!isIdle() || asked === null || !usesStudy.peek() || isWrong.peek() || missing.peek().length > 0) return;
  const { costs } = await server.forecast(asked.text);
  const cost = costs.find(({ command }) => command === analysis.peek()?.name);
  if (cost?.time !== QUICK || cost.refusal || !isIdle() || wanted.peek()?.text !== asked.text) return;
  shown.value = (await server.run(asked)).number; // the user has not asked for it, so the page stays where it is
}
