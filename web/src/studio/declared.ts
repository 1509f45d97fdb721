/** The declared keys as a tree, and the conversion of what is typed to values of the file. */

import type { Key, Value } from "./server";

export interface Branch {
  key: Key;
  name: string; // last part of the path
  inside: Branch[];
}

/** Keys at the top of the file; those of a table are inside it. */
export function treeOf(keys: Key[]): Branch[] {
  const top: Branch[] = [];
  const known = new Map<string, Branch>();
  for (const key of keys) {
    const cut = key.path.lastIndexOf(".");
    const branch = { key, name: key.path.slice(cut + 1), inside: [] };
    known.set(key.path, branch);
    const parent = cut < 0 ? undefined : known.get(key.path.slice(0, cut).replace(/\[\]$/, ""));
    (parent?.inside ?? top).push(branch);
  }
  return top;
}

export const isTable = ({ key }: Branch): boolean => ["table", "tables", "entries"].includes(key.kind);

/** A title within a sentence; names of persons keep their capital. */
export const inSentence = (title: string): string => (/^(Young|Poisson)/.test(title) ? title : title.toLowerCase());

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** The value of the file for a typed text; null for none. The server refuses what is not allowed. */
export function parsed(key: Key, typed: string): Value | null {
  const text = typed.trim().replace(/^"([^"]*)"$/, "$1"); // the quotes of the file are not needed here
  if (text === "") return null;
  switch (key.kind) {
    case "integer":
      return Number.isSafeInteger(Number(text)) && /^[+-]?\d+$/.test(text) ? Number(text) : text;
    case "number":
    case "entries":
      return NUMBER.test(text) && !key.unit ? Number(text) : text;
    case "quantities":
      return text.split(",").map((part) => (key.unit || !NUMBER.test(part.trim()) ? part.trim() : Number(part)));
    case "text":
      return typed;
    default:
      return text;
  }
}

/** A value of the file as it is typed. */
export function typedText(value: Value | undefined): string {
  if (value === undefined) return "";
  if (Array.isArray(value)) return value.map(typedText).join(", ");
  return typeof value === "object" ? "" : String(value);
}

/** What may be typed, in words. */
export function allowedWords(key: Key): string {
  const words = [
    key.help,
    key.kind === "quantities" ? "Commas between the values." : "",
    key.example ? `For example ${key.example}.` : "",
    key.bounds ? `${key.bounds[0]?.toUpperCase()}${key.bounds.slice(1)}.` : "",
    key.typical ? `Usual: ${key.typical}.` : "",
  ];
  return words.filter(Boolean).join(" ");
}
