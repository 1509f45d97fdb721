/** Entry of the page that can be sent: its data are in the page itself. */

import { Dataset } from "./dataset";
import { show } from "./views";

async function start(): Promise<void> {
  const coded = document.getElementById("data")?.textContent ?? "";
  const compressed = Uint8Array.from(atob(coded.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const content = await new Response(stream).arrayBuffer();
  const element = document.getElementById("view");
  if (element === null) throw new Error("the page has no place for the view");
  element.replaceChildren();
  show(Dataset.read(content), element);
}

start().catch((reason: unknown) => {
  const element = document.getElementById("view") ?? document.body;
  const words = document.createElement("p");
  words.textContent = `The view cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}`;
  element.replaceChildren(words);
});
