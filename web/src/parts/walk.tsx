/** The part of a view in which keys select something. */

import type { ComponentChildren } from "preact";

interface Props {
  label: string; // what it is, and what its keys do
  describedBy?: string; // id of the text about the selected thing
  onKeyDown?: (event: KeyboardEvent) => void;
  children: ComponentChildren;
}

export function Walk({ label, describedBy = "point", onKeyDown, children }: Props) {
  return (
    <div class="walk" tabIndex={0} role="application" aria-label={label} aria-describedby={describedBy} onKeyDown={onKeyDown}>
      {children}
    </div>
  );
}
