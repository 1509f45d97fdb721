// One round of use of the studio, two minutes of a user: it returns when all of it is shown.
async (text, shares) => {
  const PATIENCE = 300_000; // ms
  const find = (selector) => document.querySelector(selector);
  const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
  const until = async (what, isSo) => {
    for (const end = performance.now() + PATIENCE; !isSo(); await pause(5))
      if (performance.now() > end) throw new Error(`no ${what}`);
  };
  const there = async (selector) => (await until(selector, () => find(selector)), find(selector));
  const choose = (field, value) => {
    field.value = value;
    field.dispatchEvent(new Event("change", { bubbles: true }));
  };
  const press = async (selector, ...keys) => {
    for (const name of keys) {
      const key = name.replace("Control+", "");
      const ctrlKey = key !== name;
      find(selector).dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey, bubbles: true, cancelable: true }));
      await pause(20);
    }
  };
  const section = (name) =>
    [...document.querySelectorAll("summary")].find((summary) => summary.textContent.trim().startsWith(name));
  const area = () => find("textarea[aria-label^='Text of the study']");
  const enter = (next) => {
    area().value = next;
    area().dispatchEvent(new InputEvent("input", { bubbles: true }));
  };
  const compute = async (analysis) => {
    choose(find(".compute select"), analysis);
    const button = () => find(".compute button.main");
    await until("button", () => button().textContent.includes(analysis) && !button().disabled);
    button().click();
    await there(".compute .running");
    await until("result", () => find(`#result[aria-label='Result of ${analysis}']`) && !find(".compute .running"));
  };
  const turn = async (path, moves) => {
    choose(find(".turning select"), path);
    await there(".turning[data-prepared=true]");
    const slider = find(".turning input");
    const [low, high] = [Number(slider.min), Number(slider.max)];
    for (const share of moves) {
      slider.value = String(low + share * (high - low));
      slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
      await pause(20);
    }
    slider.dispatchEvent(new PointerEvent("pointerup", { bubbles: true }));
    slider.dispatchEvent(new Event("change", { bubbles: true }));
    await until("certified curves", () => find(".kind").textContent === "certified");
    await there(".turning select:enabled");
  };
  const paint = async () => {
    section("Map of the plate").click();
    await there(".paint canvas");
    const before = area().value;
    await press(".paint canvas", "3", "ArrowRight", " ");
    await until("painted tile", () => area().value !== before);
    await press(".paint canvas", "Control+z");
    await until("tile of before", () => area().value === before);
    await press(".paint canvas", "ArrowLeft");
    section("Map of the plate").click();
  };

  enter(text);
  await pause(500);
  await compute("bands");
  await there(".turning select:enabled");
  const paths = ["cell.pillar.diameter", "cell.pillar.height", "cell.thickness", "cell.pitch"];
  for (const [number, path] of paths.entries()) await turn(path, shares[number]);
  await press(".walk", "ArrowRight", "ArrowRight", "ArrowUp", "ArrowLeft", "h", "h", "t", "t");
  section("Pictures").click();
  await there(".pictures img");
  find(".pictures").scrollIntoView();
  await until("pictures", () => [...document.querySelectorAll(".pictures img")].every((image) => image.naturalWidth));
  section("Pictures").click();
  await paint();
  for (const analysis of ["plate", "feel"]) {
    await compute(analysis);
    await there("canvas[data-shown]");
    await press(".walk", "ArrowRight", "ArrowRight", "ArrowUp", "ArrowDown");
  }
  section("Runs").click();
  for (const row of [...document.querySelectorAll("[aria-label=Runs] tbody tr")].slice(1, 3)) {
    row.querySelector("button").click();
    await pause(500);
  }
  section("Runs").click();
}
