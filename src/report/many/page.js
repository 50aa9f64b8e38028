
(() => {
  const { element, section, folded, table, tiles, number } = page;
  const { title, jeffcott, study, axes, labels, digest, shown, rows, figures: drawn } = page.data;
  const numbers = Object.entries(digest.numbers);
  const isShown = ([name]) => shown.includes(name);
  const share = (text) => `${number(100 * Number(text), 3)} %`;

  const samplings = { grid: "a grid, the last axis fastest", latin_hypercube: "a Latin hypercube",
    sobol: "Sobol's sequence, shifted at random", monte_carlo: "independent draws" };
  const sweeps = { up: "up the last axis", down: "down the last axis", both: "up and down the last axis" };

  function keyNumbers() {
    const resonance = [...digest.resonances].filter((peak) => peak.bandwidth !== null)
      .sort((a, b) => b.height - a.height)[0];
    const error = digest.largest_measured_error;
    return tiles([
      ["runs", number(digest.runs, 12), digest.failed ? `${number(digest.failed, 12)} failed` : "none failed"],
      ["measured error", error === null ? "not measured" : `${number(error, 3)} of the motion`,
        error !== null && `the largest of the ${number(digest.runs_with_measured_error, 12)} that were measured`],
      ["values", samplings[study.sampling], study.sampling === "grid" ? null : `seed ${study.seed}`],
      study.sweep && ["each run goes on from its neighbour", sweeps[study.sweep]],
      resonance && ["highest resonance with a bandwidth", `${axes[0]} ${number(resonance.at)}`,
        `${resonance.number} ${number(resonance.height)}, half-power bandwidth ${number(resonance.bandwidth, 4)}`],
    ]);
  }

  /** How the values of an axis are given, in words. */
  function given(axis) {
    const text = (value) => (value === null || value === undefined ? null : String(value));
    if (axis.values) {
      const more = axis.values_in_all > axis.values.length ? `, … ${axis.values_in_all} in all` : "";
      return axis.values.map(text).join(", ") + more;
    }
    if (axis.count) return `${axis.from} to ${axis.to}, ${axis.count} values${axis.spacing === "logarithmic" ? " of equal ratios" : ""}`;
    const parts = ["from", "to", "mean", "deviation", "mode", "lowest", "highest"]
      .filter((name) => text(axis[name]) !== null).map((name) => `${name} ${axis[name]}`);
    return [axis.distribution, ...parts].join(", ");
  }

  function plan() {
    const told = study.axis.map((axis, index) => [drawing.labelOf(labels[index]), axis.key, given(axis)]);
    const set = study.set.map(({ key, value }) => [key, String(value)]);
    return [table(["what varies", "key", "values"], told, `Base: ${study.base}.`, 3),
      ...(set.length ? [table(["what all runs have", "value"], set, "Otherwise than the base.", 2)] : [])];
  }

  function failures() {
    const told = digest.failures.map(({ run, values, error }) => [String(run), ...values.map((v) => number(v)), error]);
    const more = digest.failed > told.length ? `The first ${told.length} of ${digest.failed}; ` : "";
    return table(["run", ...axes, "error"], told,
      `${more}jeffcott study FILE --only I makes run I alone, with all its files.`, 2 + axes.length);
  }

  function resonances() {
    const told = digest.resonances.map((peak) => [peak.number, peak.direction, number(peak.at), number(peak.height),
      number(peak.half_power_from), number(peak.half_power_to), number(peak.bandwidth, 4),
      number(peak.bandwidth === null ? null : peak.at / peak.bandwidth, 4)]);
    return table(["number", "direction", `at, ${axes[0]}`, "height", "half power from", "to", "bandwidth", "quality"], told,
      "Tops by a parabola through three runs; half power is 1/√2 of the height; quality is place over bandwidth.", 2);
  }

  function numberTable(entries) {
    const quantiles = entries.find(([, entry]) => entry.quantiles)?.[1].quantiles;
    const shares = quantiles ? Object.keys(quantiles).sort((a, b) => a - b) : [];
    const told = entries.map(([name, entry]) => [name, number(entry.known, 12), number(entry.mean),
      number(entry.lowest), String(entry.lowest_in_run), number(entry.highest), String(entry.highest_in_run),
      ...shares.map((key) => number(entry.quantiles?.[key]))]);
    return table(["number", "runs", "mean", "lowest", "in run", "highest", "in run", ...shares.map(share)], told);
  }

  function sensitivityTable(entries) {
    const told = entries.map((entry) => [entry.number, ...axes.map((axis) => number(entry.rank_correlation[axis], 3))]);
    return table(["number", ...labels.map(({ quantity }) => quantity)], told);
  }

  /** What the figures show, and all else where it is asked for. */
  function parted(all, isMain, draw) {
    const [main, others] = [all.filter(isMain), all.filter((entry) => !isMain(entry))];
    if (!main.length || !others.length) return [draw(all)];
    return [draw(main), element("details", {}, element("summary", {}, `${others.length} more`), draw(others))];
  }

  function runs() {
    const told = rows.cells.map((cells) => cells.map((cell) => {
      const value = Number(cell);
      return cell === "" ? "–" : Number.isNaN(value) ? cell : number(value);
    }));
    const rest = digest.runs > told.length ? `The first ${told.length} of ${number(digest.runs, 12)} runs; all of them` : "All columns";
    return table(rows.names, told, `${rest} stand in runs.csv beside this page.`, 0);
  }

  /** What the figures show of a run, and the command that makes it alone: results stand in a folder called like their file. */
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

  figures.tellRuns(runText);
  document.getElementById("origin").textContent = `jeffcott ${jeffcott}, a study of ${number(digest.runs, 12)} runs`;
  const warned = digest.warnings.map(({ run, runs, warning }) => `run ${run}${runs > 1 ? ` and ${runs - 1} more` : ""}: ${warning}`);
  section("numbers", "Key numbers", keyNumbers(), ...page.warnings(warned));
  if (digest.failed) section("failures", "Failed runs", failures());
  if (drawn.length) section("figures", "Figures", ...drawn.map(figures.add));
  folded("plan", "Plan", ...plan());
  if (digest.resonances.length) folded("resonances", "Resonances", resonances());
  if (digest.sensitivities.length) {
    folded("sensitivities", "Sensitivities", element("p", { class: "quiet" }, "Spearman's rank correlation of every number with every axis."),
      ...parted(digest.sensitivities, ({ number: name }) => shown.includes(name), sensitivityTable));
  }
  folded("statistics", "Numbers over all runs", ...parted(numbers, isShown, numberTable));
  folded("runs", "Runs", runs());
  page.scenarioSection("the base, with its defaults and what all runs have otherwise", page.data.base);
  page.ready(figures.redraw);
})();
