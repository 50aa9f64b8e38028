
/** Figures as they are described: their colours, axes and places, drawn by a pen. The SVG files of a folder have the same rules. */
const drawing = (() => {
  const { floats, places, bytes } = page;
  const { widthOf } = pens;

  // Colours.

  /** The colour map viridis in five anchors. */
  function graded(part) {
    const anchors = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [215, 205, 40]];
    const place = Math.min(Math.max(part, 0), 1) * (anchors.length - 1);
    const below = Math.min(Math.floor(place), anchors.length - 2);
    return anchors[below].map((v, k) => Math.round(v + (place - below) * (anchors[below + 1][k] - v)));
  }

  /** A colour of the map, of a part from 0 to 1. */
  const shade = (part) => `#${graded(part).map((v) => v.toString(16).padStart(2, "0")).join("")}`;

  const dark = matchMedia("(prefers-color-scheme: dark)");
  const isPrinted = () => document.documentElement.classList.contains("printed");
  /** Where a part of the map is seen on the screen: its dark end not on dark paper. */
  const seen = (part, onPaper) => (dark.matches && !onPaper ? 0.25 + 0.75 * part : part);
  /** The variable of the style that holds a colour of a figure. */
  const variable = (name) => (name === "grey" ? "--quiet" : `--${name.replace(/^--/, "")}`);

  /** Finds the colours of figures and of the page, those of the screen or of white paper. */
  function palette(onPaper = isPrinted()) {
    const root = document.documentElement;
    const was = isPrinted();
    root.classList.toggle("printed", onPaper);
    const style = getComputedStyle(root);
    const names = ["--paper", "--ink", "--quiet", "--line", "--panel", "--c0", "--c1", "--c2", "--c3", "--c4", "--c5"];
    const known = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(name).trim()]));
    root.classList.toggle("printed", was);
    return (name) => {
      if (typeof name === "number") return shade(seen(name, onPaper));
      return name === "white" ? "#ffffff" : known[variable(name)] ?? name;
    };
  }

  /** A colour as a style of an element has it. */
  const css = (name) => (typeof name === "number" ? shade(seen(name, isPrinted())) : `var(${variable(name)})`);

  // Data.

  /** A figure of the data of the page, ready to be drawn. */
  function read(figure) {
    const panels = figure.panels.map((panel) => ({
      ...panel,
      curves: readCurves(panel.curves),
      cells: panel.cells && readCells(panel.cells),
      map: panel.map && readMap(panel.map),
      view: { x: [...panel.x.ends], y: [...panel.y.ends] },
    }));
    return { ...figure, panels };
  }

  /** Curves; one without abscissas stands over those of the curve before it. */
  function readCurves(curves) {
    let xs = [];
    return curves.map((curve) => {
      if (curve.abscissas !== null) xs = places(curve.abscissas);
      const ys = floats(curve.values);
      const [markXs, markYs] = curve.marks ? [places(curve.marks[0]), floats(curve.marks[1])] : [xs, ys];
      const [low, high] = (curve.band ?? []).map(floats);
      return { ...curve, xs, ys, markXs, markYs, band: low && { low, high }, pointsAreMarked: !curve.marks,
        runs: curve.runs && floats(curve.runs), hidden: false };
    });
  }

  function readCells(cells) {
    const numbers = Object.fromEntries(["left", "right", "top", "bottom", "values"].map((key) => [key, floats(cells[key])]));
    return { ...numbers, colours: cells.colours, runs: cells.runs && floats(cells.runs) };
  }

  function readMap(map) {
    const levels = new Uint8Array(bytes(map.levels));
    const height = levels.length / map.width;
    const pixels = new Uint8ClampedArray(4 * levels.length);
    levels.forEach((level, k) => pixels.set([...graded(level / 255), 255], 4 * k));
    return { ...map, levels, height, picture: { width: map.width, height, pixels } };
  }

  // Axes.

  const labelOf = ({ quantity, unit }) => (unit ? `${quantity} in ${unit}` : quantity);
  const isSame = (a, b) => labelOf(a) === labelOf(b) && String([a.ends, a.reach]) === String([b.ends, b.reach]);
  /** Where a value stands on an axis: itself, or its decimal logarithm. */
  const place = (axis, value) => (!axis.logarithmic ? value : value > 0 ? Math.log10(value) : axis.ends[0]);

  const digitsOf = (value) => Math.floor(Math.log10(value) + 1e-9);
  const powerOf = (exponent) => `10${[...String(exponent)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("")}`;

  /** The least of 1, 2, 5 times a power of ten that is not below `rough`. */
  function roundStep(rough) {
    const power = 10 ** Math.floor(Math.log10(rough));
    return [1, 2, 5].map((m) => m * power).find((step) => step >= 0.999 * rough) ?? 10 * power;
  }

  /** About `most` ticks between two places of an axis: where they stand, and their texts; of names all. */
  function ticks(axis, [from, to], most) {
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    const span = high - low;
    if (!(span > 0)) return [];
    if (axis.texts.length) return axis.texts.map((text, k) => ({ at: k + 0.5, text })).filter(({ at }) => at > low && at < high);
    if (!axis.logarithmic) {
      const rough = span / most;
      if (axis.unit === "deg" && rough > 20) return even(low, high, rough <= 45 ? 45 : 90 * Math.ceil(rough / 90));
      const found = even(low, high, roundStep(rough));
      // one number tells no scale
      return found.length > 1 ? found : even(low, high, roundStep(rough / 2));
    }
    const fine = [];
    for (let decade = Math.floor(low); decade <= high; decade += 1) fine.push(...[1, 2, 5].map((m) => decade + Math.log10(m)));
    const within = fine.filter((at) => at >= low - 1e-9 && at <= high + 1e-9);
    if (span < 2 && within.length >= 2 && within.length <= most) return within.map((at) => ({ at, text: valueText(10 ** at) }));
    if (span >= 1) return even(low, high, Math.ceil(span / most)).map(({ at }) => ({ at, text: powerOf(Math.round(at)) }));
    return even(10 ** low, 10 ** high, roundStep((10 ** high - 10 ** low) / most)).map(({ at, text }) => ({ at: Math.log10(at), text }));
  }

  /** Multiples of a step between two ends, with as many digits as tell them apart. */
  function even(low, high, step) {
    const largest = Math.max(Math.abs(low), Math.abs(high));
    const text = (value) => {
      if (value === 0) return "0";
      // values from a tenth on without powers of ten, however close they are
      if (largest < 1e6 && (step >= 0.999e-4 || largest >= 0.1)) return value.toFixed(Math.max(0, -digitsOf(step)));
      const digits = Math.min(Math.max(digitsOf(Math.abs(value)) - digitsOf(step), 0), 12);
      return value.toExponential(digits).replace("e+", "e");
    };
    const found = [];
    for (let k = Math.ceil(low / step - 1e-9); k <= Math.floor(high / step + 1e-9) && found.length < 60; k += 1) {
      found.push({ at: k * step, text: text(k * step) });
    }
    return found;
  }

  function valueText(value) {
    const rounded = Number(value.toPrecision(4));
    return rounded >= 1e-2 && rounded < 1e4 ? String(rounded) : rounded.toExponential().replace("e+", "e");
  }

  // Texts.

  const SIZE = 12;
  const LINE = 16;

  /** A text that is no wider than `most`: what is too much is cut off. */
  function shortened(text, size, most) {
    if (widthOf(text, size) <= most) return text;
    let kept = text;
    while (kept && widthOf(`${kept}…`, size) > most) kept = kept.slice(0, -1);
    return `${kept.trimEnd()}…`;
  }

  /** A text in lines that are no wider than `most`. */
  function wrapped(text, size, most) {
    const lines = [];
    for (const word of text.split(/\s+/).filter(Boolean)) {
      const longer = `${lines.at(-1)} ${word}`;
      if (lines.length && widthOf(longer, size) <= most) lines[lines.length - 1] = longer;
      else lines.push(shortened(word, size, most));
    }
    return lines;
  }

  /** The middle of a text that keeps within two ends. */
  const inside = (at, half, [from, to]) => Math.max(Math.min(at, to - half - 2), from + half + 2);
  const covers = (text, others) => others.some((other) => Math.abs(other.x - text.x) < other.half + text.half + 4 && Math.abs(other.y - text.y) < 15);

  // Places.

  const [COLUMN, MARGIN, BAR, HIGHEST, MOST_PEAKS] = [230, 14, 74, 460, 10];
  const stepsUp = (height) => Math.max(2, Math.floor(height / 34));

  /** Places of all panels in a width, and the height of all. */
  function layout({ panels, columns: most }, width) {
    const columns = Math.max(1, Math.min(most, Math.floor(width / COLUMN)));
    const namesRows = (index) => index % columns === 0 || !isSame(panels[index].y, panels[index - 1].y)
      || String(panels[index].y.texts) !== String(panels[index - 1].y.texts);
    const leftRoom = (panel, index) => {
      if (panel.y.texts.length && !namesRows(index)) return MARGIN;
      const texts = ticks(panel.y, panel.view.y, stepsUp(panel.aspect ? HIGHEST : panel.height)).map(({ text }) => widthOf(text, SIZE));
      return Math.min(Math.max(20, ...texts) + 14, (0.55 * width) / columns);
    };
    const rooms = (room) => Array.from({ length: columns }, (_, column) =>
      Math.max(0, ...panels.map(room).filter((_room, index) => index % columns === column)));
    const lefts = rooms(leftRoom);
    const rights = rooms((panel) => (panel.bar ? BAR : MARGIN));
    // plots side by side are equally wide
    const plotWidth = Math.max(40, (width - [...lefts, ...rights].reduce((a, b) => a + b, 0)) / columns);
    const boxes = [];
    let top = 0;
    for (let first = 0; first < panels.length; first += columns) {
      let left = 0;
      const row = panels.slice(first, first + columns).map((panel, column) => {
        const right = left + lefts[column] + plotWidth + rights[column];
        const box = { panel, column: [left, right], head: top, title: wrapped(panel.title, SIZE + 1, right - left - 8),
          strip: strip(panel.names, right - left), view: panel.view,
          plot: { left: left + lefts[column], width: plotWidth, height: Math.max(60, panel.height) },
          namesX: !(panels[first + column + columns] && isSame(panels[first + column + columns].x, panel.x)),
          namesRows: namesRows(first + column) };
        left = right;
        return box;
      });
      const above = Math.max(...row.map(({ panel, title, strip: names }) => LINE * title.length + names.height + (panel.y.texts.length ? 0 : LINE) + 12));
      for (const box of row) {
        box.plot.top = top + above;
        if (box.panel.aspect) keepAspect(box);
      }
      top = Math.max(...row.map(({ plot, namesX }) => plot.top + plot.height + LINE + (namesX ? LINE + 12 : 8)));
      boxes.push(...row);
    }
    return { boxes, height: top };
  }

  /** Gives a plot the height of its aspect; as much is shown across as is upwards. */
  function keepAspect(box) {
    const { panel: { aspect, x, y, view }, plot } = box;
    plot.height = Math.min((plot.width * aspect * (y.ends[1] - y.ends[0])) / (x.ends[1] - x.ends[0]), HIGHEST);
    const half = (aspect * (view.y[1] - view.y[0]) * plot.width) / plot.height / 2;
    const middle = (view.x[0] + view.x[1]) / 2;
    box.view = { x: [middle - half, middle + half], y: view.y };
  }

  /** Names side by side, in rows. */
  function strip(names, width) {
    let [left, top] = [0, 0];
    const placed = names.map((name) => {
      const text = shortened(name.text, SIZE, width - 42);
      const room = widthOf(text, SIZE) + 42;
      if (left > 0 && left + room > width) [left, top] = [0, top + LINE + 2];
      const found = { ...name, text, left, top };
      left += room;
      return found;
    });
    return { placed, height: names.length ? top + LINE + 6 : 0 };
  }

  const across = ({ panel, plot, view }, x) => plot.left + ((place(panel.x, x) - view.x[0]) / (view.x[1] - view.x[0])) * plot.width;
  const upwards = ({ panel, plot, view }, y) => plot.top + ((view.y[1] - place(panel.y, y)) / (view.y[1] - view.y[0])) * plot.height;

  /** Ticks below a plot, as many as their texts leave room for. */
  function ticksBelow({ panel, plot, view, column }) {
    const placed = ({ at, text }) => {
      const [x, half] = [plot.left + ((at - view.x[0]) / (view.x[1] - view.x[0])) * plot.width, widthOf(text, SIZE) / 2];
      return { at: x, text, x: inside(x, half, column), half };
    };
    for (let most = Math.max(2, Math.floor(plot.width / 50)); most > 0; most -= 1) {
      const tried = ticks(panel.x, view.x, most).map(placed);
      if (tried.every((tick, k) => k === 0 || tick.x - tried[k - 1].x >= tick.half + tried[k - 1].half + 8)) return tried;
    }
    return [];
  }

  /** The labels of a panel inside its plot; one that would cover another stands above or below it. */
  function labels(box) {
    const { panel, plot } = box;
    const placed = [];
    for (const [[px, py], whole, colour] of panel.labels) {
      const text = shortened(whole, SIZE - 1, plot.width - 8);
      const half = widthOf(text, SIZE - 1) / 2;
      const x = inside(across(box, px) + 3 + half, half, [plot.left, plot.left + plot.width]);
      const tried = [0, 1, -1, 2, -2, 3, -3, 4, -4].map((step) => ({ text, colour, x, y: upwards(box, py) + 10 + 15 * step, half }));
      const free = tried.find((label) => label.y - 10 >= plot.top && label.y + 3 <= plot.top + plot.height && !covers(label, placed));
      if (free) placed.push(free);
    }
    return placed;
  }

  /** The peaks that a plot shows; a name that would cover a label or one before it stands higher, or is left out where there is no room either. */
  function peaks(box) {
    const { panel, plot } = box;
    const ends = [plot.left, plot.left + plot.width];
    const taken = labels(box);
    const found = [];
    for (const [[px, py], text] of panel.peaks) {
      const [left, top, half] = [across(box, px), upwards(box, py), widthOf(text, SIZE) / 2];
      const isInside = left >= ends[0] && left <= ends[1] && top >= plot.top && top <= plot.top + plot.height;
      if (!isInside || found.length === MOST_PEAKS) continue;
      const tried = [6, 21, 36].map((above) => ({ left, top, text, x: inside(left, half, ends), y: Math.max(top - above, plot.top + 11), half }));
      const peak = tried.find((place) => !covers(place, taken));
      if (!peak) continue;
      taken.push(peak);
      found.push(peak);
    }
    return found;
  }

  // Drawing.

  function drawStrip(pen, { placed }, left, top, colour) {
    for (const name of placed) {
      const [x, y] = [left + 14 + name.left, top + 12 + name.top];
      pen.line([x, y, x + 18, y], colour(name.colour), name.mark ? 1.4 : 3);
      if (name.mark) drawMark(pen, name.mark, x + 9, y, colour(name.colour));
      pen.text(name.text, x + 23, y + 4, { colour: colour("--ink"), size: SIZE });
    }
  }

  /** Draws a figure and returns its places and its height. */
  function draw(pen, figure, width, colour, withNames) {
    const names = strip(withNames ? figure.names : [], width);
    drawStrip(pen, names, 0, 0, colour);
    const { boxes, height } = layout(figure, width);
    for (const box of boxes) {
      box.plot.top += names.height;
      box.head += names.height;
      drawPanel(pen, box, colour);
    }
    return { boxes, height: names.height + height };
  }

  function drawPanel(pen, box, colour) {
    const { panel, plot, head } = box;
    const ink = colour("--ink");
    box.title.forEach((line, k) => {
      const x = inside(plot.left + plot.width / 2, widthOf(line, SIZE + 1) / 2, box.column);
      pen.text(line, x, head + LINE * (k + 1), { colour: ink, size: SIZE + 1, align: "middle" });
    });
    drawStrip(pen, box.strip, box.column[0], head + LINE * box.title.length + 2, colour);
    drawAxes(pen, box, colour);
    pen.clip(plot.left, plot.top, plot.width, plot.height);
    if (panel.map) drawMap(pen, box);
    if (panel.cells) drawCells(pen, box, colour);
    for (const curve of panel.curves) if (!curve.hidden) drawCurve(pen, box, curve, colour);
    for (const label of labels(box)) pen.text(label.text, label.x, label.y, { colour: colour(label.colour), size: SIZE - 1, align: "middle" });
    for (const peak of peaks(box)) {
      pen.circle(peak.left, peak.top, 2, ink);
      pen.text(peak.text, peak.x, peak.y, { colour: ink, size: SIZE, align: "middle" });
    }
    pen.unclip();
    if (panel.bar) drawBar(pen, box, colour);
  }

  function drawAxes(pen, box, colour) {
    const { panel, plot, view, column: [from, to] } = box;
    const [ink, line] = [colour("--ink"), colour("--line")];
    const [right, bottom] = [plot.left + plot.width, plot.top + plot.height];
    for (const tick of ticksBelow(box)) {
      pen.line([tick.at, plot.top, tick.at, bottom], line);
      pen.text(tick.text, tick.x, bottom + LINE, { colour: ink, size: SIZE, align: "middle" });
    }
    for (const { at, text } of ticks(panel.y, view.y, stepsUp(plot.height))) {
      const y = plot.top + ((view.y[1] - at) / (view.y[1] - view.y[0])) * plot.height;
      pen.line([plot.left, y, right, y], line);
      const shown = box.namesRows || !panel.y.texts.length ? shortened(text, SIZE, plot.left - from - 8) : "";
      pen.text(shown, plot.left - 6, y + 4, { colour: ink, size: SIZE, align: "end" });
    }
    pen.line([plot.left, plot.top, plot.left, bottom, right, bottom], colour("--quiet"));
    if (box.namesX) {
      const name = shortened(labelOf(panel.x), SIZE, to - from - 4);
      pen.text(name, inside(plot.left + plot.width / 2, widthOf(name, SIZE) / 2, [from, to]), bottom + 2 * LINE + 2, { colour: ink, size: SIZE, align: "middle" });
    }
    const room = panel.bar ? (to - from) / 2 - 10 : to - from - 6;
    pen.text(shortened(labelOf(panel.y), SIZE, room), from + 6, plot.top - 10, { colour: ink, size: SIZE });
    if (panel.bar) pen.text(shortened(labelOf(panel.bar), SIZE, room), to - 4, plot.top - 10, { colour: ink, size: SIZE, align: "end" });
  }

  function drawCurve(pen, box, curve, colour) {
    const shade_ = colour(curve.colour);
    const xs = (values) => values.map((x) => across(box, x) + curve.beside);
    const ys = (values) => values.map((y) => (y === null ? NaN : upwards(box, y)));
    const at = xs(curve.xs);
    if (curve.band) drawBand(pen, at, ys(curve.band.low), ys(curve.band.high), shade_);
    const up = ys(curve.ys);
    pen.line(at.flatMap((x, k) => [x, up[k]]), shade_, curve.fine ? 0.8 : 1.4);
    const [markXs, markYs] = curve.pointsAreMarked ? [at, up] : [xs(curve.markXs), ys(curve.markYs)];
    markXs.forEach((x, k) => drawMark(pen, curve.mark, x, markYs[k], shade_));
  }

  /** Areas between lowest and highest values, as far as these are known without a gap. */
  function drawBand(pen, at, low, high, colour) {
    let run = [];
    const close = () => {
      if (run.length > 1) pen.area([...run.flatMap((k) => [at[k], high[k]]), ...run.reverse().flatMap((k) => [at[k], low[k]])], colour, 0.35);
      run = [];
    };
    at.forEach((_, k) => { if (Number.isFinite(low[k])) run.push(k); else close(); });
    close();
  }

  function drawMark(pen, mark, x, y, colour) {
    if (mark === "spot") pen.rectangle(x - 1, y - 1, 2, 2, colour);
    else if (mark === "triangle") pen.area([x - 5, y + 4, x + 5, y + 4, x, y - 5], colour);
    else pen.circle(x, y, mark === "disc" ? 5 : 2.6, colour);
  }

  function drawCells(pen, box, colour) {
    const { left, right, top, bottom, colours } = box.panel.cells;
    left.forEach((_, k) => {
      const [x0, x1] = [across(box, left[k]), across(box, right[k])];
      const [y0, y1] = [upwards(box, top[k]), upwards(box, bottom[k])];
      const fill = typeof colours[k] === "number" ? shade(colours[k]) : colour(colours[k]);
      pen.rectangle(Math.min(x0, x1), Math.min(y0, y1), Math.abs(x1 - x0) + 0.3, Math.abs(y1 - y0) + 0.3, fill);
    });
  }

  function drawMap(pen, box) {
    const { x, y, map } = box.panel;
    const [left, right] = x.ends.map((end) => across(box, end));
    const [bottom, top] = y.ends.map((end) => upwards(box, end));
    pen.picture(map.picture, left, top, right - left, bottom - top);
  }

  /** All colours from below to above beside a plot. */
  function drawBar(pen, { panel: { bar }, plot }, colour) {
    const left = plot.left + plot.width + 10;
    const pixels = new Uint8ClampedArray(4 * 256);
    for (let k = 0; k < 256; k += 1) pixels.set([...graded((255 - k) / 255), 255], 4 * k);
    pen.picture({ width: 1, height: 256, pixels }, left, plot.top, 12, plot.height);
    for (const tick of ticks(bar, bar.ends, stepsUp(plot.height))) {
      const y = plot.top + plot.height * (1 - (tick.at - bar.ends[0]) / (bar.ends[1] - bar.ends[0]));
      pen.text(tick.text, left + 16, y + 4, { colour: colour("--ink"), size: SIZE - 1 });
    }
  }

  return { read, draw, palette, shade, css, dark, isPrinted, labelOf, isSame, place, across, upwards };
})();
