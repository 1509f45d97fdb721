/** The study in the fragment of the page's address, compressed; the fragment is never sent to a server. */

import type { Problem } from "./server";
import { notice, openText, text, unsaved } from "./study";

const NAME = "#study=";
const MOST_LETTERS = 100_000; // of a fragment; browsers shorten longer addresses
const MOST_BYTES = 1_000_000; // of a study, as the server allows: a small fragment may unpack to gigabytes

/** The address of this page with the study in it. */
export async function linkOf(study: string): Promise<string> {
  const packed = new Blob([study]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  const coded = btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return `${location.origin}${location.pathname}${NAME}${coded}`;
}

/** The study of a fragment.
 *  @throws Error if it is too long, before or after unpacking, or damaged */
async function studyOf(coded: string): Promise<string> {
  if (coded.length > MOST_LETTERS) throw new Error(`it has more than ${MOST_LETTERS} letters`);
  const packed = Uint8Array.from(atob(coded.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const decoder = new TextDecoder("utf-8", { fatal: true });
  let [study, size] = ["", 0];
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return study + decoder.decode();
    size += value.length;
    if (size > MOST_BYTES) {
      await reader.cancel();
      throw new Error(`the study in it has more than ${MOST_BYTES} bytes`);
    }
    study += decoder.decode(value, { stream: true });
  }
}

/** Open the study of the address, if it has one; text that is not saved is replaced only with consent. */
export async function openLink(): Promise<void> {
  if (!location.hash.startsWith(NAME)) return;
  const coded = location.hash.slice(NAME.length);
  history.replaceState(null, "", location.pathname); // loading the page again must not replace later changes
  try {
    const study = await studyOf(coded);
    if (study === text.peek()) return;
    if (unsaved.peek() && !confirm("The link has another study. Leave the text that is not saved? Undo brings it back.")) return;
    openText(study);
  } catch (reason) {
    notice.value = refused(`${coded.slice(0, 40)}${coded.length > 40 ? "..." : ""}`, reason);
  }
}

function refused(given: string, reason: unknown): Problem {
  return {
    code: "malformed", argument: "link", given, allowed: 'a link that "Copy link" has made',
    cause: reason instanceof Error && reason.constructor === Error ? reason.message : "the link is damaged or incomplete",
    next_step: "copy the link again, or open the file of the study", path: "", line: null,
  };
}

/** Copy the link of the study; without the right to do so, show it. */
export async function copyLink(): Promise<string> {
  const link = await linkOf(text.peek());
  if (link.length > MOST_LETTERS) return "The study is too long for a link. Send its file.";
  try {
    await navigator.clipboard.writeText(link);
    return "The link is copied. It contains the whole study.";
  } catch {
    prompt("Copy this link. It contains the whole study.", link);
    return "";
  }
}
