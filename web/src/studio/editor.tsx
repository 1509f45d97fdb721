/** The text of the study with its line numbers, and the problems at their lines. */

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Key } from "../parts/keys";
import { closeCompletions, completionAttributes, completionKey, Completions, moveCompletions } from "./completing";
import type { Problem } from "./server";
import { edit, problems, redo, remarks, text, undo } from "./study";

export const textKeys: Key[] = [
  { keys: "Ctrl+Space", effect: "list of keys and values that fit at the cursor", actions: {} },
  { keys: "Ctrl+Z", effect: "undo", actions: {} },
  { keys: "Ctrl+Shift+Z", effect: "redo", actions: {} },
];

export function Editor() {
  const area = useRef<HTMLTextAreaElement>(null);
  const numbers = useRef<HTMLOListElement>(null);
  const follow = () => {
    if (area.current !== null && numbers.current !== null) numbers.current.scrollTop = area.current.scrollTop;
  };
  useLayoutEffect(follow); // the browser scrolls a list of another length by itself
  const wrong = new Set(problems.value.map(({ line }) => line));
  const doubtful = new Set(remarks.value.map(({ line }) => line));
  const count = text.value.split("\n").length;
  const go = (line: number | null) => {
    if (area.current !== null && line !== null) select(area.current, line);
  };
  return (
    <div class="editor">
      <div class="page">
        <ol ref={numbers} aria-hidden="true">
          {Array.from({ length: count }, (_, k) => (
            <li class={wrong.has(k + 1) ? "wrong" : doubtful.has(k + 1) ? "doubtful" : ""}>{k + 1}</li>
          ))}
        </ol>
        <textarea
          ref={area}
          aria-label="Text of the study file, TOML"
          aria-invalid={problems.value.length > 0}
          value={text.value}
          wrap="off"
          spellcheck={false}
          autocapitalize="off"
          autocomplete="off"
          {...completionAttributes()}
          onInput={(event) => {
            edit(event.currentTarget.value);
            moveCompletions(event.currentTarget);
          }}
          onSelect={(event) => moveCompletions(event.currentTarget)}
          onBlur={closeCompletions}
          onScroll={follow}
          onKeyDown={(event) => {
            if (completionKey(event, event.currentTarget)) return;
            if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
            const letter = event.key.toLowerCase();
            const action = letter === "y" || (letter === "z" && event.shiftKey) ? redo : letter === "z" ? undo : null;
            if (action === null) return;
            event.preventDefault();
            action();
          }}
        />
      </div>
      <Completions area={area} />
      <section aria-label="Problems" aria-live="polite" class="problems">
        {problems.value.length > 0 && (
          <ul>
            {problems.value.map((problem) => (
              <li>
                <Parts problem={problem} go={go} />
              </li>
            ))}
          </ul>
        )}
        {remarks.value.map((remark) => (
          <p class="doubt">
            <Place path={remark.path} line={remark.line} go={go} />: {remark.text}
          </p>
        ))}
        {problems.value.length === 0 && remarks.value.length === 0 && text.value !== "" && (
          <p class="quiet">The study has no problem.</p>
        )}
        {text.value === "" && <p>Choose a template or open a study above, or write here.</p>}
      </section>
    </div>
  );
}

type Go = (line: number | null) => void;

function Place({ path, line, go }: { path: string; line: number | null; go: Go }) {
  const words = line === null ? path : `line ${line}${path ? `, ${path}` : ""}`;
  return line === null ? (
    <b>{words}</b>
  ) : (
    <button type="button" class="minor" onClick={() => go(line)}>
      {words}
    </button>
  );
}

/** The five parts of an error. */
export function Parts({ problem, go = () => undefined }: { problem: Problem; go?: Go }) {
  return (
    <div class="parts">
      <p>
        <Place path={problem.path || problem.argument} line={problem.line} go={go} />: got {problem.given}
      </p>
      <dl>
        <dt>allowed</dt>
        <dd>{problem.allowed}</dd>
        <dt>likely cause</dt>
        <dd>{problem.cause}</dd>
        <dt>next step</dt>
        <dd>{problem.next_step}</dd>
      </dl>
    </div>
  );
}

/** Select a line, and scroll to it. */
function select(area: HTMLTextAreaElement, line: number): void {
  const lines = area.value.split("\n");
  const start = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
  area.focus();
  area.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0));
  const height = area.scrollHeight / Math.max(lines.length, 1);
  area.scrollTop = Math.max(0, (line - 4) * height);
}
