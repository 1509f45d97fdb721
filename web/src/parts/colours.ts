/** Colours of the page's theme for what is drawn on canvases. */

export function themeColour(name: string): string {
  const themed = document.querySelector(".haptonic") ?? document.documentElement;
  return getComputedStyle(themed).getPropertyValue(`--${name}`).trim();
}

/** Call a function now and whenever the system changes between light and dark; returns what ends it. */
export function onTheme(apply: () => void): () => void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", apply);
  return () => dark.removeEventListener("change", apply);
}
