/** Facts with their titles. */

import type { ComponentChildren } from "preact";

/** A list of titles and facts; a fact that is empty is left out. */
export function FactList({ facts }: { facts: [string, ComponentChildren][] }) {
  return (
    <dl>
      {facts
        .filter(([, fact]) => fact)
        .map(([title, fact]) => (
          <div>
            <dt>{title}</dt>
            <dd>{fact}</dd>
          </div>
        ))}
    </dl>
  );
}
