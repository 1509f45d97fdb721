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

/** Show a view of the page in its place. */
async function fill(place: HTMLElement): Promise<void> {
  const coded = document.getElementById(place.dataset["view"] ?? "")?.textContent ?? "";
  try {
    const compressed = Uint8Array.from(atob(coded.trim()), (letter) => letter.charCodeAt(0));
    const data = Dataset.read(await inflated(compressed));
    place.replaceChildren();
    show(data, place);
  } catch (reason) {
    const words = document.createElement("p");
    words.textContent = `The view cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}`;
    place.replaceChildren(words);
  }
}

for (const place of document.querySelectorAll<HTMLElement>("[data-view]")) void fill(place);

export default { render };
