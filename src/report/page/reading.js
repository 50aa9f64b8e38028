
/** Figures on the page: read with a cursor, zoomed, saved, printed. */
const figures = (() => {
  const { element, number } = page;
  const { canvasPen, svgPen } = pens;
  const { read, draw, palette, css, dark, isPrinted, labelOf, isSame, place, across, upwards } = drawing;

  // Words.

  /** `speed 3000 1/min`. */
  const reading = ({ quantity, unit }, value) => `${quantity || "at"} ${number(value, 6)}${unit ? ` ${unit}` : ""}`;

  const nameOf = (figure, panel, curve) => curve.name
    || [...panel.names, ...figure.names].find(({ colour }) => colour === curve.colour)?.text || "";

  /** What stands at a point of a curve, or of its marks. */
  function pointText(figure, panel, { curve, index, marks }) {
    const [x, y] = marks ? [curve.markXs[index], curve.markYs[index]] : [curve.xs[index], curve.ys[index]];
    const { low, high } = curve.band ?? {};
    const value = y === null && low ? `between ${number(low[index], 5)} and ${number(high[index], 5)} ${panel.y.unit}`
      : panel.y.texts[Math.floor(y)] ?? reading(panel.y, y);
    const parts = [nameOf(figure, panel, curve), reading(panel.x, x), value];
    return { text: parts.filter(Boolean).join("; "), run: curve.runs?.[index], x, y: y ?? high?.[index] ?? 0 };
  }

  /** The point of a panel that is nearest to a place of the screen, of one with a map or cells only where it is near. */
  function nearest(box, px, py) {
    let best = { distance: box.panel.map || box.panel.cells ? 30 ** 2 : Infinity };
    const look = (curve, xs, ys, marks) => xs.forEach((x, index) => {
      const high = ys[index] ?? curve.band?.high[index] ?? null;
      if (high === null) return;
      const [left, top] = [across(box, x) - px, upwards(box, high) - py];
      const inBand = ys[index] === null && top <= 0 && upwards(box, curve.band.low[index]) >= py;
      const distance = left ** 2 + (inBand ? 0 : top ** 2);
      if (distance < best.distance) best = { distance, curve, index, marks };
    });
    for (const curve of box.panel.curves.filter(({ hidden }) => !hidden)) {
      look(curve, curve.xs, curve.ys, false);
      if (!curve.pointsAreMarked) look(curve, curve.markXs, curve.markYs, true);
    }
    return best.curve ? best : null;
  }

  /** What a map shows at a place: both axes, the order of the shaft, the amplitude and the line that is near. */
  function mapText(box, px, py) {
    const { panel: { x: over, y: up, map, bar, curves }, plot, view } = box;
    const x = view.x[0] + ((px - plot.left) / plot.width) * (view.x[1] - view.x[0]);
    const y = view.y[1] - ((py - plot.top) / plot.height) * (view.y[1] - view.y[0]);
    const column = Math.floor(((x - over.ends[0]) / (over.ends[1] - over.ends[0])) * map.width);
    const row = Math.floor(((up.ends[1] - y) / (up.ends[1] - up.ends[0])) * map.height);
    const level = map.levels[row * map.width + column];
    if (level === undefined || column < 0 || column >= map.width) return null;
    const line = curves.map((curve) => ({ name: curve.name, away: Math.abs(upwards(box, atAbscissa(curve, x)) - py) }))
      .filter(({ name, away }) => name && away < 8).sort((a, b) => a.away - b.away)[0];
    const size = mapValue(bar, level);
    const parts = [reading(over, x), reading(up, y), over.unit === "1/min" && `order ${number((60 * y) / x, 4)}`,
      `${bar.quantity} ${level ? number(size, 4) : `below ${number(size, 2)}`} ${bar.unit}`, line && `on the line ${line.name}`];
    return { text: parts.filter(Boolean).join("; "), x, y };
  }

  /** The value of a level of a map. */
  const mapValue = ({ ends }, level) => 10 ** (ends[0] + (level / 255) * (ends[1] - ends[0]));

  /** The value of a straight line. */
  function atAbscissa({ xs, ys }, x) {
    const last = xs.length - 1;
    return last < 1 ? NaN : ys[0] + ((x - xs[0]) / (xs[last] - xs[0])) * (ys[last] - ys[0]);
  }

  function cellText(box, px, py) {
    const { panel } = box;
    const { left, right, top, bottom, values, runs } = panel.cells;
    const within = (v, a, b) => v >= Math.min(a, b) && v <= Math.max(a, b);
    const found = values.findIndex((_, k) => within(px, across(box, left[k]), across(box, right[k]))
      && within(py, upwards(box, top[k]), upwards(box, bottom[k])));
    if (found < 0) return null;
    const [x, y] = [(left[found] + right[found]) / 2, (top[found] + bottom[found]) / 2];
    const row = panel.y.texts[Math.floor(y)];
    const parts = row ? [row, reading(panel.x, values[found])]
      : [reading(panel.x, x), reading(panel.y, y), `${panel.title || "value"}: ${number(values[found], 5)}`];
    return { text: parts.join("; "), run: runs?.[found], x, y };
  }

  function readAt(figure, box, px, py) {
    const near = nearest(box, px, py);
    if (box.panel.map && !near?.marks) return mapText(box, px, py);
    if (near) return pointText(figure, box.panel, near);
    return box.panel.cells ? cellText(box, px, py) : null;
  }

  // Saving.

  function offer(name, blob) {
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  /** Widths of saved figures, CSS pixels of 1/96 inch. */
  const widths = { "column, 88 mm": 333, "page, 180 mm": 680 };
  const nothing = () => canvasPen(document.createElement("canvas").getContext("2d"));

  /** A drawing on white paper as SVG: `paint` draws it in a width and returns its height. */
  function onPaper(width, paint) {
    const colour = palette(true);
    const pen = svgPen(width, Math.ceil(paint(nothing(), width, colour)));
    paint(pen, width, colour);
    return pen.finish();
  }

  /** A drawing on white paper as PNG, 600 pixels an inch. */
  function asPng(width, paint) {
    const colour = palette(true);
    const height = Math.ceil(paint(nothing(), width, colour));
    const context = fitted(document.createElement("canvas"), width, height, 600 / 96);
    const pen = canvasPen(context);
    pen.rectangle(0, 0, width, height, colour("--paper"));
    paint(pen, width, colour);
    return new Promise((done) => { context.canvas.toBlob(done, "image/png"); });
  }

  /** The context of a canvas of a size in CSS pixels. */
  function fitted(canvas, width, height, scale = devicePixelRatio) {
    Object.assign(canvas, { width: Math.round(width * scale), height: Math.round(height * scale) });
    Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    return context;
  }

  /** Buttons that save a drawing, and what it shows as CSV. */
  function saveButtons(name, paint, csv) {
    const size = element("select", { "aria-label": "width of the saved figure" }, ...Object.keys(widths).map((text) => element("option", {}, text)));
    const button = (kind, action) => {
      const made = element("button", { type: "button", "aria-label": `save ${name} as ${kind}` }, kind);
      made.addEventListener("click", action);
      return made;
    };
    return element("details", { class: "save screen" }, element("summary", {}, "Save"), size,
      button("SVG", () => offer(`${name}.svg`, new Blob([onPaper(widths[size.value], paint)], { type: "image/svg+xml" }))),
      button("PNG", async () => offer(`${name}.png`, await asPng(widths[size.value], paint))),
      csv && button("CSV", () => offer(`${name}.csv`, new Blob([csv()], { type: "text/csv" }))));
  }

  /** What a figure shows, a line a point. */
  function csvOf(figure) {
    const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const rows = [["panel", "curve", "abscissa", "value", "abscissa_name", "value_name"]];
    for (const [index, panel] of figure.panels.entries()) {
      const { x: over, y: up, view, cells } = panel;
      const [low, high] = [Math.min(...view.x), Math.max(...view.x)];
      const add = (name, x, y) => {
        const at = place(over, x);
        if (at >= low && at <= high && Number.isFinite(y)) rows.push([index + 1, name, x, y, labelOf(over), labelOf(up) || panel.title]);
      };
      for (const curve of panel.curves.filter((entry) => !entry.hidden)) {
        const name = nameOf(figure, panel, curve) || up.quantity;
        curve.xs.forEach((x, k) => add(name, x, curve.ys[k] ?? NaN));
        if (!curve.pointsAreMarked) curve.markXs.forEach((x, k) => add(`${name} (marks)`, x, curve.markYs[k] ?? NaN));
        if (curve.band) for (const side of ["low", "high"]) curve.xs.forEach((x, k) => add(`${name} (${side})`, x, curve.band[side][k] ?? NaN));
      }
      cells?.values.forEach((value, k) => {
        const row = (cells.top[k] + cells.bottom[k]) / 2;
        rows.push([index + 1, up.texts[Math.floor(row)] ?? `${labelOf(up)} ${row}`, (cells.left[k] + cells.right[k]) / 2, value, labelOf(over), panel.title]);
      });
      if (panel.map) mapRows(panel, index + 1, rows);
    }
    return `${rows.map((row) => row.map((cell) => quoted(String(cell))).join(",")).join("\n")}\n`;
  }

  function mapRows({ x, y, view, map, bar }, index, rows) {
    const step = (axis, count) => (axis.ends[1] - axis.ends[0]) / count;
    for (let column = 0; column < map.width; column += 1) {
      for (let row = 0; row < map.height; row += 1) {
        const [at, up] = [x.ends[0] + (column + 0.5) * step(x, map.width), y.ends[1] - (row + 0.5) * step(y, map.height)];
        if (at < view.x[0] || at > view.x[1] || up < view.y[0] || up > view.y[1]) continue;
        const size = mapValue(bar, map.levels[row * map.width + column]);
        rows.push([index, `${labelOf(y)} ${number(up, 6)}`, number(at, 7), number(size, 4), labelOf(x), labelOf(bar)]);
      }
    }
  }

  // Figures on the page.

  const velocities = "Velocities: displacements times 2πf, accelerations divided by it; the strongest lines have names.";
  const captions = {
    velocity_spectrum: velocities,
    housing_velocity_spectrum: velocities,
    trace: "Of a long run a filled band shows between which values a curve stays; its end, and what is around the first events, is drawn sample by sample.",
    histories: "Forces, loads, speed and energies over time, as far as they change.",
    waterfall: "Amplitudes over frequency in colours; lines are orders of the shaft.",
    order_tracks: "Amplitude and phase of orders of the shaft over its speed.",
    campbell: "Natural frequencies and damping ratios over the speed; grey lines are orders of the shaft, points are critical speeds.",
    response: "Numbers along what is varied.",
    bifurcation: "Where the shaft stands once a cycle, over the axis; where both ways meet, those of the way down stand two pixels to the right.",
    map: "Numbers of the runs over both axes.",
    scatter: "Numbers of the runs over what was drawn, a point a run.",
    sensitivity: "Rank correlation of the numbers with what was drawn.",
    balls: "Every rolling element of every bearing around the shaft.",
    scene: "The shaft to scale, seen from the side: bearings with the lines of their contacts, loads and unbalance.",
    orbit: "The path of the shaft's centre, both ways at one scale.",
    traces: "The runs over each other in time; of long ones the lowest and highest values of each stretch.",
    spectra: "The spectra of the runs over each other; the mean is left out.",
    accuracy: "Error over cost, a curve a method.",
    ladder: "Cost and error of each model.",
    tornado: "Per cent by which a number changes where a quantity changes by one per cent.",
    fit_observations: "What was measured, a standard deviation to either side, and what is computed with the fitted values.",
    fit_residuals: "Computed less measured, in standard deviations; grey lines are none, one and two.",
    fit_profiles: "How much χ² grows where one unknown is held and the others are at their best; at 1 lies a standard error.",
    comparison: "To the left both curves, to the right their difference.",
  };

  /** Calls when an element gets another size, after the browser has laid it out. */
  const watch = (holder, call) => new ResizeObserver(() => setTimeout(call)).observe(holder);

  /** All drawings of the page; those that can be read have a figure. */
  const all = [];
  const readable = () => all.filter(({ figure }) => figure);
  /** Tells what is known of a run of a study; set by its page. */
  let runText = null;

  /** A drawing in a holder that is redrawn as it changes its size: on paper as SVG, on the screen on a canvas. */
  function drawn(state) {
    const { holder, base, paint, most } = state;
    state.redraw = () => {
      state.width = Math.min(holder.clientWidth, most);
      state.paper?.remove();
      if (isPrinted()) {
        const text = onPaper(Math.min(680, most), state.paintWhole ?? paint);
        state.paper = document.importNode(new DOMParser().parseFromString(text, "image/svg+xml").documentElement, true);
        holder.append(state.paper);
      } else if (state.width) {
        const colour = palette();
        const height = paint(nothing(), state.width, colour);
        paint(canvasPen(fitted(base, state.width, height)), state.width, colour);
        if (state.over) fitted(state.over, state.width, height);
        state.holder.style.height = `${height}px`;
      }
    };
    all.push(state);
    watch(holder, () => { if (Math.min(holder.clientWidth, most) !== state.width) state.redraw(); });
    return state;
  }

  const hint = "Point at the figure to read it, drag to zoom, double click to see it as at first, again to see all.";

  /** A figure that is read with the pointer or the keyboard, zoomed and saved. */
  function add(data) {
    const figure = read(data);
    const caption = captions[figure.name.replace(/^[a-z]+_tornado$/, "tornado")] ?? "";
    const base = element("canvas", { class: "base" });
    const over = element("canvas", { class: "over", tabindex: "0", role: "img", "aria-label": `${figure.name.replaceAll("_", " ")}. ${caption} `
      + "Arrow keys, home and end move, plus and minus zoom, 0 shows all, comma and full stop read points, page up and page down change the curve." });
    const holder = element("div", { class: "drawing" }, base, over);
    const reading = element("output", { class: "reading screen", "aria-live": "polite" }, hint);
    const state = { figure, base, over, holder, reading, most: Infinity, boxes: [], start: null, follow: null, focus: { panel: 0, curve: 0, index: -1 } };
    state.paint = (pen, width, colour) => {
      const { boxes, height } = draw(pen, figure, width, colour, false);
      state.boxes = boxes;
      return height;
    };
    state.paintWhole = (pen, width, colour) => draw(pen, figure, width, colour, true).height;
    listen(drawn(state));
    return element("figure", { class: "interactive", "data-figure": figure.name }, legend(state), holder, reading,
      element("figcaption", {}, caption, saveButtons(figure.name, state.paintWhole, () => csvOf(figure))));
  }

  /** Buttons that hide and show the curves of a colour. */
  function legend(state) {
    const buttons = state.figure.names.map(({ text, colour }) => {
      const made = element("button", { type: "button", class: "name", "aria-pressed": "true" },
        element("span", { class: "swatch", style: `background: ${css(colour)}` }), text);
      made.addEventListener("click", () => {
        const curves = state.figure.panels.flatMap((panel) => panel.curves);
        made.setAttribute("aria-pressed", String(toggle(state, curves, colour)));
      });
      return made;
    });
    return element("div", { class: "legend screen" }, ...buttons);
  }

  /** Hides the curves of a colour, or shows them where all are hidden; returns whether they are shown. */
  function toggle(state, curves, colour) {
    const own = curves.filter((curve) => curve.colour === colour);
    const hidden = !own.every((curve) => curve.hidden);
    for (const curve of own) curve.hidden = hidden;
    state.redraw();
    return !hidden;
  }

  const redraw = () => all.forEach((state) => state.redraw());
  dark.addEventListener("change", redraw);
  // what a closed section hides has no size until it is opened
  document.addEventListener("toggle", () => all.filter(({ holder, most, width }) => Math.min(holder.clientWidth, most) !== width)
    .forEach((state) => state.redraw()), true);

  const isIn = (left, top, width, height, px, py) => px >= left && px <= left + width && py >= top && py <= top + height;
  const boxAt = ({ boxes }, px, py) => boxes.find(({ plot }) => isIn(plot.left, plot.top, plot.width, plot.height, px, py));

  const clear = ({ over, width }) => over.getContext("2d").clearRect(0, 0, width, over.height);

  /** Shows what was found: a cross at it, its words below, and its abscissa in all panels over the same axis. */
  function show(state, box, found) {
    for (const other of readable()) clear(other);
    state.reading.textContent = found ? found.text : hint;
    if (!found) return;
    const colour = palette();
    mark(box.panel.x, found.x, colour);
    const pen = canvasPen(state.over.getContext("2d"));
    const [x, y] = [across(box, found.x), upwards(box, found.y)];
    pen.line([box.plot.left, y, box.plot.left + box.plot.width, y], colour("--quiet"), 1, [4, 3]);
    pen.circle(x, y, 4, null, colour("--ink"));
    const run = found.run === undefined || found.run === null ? null : runText?.(found.run);
    if (run) state.reading.textContent += `. ${run}`;
    state.follow?.(found.x);
  }

  /** Draws a line at an abscissa in all panels over an axis. */
  function mark(axis, at, colour = palette()) {
    for (const state of readable()) {
      for (const box of state.boxes.filter(({ panel }) => isSame(panel.x, axis))) {
        const x = across(box, at);
        const { left, top, width, height } = box.plot;
        if (x >= left && x <= left + width) canvasPen(state.over.getContext("2d")).line([x, top, x, top + height], colour("--quiet"), 1, [4, 3]);
      }
    }
  }

  /** Puts the cursor of a figure at an abscissa. */
  function seek(name, at) {
    const state = readable().find(({ figure }) => figure.name === name);
    const box = state?.boxes[0];
    if (!box?.panel.curves[0]) return;
    clear(state);
    mark(box.panel.x, at);
    const { xs } = box.panel.curves[0];
    const index = xs.reduce((best, x, k) => (Math.abs(x - at) < Math.abs(xs[best] - at) ? k : best), 0);
    state.reading.textContent = pointText(state.figure, box.panel, { curve: box.panel.curves[0], index, marks: false }).text;
  }

  // Zoom.

  /** Shows a range in a panel and in all of the page that stand over the same axis. */
  function zoom(state, box, x, y = null) {
    const { panel } = box;
    const [low, high] = panel.x.reach ?? panel.x.ends;
    const size = Math.min(x[1] - x[0], high - low);
    const from = Math.min(Math.max(x[0], low), high - size);
    if (panel.aspect) {
      // as much upwards as both ranges need
      const up = Math.max(y ? y[1] - y[0] : 0, (size * box.plot.height) / box.plot.width / panel.aspect);
      const middle = (y ?? box.view.y).reduce((a, b) => a + b, 0) / 2;
      panel.view = { x: [from, from + size], y: [middle - up / 2, middle + up / 2] };
      state.redraw();
      return;
    }
    if (y) panel.view.y = y;
    for (const other of readable()) {
      const alike = other.figure.panels.filter((each) => !each.aspect && isSame(each.x, panel.x));
      for (const each of alike) each.view.x = [from, from + size];
      if (alike.length) other.redraw();
    }
  }

  /** Shows what was shown at first, or where that is shown all. */
  function reset(state) {
    const axes = state.figure.panels.flatMap(({ x, y, view }) => [[x, view.x], [y, view.y]]);
    const asAtFirst = axes.every(([axis, shown]) => String(axis.ends) === String(shown));
    const wanted = (axis) => [...((asAtFirst && axis.reach) || axis.ends)];
    for (const panel of state.figure.panels) panel.view = { x: wanted(panel.x), y: wanted(panel.y) };
    for (const box of state.boxes.filter(({ panel }) => !panel.aspect)) zoom(state, box, wanted(box.panel.x));
    state.redraw();
  }

  function listen(state) {
    const { over } = state;
    const local = (event) => {
      const { left, top } = over.getBoundingClientRect();
      return [event.clientX - left, event.clientY - top];
    };
    over.addEventListener("pointerdown", (event) => {
      const [x, y] = local(event);
      const box = boxAt(state, x, y);
      if (box && event.button === 0) state.start = { box, x, y };
      else press(state, x, y);
    });
    over.addEventListener("pointermove", (event) => {
      const [x, y] = local(event);
      if (state.start) { marquee(state, x, y); return; }
      const box = boxAt(state, x, y);
      show(state, box, box && readAt(state.figure, box, x, y));
    });
    over.addEventListener("pointerup", (event) => {
      const { start } = state;
      state.start = null;
      if (start) drop(state, start, ...local(event));
    });
    over.addEventListener("pointerleave", () => { state.start = null; show(state, null, null); });
    over.addEventListener("dblclick", () => reset(state));
    over.addEventListener("keydown", (event) => keys(state, event));
  }

  /** Hides or shows the curves of the name of a panel that is pressed. */
  function press(state, px, py) {
    for (const { panel, strip, column, head, title } of state.boxes) {
      const [left, top] = [column[0] + 14, head + 16 * title.length + 2];
      const found = strip.placed.find((name) => isIn(left + name.left, top + name.top, 26 + 7 * name.text.length, 18, px, py));
      if (found) toggle(state, panel.curves, found.colour);
    }
  }

  function marquee(state, x, y) {
    const { start: { box: { plot }, ...start }, over } = state;
    const context = over.getContext("2d");
    const flat = Math.abs(y - start.y) < 12;
    clear(state);
    context.fillStyle = `${palette()("--c0")}38`;
    context.fillRect(start.x, flat ? plot.top : start.y, x - start.x, flat ? plot.height : y - start.y);
  }

  /** Zooms into what was marked: across alone where the mark is flat. */
  function drop(state, { box, x: x0, y: y0 }, x1, y1) {
    const { view, plot } = box;
    clear(state);
    if (Math.abs(x1 - x0) < 6) return;
    const at = (px) => view.x[0] + ((Math.min(Math.max(px, plot.left), plot.left + plot.width) - plot.left) / plot.width) * (view.x[1] - view.x[0]);
    const up = (py) => view.y[1] - ((Math.min(Math.max(py, plot.top), plot.top + plot.height) - plot.top) / plot.height) * (view.y[1] - view.y[0]);
    const flat = Math.abs(y1 - y0) < 12;
    zoom(state, box, [at(Math.min(x0, x1)), at(Math.max(x0, x1))], flat ? null : [up(Math.max(y0, y1)), up(Math.min(y0, y1))]);
  }

  // The keyboard.

  function keys(state, event) {
    const box = state.boxes[state.focus.panel];
    if (!box || event.ctrlKey || event.metaKey || event.altKey) return;
    const [low, high] = box.view.x;
    const [step, middle] = [(high - low) / 10, (low + high) / 2];
    const [first, last] = box.panel.x.reach ?? box.panel.x.ends;
    const moves = {
      ArrowLeft: () => zoom(state, box, [low - step, high - step]),
      ArrowRight: () => zoom(state, box, [low + step, high + step]),
      Home: () => zoom(state, box, [first, first + high - low]),
      End: () => zoom(state, box, [last - (high - low), last]),
      "+": () => zoom(state, box, [middle - 4 * step, middle + 4 * step]),
      "=": () => zoom(state, box, [middle - 4 * step, middle + 4 * step]),
      "-": () => zoom(state, box, [middle - 6.25 * step, middle + 6.25 * step]),
      0: () => reset(state),
      Escape: () => reset(state),
      ",": () => next(state, -1),
      ".": () => next(state, 1),
      PageDown: () => turn(state, 1),
      PageUp: () => turn(state, -1),
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  }

  /** All curves of a figure in their order, each with its panel. */
  const shownCurves = (state) => state.boxes.flatMap((box, panel) => box.panel.curves.map((curve, index) => ({ panel, index, curve })))
    .filter(({ curve }) => !curve.hidden && (curve.xs.length || curve.markXs.length));

  /** Reads the next curve. */
  function turn(state, by) {
    const curves = shownCurves(state);
    const now = curves.findIndex(({ panel, index }) => panel === state.focus.panel && index === state.focus.curve);
    const found = curves[(now + by + curves.length) % curves.length];
    if (!found) return;
    state.focus = { panel: found.panel, curve: found.index, index: -1 };
    next(state, 1);
  }

  /** Reads the next point of the curve. */
  function next(state, by) {
    const { focus } = state;
    const box = state.boxes[focus.panel];
    const curve = box?.panel.curves[focus.curve] ?? shownCurves(state)[0]?.curve;
    if (!curve) return;
    const marks = !curve.xs.length;
    const count = marks ? curve.markXs.length : curve.xs.length;
    focus.index = Math.min(Math.max(focus.index + by, 0), count - 1);
    show(state, box, pointText(state.figure, box.panel, { curve, index: focus.index, marks }));
  }

  /** A drawing that is made by `paint`, which is given a pen, a width and colours, and returns its height. */
  function sketch({ name, label, caption, paint, csv = null, width = 460 }) {
    const base = element("canvas", { role: "img", "aria-label": label });
    const holder = element("div", { class: "sketch", style: `max-width: ${width}px` }, base);
    const { redraw: again } = drawn({ holder, base, paint, most: width });
    return { redraw: again, figure: element("figure", { style: `max-width: ${width}px` }, holder,
      element("figcaption", {}, caption, saveButtons(name, paint, csv))) };
  }

  /** Calls with the abscissa of what is read in a figure. */
  const follow = (name, call) => readable().filter(({ figure }) => figure.name === name).forEach((state) => { state.follow = call; });

  return { add, sketch, redraw, seek, follow, all: () => readable().map(({ figure }) => figure), tellRuns: (tell) => { runText = tell; } };
})();
