
(() => {
  const { element, section, folded, table, number } = page;
  const { jeffcott, sealed, parts, warnings, figures: drawn, tables, scenario } = page.data;

  /** Most rows of a table that stands open. */
  const LONGEST = 10;

  /** What is told line by line: a name and its text, those without a name belonging to the one before. */
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

  /** All that is told, in its order. */
  function told() {
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
    const rest = count > shown ? `The first ${shown} of ${count} rows; all` : "All rows with all digits";
    return table(columns.map((column) => column.name), cells, `${rest} stand in the table ${name} beside this page.`);
  }

  document.getElementById("origin").textContent = `jeffcott ${jeffcott}; all numbers stand in ${sealed}`;
  section("numbers", "Answer", ...page.warnings(warnings ?? []), ...told());
  if (drawn.length) section("figures", "Figures", ...drawn.map(figures.add));
  for (const entry of tables) folded(`table-${entry.name}`, `Table ${entry.name}`, rows(entry));
  if (scenario) page.scenarioSection("as it was read, with defaults", scenario);
  page.ready(figures.redraw);
})();
