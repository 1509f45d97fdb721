/** Entry of pages that contain their data, and of notebooks. */

import { Dataset, inflated } from "./dataset";
import { show } from "./views";

/** Part of anywidget's model that is used here. */
interface Model {
  get(name: "data"): DataView<ArrayBuffer>;
}

/** Show a view in an output of a notebook; anywidget calls it, and calls the returned function to remove the view. */
async function render({ model, el }: { model: Model; el: HTMLElement }): Promise<() => void> {
  el.dataset["lmSuppressShortcuts"] = "true"; // keys belong to the view; JupyterLab uses most of them itself
  const { buffer, byteOffset, byteLength } = model.get("data");
  return show(Dataset.read(await inflated(new Uint8Array(buffer, byteOffset, byteLength))), el);
}

/** Show a view of the page in its place; the returned function removes it. */
async function fill(place: HTMLElement): Promise<() => void> {
  const coded = document.getElementById(place.dataset["view"] ?? "")?.textContent ?? "";
  try {
    const compressed = Uint8Array.from(atob(coded.trim()), (letter) => letter.charCodeAt(0));
    const data = Dataset.read(await inflated(compressed));
    place.replaceChildren();
    return show(data, place);
  } catch (reason) {
    const words = document.createElement("p");
    words.textContent = `The view cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}`;
    place.replaceChildren(words);
    return () => undefined;
  }
}

let opened: (() => void) | null = null; // closes the open view

/** A button that opens the view in its place and closes it again; one view of a page is open at a time. */
function addButton(place: HTMLElement, words: string): void {
  const button = document.createElement("button");
  const inside = document.createElement("div");
  button.type = "button";
  let remove: (() => void) | null = null;
  const close = () => {
    remove?.();
    inside.remove();
    button.textContent = words;
    button.ariaExpanded = "false";
    [opened, remove] = [null, null];
  };
  button.addEventListener("click", async () => {
    const own = opened === close;
    opened?.();
    if (own) return;
    opened = close;
    button.textContent = "Close the view";
    button.ariaExpanded = "true";
    place.append(inside);
    inside.dataset["view"] = place.dataset["view"] ?? "";
    const shown = await fill(inside);
    if (opened === close) remove = shown;
    else shown(); // closed in the meantime
  });
  close();
  place.append(button);
}

for (const place of document.querySelectorAll<HTMLElement>("[data-view]")) {
  const words = place.dataset["opens"];
  if (words === undefined) void fill(place);
  else addButton(place, words);
}

export default { render };
