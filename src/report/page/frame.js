
"use strict";
/** What every page has: its data, the elements it is made of, how numbers are written. */
const page = (() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const main = document.querySelector("main");

  // Elements.

  function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...children.filter((child) => child !== null));
    return made;
  }

  function section(id, title, ...children) {
    const made = element("section", { id }, element("h2", {}, title), ...children);
    main.append(made);
    document.querySelector("nav").append(element("a", { href: `#${id}` }, title));
    return made;
  }

  /** A section that is opened by whoever asks for it. */
  function folded(id, title, ...children) {
    const body = element("details", {}, element("summary", {}, element("h2", {}, title)), ...children);
    main.append(element("section", { id }, body));
    const link = element("a", { href: `#${id}` }, title);
    link.addEventListener("click", () => { body.open = true; });
    document.querySelector("nav").append(link);
    if (location.hash === `#${id}`) body.open = true;
  }

  function table(heads, rows, caption = null) {
    const cell = (tag) => (text, column) =>
      element(tag, column === 0 ? { class: "name" } : {}, text);
    const head = element("thead", {}, element("tr", {}, ...heads.map(cell("th"))));
    const body = element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map(cell("td")))));
    const made = element("div", { class: "scroll" }, element("table", {}, head, body));
    return element("figure", {}, made, caption && element("figcaption", {}, caption));
  }

  const warnings = (texts) => texts.map((text) => element("p", { class: "warning" }, text));

  // Numbers.

  function number(value, digits = 5) {
    if (value === null || value === undefined) return "–";
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (Number.isInteger(value) && size < 10 ** digits) return String(value);
    if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits)));
    return value.toExponential(digits - 2);
  }

  // Data in base64.

  const bytes = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;
  const places = (base64) => Array.from(new Float64Array(bytes(base64)));
  /** Values; null where there is none. */
  const floats = (base64) => Array.from(new Float32Array(bytes(base64)), (v) => (Number.isNaN(v) ? null : v));

  /** The page stands: paper is light whatever the screen is. */
  function ready(redraw = () => {}) {
    const all = () => [...document.querySelectorAll("section > details")];
    const open = [];
    const isJson = (body) => body.querySelector(":scope > pre") !== null;
    const printed = (on) => () => {
      // on paper everything but what stands in the document is open
      if (on) open.splice(0, open.length, ...all().filter((body) => body.open));
      for (const body of all()) body.open = on ? !isJson(body) : open.includes(body);
      document.documentElement.classList.toggle("printed", on);
      redraw();
    };
    addEventListener("beforeprint", printed(true));
    addEventListener("afterprint", printed(false));
    document.documentElement.dataset.readyMs = String(Math.round(performance.now()));
  }

  return { data, element, section, folded, table, warnings, number, bytes, places, floats, ready };
})();
