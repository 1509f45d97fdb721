/** Heading and foot that all views share. */

import type { ComponentChildren } from "preact";
import type { Dataset } from "../dataset";
import { keyPressed, type Key } from "./keys";

interface Props {
  name: string;
  data: Dataset;
  keys: Key[];
  foot: string;
  children: ComponentChildren;
}

export function Frame({ name, data, keys, foot, children }: Props) {
  const summary = (data.header.extra["summary"] ?? []) as string[];
  return (
    <div class={name} onKeyDown={(event) => keyPressed(event, keys)}>
      <header>
        <h1>{data.header.title}</h1>
        <p class="origin">{String(data.header.attrs["origin"] ?? "simulated")}</p>
        {summary.map((sentence) => (
          <p>{sentence}</p>
        ))}
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
