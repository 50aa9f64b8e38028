
(() => {
  const { element, section, folded, table, number } = page;
  const { document: answer, sealed, parts, figures: drawn, film: ended, tables } = page.data;

  /** Most rows of a table that stands open. */
  const LONGEST = 10;

  /** What is reported line by line: a name and its text, those without a name belonging to the one before. */
  function lines(entries) {
    const list = element("dl", { class: "lines" });
    for (const [name, text] of entries) {
      if (name) list.append(element("dt", {}, name));
      list.append(element("dd", {}, text));
    }
    return list;
  }

  /** A table, opened by whoever asks for it where it is long. */
  function shortened([heads, cells]) {
    if (cells.length <= LONGEST) return table(heads, cells);
    return element("details", {}, element("summary", {}, `${heads[0] || "table"}: ${cells.length} rows`), table(heads, cells));
  }

  /** All that is reported, in its order. */
  function reported() {
    const made = [];
    let open = [];
    const close = () => { if (open.length) made.push(lines(open)); open = []; };
    for (const part of parts) {
      if (part.line) { open.push(part.line); continue; }
      close();
      if (part.table) made.push(shortened(part.table));
      else made.push(element("p", {}, part.text.trim()));
    }
    close();
    return made;
  }

  function rows({ name, columns, rows: count }) {
    const shown = columns[0]?.cells.length ?? 0;
    const cell = (value) => (typeof value === "string" ? value : number(value, 6));
    const cells = Array.from({ length: shown }, (_, row) => columns.map((column) => cell(column.cells[row])));
    const rest = count > shown ? `The first ${shown} of ${count} rows; all, as SI units,` : "All rows with all digits, as SI units,";
    return table(columns.map((column) => column.name), cells, `${rest} stand in ${name}.csv beside this page.`);
  }

  /** What the figures show of a run of a study, and the command that makes it alone: results stand in a folder called like their file. */
  function runText(run) {
    const found = new Map();
    const note = ({ quantity, unit }, value) => { if (quantity && value !== undefined) found.set(quantity, `${quantity} ${number(value)} ${unit}`.trim()); };
    for (const figure of figures.all()) for (const panel of figure.panels) {
      for (const curve of panel.curves) {
        const k = curve.runs?.indexOf(run) ?? -1;
        if (k < 0 || curve.mark === "spot" && figure.name === "bifurcation") continue;
        const [xs, ys] = curve.xs.length ? [curve.xs, curve.ys] : [curve.markXs, curve.markYs];
        note(panel.x, xs[k]);
        note(panel.y, ys[k]);
      }
      const k = panel.cells?.runs?.indexOf(run) ?? -1;
      if (k >= 0) note({ quantity: panel.title, unit: "" }, panel.cells.values[k]);
    }
    const folder = decodeURIComponent(location.pathname.split("/").at(-2) ?? "FILE");
    return `Run ${run}: ${[...found.values()].join(", ")}. Alone: jeffcott study ${folder}.toml --only ${run}`;
  }

  const json = (value) => element("pre", {}, JSON.stringify(value, null, 2));

  figures.tellRuns(runText);
  section("numbers", "Answer", ...page.warnings(answer.warnings ?? []), ...reported());
  // what is asked first stands open
  const [first, ...others] = drawn;
  if (first) section(`figure-${first.name}`, first.heading, figures.add(first));
  for (const figure of others) folded(`figure-${figure.name}`, figure.heading, figures.add(figure));
  if (ended) {
    const { figure, at } = film.add(ended, (time) => figures.seek("trace", time));
    figures.follow("trace", at);
    folded("film", "In motion", figure);
  }
  for (const entry of tables) folded(`table-${entry.name}`, `${entry.heading}, a table`, rows(entry));
  const { scenario, study, ...numbers } = answer;
  if (scenario) folded("scenario", scenario.record ? "Record" : "Scenario", element("p", { class: "quiet" }, "as it was read, with defaults"), json(scenario));
  if (study) folded("study", "Study", json(study));
  folded("document", "All numbers", element("p", { class: "quiet" }, `what stands in ${sealed}`), json(numbers));
  page.ready(figures.redraw);
})();
