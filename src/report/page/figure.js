
/** Figures: told as data, drawn at the size of the screen, read with a cursor, zoomed, saved. */
const figures = (() => {
  const { element, number, floats, bytes } = page;
  const { canvasPen, svgPen, pdfPen, widthOf } = pens;

  // Colours.

  /** Colours of the figures as the page has them in its two themes. */
  const roles = { "#0072b2": "--c0", "#d55e00": "--c1", "#009e73": "--c2", "#cc79a7": "--c3", "#e69f00": "--c4",
    "#56b4e9": "--c5", "#969696": "--quiet" };

  /** Finds colours by their names or those of figures, of the screen or of white paper. */
  function palette(onPaper) {
    const root = document.documentElement;
    const was = root.classList.contains("printed");
    if (onPaper) root.classList.add("printed");
    const style = getComputedStyle(root);
    const names = ["--paper", "--ink", "--quiet", "--line", "--panel", "--c0", "--c1", "--c2", "--c3", "--c4", "--c5"];
    const known = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(name).trim()]));
    if (onPaper && !was) root.classList.remove("printed");
    return (name) => known[roles[name] ?? name] ?? name;
  }

  /** The colour map viridis in five anchors, as the figures of the folder have it. */
  function graded(part) {
    const anchors = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [215, 205, 40]];
    const place = Math.min(Math.max(part, 0), 1) * (anchors.length - 1);
    const below = Math.min(Math.floor(place), anchors.length - 2);
    return anchors[below].map((v, k) => Math.round(v + (place - below) * (anchors[below + 1][k] - v)));
  }

  // Data.

  function readCurve(curve) {
    const [xs, ys] = curve.points.map(floats);
    const [markXs, markYs] = curve.pointsAreMarked ? [xs, ys] : curve.marks.map(floats);
    return { ...curve, xs, ys, markXs, markYs, runs: curve.runs && floats(curve.runs), hidden: false };
  }

  function readCells(cells) {
    const read = Object.fromEntries(["left", "right", "top", "bottom", "values"].map((key) => [key, floats(cells[key])]));
    return { ...read, colours: cells.colours, runs: cells.runs && floats(cells.runs) };
  }

  function readMap(map) {
    const levels = new Uint8Array(bytes(map.levels));
    const height = levels.length / map.width;
    const pixels = new Uint8ClampedArray(4 * levels.length);
    levels.forEach((level, k) => pixels.set([...graded(level / 255), 255], 4 * k));
    return { ...map, levels, height, picture: { width: map.width, height, pixels } };
  }

  /** A figure of the data of the page, ready to be drawn. */
  function read(figure) {
    const panels = figure.panels.map((panel) => ({
      ...panel,
      curves: panel.curves.map(readCurve),
      cells: panel.cells && readCells(panel.cells),
      map: panel.map && readMap(panel.map),
      view: { x: [...panel.x.ends], y: [...panel.y.ends] },
    }));
    return { ...figure, panels };
  }

  // Axes.

  /** Where a value stands on an axis: itself, or its decimal logarithm. */
  const place = (axis, value) => (!axis.logarithmic ? value : value > 0 ? Math.log10(value) : axis.ends[0]);
  const valueAt = (axis, at) => (axis.logarithmic ? 10 ** at : at);

  /** Round places between two ends with what is written there. */
  function ticks(axis, [from, to], most) {
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    if (axis.texts) return axis.texts.map((text, k) => ({ at: k + 0.5, text })).filter(({ at }) => at > low && at < high);
    if (axis.logarithmic && high - low >= 1) {
      const step = Math.ceil((high - low) / most);
      const found = [];
      for (let at = Math.ceil(low / step) * step; at <= high; at += step) found.push({ at, text: `1e${at}` });
      return found;
    }
    if (axis.logarithmic) {
      const values = ticks({}, [10 ** low, 10 ** high], most);
      return values.map(({ at, text }) => ({ at: Math.log10(at), text }));
    }
    const rough = (high - low) / Math.max(most, 1);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough * 0.999);
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const found = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && found.length < 30; k += 1) {
      const value = k * step;
      found.push({ at: value, text: digits > 9 || Math.abs(value) >= 1e7 ? number(value, 6) : value.toFixed(digits) });
    }
    return found;
  }

  // Drawing.

  const TEXT = 12;
  const BAR = 86;

  /** Places of all panels in a width: of each its plot, and the height of all. */
  function layout(figure, width) {
    const columns = width >= 700 ? figure.columns : 1;
    const boxes = [];
    // plots below each other begin at one line
    const rooms = Array.from({ length: columns }, (_, column) => Math.max(0, ...figure.panels
      .filter((_panel, index) => index % columns === column).map((panel) => leftRoom(panel, width / columns))));
    let top = 0;
    for (let first = 0; first < figure.panels.length; first += columns) {
      const row = figure.panels.slice(first, first + columns);
      const heights = row.map((panel, column) => {
        const left = (column * width) / columns + rooms[column];
        const right = ((column + 1) * width) / columns - (panel.bar || panel.map ? BAR : 14);
        const strips = strip(panel.names, width / columns);
        const above = (panel.title ? 20 : 0) + strips.height + 10;
        const plot = { left, top: top + above, width: Math.max(right - left, 40) };
        plot.height = panel.equal ? equalHeight(panel, plot.width) : Math.max(60, panel.height);
        boxes.push({ panel, plot, head: { left: (column * width) / columns, top, strips } });
        return above + plot.height + (panel.x.name ? 46 : 24);
      });
      top += Math.max(...heights);
    }
    return { boxes, height: top };
  }

  /** The height that makes a unit as long upwards as it is across, within bounds: beyond these less is shown across. */
  function equalHeight(panel, width) {
    const { x, y } = panel.view;
    const wanted = (width * Math.abs(y[1] - y[0])) / Math.abs(x[1] - x[0]);
    const height = Math.min(wanted, 460);
    const [half, middle] = [((y[1] - y[0]) * width) / height / 2, (x[0] + x[1]) / 2];
    panel.view.x = [middle - half, middle + half];
    return height;
  }

  function leftRoom(panel, width) {
    const texts = panel.y.texts ?? ticks(panel.y, panel.view.y, 8).map(({ text }) => text);
    const longest = Math.max(...texts.map((text) => widthOf(text, TEXT)), 20);
    return Math.min(longest + (panel.y.name ? 34 : 12), 0.45 * width);
  }

  /** Names side by side, in rows. */
  function strip(names, width) {
    let [left, top] = [0, 0];
    const placed = names.map(({ text, colour }) => {
      const room = widthOf(text, TEXT) + 42;
      if (left > 0 && left + room > width - 20) [left, top] = [0, top + 18];
      const name = { text, colour, left, top };
      left += room;
      return name;
    });
    return { placed, height: names.length ? top + 22 : 0 };
  }

  function drawStrip(pen, { placed }, left, top, colour) {
    for (const name of placed) {
      const [x, y] = [left + 14 + name.left, top + 12 + name.top];
      pen.line([x, y, x + 18, y], colour(name.colour), 3);
      pen.text(name.text, x + 23, y + 4, { colour: colour("--ink"), size: TEXT });
    }
  }

  /** Draws a figure and returns its height. */
  function draw(pen, figure, width, colour, withNames) {
    const names = strip(withNames ? shownNames(figure) : [], width);
    drawStrip(pen, names, 0, 0, colour);
    const { boxes, height } = layout(figure, width);
    for (const box of boxes) {
      box.plot.top += names.height;
      box.head.top += names.height;
      drawPanel(pen, box, colour);
    }
    return { boxes, height: names.height + height };
  }

  /** What the colours mean; of a map its bar tells that. */
  const shownNames = (figure) => (figure.panels.some((panel) => panel.map) ? [] : figure.names);

  const across = ({ panel, plot }, x) => plot.left
    + ((place(panel.x, x) - panel.view.x[0]) / (panel.view.x[1] - panel.view.x[0])) * plot.width;
  const upwards = ({ panel, plot }, y) => plot.top
    + ((panel.view.y[1] - place(panel.y, y)) / (panel.view.y[1] - panel.view.y[0])) * plot.height;

  function drawPanel(pen, box, colour) {
    const { panel, plot, head } = box;
    const ink = colour("--ink");
    if (panel.title) pen.text(panel.title, plot.left + plot.width / 2, head.top + 15, { colour: ink, size: 13, align: "middle" });
    drawStrip(pen, head.strips, head.left, head.top + (panel.title ? 20 : 0), colour);
    drawAxes(pen, box, colour);
    pen.clip(plot.left, plot.top, plot.width, plot.height);
    if (panel.map) drawMap(pen, box);
    if (panel.cells) drawCells(pen, box, colour);
    for (const curve of panel.curves) if (!curve.hidden) drawCurve(pen, box, curve, colour);
    for (const [x, y, text, name] of panel.labels ?? []) {
      pen.text(text, across(box, x) + 3, upwards(box, y) + 10, { colour: colour(name), size: 11 });
    }
    drawPeaks(pen, box, ink);
    pen.unclip();
    if (panel.bar) drawBar(pen, box, panel.bar.name, panel.bar, panel.bar.ends, colour);
    if (panel.map) {
      const top = Math.log10(panel.map.top);
      const axis = { logarithmic: true, ends: [top - panel.map.decades, top] };
      drawBar(pen, box, `amplitude in ${panel.map.unit}`, axis, axis.ends, colour);
    }
  }

  function drawAxes(pen, { panel, plot, head }, colour) {
    const [ink, line] = [colour("--ink"), colour("--line")];
    const bottom = plot.top + plot.height;
    for (const tick of ticks(panel.x, panel.view.x, Math.max(3, Math.floor(plot.width / 60)))) {
      const x = across({ panel, plot }, valueAt(panel.x, tick.at));
      pen.line([x, plot.top, x, bottom], line);
      pen.text(tick.text, x, bottom + 16, { colour: ink, size: TEXT, align: "middle" });
    }
    for (const tick of ticks(panel.y, panel.view.y, Math.max(2, Math.floor(plot.height / 34)))) {
      const y = upwards({ panel, plot }, valueAt(panel.y, tick.at));
      pen.line([plot.left, y, plot.left + plot.width, y], line);
      pen.text(tick.text, plot.left - 6, y + 4, { colour: ink, size: TEXT, align: "end" });
    }
    pen.line([plot.left, plot.top, plot.left, bottom, plot.left + plot.width, bottom], colour("--quiet"));
    pen.text(panel.x.name, plot.left + plot.width / 2, bottom + 36, { colour: ink, size: TEXT, align: "middle" });
    if (!panel.y.texts) pen.text(panel.y.name, head.left + 14, plot.top + plot.height / 2, { colour: ink, size: TEXT, align: "middle", upright: true });
  }

  function drawCurve(pen, box, curve, colour) {
    const { panel } = box;
    const shade = panel.map ? curve.colour : colour(curve.colour);
    const xs = (values) => values.map((x) => (x === null ? NaN : across(box, x)));
    const ys = (values) => values.map((y) => (y === null ? NaN : upwards(box, y)));
    const woven = (as, bs) => as.flatMap((a, k) => [a, bs[k]]);
    if (curve.band) {
      const [at, low, high] = [xs(curve.xs), ys(curve.band.low), ys(curve.band.high)];
      let run = [];
      const close = () => {
        if (run.length > 1) pen.area([...run.flatMap((k) => [at[k], high[k]]), ...run.reverse().flatMap((k) => [at[k], low[k]])], shade, 0.35);
        run = [];
      };
      at.forEach((_, k) => { if (Number.isFinite(low[k])) run.push(k); else close(); });
      close();
    }
    pen.line(woven(xs(curve.xs), ys(curve.ys)), shade, curve.fine ? 0.8 : 1.4, curve.dashes);
    const [markXs, markYs] = [xs(curve.markXs), ys(curve.markYs)];
    markXs.forEach((x, k) => drawMark(pen, curve.mark, x, markYs[k], shade));
  }

  function drawMark(pen, mark, x, y, colour) {
    if (mark === "spot") pen.rectangle(x - 0.8, y - 0.8, 1.6, 1.6, colour);
    else if (mark === "triangle") pen.area([x - 5, y + 4, x + 5, y + 4, x, y - 5], colour);
    else pen.circle(x, y, mark === "disc" ? 5 : 2.6, colour);
  }

  function drawCells(pen, box, colour) {
    const { left, right, top, bottom, colours } = box.panel.cells;
    left.forEach((_, k) => {
      const [x0, x1] = [across(box, left[k]), across(box, right[k])];
      const [y0, y1] = [upwards(box, top[k]), upwards(box, bottom[k])];
      pen.rectangle(Math.min(x0, x1), Math.min(y0, y1), Math.abs(x1 - x0) + 0.3, Math.abs(y1 - y0) + 0.3, colour(colours[k]));
    });
  }

  function drawMap(pen, box) {
    const { x, y, map } = box.panel;
    const [left, right] = x.ends.map((end) => across(box, valueAt(x, end)));
    const [bottom, top] = y.ends.map((end) => upwards(box, valueAt(y, end)));
    pen.picture(map.picture, left, top, right - left, bottom - top);
  }

  /** All colours from below to above beside a plot. */
  function drawBar(pen, { plot }, name, axis, ends, colour) {
    const left = plot.left + plot.width + 10;
    const pixels = new Uint8ClampedArray(4 * 256);
    for (let k = 0; k < 256; k += 1) pixels.set([...graded((255 - k) / 255), 255], 4 * k);
    pen.picture({ width: 1, height: 256, pixels }, left, plot.top, 12, plot.height);
    for (const tick of ticks(axis, ends, Math.floor(plot.height / 34))) {
      const y = plot.top + plot.height * (1 - (tick.at - ends[0]) / (ends[1] - ends[0]));
      pen.text(tick.text, left + 16, y + 4, { colour: colour("--ink"), size: 11 });
    }
    pen.text(name, left + 68, plot.top + plot.height / 2, { colour: colour("--ink"), size: 11, align: "middle", upright: true });
  }

  /** Names of peaks, each only where it covers none before it. */
  function drawPeaks(pen, box, ink) {
    const taken = [];
    for (const [x, y, text] of box.panel.peaks ?? []) {
      const [left, top, half] = [across(box, x), upwards(box, y), widthOf(text, TEXT) / 2 + 3];
      const { plot } = box;
      const outside = left - half < plot.left || left + half > plot.left + plot.width || top < plot.top || top > plot.top + plot.height;
      if (outside || taken.length > 9 || taken.some((other) => Math.abs(other.left - left) < other.half + half && Math.abs(other.top - top) < 14)) continue;
      taken.push({ left, top, half });
      pen.circle(left, top, 2, ink);
      pen.text(text, left, Math.max(top - 6, plot.top + 11), { colour: ink, size: TEXT, align: "middle" });
    }
  }

  // Reading.

  /** `speed = 3000 1/min` of an axis called `speed in 1/min`. */
  function told(axis, value) {
    const [name, unit] = axis.name.split(" in ");
    return `${name || "at"} ${number(value, 6)}${unit ? ` ${unit}` : ""}`;
  }

  /** The axis below a panel, which may be named under another one. */
  function below(figure, panel) {
    const alike = (other) => other.x.name && String(other.x.ends) === String(panel.x.ends);
    return panel.x.name ? panel.x : figure.panels.find(alike)?.x ?? panel.x;
  }

  const nameOf = (figure, panel, curve) => curve.name
    || [...panel.names, ...figure.names].find(({ colour }) => colour === curve.colour)?.text || "";

  /** What stands at a point of a curve, or of its marks. */
  function pointText(figure, panel, { curve, index, marks }) {
    const [x, y] = marks ? [curve.markXs[index], curve.markYs[index]] : [curve.xs[index], curve.ys[index]];
    const row = panel.y.texts?.[Math.floor(y)];
    const parts = [nameOf(figure, panel, curve), told(below(figure, panel), x), row ?? told(panel.y, y)];
    return { text: parts.filter(Boolean).join("; "), run: curve.runs?.[index], x, y };
  }

  /** The point of a panel that is nearest to a place of the screen. */
  function nearest(box, px, py) {
    let best = { distance: 30 ** 2 };
    for (const curve of box.panel.curves) {
      if (curve.hidden || curve.silent) continue;
      const look = (xs, ys, marks) => xs.forEach((x, index) => {
        if (ys[index] === null || x === null) return;
        const distance = (across(box, x) - px) ** 2 + (upwards(box, ys[index]) - py) ** 2;
        if (distance < best.distance) best = { distance, curve, index, marks };
      });
      look(curve.xs, curve.ys, false);
      if (!curve.pointsAreMarked) look(curve.markXs, curve.markYs, true);
    }
    return best.curve ? best : null;
  }

  /** What a map shows at a place: both axes, the order of the shaft, the amplitude and the line that is near. */
  function mapText(figure, box, px, py) {
    const { panel, plot } = box;
    const { map, view } = panel;
    const x = view.x[0] + ((px - plot.left) / plot.width) * (view.x[1] - view.x[0]);
    const y = view.y[1] - ((py - plot.top) / plot.height) * (view.y[1] - view.y[0]);
    const column = Math.floor(((x - panel.x.ends[0]) / (panel.x.ends[1] - panel.x.ends[0])) * map.width);
    const row = Math.floor(((panel.y.ends[1] - y) / (panel.y.ends[1] - panel.y.ends[0])) * map.height);
    const level = map.levels[row * map.width + column];
    if (level === undefined || column < 0 || column >= map.width) return null;
    const size = map.top * 10 ** ((level / 255 - 1) * map.decades);
    const overSpeed = panel.x.name.startsWith("speed in 1/min");
    const line = panel.curves.map((curve) => ({ name: curve.name, away: Math.abs(upwards(box, atAbscissa(curve, x)) - py) }))
      .filter(({ name, away }) => name && away < 8).sort((a, b) => a.away - b.away)[0];
    const parts = [told({ name: panel.x.name.replace(/ \(.*/, "") }, x), told(panel.y, y),
      overSpeed && `order ${number((60 * y) / x, 4)}`,
      `amplitude ${level ? number(size, 4) : `below ${number(size, 2)}`} ${map.unit}`, line && `on the line ${line.name}`];
    return { text: parts.filter(Boolean).join("; "), x, y };
  }

  /** The value of a straight line. */
  function atAbscissa({ xs, ys }, x) {
    const last = xs.length - 1;
    return last < 1 ? NaN : ys[0] + ((x - xs[0]) / (xs[last] - xs[0])) * (ys[last] - ys[0]);
  }

  function cellText(figure, box, px, py) {
    const { panel } = box;
    const { left, right, top, bottom, values, runs } = panel.cells;
    const within = (v, a, b) => v >= Math.min(a, b) && v <= Math.max(a, b);
    const found = values.findIndex((_, k) => within(px, across(box, left[k]), across(box, right[k]))
      && within(py, upwards(box, top[k]), upwards(box, bottom[k])));
    if (found < 0) return null;
    const [x, y] = [(left[found] + right[found]) / 2, (top[found] + bottom[found]) / 2];
    const row = panel.y.texts?.[Math.floor(y)];
    const parts = row ? [row, told(panel.x, values[found])]
      : [told(panel.x, x), told(panel.y, y), `${panel.title || "value"}: ${number(values[found], 5)}`];
    return { text: parts.join("; "), run: runs?.[found], x, y };
  }

  function readAt(figure, box, px, py) {
    const { panel } = box;
    const near = nearest(box, px, py);
    if (panel.map && !near?.marks) return mapText(figure, box, px, py);
    if (near) return pointText(figure, panel, near);
    return panel.cells ? cellText(figure, box, px, py) : null;
  }

  // Saving.

  function offer(name, blob) {
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  /** Widths of saved figures, CSS pixels of 1/96 inch. */
  const widths = { "column, 88 mm": 333, "page, 180 mm": 680 };

  /** A drawing on white paper as a file: `paint` draws it in a width and returns its height. */
  async function save(kind, name, width, paint) {
    const colour = palette(true);
    const height = Math.ceil(paint(canvasPen(document.createElement("canvas").getContext("2d")), width, colour));
    if (kind === "png") {
      const scale = 600 / 96; // 600 pixels an inch
      const canvas = document.createElement("canvas");
      Object.assign(canvas, { width: Math.round(width * scale), height: Math.round(height * scale) });
      const context = canvas.getContext("2d");
      context.scale(scale, scale);
      const pen = canvasPen(context);
      pen.rectangle(0, 0, width, height, colour("--paper"));
      paint(pen, width, colour);
      return offer(`${name}.png`, await new Promise((done) => { canvas.toBlob(done, "image/png"); }));
    }
    const pen = { svg: svgPen, pdf: pdfPen }[kind](width, height);
    paint(pen, width, colour);
    return offer(`${name}.${kind}`, pen.finish());
  }

  /** Buttons that save a drawing, and what it shows as CSV. */
  function saveButtons(name, paint, csv) {
    const size = element("select", { "aria-label": "width of the saved figure" }, ...Object.keys(widths).map((text) => element("option", {}, text)));
    const button = (kind, action) => {
      const made = element("button", { type: "button", "aria-label": `save ${name} as ${kind}` }, kind);
      made.addEventListener("click", action);
      return made;
    };
    const drawings = ["SVG", "PNG", "PDF"].map((kind) => button(kind, () => save(kind.toLowerCase(), name, widths[size.value], paint)));
    const values = csv && button("CSV", () => offer(`${name}.csv`, new Blob([csv()], { type: "text/csv" })));
    return element("details", { class: "save screen" }, element("summary", {}, "Save"), size, ...drawings, values ?? null);
  }

  /** What a figure shows, a line a point. */
  function csvOf(figure) {
    const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const rows = [["panel", "curve", "abscissa", "value", "abscissa_name", "value_name"]];
    for (const [index, panel] of figure.panels.entries()) {
      const within = ([low, high], axis, v) => v !== null && place(axis, v) >= Math.min(low, high) && place(axis, v) <= Math.max(low, high);
      const add = (name, x, y) => {
        if (within(panel.view.x, panel.x, x) && y !== null && Number.isFinite(y)) rows.push([index + 1, name, x, y, below(figure, panel).name, panel.y.name || panel.title]);
      };
      for (const curve of panel.curves.filter((entry) => !entry.hidden && !entry.silent)) {
        const name = nameOf(figure, panel, curve);
        curve.xs.forEach((x, k) => add(name, x, curve.ys[k]));
        if (!curve.pointsAreMarked) curve.markXs.forEach((x, k) => add(`${name} (marks)`, x, curve.markYs[k]));
        if (curve.band) for (const side of ["low", "high"]) curve.xs.forEach((x, k) => add(`${name} (${side})`, x, curve.band[side][k]));
      }
      panel.cells?.values.forEach((value, k) => rows.push([index + 1, panel.y.texts?.[Math.floor((panel.cells.top[k] + panel.cells.bottom[k]) / 2)]
        ?? `${panel.y.name} ${(panel.cells.top[k] + panel.cells.bottom[k]) / 2}`, (panel.cells.left[k] + panel.cells.right[k]) / 2, value, panel.x.name, panel.title]));
      if (panel.map) mapRows(panel, index + 1, rows);
    }
    return `${rows.map((row) => row.map((cell) => quoted(String(cell))).join(",")).join("\n")}\n`;
  }

  function mapRows({ x, y, view, map }, index, rows) {
    const step = (axis, count) => (axis.ends[1] - axis.ends[0]) / count;
    for (let column = 0; column < map.width; column += 1) {
      for (let row = 0; row < map.height; row += 1) {
        const [at, up] = [x.ends[0] + (column + 0.5) * step(x, map.width), y.ends[1] - (row + 0.5) * step(y, map.height)];
        if (at < view.x[0] || at > view.x[1] || up < view.y[0] || up > view.y[1]) continue;
        const size = map.top * 10 ** ((map.levels[row * map.width + column] / 255 - 1) * map.decades);
        rows.push([index, `${y.name} ${number(up, 6)}`, number(at, 7), number(size, 4), x.name, `amplitude in ${map.unit}`]);
      }
    }
  }

  // Figures on the page.

  const captions = {
    waterfall: "Amplitudes over frequency in colours; lines are orders of the shaft.",
    order_tracks: "Amplitude and phase of orders of the shaft over its speed.",
    campbell: "Natural frequencies and damping ratios over the speed; grey lines are orders of the shaft, points are critical speeds.",
    response: "Numbers along what is varied.",
    bifurcation: "Where the shaft stands once a cycle, over the axis.",
    map: "Numbers of the runs over both axes.",
    scatter: "Numbers of the runs over what was drawn, a point a run.",
    sensitivity: "Rank correlation of the numbers with what was drawn.",
    balls: "Every ball of every bearing around the shaft.",
    scene: "The shaft to scale, seen from the side: bearings with the lines of their contacts, loads and unbalance.",
    orbit: "The path of the shaft's centre, both ways at one scale.",
    traces: "The runs over each other in time; of long ones the lowest and highest values of each stretch.",
    spectra: "The spectra of the runs over each other; the mean is left out.",
    accuracy: "Error over cost, a curve a method.",
    ladder: "Cost and error of each model.",
    comparison: "To the left both curves, to the right their difference.",
  };

  /** Calls when an element gets another size, after the browser has laid it out. */
  const watch = (holder, call) => new ResizeObserver(() => setTimeout(call)).observe(holder);

  const all = [];
  /** Tells what is known of a run of a study; set by its page. */
  let runText = null;

  /** A figure that is read with the pointer or the keyboard, zoomed and saved. */
  function add(data) {
    const figure = read(data);
    const caption = captions[figure.name] ?? "";
    const base = element("canvas", { class: "base" });
    const over = element("canvas", { class: "over", tabindex: "0", role: "img", "aria-label": `${figure.name.replaceAll("_", " ")}. ${caption} `
      + "Arrow keys move, plus and minus zoom, 0 shows all, comma and full stop read points, page up and page down change the curve." });
    const holder = element("div", { class: "drawing" }, base, over);
    const reading = element("output", { class: "reading screen", "aria-live": "polite" }, hint);
    const state = { figure, base, over, holder, reading, boxes: [], width: 0, start: null, focus: { panel: 0, curve: 0, index: -1 } };
    all.push(state);
    listen(state);
    watch(holder, () => { if (holder.clientWidth !== state.width) redrawOne(state); });
    const paint = (pen, width, colour) => draw(pen, figure, width, colour, true).height;
    return element("figure", { class: "interactive", "data-figure": figure.name }, legend(state), holder, reading,
      element("figcaption", {}, caption, saveButtons(figure.name, paint, () => csvOf(figure))));
  }

  const hint = "Point at the figure to read it, drag to zoom, double click to see all.";

  /** Buttons that hide and show the curves of a colour. */
  function legend(state) {
    const buttons = shownNames(state.figure).map(({ text, colour }) => {
      const swatch = element("span", { class: "swatch", style: `background: ${roles[colour] ? `var(${roles[colour]})` : colour}` });
      const made = element("button", { type: "button", class: "name", "aria-pressed": "true" }, swatch, text);
      made.addEventListener("click", () => {
        const curves = state.figure.panels.flatMap((panel) => panel.curves).filter((curve) => curve.colour === colour);
        const hidden = !curves.every((curve) => curve.hidden);
        for (const curve of curves) curve.hidden = hidden;
        made.setAttribute("aria-pressed", String(!hidden));
        redrawOne(state);
      });
      return made;
    });
    return element("div", { class: "legend" }, ...buttons);
  }

  function redrawOne(state) {
    const { holder, base, over, figure } = state;
    const width = document.documentElement.classList.contains("printed") ? 680 : holder.clientWidth;
    if (!width) return;
    state.width = holder.clientWidth;
    const colour = palette(false);
    const { height } = layout(figure, width);
    for (const canvas of [base, over]) {
      Object.assign(canvas, { width: Math.round(width * devicePixelRatio), height: Math.round(height * devicePixelRatio) });
      canvas.style.height = `${height}px`;
      canvas.getContext("2d").scale(devicePixelRatio, devicePixelRatio);
    }
    holder.style.height = `${height}px`;
    state.boxes = draw(canvasPen(base.getContext("2d")), figure, width, colour, false).boxes;
  }

  const redraw = () => all.forEach(redrawOne);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);

  const boxAt = (state, px, py) => state.boxes.find(({ plot }) => px >= plot.left && px <= plot.left + plot.width
    && py >= plot.top && py <= plot.top + plot.height);

  /** Shows what was found: a cross at it and its words below. */
  function show(state, box, found) {
    const pen = canvasPen(state.over.getContext("2d"));
    state.over.getContext("2d").clearRect(0, 0, state.width, 1e5);
    if (!found) { state.reading.textContent = hint; return; }
    const colour = palette(false);
    const [x, y] = [across(box, found.x), upwards(box, found.y)];
    const { plot } = box;
    pen.line([x, plot.top, x, plot.top + plot.height], colour("--quiet"), 1, [4, 3]);
    pen.line([plot.left, y, plot.left + plot.width, y], colour("--quiet"), 1, [4, 3]);
    pen.circle(x, y, 4, null, colour("--ink"));
    const run = found.run === undefined || found.run === null ? null : runText?.(found.run);
    state.reading.textContent = run ? `${found.text}. ${run}` : found.text;
  }

  /** Shows a range in a panel and in all that stand over the same axis. */
  function zoom(state, box, x, y = null) {
    const alike = state.figure.panels.filter((panel) => String(panel.x.ends) === String(box.panel.x.ends));
    for (const panel of alike) {
      const [low, high] = panel.x.ends;
      const size = Math.min(x[1] - x[0], high - low);
      const from = Math.min(Math.max(x[0], low), high - size);
      panel.view.x = [from, from + size];
    }
    if (y) box.panel.view.y = y;
    redrawOne(state);
  }

  function reset(state) {
    for (const panel of state.figure.panels) panel.view = { x: [...panel.x.ends], y: [...panel.y.ends] };
    redrawOne(state);
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

  function marquee({ start, over }, x, y) {
    const context = over.getContext("2d");
    const { plot } = start.box;
    const flat = Math.abs(y - start.y) < 12;
    context.clearRect(0, 0, 1e5, 1e5);
    context.fillStyle = `${palette(false)("--c0")}38`;
    context.fillRect(start.x, flat ? plot.top : start.y, x - start.x, flat ? plot.height : y - start.y);
  }

  /** Zooms into what was marked: across alone where the mark is flat. */
  function drop(state, { box, x: x0, y: y0 }, x1, y1) {
    const { panel: { view }, plot } = box;
    state.over.getContext("2d").clearRect(0, 0, 1e5, 1e5);
    if (Math.abs(x1 - x0) < 6) return;
    const at = (px) => view.x[0] + ((Math.min(Math.max(px, plot.left), plot.left + plot.width) - plot.left) / plot.width) * (view.x[1] - view.x[0]);
    const up = (py) => view.y[1] - ((Math.min(Math.max(py, plot.top), plot.top + plot.height) - plot.top) / plot.height) * (view.y[1] - view.y[0]);
    const flat = Math.abs(y1 - y0) < 12 || box.panel.equal;
    zoom(state, box, [at(Math.min(x0, x1)), at(Math.max(x0, x1))], flat ? null : [up(Math.max(y0, y1)), up(Math.min(y0, y1))]);
  }

  function keys(state, event) {
    const box = state.boxes[state.focus.panel];
    if (!box || event.ctrlKey || event.metaKey || event.altKey) return;
    const [low, high] = box.panel.view.x;
    const [step, middle] = [(high - low) / 10, (low + high) / 2];
    const moves = {
      ArrowLeft: () => zoom(state, box, [low - step, high - step]),
      ArrowRight: () => zoom(state, box, [low + step, high + step]),
      "+": () => zoom(state, box, [middle - 4 * step, middle + 4 * step]),
      "=": () => zoom(state, box, [middle - 4 * step, middle + 4 * step]),
      "-": () => zoom(state, box, [middle - 6.25 * step, middle + 6.25 * step]),
      0: () => reset(state),
      Escape: () => reset(state),
      ",": () => step_(state, -1),
      ".": () => step_(state, 1),
      PageDown: () => turn(state, 1),
      PageUp: () => turn(state, -1),
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  }

  /** All curves of a figure in their order, each with its panel. */
  const readable = (state) => state.boxes.flatMap((box, panel) => box.panel.curves.map((curve, index) => ({ panel, index, curve })))
    .filter(({ curve }) => !curve.hidden && !curve.silent && (curve.xs.length || curve.markXs.length));

  function turn(state, by) {
    const curves = readable(state);
    const now = curves.findIndex(({ panel, index }) => panel === state.focus.panel && index === state.focus.curve);
    const next = curves[(now + by + curves.length) % curves.length];
    if (!next) return;
    state.focus = { panel: next.panel, curve: next.index, index: -1 };
    step_(state, 1);
  }

  /** Reads the next point of the curve. */
  function step_(state, by) {
    const { focus } = state;
    const box = state.boxes[focus.panel];
    const curve = box?.panel.curves[focus.curve] ?? readable(state)[0]?.curve;
    if (!curve) return;
    const marks = !curve.xs.length;
    const count = marks ? curve.markXs.length : curve.xs.length;
    focus.index = Math.min(Math.max(focus.index + by, 0), count - 1);
    show(state, box, pointText(state.figure, box.panel, { curve, index: focus.index, marks }));
  }

  /** A drawing that is made by `paint`, which is given a pen, a width and colours, and returns its height. */
  function sketch({ name, label, caption, paint, csv = null, width = 460 }) {
    const canvas = element("canvas", { role: "img", "aria-label": label });
    const holder = element("div", { class: "sketch", style: `max-width: ${width}px` }, canvas);
    const state = { redraw() {
      const across_ = Math.min(holder.clientWidth, width);
      if (!across_) return;
      const colour = palette(false);
      const height = paint(canvasPen(document.createElement("canvas").getContext("2d")), across_, colour);
      Object.assign(canvas, { width: across_ * devicePixelRatio, height: height * devicePixelRatio });
      Object.assign(canvas.style, { width: `${across_}px`, height: `${height}px` });
      const context = canvas.getContext("2d");
      context.scale(devicePixelRatio, devicePixelRatio);
      paint(canvasPen(context), across_, colour);
    } };
    sketches.push(state);
    watch(holder, state.redraw);
    return { holder, canvas, redraw: state.redraw, figure: element("figure", { style: `max-width: ${width}px` }, holder, caption && element("figcaption", {}, caption, saveButtons(name, paint, csv))) };
  }

  const sketches = [];
  const redrawAll = () => { redraw(); sketches.forEach((entry) => entry.redraw()); };

  // what a closed section hides has no size until it is opened
  document.addEventListener("toggle", () => {
    all.filter(({ holder, width }) => holder.clientWidth !== width).forEach(redrawOne);
    sketches.forEach((entry) => entry.redraw());
  }, true);

  /** Buttons that save what `figure` tells when they are pressed, in the form of a figure that was read. */
  const saving = (name, figure) => saveButtons(name, (pen, width, colour) => draw(pen, figure(), width, colour, true).height, () => csvOf(figure()));

  /** A colour of the map, of a part from 0 to 1. */
  const shade = (part) => `#${graded(part).map((v) => v.toString(16).padStart(2, "0")).join("")}`;

  return { add, sketch, shade, saving, palette, redraw: redrawAll, all: () => all.map(({ figure }) => figure), tellRuns: (tell) => { runText = tell; } };
})();
