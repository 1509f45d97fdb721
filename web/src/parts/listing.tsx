/** The list of keys and the tables below a view, opened by buttons or keys. */

import { useSignalEffect, type Signal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { ComponentChildren } from "preact";
import type { Key } from "./keys";

export type Listed = "keys" | "table" | "none";

/** Keys that open the list and the tables. */
export function listingKeys(listing: Signal<Listed>): Key[] {
  return [
    { keys: "t", effect: "tables", actions: { t: () => toggle(listing, "table") } },
    { keys: "?", effect: "this list", actions: { "?": () => toggle(listing, "keys") } },
  ];
}

function toggle(listing: Signal<Listed>, which: Listed): void {
  listing.value = listing.value === which ? "none" : which;
}

interface Props {
  listing: Signal<Listed>;
  keys: Key[];
  children: ComponentChildren;
}

export function Listing({ listing, keys, children }: Props) {
  const place = useRef<HTMLDivElement>(null);
  useSignalEffect(() => {
    if (listing.value !== "none") place.current?.focus();
  });
  const buttons: [Listed, string][] = [
    ["table", "Tables"],
    ["keys", "Keys"],
  ];
  return (
    <section aria-label="Tables and keys">
      <p class="opened">
        {buttons.map(([which, words]) => (
          <button type="button" aria-expanded={listing.value === which} onClick={() => toggle(listing, which)}>
            {words}
          </button>
        ))}
      </p>
      <div ref={place} tabIndex={-1}>
        {listing.value === "table" && children}
        {listing.value === "keys" && (
          <KeyTable title="Keys" keys={keys} />
        )}
      </div>
    </section>
  );
}

export function KeyTable({ title, keys }: { title?: string; keys: Key[] }) {
  return (
    <table>
      {title && <caption>{title}</caption>}
      <tbody>
        {keys.map(({ keys: names, effect }) => (
          <tr>
            <th scope="row">
              <kbd>{names}</kbd>
            </th>
            <td>{effect}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
