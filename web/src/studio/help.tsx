/** The list of all keys of the page, opened by "?" or a button. */

import { useEffect, useRef } from "preact/hooks";
import { keyLists, keyPressed, type Key } from "../parts/keys";
import { KeyTable } from "../parts/listing";

export function Help() {
  const dialog = useRef<HTMLDialogElement>(null);
  const open = () => {
    if (!dialog.current?.open) dialog.current?.showModal();
  };
  useEffect(() => {
    const keys: Key[] = [{ keys: "?", effect: "this list", actions: { "?": open } }];
    const pressed = (event: KeyboardEvent) => keyPressed(event, keys);
    document.addEventListener("keydown", pressed);
    return () => document.removeEventListener("keydown", pressed);
  }, []);
  return (
    <>
      <button type="button" onClick={open} aria-keyshortcuts="?">
        Keys
      </button>
      <dialog ref={dialog} aria-label="Keys of the page">
        {keyLists.value.map(({ title, keys }) => (
          <KeyTable title={title} keys={keys} />
        ))}
        <p class="quiet">Keys of a part work while it has the focus.</p>
        <button type="button" onClick={() => dialog.current?.close()}>
          Close
        </button>
      </dialog>
    </>
  );
}
