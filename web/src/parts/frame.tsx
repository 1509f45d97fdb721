/** Heading and foot that all views share. */

import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import type { Dataset } from "../dataset";
import { typeset } from "./numbers";
import { addKeys, keyPressed, type Key } from "./keys";

interface Props {
  name: string;
  data: Dataset;
  keys: Key[];
  foot: string;
  isOld?: boolean; // the sentences belong to an earlier design than the one that is drawn
  children: ComponentChildren;
}

/** Origin of the numbers: simulated or measured. */
export const origin = (data: Dataset): string => String(data.header.attrs["origin"] ?? "simulated");

export function Frame({ name, data, keys, foot, isOld = false, children }: Props) {
  useEffect(() => addKeys(data.header.title, keys), [data, keys]);
  const summary = (data.header.extra["summary"] ?? []) as string[];
  return (
    // a click anywhere in the view takes the focus, so its keys work
    <div class={name} tabIndex={-1} onKeyDown={(event) => keyPressed(event, keys)}>
      <header>
        <h1>{data.header.title}</h1>
        <p class="origin">{origin(data)}</p>
        <div class={isOld ? "old" : ""}>
          {summary.map((sentence) => (
            <p>{typeset(sentence)}</p>
          ))}
        </div>
      </header>
      {children}
      <footer>
        <p>
          haptonic {String(data.header.attrs["haptonic_version"] ?? "")}. {foot}
        </p>
      </footer>
    </div>
  );
}
