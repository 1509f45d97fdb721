/** Entry of the studio. */

import { render } from "preact";
import { addKeys } from "./parts/keys";
import { Result } from "./studio/answer";
import { Compute } from "./studio/compute";
import { analyses, list } from "./studio/chosen";
import { completeWith } from "./studio/completing";
import { Comparison, followComparison } from "./studio/compare";
import { treeOf } from "./studio/declared";
import { followDrops } from "./studio/drop";
import { Editor, textKeys } from "./studio/editor";
import { Bar } from "./studio/files";
import { Form } from "./studio/form";
import { follow, lost } from "./studio/jobs";
import { followOpenings } from "./studio/opening";
import { Paint } from "./studio/paint/paint";
import paintStyle from "./studio/paint/paint.css";
import { Points, pointsKeys } from "./studio/points";
import { followPoints } from "./studio/points_data";
import { openLink } from "./studio/share";
import { server, type Start } from "./studio/server";
import { attempt, openFile, unsaved } from "./studio/study";
import { followReading } from "./studio/understood";
import { followTurns } from "./studio/turn";
import style from "./studio/studio.css";
import { addStyle } from "./views";

function Page({ start }: { start: Start }) {
  const tree = treeOf(start.form);
  return (
    <>
      <Bar start={start} />
      <Lost />
      <main class="workbench">
        <div class="study">
          <section id="form" aria-label="Form" tabIndex={0}>
            <Form tree={tree} />
          </section>
          <section id="text" aria-label="Text">
            <Editor />
          </section>
        </div>
        <div class="results" tabIndex={0} role="group" aria-label="Analyses and result">
          <Compute />
          <Paint first={start.plate} />
          <Comparison />
          <Points />
          <Result exports={start.exports} />
          <footer>
            <p>haptonic {start.version}</p>
          </footer>
        </div>
      </main>
    </>
  );
}

function Lost() {
  if (!lost.value) return null;
  return (
    <p class="notice" role="alert">
      The server of the studio does not answer. If it has ended, run <code>haptonic studio</code> again and open its
      new link; copy a text that is not saved first.
    </p>
  );
}

async function begin(): Promise<void> {
  addStyle();
  const sheet = document.createElement("style");
  sheet.textContent = style + paintStyle;
  document.head.append(sheet);
  const place = document.getElementById("studio");
  if (place === null) throw new Error("the page has no place for the studio");
  await attempt(async () => {
    const start = await server.start();
    analyses.value = start.analyses;
    list(start);
    completeWith(start.form, start.expressions);
    addKeys("Text of the study", textKeys);
    addKeys("Computed designs", pointsKeys);
    render(<Page start={start} />, place);
    if (start.opened !== null) await openFile(start.opened);
    await openLink();
    follow();
    followOpenings();
    followPoints();
    followComparison();
    followTurns();
    followDrops(start.solids);
    followReading();
  });
  addEventListener("hashchange", () => void openLink());
  addEventListener("beforeunload", (event) => {
    if (unsaved.peek()) event.preventDefault();
  });
}

begin().catch((reason: unknown) => {
  const words = document.createElement("p");
  words.textContent = `The studio cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}`;
  document.body.replaceChildren(words);
});
