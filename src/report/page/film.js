
/** The end of the run in motion: every bearing seen along −Z, the shaft's displacement magnified, balls and rollers coloured by load. */
const film = (() => {
  const { element, number, floats } = page;
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  /** A round number that makes `size` about as large as `wanted`. */
  function magnification(size, wanted) {
    if (!(size > 0)) return 1;
    const power = 10 ** Math.floor(Math.log10(wanted / size));
    return [5, 2, 1].map((m) => m * power).find((m) => m * size <= wanted) ?? power;
  }

  function read(data) {
    const times = floats(data.times).map((t) => t + data.start);
    const angles = floats(data.angles).map((a) => a + data.startAngle);
    const [x, y, , tiltX, tiltY] = data.displacements.map(floats);
    const bearings = data.bearings.map((bearing) => {
      // x + a θy and y − a θx at the position a in mm, µm
      const xs = x.map((v, k) => v + bearing.position * 1e-3 * tiltY[k]);
      const ys = y.map((v, k) => v - bearing.position * 1e-3 * tiltX[k]);
      const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
      const [cx, cy] = [mean(xs), mean(ys)];
      const orbit = xs.map((v, k) => [v - cx, ys[k] - cy]);
      const loads = bearing.loads && floats(bearing.loads);
      const largest = loads ? loads.reduce((a, b) => Math.max(a, b), 0) : 0;
      return { ...bearing, orbit, loads, largest, reach: Math.max(...orbit.map(([u, v]) => Math.hypot(u, v))) };
    });
    // µm → mm
    const inner = Math.min(...bearings.map(({ pitch, ball }) => 0.5 * (pitch - ball)));
    const factor = magnification(Math.max(...bearings.map(({ reach }) => reach)) * 1e-3, 0.3 * inner);
    return { times, angles, bearings, factor };
  }

  function paintBearing(pen, colour, { angles, factor }, bearing, frame, [centreX, centreY], scale) {
    const shift = (k) => { const [u, v] = bearing.orbit[k]; return [centreX + u * 1e-3 * factor * scale, centreY - v * 1e-3 * factor * scale]; };
    const [pitch, ball] = [0.5 * bearing.pitch * scale, 0.5 * bearing.ball * scale];
    const [shaftX, shaftY] = shift(frame);
    pen.circle(centreX, centreY, pitch + ball, null, colour("--ink"));
    pen.circle(centreX, centreY, pitch + 1.7 * ball, null, colour("--line"));
    pen.circle(shaftX, shaftY, pitch - ball, colour("--panel"), colour("--ink"));
    // rollers are seen from a little way off: what lies behind is smaller and nearer to the axis
    const away = (row) => 1 - 0.12 * row * Math.min(1, bearing.length / bearing.ball);
    for (let row = bearing.rows - 1; row >= 0; row -= 1) {
      for (let k = 0; k < bearing.balls; k += 1) {
        const angle = bearing.firstBall + (2 * Math.PI * k) / bearing.balls + bearing.cage * angles[frame];
        const load = bearing.loads?.[(frame * bearing.rows + row) * bearing.balls + k] ?? 0;
        const fill = load > 0 ? drawing.shade(load / bearing.largest) : null;
        const face = (back) => pen.circle(centreX + back * pitch * Math.cos(angle), centreY - back * pitch * Math.sin(angle), 0.93 * back * ball, fill, colour("--ink"));
        if (bearing.length > 0) {
          face(away(row + 1));
          for (const side of [-1, 1]) {
            const edge = (back) => [centreX + back * (pitch * Math.cos(angle) - side * 0.93 * ball * Math.sin(angle)), centreY - back * (pitch * Math.sin(angle) + side * 0.93 * ball * Math.cos(angle))];
            pen.line([...edge(away(row)), ...edge(away(row + 1))], colour("--ink"), 1);
          }
        }
        face(away(row));
      }
    }
    pen.line(bearing.orbit.slice(0, frame + 1).flatMap((_, k) => shift(k)), colour("--c0"), 1.2);
    // where the shaft's mark, on the side of the unbalance, points to
    const turn = angles[frame];
    pen.line([shaftX, shaftY, shaftX + (pitch - ball) * 0.9 * Math.cos(turn), shaftY - (pitch - ball) * 0.9 * Math.sin(turn)], colour("--c1"), 2);
    pen.circle(shaftX, shaftY, 3, colour("--c0"));
  }

  /** Adds what it takes to see the film; `seek` takes the time that is shown. */
  function add(data, seek) {
    const shown = read(data);
    const { times, bearings, factor } = shown;
    const last = times.length - 1;
    let [frame, playing, before] = [0, false, 0];

    const paint = (pen, width, colour) => {
      const columns = Math.min(bearings.length, Math.max(1, Math.floor(width / 220)));
      const size = Math.min(width / columns, 300);
      bearings.forEach((bearing, index) => {
        const [left, top] = [(index % columns) * size, Math.floor(index / columns) * (size + 24)];
        const scale = (size / 2 - 8) / (0.5 * bearing.pitch + 0.9 * bearing.ball);
        paintBearing(pen, colour, shown, bearing, frame, [left + size / 2, top + size / 2], scale);
        const load = bearing.loads ? `, at most ${number(bearing.largest, 4)} N` : "";
        pen.text(`bearing ${index + 1}${load}`, left + 8, top + size + 14, { colour: colour("--ink"), size: size < 260 ? 10 : 12 });
      });
      return Math.ceil(bearings.length / columns) * (size + 24);
    };
    const csv = () => [["t_s", "angle_rad", ...bearings.flatMap((_, k) => [`bearing${k + 1}_x_um`, `bearing${k + 1}_y_um`])],
      ...times.map((t, k) => [t, shown.angles[k], ...bearings.flatMap((bearing) => bearing.orbit[k])])].map((row) => `${row.join(",")}\n`).join("");
    const drawing = figures.sketch({ name: "motion", width: 300 * Math.min(bearings.length, 3), paint, csv,
      label: `Shaft, balls and rollers in motion, the displacement of the shaft magnified ${number(factor)} times`,
      caption: `The end of the run, seen along −Z: displacements about their mean are magnified ${number(factor)} times, balls, rollers and rings are to scale. Balls and rollers are coloured by their load from blue to yellow, the largest; empty ones bear none; of two rows the second lies behind. The orange line turns with the shaft.` });

    const place = element("output", { class: "reading screen" });
    const slider = element("input", { type: "range", min: "0", max: String(last), value: "0", "aria-label": "time", class: "time" });
    const show = (next, tell = true) => {
      frame = Math.min(Math.max(next, 0), last);
      slider.value = String(frame);
      place.textContent = `${number(times[frame], 7)} s, shaft at ${number(((shown.angles[frame] * 180) / Math.PI) % 360, 4)}°`;
      slider.setAttribute("aria-valuetext", place.textContent);
      drawing.redraw();
      if (tell) seek(times[frame]);
    };

    const speed = element("select", { "aria-label": "speed" }, ...[["slow", 10], ["medium", 30], ["fast", 90]].map(([name, rate]) => element("option", { value: rate }, name)));
    speed.value = "30";
    const button = (text, name, action) => {
      const made = element("button", { type: "button", "aria-label": name }, text);
      made.addEventListener("click", action);
      return made;
    };
    const stop = () => { playing = false; play.textContent = "play"; };
    const step = (now) => {
      if (!playing || still.matches) return stop();
      const passed = Math.floor(((now - before) / 1000) * Number(speed.value));
      if (passed > 0) { before = now; show((frame + passed) % (last + 1)); }
      return requestAnimationFrame(step);
    };
    const play = button("play", "play or pause", () => {
      if (playing) { stop(); return; }
      [playing, before] = [true, performance.now()];
      play.textContent = "pause";
      requestAnimationFrame(step);
    });
    const calm = element("span", { class: "quiet" });
    const settle = () => {
      play.disabled = still.matches;
      calm.textContent = still.matches ? "Your system asks for less motion: step, or move the slider." : "";
    };
    still.addEventListener("change", settle);
    slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
    const controls = element("div", { class: "screen controls" }, play, button("‹", "one step back", () => { stop(); show(frame - 1); }),
      button("›", "one step on", () => { stop(); show(frame + 1); }), speed, slider, calm);
    drawing.figure.prepend(controls, place);
    settle();
    show(0, false);
    /** Shows what stands at a time, where the film has it. */
    const at = (time) => {
      if (playing || !(time >= times[0] && time <= times[last])) return;
      const next = times.findIndex((t) => t >= time);
      if (next !== frame) show(next, false);
    };
    return { figure: drawing.figure, at };
  }

  return { add };
})();
