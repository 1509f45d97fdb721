/** The questions of an analysis, and how its files were read before it computes. */

import { useEffect, useRef } from "preact/hooks";
import { show } from "../views";
import { typeset } from "../parts/numbers";
import { chooseFile, isWrong, missing, namesFile, ofFiles, options, usesStudy, useStudy } from "./chosen";
import { Drop } from "./drop";
import { Parts } from "./editor";
import { Question } from "./question";
import type { Analysis, Option } from "./server";
import { opened } from "./study";
import { TableOf } from "./table";
import { isReading, lostServer, questionOf, refused, tableOf, understood } from "./understood";

export function Questions({ chosen }: { chosen: Analysis }) {
  const needed = chosen.options.filter(({ required }) => required);
  const others = chosen.options.filter(({ required }) => !required);
  const topics = [...new Set(others.map(({ topic }) => topic))].filter((topic) => topic !== "");
  const rest = others.filter(({ topic }) => topic === "");
  return (
    <>
      {needed.some(namesFile) && <Drop />}
      <div class="asks">
        <Group options={needed} chosen={chosen} />
      </div>
      <StudyUse chosen={chosen} />
      {chosen.examines && <Understood chosen={chosen} />}
      {topics.map((topic) => (
        <fieldset class="item asks">
          <legend>{topic}</legend>
          <Group options={others.filter((option) => option.topic === topic)} chosen={chosen} />
        </fieldset>
      ))}
      {topics.length === 0 ? (
        <Group options={rest} chosen={chosen} />
      ) : (
        <details class="further">
          <summary>Further options</summary>
          <Group options={rest} chosen={chosen} />
        </details>
      )}
    </>
  );
}

function Group({ options: group, chosen }: { options: Option[]; chosen: Analysis }) {
  if (group.length === 0) return null;
  return (
    <div class="fields">
      {group.map((option) => (
        <Question key={`${chosen.name}-${option.name}`} option={option} />
      ))}
    </div>
  );
}

/** Whether the study of the page belongs to the files, and its tables about them. */
function StudyUse({ chosen }: { chosen: Analysis }) {
  if (chosen.study === "needed" || chosen.study === "none") return null;
  return (
    <div class="row">
      <label class="check">
        <input type="checkbox" checked={usesStudy.value} onChange={(event) => useStudy(event.currentTarget.checked)} />
        {chosen.study === "optional" ? "with the study of this page" : "with the settings of the study of this page"}
      </label>
      {usesStudy.value &&
        chosen.tables.map((table) => (
          <OpenTable path={table} />
        ))}
      {usesStudy.value && isWrong.value && <span class="quiet">The study has problems, or is empty.</span>}
    </div>
  );
}

/** Opens a table in the form, whose keys are then used for the files. */
function OpenTable({ path }: { path: string }) {
  const open = () => {
    useStudy(true);
    opened.value = { path, isReached: false };
  };
  return (
    <button type="button" onClick={open}>
      Open the table {path} in the form
    </button>
  );
}

function Understood({ chosen }: { chosen: Analysis }) {
  const place = useRef<HTMLDivElement>(null);
  const reading = understood.value;
  const data = reading?.data ?? null;
  useEffect(() => (place.current === null || data === null ? undefined : show(data, place.current)), [data]);
  if (missing.value.length > 0) return <p class="quiet">Choose the files to see what is in them.</p>;
  return (
    <section class="understood" aria-labelledby="understood-title" aria-busy={isReading.value}>
      <h3 id="understood-title">{reading?.answer.title ?? "Reading the files"}</h3>
      <p class="quiet" role="status">
        {isReading.value ? "The files are read." : refused.value !== null ? "The files cannot be read like this." : "Nothing is computed yet."}
      </p>
      {lostServer.value && <p class="problem">{lostServer.value}</p>}
      {refused.value !== null && questionOf.value === "" && (
        <div class="refusal" role="alert">
          <Parts problem={{ ...refused.value, path: "", line: null }} />
        </div>
      )}
      {refused.value !== null && questionOf.value !== "" && (
        <p>
          <a href={`#option-${questionOf.value}`} onClick={toQuestion}>
            Go to the question: {questionOf.value.replaceAll("_", " ")}
          </a>
        </p>
      )}
      {tableOf.value !== "" && (
        <p>
          <OpenTable path={tableOf.value} />
        </p>
      )}
      {refused.value !== null && <Instead chosen={chosen} />}
      {reading !== null && (
        <>
          {reading.answer.summary.map((sentence) => (
            <p>{typeset(sentence)}</p>
          ))}
          {reading.answer.remarks.map((remark) => (
            <p class="doubt">{remark}</p>
          ))}
          <div ref={place} />
          {reading.answer.tables.map((table) => (
            <TableOf table={table} />
          ))}
        </>
      )}
    </section>
  );
}

const RESULT = ".nc";

/** Other analyses that may understand the same file. */
function Instead({ chosen }: { chosen: Analysis }) {
  const file = chosen.options.find((option) => option.required && namesFile(option));
  const name = String(options.value[file?.name ?? ""] ?? "");
  return (
    <p>
      {ofFiles.value
        .filter((other) => other.name !== chosen.name)
        .map((other) => (
          <button type="button" onClick={() => chooseFile(name, other)}>
            Read it for {other.name}
          </button>
        ))}
      {name.endsWith(RESULT) && <span class="quiet"> The bands of a study, {RESULT}, are chosen in the analysis compare.</span>}
    </p>
  );
}

function toQuestion(event: Event): void {
  event.preventDefault();
  document.getElementById(`option-${questionOf.peek()}`)?.focus();
}
