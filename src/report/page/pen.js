
/** Pens make the same strokes on a canvas, as SVG and as PDF. Lengths are CSS pixels, y counts downwards, colours are #rrggbb. */
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
      text(text, x, y, { size = 12, colour, align = "start", upright = false }) {
        context.save();
        context.translate(x, y);
        if (upright) context.rotate(-Math.PI / 2);
        context.font = `${size}px ${FONT}`;
        context.fillStyle = colour;
        context.textAlign = align === "middle" ? "center" : align;
        context.fillText(text, 0, 0);
        context.restore();
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

  /** A pen whose `finish` gives an SVG document. */
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
      text(text, x, y, { size = 12, colour, align = "start", upright = false }) {
        const turned = upright ? ` transform="rotate(-90 ${short(x)} ${short(y)})"` : "";
        parts.push(`<text x="${short(x)}" y="${short(y)}" font-size="${size}" fill="${colour}" text-anchor="${align}"${turned}>${escaped(text)}</text>`);
      },
      picture: (picture, x, y, w, h) => parts.push(`<image x="${short(x)}" y="${short(y)}" width="${short(w)}" height="${short(h)}" `
        + `preserveAspectRatio="none" style="image-rendering:pixelated" href="${canvasOf(picture).toDataURL()}"/>`),
      // an inner picture shows nothing beyond its edges
      clip(x, y, w, h) {
        const [left, top, across, down] = [x, y, w, h].map(short);
        parts.push(`<svg x="${left}" y="${top}" width="${across}" height="${down}" viewBox="${left} ${top} ${across} ${down}">`);
      },
      unclip: () => parts.push("</svg>"),
      finish: () => new Blob([`<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" `
        + `font-family="${FONT}"><rect width="100%" height="100%" fill="#ffffff"/>${parts.join("\n")}</svg>\n`], { type: "image/svg+xml" }),
    };
  }

  // PDF 1.4 (ISO 32000): one page, the two standard fonts Helvetica and Symbol, pictures as hexadecimal digits.

  /** Letters of the font Symbol; all others are those of Helvetica. */
  const symbols = { α: "a", β: "b", γ: "g", δ: "d", ζ: "z", θ: "q", κ: "k", λ: "l", π: "p", φ: "f", ψ: "y", ω: "w", Δ: "D", Σ: "S" };
  /** Letters beyond Latin-1 in the encoding of Windows, and those that are written otherwise. */
  const windows = { "–": "\x96", "—": "\x97", "…": "\x85", "−": "-", "₀": "0", "₁": "1", "₂": "2", "μ": "µ" };

  /** A pen whose `finish` gives a PDF document. */
  function pdfPen(width, height) {
    const POINTS = 0.75; // of a CSS pixel
    const content = [];
    const pictures = [];
    const up = (y) => short((height - y) * POINTS);
    const at = (x, y) => `${short(x * POINTS)} ${up(y)}`;
    const parts = (colour, opacity) => [1, 3, 5].map((k) => 1 - opacity * (1 - parseInt(colour.slice(k, k + 2), 16) / 255));
    const rgb = (colour, opacity = 1) => parts(colour, opacity).map((v) => v.toFixed(3)).join(" ");
    const path = (run) => Array.from({ length: run.length / 2 }, (_, k) => `${at(run[2 * k], run[2 * k + 1])} ${k ? "l" : "m"}`).join("\n");
    const literal = (text) => `(${text.replace(/[\\()]/g, "\\$&")})`;
    /** Stretches of text of one font. */
    function* stretches(text) {
      let [font, run] = ["F1", ""];
      for (const letter of text) {
        const next = letter in symbols ? "F2" : "F1";
        if (next !== font && run) { yield [font, run]; run = ""; }
        font = next;
        const known = symbols[letter] ?? windows[letter] ?? letter;
        run += known.charCodeAt(0) < 256 ? known : "?";
      }
      if (run) yield [font, run];
    }
    const circle = (x, y, r) => {
      const k = 0.5523 * r; // a quarter of a circle as a Bézier curve
      return `${at(x + r, y)} m ${at(x + r, y + k)} ${at(x + k, y + r)} ${at(x, y + r)} c ${at(x - k, y + r)} ${at(x - r, y + k)} ${at(x - r, y)} c `
        + `${at(x - r, y - k)} ${at(x - k, y - r)} ${at(x, y - r)} c ${at(x + k, y - r)} ${at(x + r, y - k)} ${at(x + r, y)} c`;
    };
    return {
      line(points, colour, thickness = 1, dashes = []) {
        const d = [...strokes(points)].map(path).join("\n");
        if (d) content.push(`${rgb(colour)} RG ${short(thickness * POINTS)} w 1 j [${dashes.map((v) => v * POINTS).join(" ")}] 0 d\n${d}\nS`);
      },
      area: (points, colour, opacity = 1) => content.push(`${rgb(colour, opacity)} rg\n${path(points)}\nf`),
      rectangle: (x, y, w, h, colour) =>
        content.push(`${rgb(colour)} rg ${at(x, y + h)} ${short(w * POINTS)} ${short(h * POINTS)} re f`),
      circle(x, y, radius, fill, edge = null) {
        const paint = fill && edge ? "B" : fill ? "f" : "S";
        content.push(`${fill ? `${rgb(fill)} rg ` : ""}${edge ? `${rgb(edge)} RG 0.75 w [] 0 d ` : ""}${circle(x, y, radius)} ${paint}`);
      },
      text(text, x, y, { size = 12, colour, align = "start", upright = false }) {
        const back = widthOf(text, size) * { start: 0, middle: 0.5, end: 1 }[align];
        const [left, low] = upright ? [x, y + back] : [x - back, y];
        const turn = upright ? "0 1 -1 0" : "1 0 0 1";
        const shown = [...stretches(text)].map(([font, run]) => `/${font} ${short(size * POINTS)} Tf ${literal(run)} Tj`);
        content.push(`BT ${rgb(colour)} rg ${turn} ${at(left, low)} Tm ${shown.join(" ")} ET`);
      },
      picture(picture, x, y, w, h) {
        pictures.push(picture);
        content.push(`q ${short(w * POINTS)} 0 0 ${short(h * POINTS)} ${at(x, y + h)} cm /P${pictures.length} Do Q`);
      },
      clip: (x, y, w, h) => content.push(`q ${at(x, y + h)} ${short(w * POINTS)} ${short(h * POINTS)} re W n`),
      unclip: () => content.push("Q"),
      finish() {
        const stream = (head, body) => `<< ${head} /Length ${body.length} >>\nstream\n${body}\nendstream`;
        const digits = ({ pixels }) => {
          let text = "";
          for (let k = 0; k < pixels.length; k += 4) for (let c = k; c < k + 3; c += 1) text += pixels[c].toString(16).padStart(2, "0");
          return `${text}>`;
        };
        const image = (picture) => stream(`/Type /XObject /Subtype /Image /Width ${picture.width} /Height ${picture.height} `
          + "/ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /ASCIIHexDecode", digits(picture));
        const named = pictures.map((_, k) => `/P${k + 1} ${7 + k} 0 R`).join(" ");
        const objects = [
          "<< /Type /Catalog /Pages 2 0 R >>",
          "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
          `<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ${short(width * POINTS)} ${short(height * POINTS)}] /Contents 4 0 R `
            + `/Resources << /Font << /F1 5 0 R /F2 6 0 R >> /XObject << ${named} >> >> >>`,
          stream("", content.join("\n")),
          "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
          "<< /Type /Font /Subtype /Type1 /BaseFont /Symbol >>",
          ...pictures.map(image),
        ];
        let text = "%PDF-1.4\n";
        const places = objects.map((object, k) => {
          const place = text.length;
          text += `${k + 1} 0 obj\n${object}\nendobj\n`;
          return place;
        });
        const table = text.length;
        text += `xref\n0 ${objects.length + 1}\n0000000000 65535 f \n${places.map((place) => `${String(place).padStart(10, "0")} 00000 n \n`).join("")}`
          + `trailer\n<< /Size ${objects.length + 1} /Root 1 0 R >>\nstartxref\n${table}\n%%EOF\n`;
        return new Blob([Uint8Array.from(text, (c) => c.charCodeAt(0))], { type: "application/pdf" });
      },
    };
  }

  return { canvasPen, svgPen, pdfPen, widthOf };
})();
