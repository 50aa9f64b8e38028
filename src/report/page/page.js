
(() => {
  const { element, section, folded, table, tiles, number, places, floats } = page;
  const { summary, balls, histories, spectra, furtherSpectra } = page.data;
  const drawn = new Map(page.data.figures.map((figure) => [figure.name, figure]));
  const names = { tilt_x: "θx", tilt_y: "θy", force_x: "force x", force_y: "force y", force_z: "force z",
    moment_x: "moment x", moment_y: "moment y" };
  const named = (name) => names[name] ?? name;

  const shownUnits = { m: ["µm", 1e6], rad: ["µrad", 1e6] };
  const shown = (value, unit) => {
    const [name, factor] = shownUnits[unit] ?? [unit, 1];
    return `${number(value * factor)} ${name}`;
  };

  // Charts.

  const charts = [];
  const groups = new Map();
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  /** Axes of a panel in the colours of the page. */
  function axes(panel) {
    const look = { stroke: colour("--ink"), grid: { stroke: colour("--line"), width: 1 },
      ticks: { stroke: colour("--line"), width: 1 }, font: "12px system-ui, sans-serif",
      labelFont: "12px system-ui, sans-serif" };
    const unit = panel.unit ? ` in ${panel.unit}` : "";
    const powers = (_, splits) => splits.map((v) => {
      const power = Math.log10(v);
      return v !== null && Math.abs(power - Math.round(power)) < 1e-9 ? `1e${Math.round(power)}` : "";
    });
    const upright = { ...look, size: 70, label: `${named(panel.name)}${unit}`, labelSize: 22 };
    if (panel.logarithmic) upright.values = powers;
    else upright.values = (_, splits) => splits.map((v) => (v === null ? "" : number(v, 7)));
    const below = panel.last ? { label: panel.over[1] ? `${panel.over[0]} in ${panel.over[1]}` : panel.over[0], labelSize: 20 } : {};
    return [{ ...look, size: 30, ...below }, upright];
  }

  /** Six decades below the largest value, whatever part is looked at. */
  function decades(curves) {
    let top = 0;
    for (const values of curves) for (const value of values) if (value > top) top = value;
    const highest = top > 0 ? Math.ceil(Math.log10(top * 1.5)) : 0;
    return [10 ** (highest - 7), 10 ** highest];
  }

  /** What is to be seen with a margin; a constant in the middle of a neighbourhood. */
  function padded(low, high) {
    const margin = 0.06 * (high - low) || 0.5 * Math.abs(low) || 1;
    return [low - margin, high + margin];
  }

  /** Names of peaks, the highest first, each only where it covers no other. */
  function drawMarks(u, marks) {
    const { ctx, bbox } = u;
    const ratio = devicePixelRatio;
    const taken = [];
    const seen = new Set();
    ctx.save();
    ctx.font = `${12 * ratio}px system-ui, sans-serif`;
    ctx.fillStyle = colour("--ink");
    ctx.textAlign = "center";
    for (const { at, height, name } of [...marks].sort((a, b) => b.height - a.height)) {
      const x = u.valToPos(at, "x", true);
      const y = u.valToPos(height, "y", true);
      const half = ctx.measureText(name).width / 2 + 3 * ratio;
      const hidden = x - half < bbox.left || x + half > bbox.left + bbox.width
        || y < bbox.top || y > bbox.top + bbox.height;
      const covered = taken.some((other) => Math.abs(other.x - x) < other.half + half
        && Math.abs(other.y - y) < 14 * ratio);
      if (hidden || covered || seen.has(name)) continue;
      seen.add(name);
      taken.push({ x, y, half });
      ctx.fillText(name, x, Math.max(y - 6 * ratio, bbox.top + 12 * ratio));
    }
    ctx.restore();
  }

  function options(panel, width, height, data) {
    const line = (label, index, width) => ({
      label, stroke: colour(`--c${index % 6}`), width,
      value: (_, value) => (value === null ? "–" : `${number(value)}${panel.unit ? ` ${panel.unit}` : ""}`),
      points: { show: false },
    });
    const series = panel.curves.map((curve, index) => line(named(curve.name), index, 1.25));
    // where not every sample is shown, between its lowest and its highest value
    const bands = panel.band ? [{ series: [series.length + 2, series.length + 1], fill: `${colour("--c0")}55` }] : [];
    if (panel.band) series.push(line("lowest", 0, 0.5), line("highest", 0, 0.5));
    const [abscissa, abscissaUnit] = panel.over;
    const settings = {
      width, height, legend: { live: true }, axes: axes(panel), bands,
      series: [{ label: abscissa, value: (_, v) => (v === null ? "–" : `${number(v, 7)} ${abscissaUnit}`) }, ...series],
      scales: { x: { time: false, ...(panel.shown ? { min: data[0][0], max: panel.shown } : {}) }, y: panel.logarithmic ? { distr: 3, range: () => decades(data.slice(1)) }
        : { range: (_, low, high) => (low === null ? [-1, 1] : padded(low, high)) } },
      cursor: { drag: { x: true, y: false }, sync: { key: panel.group, scales: ["x", null], setSeries: false } },
      hooks: { draw: [(u) => drawMarks(u, panel.marks)], setCursor: [(u) => follow(u, panel)] },
    };
    return settings;
  }

  function span(u) {
    const abscissas = u.data[0];
    return [abscissas[0], abscissas[abscissas.length - 1]];
  }

  /** Shows a stretch in all charts of a group, kept within what there is. */
  function show(group, from, to) {
    for (const { plot } of groups.get(group)) {
      const [first, last] = span(plot);
      const size = Math.min(to - from, last - first);
      const start = Math.min(Math.max(from, first), last - size);
      plot.setScale("x", { min: start, max: start + size });
    }
  }

  function keys(chart, event) {
    const { plot, panel } = chart;
    const { min, max } = plot.scales.x;
    const [step, middle] = [(max - min) / 10, (max + min) / 2];
    const moves = {
      ArrowLeft: () => show(panel.group, min - step, max - step),
      ArrowRight: () => show(panel.group, min + step, max + step),
      "+": () => show(panel.group, middle - 4 * step, middle + 4 * step),
      "=": () => show(panel.group, middle - 4 * step, middle + 4 * step),
      "-": () => show(panel.group, middle - 6.25 * step, middle + 6.25 * step),
      0: () => show(panel.group, ...span(plot)),
      Escape: () => show(panel.group, ...span(plot)),
      ",": () => point(plot, -1),
      ".": () => point(plot, 1),
    };
    const move = event.ctrlKey || event.metaKey || event.altKey ? null : moves[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  }

  /** Moves the reading by one point that is shown. */
  function point(plot, step) {
    const { min, max } = plot.scales.x;
    const abscissas = plot.data[0];
    const start = plot.cursor.idx ?? abscissas.findIndex((x) => x >= (min + max) / 2);
    const next = Math.min(Math.max(start + step, 0), abscissas.length - 1);
    const left = plot.valToPos(abscissas[next], "x");
    plot.setCursor({ left, top: plot.over.clientHeight / 2 });
  }

  function build(chart) {
    const kept = chart.plot && { ...chart.plot.scales.x };
    chart.plot?.destroy();
    const settings = options(chart.panel, width(chart), chart.height, chart.data);
    chart.plot = new uPlot(settings, chart.data, chart.holder);
    if (kept) chart.plot.setScale("x", kept);
    for (const entry of chart.holder.querySelectorAll(".u-legend .u-series th")) {
      entry.tabIndex = 0;
      entry.onkeydown = (event) => { if (event.key === "Enter") { event.stopPropagation(); entry.click(); } };
    }
  }

  const width = (chart) => (document.documentElement.classList.contains("printed") ? 680
    : Math.max(chart.holder.clientWidth || document.querySelector("main").clientWidth, 280));

  function addChart(panel, group, height, last = true) {
    const holder = element("div", { class: "chart", tabindex: "0", role: "group",
      "aria-label": `${named(panel.name)} over ${panel.over[0]}; arrow keys move, plus and minus zoom, 0 shows all, comma and full stop read points` });
    const data = [places(panel.curves[0].abscissas), ...panel.curves.map((curve) => floats(curve.values))];
    if (panel.band) data.push(floats(panel.band.low), floats(panel.band.high));
    const chart = { panel: { ...panel, group, last }, holder, height: last ? height + 20 : height, data };
    if (panel.logarithmic) chart.data = [data[0], ...data.slice(1).map((curve) => curve.map((v) => (v > 0 ? v : null)))];
    holder.addEventListener("keydown", (event) => keys(chart, event));
    charts.push(chart);
    groups.set(group, [...(groups.get(group) ?? []), chart]);
    return element("figure", {}, holder, figures.saving(panel.name.replaceAll(/\W+/g, "_"), () => asFigure(chart)));
  }

  /** A chart as it is shown now, as a figure that can be saved. */
  function asFigure({ panel, plot, data }) {
    const [xs, ...columns] = data;
    const { x, y } = plot.scales;
    const shown = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
    const [over, unit] = panel.over;
    const place = (v) => (panel.logarithmic ? Math.log10(v) : v);
    const ends = { x: [x.min, x.max], y: [place(y.min), place(y.max)] };
    const near = xs.map((at, k) => k).filter((k) => xs[Math.min(k + 1, xs.length - 1)] >= x.min && xs[Math.max(k - 1, 0)] <= x.max);
    const of = (column) => near.map((k) => column[k]);
    const curves = panel.curves.map((curve, k) => ({ name: named(curve.name), colour: shown[k % shown.length], xs: of(xs), ys: of(columns[k]),
      markXs: [], markYs: [], hidden: !plot.series[k + 1].show }));
    const count = panel.curves.length;
    if (panel.band) curves[0].band = { low: of(columns[count]), high: of(columns[count + 1]) };
    const peaks = [...panel.marks].sort((a, b) => b.height - a.height).map((mark) => [mark.at, mark.height, mark.name]);
    return { names: count > 1 ? curves.map(({ name, colour }) => ({ text: name, colour })) : [], columns: 1, panels: [{ title: "", names: [], curves,
      labels: [], peaks: peaks.filter(([, , name], k) => peaks.findIndex((peak) => peak[2] === name) === k), height: 200,
      x: { name: unit ? `${over} in ${unit}` : over, ends: ends.x }, view: ends,
      y: { name: `${named(panel.name)}${panel.unit ? ` in ${panel.unit}` : ""}`, ends: ends.y, logarithmic: panel.logarithmic } }] };
  }

  /** What moves with the cursor of the curves over time. */
  let moving = null;
  let seeking = false;

  /** Puts the cursor of the curves that are seen at a time. */
  function seek(time) {
    seeking = true;
    for (const { plot, holder } of groups.get("time") ?? []) {
      if (!holder.offsetParent || time < plot.scales.x.min || time > plot.scales.x.max) continue;
      plot.setCursor({ left: plot.valToPos(time, "x"), top: plot.over.clientHeight / 2 });
      break; // the others follow
    }
    seeking = false;
  }

  /** Shows the motion at the cursor of a curve over time. */
  function follow({ cursor, data }, panel) {
    if (panel.group === "time" && !seeking && cursor.idx !== null && cursor.idx !== undefined) moving?.at(data[0][cursor.idx]);
  }

  const hint = () => element("p", { class: "quiet screen" },
    "Drag to zoom, double click to see all. With the keyboard: Tab to a chart, ← → move, + − zoom, 0 shows all, , and . read points, Enter on a name hides its curve. Of a long run a filled band shows between which values a curve stays; its end, and what is around the first events, is drawn sample by sample.");

  // Balls at the equilibrium.

  function ballFigure(bearing, index, count) {
    const largest = Math.max(...bearing.flatMap((ball) => ball.load), 1e-300);
    const name = count > 1 ? `Bearing ${index + 1}. ` : "";
    const heads = ["ball", "azimuth in °", "load inner in N", "load outer in N", "angle inner in °", "angle outer in °"];
    const csv = () => [heads, ...bearing.map((ball, k) => [k + 1, ball.azimuth, ...ball.load, ...ball.angle])].map((row) => `${row.join(",")}\n`).join("");
    const { figure } = figures.sketch({ name: `balls_${index + 1}`, width: 300, csv,
      label: `Ball loads around bearing ${index + 1}, the largest ${number(largest)} newtons`,
      caption: `${name}Loads at inner (blue) and outer race (orange), X to the right, Y up; the outer circle is the largest load.`,
      paint: (pen, width, colour) => paintBalls(pen, width, colour, bearing, largest) });
    const rows = bearing.map((ball, k) => [String(k + 1), number(ball.azimuth, 4), ...ball.load.map((v) => number(v)), ...ball.angle.map((v) => number(v))]);
    figure.append(element("details", {}, element("summary", {}, "as a table"), table(heads, rows)));
    return figure;
  }

  function paintBalls(pen, width, colour, bearing, largest) {
    const size = Math.min(width, 300);
    const [centre, pitch, longest] = [size / 2, 0.21 * size, 0.23 * size];
    const at = (azimuth, radius) => {
      const angle = (azimuth * Math.PI) / 180;
      return [centre + radius * Math.cos(angle), centre - radius * Math.sin(angle)];
    };
    for (const radius of [pitch, pitch + 12 + longest]) pen.circle(centre, centre, radius, null, colour("--line"));
    bearing.forEach((ball, k) => {
      const outwards = (load, shift, name) => pen.line([...at(ball.azimuth + shift, pitch + 12),
        ...at(ball.azimuth + shift, pitch + 12 + (longest * load) / largest)], colour(name), 4);
      outwards(ball.load[0], 2, "--c0");
      outwards(ball.load[1], -2, "--c1");
      const [x, y] = at(ball.azimuth, pitch);
      pen.circle(x, y, 10, ball.load[0] > 0 ? colour("--panel") : null, colour("--ink"));
      pen.text(String(k + 1), x, y + 4, { colour: colour("--ink"), align: "middle" });
    });
    pen.text(`${number(largest, 4)} N`, centre, centre + 4, { colour: colour("--ink"), align: "middle" });
    return size;
  }

  // Sections.

  /** What kind of motion it is, in words. */
  function kindText({ name, section, cycles }) {
    const cycle = (section ?? "").replaceAll("_", " ");
    if (name === "periodic") return cycles === 1 ? `repeats every ${cycle}` : `repeats every ${cycles} ${cycle === "ball pass" ? "ball passes" : `${cycle}s`}`;
    return { rest: "no motion", "quasi-periodic": "two frequencies" }[name] ?? name;
  }

  /** Statistics of a motion after its settle time. */
  function statistics(motion) {
    const rows = motion.statistics.map((entry) => {
      const [, name, unit] = /^(.*?)_(N_m|m|rad|N)$/.exec(entry.channel);
      const of = (value) => (value === null || value === undefined ? "–" : shown(value, unit.replace("_", " ")));
      return [named(name), of(entry.mean), of(entry.rms), of(entry.peak), of(entry.peak_to_peak),
        number(entry.crest_factor, 4), number(entry.kurtosis, 4)];
    });
    return table(["channel", "mean", "RMS", "peak", "peak to peak", "crest factor", "kurtosis"], rows,
      "After the settle time; RMS, peak and kurtosis about the mean.");
  }

  function speedText({ constant, from, to, drive, profile }) {
    if (constant) return constant;
    if (from || to) return `${from ?? "0 rpm"} to ${to}`;
    if (drive) return "by a drive";
    return profile ? "by a profile" : "–";
  }

  function largestOf(name) {
    const panel = histories.find((entry) => entry.name === name);
    if (!panel) return null;
    const values = [panel.curves[0].values, ...(panel.band ? [panel.band.high] : [])].flatMap(floats);
    return values.reduce((a, b) => Math.max(a, b), 0);
  }

  const velocityOf = (peak) => 2e3 * Math.PI * peak.frequency_Hz * peak.amplitude;

  /** RMS velocity of each direction. */
  function velocities() {
    const levels = Object.entries(summary.motion?.velocity_rms ?? {}).filter(([, level]) => level);
    const housings = (summary.motion?.housing_velocity_rms ?? []).map((level) => [level.channel.replace(/_velocity.*$/, ""), level]);
    return [...levels, ...housings].map(([axis, { rms_m_s: rms, band_Hz: [low, high] }]) => [`vibration velocity, ${named(axis)}`,
      `${number(1e3 * rms, 4)} mm/s`, `RMS, ${number(low, 2)} to ${number(high, 2)} Hz`]);
  }

  /** Zone of ISO 20816-3. */
  function zoneTile() {
    const found = summary.vibration_severity;
    return found && ["vibration zone", found.zone, found.meaning];
  }

  /** The largest motion of a run whose speed changes, and the critical speeds that it passed. */
  function runUpTiles() {
    const found = summary.run_up;
    if (!found) return [];
    const rpm = (speed) => `${number((30 / Math.PI) * speed)} rpm`;
    const { radial, critical_speeds_passed: passed } = found;
    const axes = Object.entries(found.axes).map(([name, { amplitude }]) => `${named(name)} ${shown(amplitude, name.startsWith("tilt") ? "rad" : "m")}`);
    return [
      ["largest motion", shown(radial.amplitude, "m"), `from the equilibrium at ${rpm(radial.speed_rad_s)}, ${number(radial.time_s)} s; ${axes.join(", ")}`],
      passed && ["critical speeds passed", passed.map((critical) => rpm(critical.speed_rad_s)).join(", ") || "none", "crossed by 1×, of the linearised shaft"],
    ];
  }

  /** What the zone rests on. */
  function zoneText() {
    const found = summary.vibration_severity;
    if (!found) return null;
    const boundaries = found.boundaries_m_s.map((boundary) => number(1e3 * boundary, 3)).join(", ");
    const [axis, part] = found.channel.replace(/_velocity.*$/, "").split("_").reverse();
    const text = `Zone ${found.zone} of ${found.standard} for bearing housings, group ${found.group}, ${found.support} support: `
      + `${number(1e3 * found.rms_m_s, 4)} mm/s RMS of ${part ?? "the shaft"} along ${axis}, boundaries ${boundaries} mm/s`;
    return element("p", {}, `${[text, ...(found.remarks ?? [])].join("; ")}.`);
  }

  function keyNumbers() {
    const error = summary.measured_error;
    const first = summary.natural_frequencies[0];
    const load = largestOf("largest ball load");
    const lives = summary.bearings.map((bearing) => bearing.life?.after_settle.life_h ?? bearing.life?.whole_run.life_h).filter((h) => h);
    const ballsOf = summary.ball_pass[0];
    return tiles([
      zoneTile(),
      ...runUpTiles(),
      ["speed", speedText(summary.scenario.speed ?? {})],
      ...velocities(),
      summary.motion && ["kind of motion", kindText(summary.motion.kind), summary.motion.settling
        && (summary.motion.settling.settled ? "settled" : "not settled")],
      lives.length > 0 && ["life L10r", `${number(Math.min(...lives), 4)} h`, lives.length > 1 ? "of the shortest-lived bearing" : "of this motion"],
      ["measured error", error ? `${number(error.relative, 3)} of the motion` : "not measured",
        error && `${shown(error.displacement_m, "m")}; asked for ${number(error.tolerance, 3)}`],
      summary.reduction && ["modes of bending", `${summary.reduction.modes} in each plane`,
        summary.reduction.error && `${number(summary.reduction.error.relative, 2)} of the motion off ${summary.reduction.error.modes} modes`],
      load && ["largest ball load", `${number(load)} N`],
      first && ["lowest natural frequency", `${number(first.frequency_Hz)} Hz`, `damping ratio ${number(first.damping_ratio, 3)}`],
      ballsOf && ballsOf.outer_Hz > 0 && ["ball pass, outer race", `${number(ballsOf.outer_Hz)} Hz`, `inner race ${number(ballsOf.inner_Hz)} Hz`],
    ]);
  }

  /** The lines that a velocity sensor would show highest, one for each name. */
  function strongestLines() {
    const seen = new Set();
    const lines = summary.peaks.filter((peak) => peak.unit === "m").sort((a, b) => velocityOf(b) - velocityOf(a))
      .filter(({ name, frequency_Hz: at }) => { const key = name ?? at; return !seen.has(key) && seen.add(key); }).slice(0, 5);
    const rows = lines.map((peak) => [peak.name ?? "no name", number(velocityOf(peak), 4), number(peak.frequency_Hz),
      number(1e6 * peak.amplitude, 4), named(peak.channel), number(peak.order, 4)]);
    return rows.length ? table(["line", "mm/s", "Hz", "µm", "along", "order"], rows, "The strongest lines by velocity; peak values.") : null;
  }

  function warnings() {
    const all = page.warnings(summary.warnings);
    return all.length ? all : [element("p", { class: "quiet" }, "No warnings.")];
  }

  function equilibrium() {
    const places = Object.entries(summary.equilibrium).flatMap(([key, value]) => {
      const [, name, unit] = /^(.*)_(m|rad)$/.exec(key) ?? [];
      return name ? [{ name, value, unit }] : [];
    });
    // what is round-off beside the others is zero
    const largest = Math.max(...places.map(({ value }) => Math.abs(value)));
    const place = places.map(({ name, value, unit }) =>
      [named(name), shown(Math.abs(value) < 1e-12 * largest ? 0 : value, unit)]);
    const columns = ["x", "y", "z", "θx", "θy"];
    // of N/m: per µm and per mrad
    const factor = (column) => (column < 3 ? 1e-6 : 1e-3);
    const rows = summary.stiffness.matrix.map((row, r) => [
      r < 3 ? `force ${columns[r]} in N` : `moment ${columns[r][1]} in N m`,
      ...row.map((value, c) => number(Math.abs(value) < 1e-12 * Math.sqrt(Math.abs(summary.stiffness.matrix[r][r] * summary.stiffness.matrix[c][c])) ? 0 : value * factor(c), 4)),
    ]);
    const stiffness = table(["stiffness", "x, µm", "y, µm", "z, µm", "θx, mrad", "θy, mrad"], rows, "Force and moment that the bearings need per displacement and tilt.");
    const frequencies = table(["natural frequency in Hz", "damping ratio"],
      summary.natural_frequencies.map((entry) => [number(entry.frequency_Hz), number(entry.damping_ratio, 4)]), "Linearised here.", 0);
    const figures = balls.flatMap((bearing, index) => (bearing ? [ballFigure(bearing, index, balls.length)] : []));
    return [element("div", { class: "side" }, table(["place", ""], place), stiffness, frequencies), element("div", { class: "side" }, ...figures)];
  }

  function bearings() {
    const passes = summary.ball_pass.map((pass, index) => [String(index + 1), ...["outer_Hz", "inner_Hz", "spin_Hz", "cage_Hz"].map((key) => {
      const [own, nominal] = [pass[key], summary.nominal_ball_pass[index][key]].map((value) => number(value));
      return own === nominal ? own : `${own} (nominal ${nominal})`;
    })]);
    const told = summary.bearings.map((bearing, index) => {
      const zone = bearing.load_zone;
      const life = bearing.life?.after_settle.life_h ? bearing.life.after_settle : bearing.life?.whole_run;
      return [String(index + 1), zone ? `${zone.balls_loaded.smallest} to ${zone.balls_loaded.largest} of ${bearing.balls}` : "–",
        String(bearing.events?.contact_lost?.count ?? "–"), String(bearing.events?.preload_lost?.count ?? "–"),
        number(life?.life_Mrev), number(life?.life_h)];
    });
    return [
      table(["bearing", "outer race in Hz", "inner race in Hz", "ball spin in Hz", "cage in Hz"], passes, "Ball-pass frequencies."),
      table(["bearing", "loaded balls", "contact lost", "preload lost", "life in 10⁶ revolutions", "life in h"], told),
    ];
  }

  function peaks() {
    const rows = summary.peaks.map((peak) => [named(peak.channel), peak.name ?? "", number(peak.frequency_Hz, 7),
      number(peak.order, 6), shown(peak.amplitude, peak.unit), number(peak.distance_Hz, 2)]);
    return element("details", {}, element("summary", {}, `${rows.length} peaks`),
      table(["channel", "name", "frequency in Hz", "order", "amplitude", "off the name in Hz"], rows, null, 2));
  }

  function accuracy() {
    const error = summary.measured_error;
    const row = (name, counters) => [name, ...[counters.evaluations, counters.steps, counters.rejected].map((v) => number(v, 9))];
    const rows = [row("run", summary.counters), ...(error ? [row("second pass", error.reference_counters)] : [])];
    const text = error
      ? `The run was repeated at tolerance ${number(error.reference_tolerance, 3)}; the largest difference of any sample is ${shown(error.displacement_m, "m")}, ${number(error.relative, 3)} of the motion. Asked: ${number(error.tolerance, 3)}.`
      : "Not measured: the second pass was left out.";
    const tables = (summary.tables ?? []).flatMap((used, index) => (used ? [element("p", {}, used.note
      ? `Bearing ${index + 1} has no table: ${used.note}`
      : `Table of bearing ${index + 1}: ${number(used.cells, 9)} cells, off by ${number(used.relative_error, 2)} of the largest ball load; ${used.samples_outside} samples outside it.`)] : []));
    return [element("p", {}, text), table(["pass", "evaluations", "steps", "rejected"], rows), ...tables];
  }

  function energy() {
    const account = summary.energy;
    const rows = [["kinetic energy, change", account.kinetic_change_J], ["stored energy, change", account.stored_change_J],
      ...Object.entries(account.supplied_J).map(([name, value]) => [`supplied by ${name}`, value]),
      ...Object.entries(account.dissipated_J).map(([name, value]) => [`dissipated by ${name.replaceAll("_", " ")}`, value]),
      ["largest residual", account.largest_residual_J]].filter(([, value]) => value !== null);
    return table(["account", "J"], rows.map(([name, value]) => [name, number(value)]),
      `The residual is ${number(account.relative_residual, 3)} of the energy turned over.`);
  }

  function write() {
    document.getElementById("origin").textContent = `jeffcott ${summary.jeffcott}, ${summary.samples} samples`;
    section("numbers", "Key numbers", zoneText(), keyNumbers(), ...warnings(), strongestLines());
    const [first, ...others] = spectra;
    if (first) section("spectra", "Spectrum", addChart(first, "frequency", 300), peaks());
    if (others.length) folded("further", "Spectra of displacements and forces", ...others.map((panel) => addChart(panel, "frequency", 300)));
    if (furtherSpectra.length) folded("further-spectra", "Spectra asked for",
      ...furtherSpectra.map((panel) => addChart(panel, `${panel.name} ${panel.over[0]}`, 320)));
    if (drawn.has("defects")) folded("defects", "Defects", figures.add(drawn.get("defects")));
    const maps = ["waterfall", "order_tracks", "campbell"].filter((name) => drawn.has(name));
    if (maps.length) folded("maps", "Maps over the speed", ...maps.map((name) => figures.add(drawn.get(name))));
    if (histories.length) {
      folded("motion", "Motion over time", hint(), ...histories.map((panel, index) =>
        addChart(panel, "time", 170, index === histories.length - 1)));
    }
    if (drawn.has("scene")) folded("scene", "Scene", figures.add(drawn.get("scene")));
    if (page.data.film) {
      moving = film.add(page.data.film, seek);
      folded("film", "In motion", moving.figure);
    }
    if (drawn.has("orbit")) folded("orbit", "Orbit", figures.add(drawn.get("orbit")));
    if (summary.motion) folded("statistics", "Statistics", statistics(summary.motion));
    folded("equilibrium", "Static equilibrium", ...equilibrium());
    folded("bearings", "Bearings", ...bearings());
    if (summary.energy) folded("energy", "Energy", energy());
    folded("error", "Error and work", ...accuracy());
    page.scenarioSection("as it was run, with defaults", summary.scenario);
  }

  write();
  charts.forEach(build);
  const rebuild = () => charts.forEach(build);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", rebuild);
  let waiting = 0;
  addEventListener("resize", () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => charts.forEach((chart) => chart.plot.setSize({ width: width(chart), height: chart.height })), 100);
  });
  page.ready(() => { rebuild(); figures.redraw(); });
})();
