
(() => {
  const { element, section, folded, table, tiles, number } = page;
  const { summary, columns, balls, histories, spectra, furtherSpectra } = page.data;
  const drawn = new Map(page.data.figures.map((figure) => [figure.name, figure]));
  const names = { tilt_x: "θx", tilt_y: "θy", force_x: "force x", force_y: "force y", force_z: "force z",
    moment_x: "moment x", moment_y: "moment y" };
  const named = (name) => names[name] ?? name;

  const shownUnits = { m: ["µm", 1e6], rad: ["µrad", 1e6] };
  const shown = (value, unit) => {
    const [name, factor] = shownUnits[unit] ?? [unit, 1];
    return `${number(value * factor)} ${name}`;
  };

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
      const [name, unit] = columns[entry.channel];
      const of = (value) => (value === null || value === undefined ? "–" : shown(value, unit));
      return [name, of(entry.mean), of(entry.rms), of(entry.peak), of(entry.peak_to_peak),
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

  const velocityOf = (peak) => 2e3 * Math.PI * peak.frequency_Hz * peak.amplitude;

  /** RMS velocity of each direction. */
  function velocities() {
    const levels = Object.entries(summary.motion?.velocity_rms ?? {}).filter(([, level]) => level)
      .map(([axis, level]) => [`vibration velocity, ${named(axis)}`, level]);
    const housings = (summary.motion?.housing_velocity_rms ?? []).map((level) => [columns[level.channel][0], level]);
    return [...levels, ...housings].map(([name, { rms_m_s: rms, band_Hz: [low, high] }]) => [name,
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
    const text = `Zone ${found.zone} of ${found.standard} for bearing housings, group ${found.group}, ${found.support} support: `
      + `${number(1e3 * found.rms_m_s, 4)} mm/s RMS, ${columns[found.channel][0]}, boundaries ${boundaries} mm/s`;
    return element("p", {}, `${[text, ...(found.remarks ?? [])].join("; ")}.`);
  }

  function keyNumbers() {
    const error = summary.measured_error;
    const first = summary.natural_frequencies[0];
    const load = summary.largest_ball_load_N;
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
      const [name, unit] = columns[key] ?? [];
      return name ? [{ name, value, unit }] : [];
    });
    // what is round-off beside the others is zero
    const largest = Math.max(...places.map(({ value }) => Math.abs(value)));
    const place = places.map(({ name, value, unit }) =>
      [name, shown(Math.abs(value) < 1e-12 * largest ? 0 : value, unit)]);
    const axes = ["x", "y", "z", "θx", "θy"];
    // of N/m: per µm and per mrad
    const factor = (column) => (column < 3 ? 1e-6 : 1e-3);
    const rows = summary.stiffness.matrix.map((row, r) => [
      r < 3 ? `force ${axes[r]} in N` : `moment ${axes[r][1]} in N m`,
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
    const [first, ...others] = spectra.map(figures.add);
    if (first) section("spectra", "Spectrum", first, peaks());
    if (others.length) folded("further", "Spectra of displacements and forces", ...others);
    if (furtherSpectra.length) folded("further-spectra", "Spectra asked for", ...furtherSpectra.map(figures.add));
    if (drawn.has("defects")) folded("defects", "Defects", figures.add(drawn.get("defects")));
    const maps = ["waterfall", "order_tracks", "campbell"].filter((name) => drawn.has(name));
    if (maps.length) folded("maps", "Maps over the speed", ...maps.map((name) => figures.add(drawn.get(name))));
    if (histories.panels.length) folded("motion", "Motion over time", figures.add(histories));
    if (drawn.has("scene")) folded("scene", "Scene", figures.add(drawn.get("scene")));
    if (page.data.film) {
      const { figure, at } = film.add(page.data.film, (time) => figures.seek("histories", time));
      figures.follow("histories", at);
      folded("film", "In motion", figure);
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
  page.ready(figures.redraw);
})();
