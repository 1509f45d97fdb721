/** What may stand at the cursor of the study's text, from the declarations of the keys. */

import type { Key } from "./server";

export interface Completion {
  insert: string; // in place of the text from `from` to the cursor
  label: string;
  detail: string;
}

export interface Completions {
  from: number; // position in the text
  list: Completion[];
}

const HEADING = /^\s*\[\[?\s*([^\]]+?)\s*\]\]?/;
const NUMERIC = ["quantity", "number", "integer", "quantities", "entries"];
const MOST = 50;

/** Completions at a position; expressions may use the names of the table `parameters`. */
export function completionsAt(text: string, position: number, keys: Key[], parameters: string): Completions {
  const start = text.lastIndexOf("\n", position - 1) + 1;
  const before = text.slice(start, position);
  const above = text.slice(0, start).split("\n");
  const byPath = new Map(keys.map((key) => [key.path, key]));
  const equals = before.indexOf("=");
  const heading = /^\s*\[+\s*([\w.-]*)$/.exec(before);
  if (heading !== null) return tablesFor(heading[1] ?? "", position - before.trimStart().length, keys);
  const table = tableAt(above, byPath);
  if (equals < 0) {
    const given = givenIn(text.split("\n"), above.length - 1);
    return keysFor(/[\w-]*$/.exec(before)?.[0] ?? "", position, { keys, table, given });
  }
  const key = byPath.get(inside(table, patternOf(before.slice(0, equals).trim(), byPath, table))) ?? byPath.get(table);
  return key === undefined ? { from: position, list: [] } : valuesFor(before.slice(equals + 1), position, key, key.path === parameters ? [] : parametersIn(text, parameters));
}

/** Path of the table of the last heading, with "[]" behind the names of lists. */
function tableAt(above: string[], byPath: Map<string, Key>): string {
  return patternOf(above.flatMap((line) => HEADING.exec(line)?.[1] ?? []).at(-1) ?? "", byPath, "");
}

function patternOf(name: string, byPath: Map<string, Key>, table: string): string {
  return name.split(".").reduce((path, part) => {
    const step = path ? `${path}.${part.trim()}` : part.trim();
    return byPath.get(inside(table, step))?.kind === "tables" ? `${step}[]` : step;
  }, "");
}

const inside = (table: string, name: string) => (table && name ? `${table}.${name}` : table || name);

/** Names of the keys that the table of a line has in other lines. */
function givenIn(lines: string[], current: number): Set<string> {
  const isHeading = lines.map((line) => HEADING.test(line));
  const begin = isHeading.lastIndexOf(true, current) + 1;
  const next = isHeading.indexOf(true, current + 1);
  const others = lines.filter((_, k) => k >= begin && (next < 0 || k < next) && k !== current);
  return new Set(others.map((line) => /^\s*([\w-]+)\s*=/.exec(line)?.[1] ?? ""));
}

/** Names and texts of the parameters, also of a text that cannot be read at the moment. */
function parametersIn(text: string, table: string): [string, string][] {
  const lines = text.split("\n");
  const begin = lines.findIndex((line) => HEADING.exec(line)?.[1] === table) + 1;
  if (begin === 0) return [];
  const count = lines.slice(begin).findIndex((line) => HEADING.test(line));
  return lines.slice(begin, count < 0 ? lines.length : begin + count).flatMap((line) => {
    const [, name, value] = /^\s*([A-Za-z_]\w*)\s*=\s*(.*)/.exec(line) ?? [];
    return name === undefined ? [] : [[name, value ?? ""] as [string, string]];
  });
}

function matching(list: Completion[], word: string): Completion[] {
  const wanted = word.toLowerCase();
  return list.filter(({ label }) => label.replace(/^[["]+/, "").toLowerCase().startsWith(wanted)).slice(0, MOST);
}

function tablesFor(word: string, from: number, keys: Key[]): Completions {
  const list = keys
    .filter(({ kind }) => ["table", "tables", "entries"].includes(kind))
    .map(({ path, kind, title }) => {
      const name = path.replaceAll("[]", "");
      const label = kind === "tables" ? `[[${name}]]` : `[${name}]`;
      return { insert: label, label, detail: title };
    });
  return { from, list: matching(list, word) };
}

function keysFor(word: string, position: number, { keys, table, given }: { keys: Key[]; table: string; given: Set<string> }): Completions {
  const list = keys
    .filter(({ path, kind }) => path.slice(0, path.lastIndexOf(".") + 1) === (table && `${table}.`) && !["table", "tables", "entries"].includes(kind))
    .map((key) => ({ name: key.path.slice(key.path.lastIndexOf(".") + 1), key }))
    .filter(({ name }) => !given.has(name))
    .map(({ name, key }) => ({
      insert: `${name} = `, label: name,
      detail: key.title + (key.required ? ", required" : key.default ? `, default ${key.default}` : ""),
    }));
  return { from: position - word.length, list: matching(list, word) };
}

function valuesFor(typed: string, position: number, key: Key, own: [string, string][]): Completions {
  const quoted = typed.trimStart().startsWith('"');
  const word = /[\w.-]*$/.exec(typed)?.[0] ?? "";
  const quote = (name: string) => (quoted ? name : `"${name}"`);
  const named = [...key.names, ...key.numbers].map((name) => ({ insert: quote(name), label: name, detail: key.title }));
  const truths = key.kind === "boolean" ? ["true", "false"].map((name) => ({ insert: name, label: name, detail: key.title })) : [];
  const numeric = NUMERIC.includes(key.kind);
  const parameters = (numeric ? own : []).map(([name, value]) => ({
    insert: quote(name), label: name, detail: `parameter, ${value}`,
  }));
  const example = typed.trim() === "" && key.example && !key.closed
    ? [{ insert: key.kind === "quantity" ? `"${key.example}"` : key.example, label: key.example, detail: `${key.title}, an example` }]
    : [];
  return { from: position - word.length, list: matching([...truths, ...named, ...parameters, ...example], word) };
}
