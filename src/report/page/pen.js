
/** Pens make the same strokes on a canvas and as SVG. Lengths are CSS pixels, y counts downwards, colours are #rrggbb. */
const pens = (() => {
  const FONT = "Helvetica, Arial, sans-serif";
  const scratch = document.createElement("canvas").getContext("2d");

  function widthOf(text, size) {
    scratch.font = `${size}px ${FONT}`;
    return scratch.measureText(text).width;
  }

  /** A picture of RGBA pixels as a canvas. */
  function canvasOf({ width, height, pixels }) {
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width, height });
    canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);
    return canvas;
  }

  /** Runs of points without a gap, each as a list of x and y in turn. */
  function* strokes(points) {
    let run = [];
    for (let k = 0; k < points.length; k += 2) {
      if (Number.isFinite(points[k]) && Number.isFinite(points[k + 1])) run.push(points[k], points[k + 1]);
      else if (run.length) { yield run; run = []; }
    }
    if (run.length) yield run;
  }

  function canvasPen(context) {
    const trace = (run) => {
      context.moveTo(run[0], run[1]);
      for (let k = 2; k < run.length; k += 2) context.lineTo(run[k], run[k + 1]);
    };
    return {
      line(points, colour, width = 1, dashes = []) {
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.setLineDash(dashes);
        context.lineJoin = "round";
        context.beginPath();
        for (const run of strokes(points)) trace(run);
        context.stroke();
        context.setLineDash([]);
      },
      area(points, colour, opacity = 1) {
        context.globalAlpha = opacity;
        context.fillStyle = colour;
        context.beginPath();
        trace(points);
        context.fill();
        context.globalAlpha = 1;
      },
      rectangle(x, y, width, height, colour) {
        context.fillStyle = colour;
        context.fillRect(x, y, width, height);
      },
      circle(x, y, radius, fill, edge = null) {
        context.beginPath();
        context.arc(x, y, radius, 0, 2 * Math.PI);
        if (fill) { context.fillStyle = fill; context.fill(); }
        if (edge) { context.strokeStyle = edge; context.lineWidth = 1; context.stroke(); }
      },
      text(text, x, y, { size = 12, colour, align = "start" }) {
        context.font = `${size}px ${FONT}`;
        context.fillStyle = colour;
        context.textAlign = align === "middle" ? "center" : align;
        context.fillText(text, x, y);
      },
      picture(picture, x, y, width, height) {
        context.imageSmoothingEnabled = false;
        context.drawImage(canvasOf(picture), x, y, width, height);
      },
      clip(x, y, width, height) {
        context.save();
        context.beginPath();
        context.rect(x, y, width, height);
        context.clip();
      },
      unclip: () => context.restore(),
    };
  }

  const short = (value) => String(Math.round(value * 100) / 100);

  /** A pen whose `finish` gives the text of an SVG document. */
  function svgPen(width, height) {
    const parts = [];
    const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
    const path = (run) => run.map((v, k) => `${k % 2 ? " " : k ? "L" : "M"}${short(v)}`).join("");
    return {
      line(points, colour, thickness = 1, dashes = []) {
        const d = [...strokes(points)].map(path).join("");
        const dashed = dashes.length ? ` stroke-dasharray="${dashes.join(" ")}"` : "";
        if (d) parts.push(`<path d="${d}" fill="none" stroke="${colour}" stroke-width="${thickness}" stroke-linejoin="round"${dashed}/>`);
      },
      area: (points, colour, opacity = 1) =>
        parts.push(`<path d="${path(points)}Z" fill="${colour}" fill-opacity="${opacity}"/>`),
      rectangle: (x, y, w, h, colour) =>
        parts.push(`<rect x="${short(x)}" y="${short(y)}" width="${short(w)}" height="${short(h)}" fill="${colour}"/>`),
      circle: (x, y, radius, fill, edge = null) =>
        parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" fill="${fill ?? "none"}" stroke="${edge ?? "none"}"/>`),
      text: (text, x, y, { size = 12, colour, align = "start" }) =>
        parts.push(`<text x="${short(x)}" y="${short(y)}" font-size="${size}" fill="${colour}" text-anchor="${align}">${escaped(text)}</text>`),
      picture: (picture, x, y, w, h) => parts.push(`<image x="${short(x)}" y="${short(y)}" width="${short(w)}" height="${short(h)}" `
        + `preserveAspectRatio="none" style="image-rendering:pixelated" href="${canvasOf(picture).toDataURL()}"/>`),
      // an inner picture shows nothing beyond its edges
      clip(x, y, w, h) {
        const [left, top, across, down] = [x, y, w, h].map(short);
        parts.push(`<svg x="${left}" y="${top}" width="${across}" height="${down}" viewBox="${left} ${top} ${across} ${down}">`);
      },
      unclip: () => parts.push("</svg>"),
      finish: () => `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" `
        + `font-family="${FONT}"><rect width="100%" height="100%" fill="#ffffff"/>${parts.join("\n")}</svg>\n`,
    };
  }

  return { canvasPen, svgPen, widthOf };
})();
