/** What the page asks the server for, with the types of the answers. */

import type { Drawing, Point } from "../parts/plan";
import { Dataset } from "../dataset";

export type Value = string | number | boolean | Value[] | Tables;
export interface Tables {
  [key: string]: Value;
}
export type Step = string | number;

/** Declaration of a key of the study, as `haptonic.studio.form` gives it. */
export interface Key {
  path: string;
  title: string;
  kind:
    | "quantity" | "number" | "integer" | "boolean" | "text" | "choice" | "table" | "tables" | "quantities"
    | "entries";
  unit: string;
  default: string;
  required: boolean;
  bounds: string;
  typical: string;
  help: string;
  names: string[];
  closed: boolean;
  numbers: string[];
  count: number;
  example: string;
}

export interface Option {
  name: string;
  form: "bool" | "int" | "float" | "str" | "text" | "choice" | "path"; // a path is a name in the folder
  unit: string;
  help: string;
  choices: string[];
  default: string | number | boolean | null;
  topic: string; // heading of its question; empty for one that is rarely needed
  required: boolean;
}

export interface Analysis {
  name: string;
  help: string;
  interactive: boolean; // its result has an interactive view
  examines: boolean; // it can report what it understood of its files
  study: "needed" | "optional" | "settings" | "none"; // "settings": only the tables for its files are used
  tables: string[]; // of the study, with settings for its files
  options: Option[];
}

/** Forms and styles of saved files, as `haptonic.studio.files` gives them. */
export interface Exports {
  pictures: string[];
  looks: Record<string, string>;
  tables: string[];
}

/** Names in the folder. */
export interface Listed {
  files: string[]; // studies
  measured: string[];
}

export interface Start extends Listed {
  version: string;
  folder: string;
  form: Key[];
  analyses: Analysis[];
  templates: Record<string, string>;
  opened: string | null;
  exports: Exports;
  expressions: string; // table whose names expressions may use
  plate: Tables; // of a study that gets its first plate
  solids: string[]; // endings of CAD files and meshes
}

/** An error in its five parts, with the path and the line of its key. */
export interface Problem {
  code: string;
  argument: string;
  given: string;
  allowed: string;
  cause: string;
  next_step: string;
  path: string;
  line: number | null;
}

export interface Remark {
  path: string;
  text: string;
  line: number | null;
}

/** Another value of one key; null removes it. */
export interface Change {
  steps: Step[];
  value: Value | null;
}

/** Something on the plate that can be moved, as `haptonic.studio.painting` gives it; lengths in m. */
export interface Part {
  steps: Step[]; // to its table
  name: string;
  centre: Point; // on the plate
  corner: Point; // that its key counts from
  size: number[]; // along x, along y and further ones; empty for a point and a disc
  diameter: number | null;
}

export interface PlateDrawing extends Drawing {
  x: number[]; // lines between the letters of the map, m
  y: number[];
  lattices: string[];
  parts: Part[];
  clamp: number | null; // supported length at the corners, m
  mass: number | null; // kg
  contents: string;
  remarks: string[];
}

export interface Forecast {
  command: string;
  time: string;
  memory: string;
  refusal: string;
}

export interface Checked {
  values: Tables | null;
  problems: Problem[];
  remarks: Remark[];
  plate: PlateDrawing | null;
}

export interface Job {
  number: number;
  analysis: string;
  file: string;
  title: string; // of the study
  started: number; // s since 1970
  points: number; // computed designs so far
  state: "running" | "done" | "failed" | "cancelled" | "interrupted"; // the last: by the end of its server
  cost: string;
  progress: [number, number, string];
  seconds: number;
  turned: boolean; // it belongs to a number that a user turns
  first: number; // versions so far of the part of the view that is computed first
  archived: boolean; // from an earlier start of the server, or too old to stay in memory
  byCommand?: boolean; // of the command line
  turns: boolean; // the list of numbers that can be turned is there
  previews: Record<string, number>; // improvements of each preview so far, by the path of its number
}

/** A number that can be turned; its values are in `unit`. */
export interface Knob {
  path: string;
  steps: Step[];
  title: string;
  unit: string;
  scale: number; // SI units in one `unit`
  value: number;
  low: number;
  high: number;
  step: number;
}

/** Numbers of a computed design, as `haptonic.analyses.points` declares them. */
export interface PointNumber {
  title: string;
  value: number; // SI
  unit: string;
  error: number | null;
}

export interface DesignPoint {
  group: string;
  varied: PointNumber[];
  results: PointNumber[];
}

export interface ResultTable {
  title: string;
  head: string[];
  rows: string[][];
  count: number;
  numeric: boolean[];
  strong: number[];
}

export interface Answer {
  title: string;
  origin: string;
  summary: string[];
  tables: ResultTable[];
  remarks: string[];
  pictures: { name: string; caption: string }[];
  files: string[];
}

/** Two runs, as `haptonic.studio.comparing` gives them. */
export interface Compared {
  runs: { name: string; title: string; summary: string[] }[];
  tables: ResultTable[];
}

export interface WholeJob extends Job {
  text: string;
  error: Problem | null;
  answer: Answer | null;
  view: boolean;
  options: object;
  alone: boolean; // without a study
  command: string;
  python: string;
}

/** A refusal of the server, with its parts if the user can correct it. */
export class Refusal extends Error {
  constructor(
    message: string,
    readonly problem?: Problem,
  ) {
    super(message);
  }
}

export const NO_ANSWER = "The server does not answer, so nothing was changed; is `haptonic studio` still running?";

async function accepted(request: Promise<Response>): Promise<Response> {
  let response: Response;
  try {
    response = await request;
  } catch {
    throw new Refusal(NO_ANSWER);
  }
  if (response.ok) return response;
  if (response.status === 422) {
    const { error } = (await response.json()) as { error: Problem };
    throw new Refusal(`${error.argument}: ${error.cause}`, error);
  }
  if (response.status === 403) throw new Refusal("The server was started again; open its new link.");
  throw new Refusal(response.headers.get("content-type")?.startsWith("text/plain") ? await response.text() : `Error ${response.status} of the server.`);
}

const answered = async <T,>(request: Promise<Response>): Promise<T> => (await (await accepted(request)).json()) as T;

/** A file with the name that the server gives it. */
async function file(request: Promise<Response>): Promise<{ name: string; content: Blob }> {
  const response = await accepted(request);
  const name = /filename="([^"]*)"/.exec(response.headers.get("content-disposition") ?? "")?.[1] ?? "file";
  return { name, content: await response.blob() };
}

function posted(name: string, asked: object): Promise<Response> {
  const headers = { "content-type": "application/json" };
  return fetch(`api/${name}`, { method: "POST", headers, body: JSON.stringify(asked) });
}

const post = <T,>(name: string, asked: object) => answered<T>(posted(name, asked));

/** A text that the server has written. */
export type Edited = Checked & { text: string };

/** How files were read, or why they cannot be read; the view is in base 64. */
export interface Examined {
  answer: Answer | null;
  view: string | null;
  problem: Problem | null;
}

/** An analysis to run, or whose files are to be read. */
export interface Wanted {
  analysis: string;
  options: object;
  alone: boolean;
  text: string;
  file: string | null;
}

export const server = {
  start: () => answered<Start>(fetch("api/start")),
  check: (text: string) => post<Checked>("check", { text }),
  change: (text: string, changes: Change[]) => post<Edited>("change", { text, changes }),
  forecast: (text: string) => post<{ costs: Forecast[] }>("forecast", { text }),
  open: (name: string) => post<Edited & { name: string }>("open", { name }),
  template: (name: string) => post<Edited>("template", { name }),
  save: (name: string, text: string, known: string | null, replace: boolean) =>
    post<{ name: string; files: string[] }>("save", { name, text, known, replace }),
  run: (wanted: Wanted) => post<{ number: number }>("run", wanted),
  examine: (wanted: Wanted) => post<Examined>("examine", wanted),
  upload: (name: string, content: Blob, replace: boolean) => {
    const query = new URLSearchParams({ name, replace: replace ? "1" : "0" });
    return answered<Listed>(fetch(`api/upload?${query}`, { method: "POST", body: content }));
  },
  cancel: (number: number) => post<object>("cancel", { number }),
  compare: (first: number, second: number) => post<Compared>("differences", { first, second }),
  export: (number: number, wanted: object) => file(posted("product", { number, ...wanted })),
  page: (number: number) => file(fetch(`api/jobs/${number}/page`)),
  remove: (number: number) => post<object>("remove", { number }),
  design: (number: number, point: number) => post<Edited>("opened", { number, point }),
  points: (number: number, first: number) => answered<DesignPoint[]>(fetch(`api/jobs/${number}/points/${first}`)),
  job: (number: number) => answered<WholeJob>(fetch(`api/jobs/${number}`)),
  view: async (number: number) => (await fetch(`api/jobs/${number}/view`)).arrayBuffer(),
  turn: (job: WholeJob, text: string, steps: Step[], value: Value, file: string | null) =>
    post<{ number: number }>("run", { analysis: job.analysis, options: job.options, text, file, steps, value }),
  wish: (path: string) => post<object>("wish", { path }),
  knobs: (number: number) => answered<Knob[]>(fetch(`api/jobs/${number}/knobs`)),
  /** The part of a view that is computed first, or a preview; null if the job has been replaced. */
  part: async (number: number, name: string) => {
    const response = await fetch(`api/jobs/${number}/${name}`);
    return response.ok ? Dataset.read(await response.arrayBuffer()) : null;
  },
  picture: (number: number, name: string) => `api/jobs/${number}/pictures/${encodeURIComponent(name)}`,
};

const AGAIN = 2000; // ms between two attempts to connect

/** Follow the list of jobs; `lost` is called when the server is gone. */
export function followJobs(heard: (jobs: Job[]) => void, lost: (gone: boolean) => void): void {
  const socket = new WebSocket(`ws://${location.host}/api/live`);
  socket.onopen = () => lost(false);
  socket.onmessage = (event) => heard((JSON.parse(String(event.data)) as { jobs: Job[] }).jobs);
  socket.onclose = () => {
    lost(true);
    setTimeout(() => followJobs(heard, lost), AGAIN);
  };
}
