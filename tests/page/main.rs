//! `report.html` as a browser on a desk without network meets it.
//!
//! What needs a browser is skipped with a word where no Chromium is installed.

mod manual;
#[path = "../command/support/mod.rs"]
#[allow(dead_code)] // the tests of the command use the rest
mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread;

use tempfile::TempDir;

use support::{changed, column, done, json, scenarios, shipped, told, toml_files, verb};

/// Largest size of a page, bytes.
const LARGEST: u64 = 3_000_000;
/// Longest time from opening a page until it can be read, ms.
const LONGEST: f64 = 2000.0;

/// A folder with the page of a scenario that is run for it.
struct Shown {
    folder: TempDir,
    page: PathBuf,
}

/// The output of a verb for one file, and where its page is to be.
fn shown(name: &str, file: &Path, more: &[&str]) -> (Output, Shown) {
    let folder = TempDir::new().expect("a folder");
    let output = verb(name, &[file], folder.path(), more).output();
    let stem = file.file_stem().expect("a stem");
    let page = match name {
        "run" | "study" => "report.html".to_owned(),
        "steady" if more.contains(&"--over") => "response.html".to_owned(),
        other => format!("{other}.html"),
    };
    let page = folder.path().join(stem).join(page);
    (output.expect("the command starts"), Shown { folder, page })
}

fn run(scenario: &Path) -> Shown {
    let (output, shown) = shown("run", scenario, &["--no-verify"]);
    done(output);
    shown
}

/// A folder with the page of a study that is made for it.
fn study(file: &Path) -> Shown {
    let (output, shown) = shown("study", file, &[]);
    // a study with failed runs has its page as well
    assert!(output.status.code() != Some(2), "{}", told(&output));
    shown
}

fn shipped_study(name: &str) -> PathBuf {
    shipped(&format!("studies/{name}"))
}

impl Shown {
    fn text(&self) -> String {
        fs::read_to_string(&self.page).expect("the page")
    }

    /// The document once its scripts have run, and what the browser said meanwhile; `None` without a
    /// browser.
    fn in_browser(&self) -> Option<(String, String)> {
        self.opened(&self.page, &[])
    }

    /// The same of another file, which may look into the page, with further options of the browser.
    fn opened(&self, file: &Path, options: &[&str]) -> Option<(String, String)> {
        let chromium = ["chromium", "chromium-browser", "google-chrome"]
            .into_iter()
            .find(|name| Command::new(name).arg("--version").output().is_ok())?;
        let output = Command::new(chromium)
            .args([
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--allow-file-access-from-files",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--enable-logging=stderr",
                "--virtual-time-budget=10000",
                "--dump-dom",
            ])
            .args(options)
            .arg(format!(
                "--user-data-dir={}",
                self.folder.path().join("browser").display()
            ))
            .arg(format!("file://{}", file.display()))
            .output()
            .expect("the browser starts");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Some((text(&output.stdout), text(&output.stderr)))
    }
}

/// Loads of a page of which the fastest counts: others may keep the machine busy.
const LOADS: usize = 3;

/// The document of a page in a browser that had nothing to complain of.
fn document(shown: &Shown) -> Option<String> {
    let mut fastest = f64::INFINITY;
    for _ in 0..LOADS {
        let Some((document, told)) = shown.in_browser() else {
            eprintln!("skipped: no Chromium is installed");
            return None;
        };
        let complaints: Vec<_> = told
            .lines()
            .filter(|line| line.contains("CONSOLE"))
            .collect();
        assert!(complaints.is_empty(), "{complaints:#?}");
        fastest = fastest.min(ready_after(&document));
        if fastest < LONGEST {
            return Some(document);
        }
    }
    panic!("ready after {fastest} ms at best");
}

/// When the script of a document came to its end, ms.
fn ready_after(document: &str) -> f64 {
    let ready = document.split_once("data-ready-ms=\"");
    let ready = ready
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(ms, _)| ms);
    ready
        .expect("the script came to its end")
        .parse()
        .expect("a time")
}

/// Frames of 400 and 1280 px that open all of a page and tell how far it reaches beyond them.
const FRAMES: &str = r#"<iframe src="report.html" width="400" height="900"></iframe>
<iframe src="report.html" width="1280" height="900"></iframe><p id="told"></p><script>
const frames = [...document.querySelectorAll("iframe")];
addEventListener("load", () => {
  for (const { contentDocument: page } of frames) for (const body of page.querySelectorAll("details")) body.open = true;
  setTimeout(() => {
    const beyond = frames.map(({ contentDocument: page }) => page.documentElement.scrollWidth - page.documentElement.clientWidth);
    document.getElementById("told").textContent = `beyond by ${beyond.join(" and ")} px`;
  }, 1000);
});
</script>"#;

/// The pages of all shipped scenarios, all of them opened: nothing to complain of, nothing to scroll sideways.
#[test]
fn every_shipped_scenario_has_a_page_without_complaints() {
    let files = toml_files(&scenarios());
    let look = |part: usize| {
        for file in files.iter().skip(part).step_by(2) {
            looks_well(&run(file), file);
        }
    };
    // the longest of these tests by far: two scenarios at a time
    thread::scope(|scope| {
        scope.spawn(|| look(0));
        look(1);
    });
}

/// The same of every other verb that answers, on one scenario.
#[test]
fn every_verb_has_a_page_without_complaints() {
    let file = shipped("steady-7205c");
    let verbs: [(&str, &[&str]); 5] = [
        ("bearing", &[]),
        ("steady", &[]),
        (
            "steady",
            &[
                "--over",
                "speed.constant",
                "--from",
                "400 rad/s",
                "--to",
                "500 rad/s",
            ],
        ),
        ("campbell", &["--to", "60000 rpm"]),
        (
            "accuracy",
            &["--tolerances", "1e-5,1e-6", "--methods", "verner76"],
        ),
    ];
    for (verb, more) in verbs {
        let (output, shown) = shown(verb, &file, more);
        done(output);
        if let Some(document) = document(&shown) {
            let shown_text = document.split("<script").next().expect("a start");
            for sign in ["undefined", "NaN", "[object"] {
                assert!(!shown_text.contains(sign), "{verb}: {sign} is shown");
            }
            assert!(shown_text.contains("data-figure="), "{verb}");
        }
        looks_well(&shown, Path::new(verb));
    }
}

/// Opened at both widths a page complains of nothing and needs no scrolling sideways.
fn looks_well(shown: &Shown, name: &Path) {
    let frames = shown.page.with_file_name("frames.html");
    let page = shown.page.file_name().and_then(|name| name.to_str());
    let text = FRAMES.replace("report.html", page.expect("a name"));
    fs::write(&frames, text).expect("a written file");
    let Some((document, told)) = shown.opened(&frames, &[]) else {
        eprintln!("skipped: no Chromium is installed");
        return;
    };
    assert!(!told.contains("CONSOLE"), "{}: {told}", name.display());
    let beyond = document.contains(">beyond by 0 and 0 px<");
    let end = document.rsplit("</iframe>").next();
    assert!(beyond, "{}: {end:?}", name.display());
}

/// What a script finds once it has put a text into `document.documentElement.dataset.found`.
fn found(shown: &Shown, script: &str) -> Option<String> {
    let whole = format!("<script>{{ {script} }}</script></html>");
    let text = shown.text().replace("</html>", &whole);
    fs::write(&shown.page, text).expect("a writable folder");
    let document = document(shown)?;
    let (_, found) = document
        .split_once("data-found=\"")
        .expect("the script ran");
    let found = found.split_once('"').expect("an end").0;
    let signs = [
        ("&quot;", "\""),
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&amp;", "&"),
    ];
    let plain = |text: String, (sign, letter): (&str, &str)| text.replace(sign, letter);
    Some(signs.into_iter().fold(found.to_owned(), plain))
}

/// Catches what is saved, as text, in `saved`.
const CATCH: &str = r#"const saved = [];
    // what is saved can be read at once: the browser's virtual time does not wait for its files
    const Native = Blob;
    window.Blob = class extends Native {
      constructor(parts, options) {
        super(parts, options);
        const text = (part) => (typeof part === "string" ? part : new TextDecoder("latin1").decode(part));
        this.whole = parts.map(text).join("");
      }
      text() { return Promise.resolve(this.whole); }
      slice(start, end) { return new window.Blob([this.whole.slice(start, end)]); }
    };
    URL.createObjectURL = (blob) => { saved.push(blob); return "saved"; };
    HTMLAnchorElement.prototype.click = () => {};
    const press = (figure, name) => [...figure.querySelectorAll(".save button")].find((button) => button.textContent === name).click();
    const tell = (value) => { document.documentElement.dataset.found = JSON.stringify(value); };"#;

/// Zoomed into by the pointer, a figure shows the wave that the table has there: so says what it saves.
#[test]
fn a_figure_that_is_zoomed_shows_the_wave_of_its_table() {
    let (output, shown) = shown("steady", &shipped("steady-7205c"), &[]);
    done(output);
    let script = format!(
        r#"{CATCH}
        const figure = document.querySelector("[data-figure=steady_trace]");
        figure.closest("details").open = true;
        const over = figure.querySelector(".over");
        const at = (type, part) => {{
          const {{ left, top, width }} = over.getBoundingClientRect();
          over.dispatchEvent(new PointerEvent(type, {{ clientX: left + part * width, clientY: top + 60, button: 0, bubbles: true }}));
        }};
        setTimeout(() => {{
          at("pointerdown", 0.4); at("pointermove", 0.5); at("pointerup", 0.6);
          press(figure, "CSV");
          saved[0].text().then(tell);
        }}, 500);"#
    );
    let Some(text) = found(&shown, &script) else {
        return;
    };
    let text: String = serde_json::from_str(&text).expect("JSON");
    let table = shown.page.with_file_name("steady_trace.csv");
    let [times, values] = ["t_s", "x_m"].map(|name| column(&table, name));
    let rows: Vec<(f64, f64)> = text
        .lines()
        .filter(|line| line.starts_with("1,"))
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |cell: usize| cells[cell].parse().expect("a number");
            (number(2), number(3))
        })
        .collect();
    let part = rows.len() as f64 / times.len() as f64;
    assert!(part > 0.1 && part < 0.3, "{part} of the wave is shown");
    for (time, shown) in rows {
        let nearest = times
            .iter()
            .position(|known| (known - time).abs() < 1e-6)
            .expect("a row");
        // single precision is kept of what is drawn
        assert!(
            (shown - 1e6 * values[nearest]).abs() < 1e-6,
            "{shown} at {time}"
        );
    }
}

/// A very long run is drawn as a band; its end, zoomed into, is the wave that the table has.
#[test]
fn the_end_of_a_long_run_is_the_wave_of_its_table() {
    let folder = TempDir::new().expect("a folder");
    let long = [("duration = \"0.5 s\"", "duration = \"40 s\"")];
    let scenario = changed(folder.path(), "linear-7205c", &long);
    let shown = run(&scenario);
    let script = format!(
        r#"{CATCH}
        const body = document.getElementById("figure-trace").firstElementChild;
        body.open = true;
        const figure = body.querySelector("figure");
        const chart = figure.querySelector(".over");
        const key = (key) => chart.dispatchEvent(new KeyboardEvent("keydown", {{ key, bubbles: true, cancelable: true }}));
        setTimeout(() => {{
          for (let k = 0; k < 25; k += 1) key("+");
          key("End");
          press(figure, "CSV");
          saved[0].text().then(tell);
        }}, 500);"#
    );
    let Some(text) = found(&shown, &script) else {
        return;
    };
    let text: String = serde_json::from_str(&text).expect("JSON");
    let table = shown.page.with_file_name("trace.csv");
    let [times, values] = ["t_s", "x_m"].map(|name| column(&table, name));
    let mut compared = 0;
    for line in text.lines().filter(|line| line.starts_with("1,x,")) {
        let cells: Vec<&str> = line.split(',').collect();
        let [time, shown]: [f64; 2] = [2, 3].map(|cell| cells[cell].parse().expect("a number"));
        // the table has every so many of the samples that the page shows
        let near = |known: &f64| (known - time).abs() < 1e-9;
        if let Some(row) = times.iter().position(near) {
            let expected = 1e6 * values[row];
            assert!(
                (shown - expected).abs() < 1e-6,
                "{shown} and {expected} at {time}"
            );
            compared += 1;
        }
    }
    assert!(compared > 50, "{compared} places compared: {text}");
}

/// Finds the texts of an SVG that leave the paper or cover one before them.
const COVERED: &str = r#"const covered = (svg) => {
      const { documentElement: paper } = new DOMParser().parseFromString(svg, "image/svg+xml");
      const [width, height] = ["width", "height"].map((name) => Number(paper.getAttribute(name)));
      const boxes = [...paper.querySelectorAll("text")].map((text) => {
        const [x, y, size] = ["x", "y", "font-size"].map((name) => Number(text.getAttribute(name)));
        const wide = pens.widthOf(text.textContent, size);
        const left = x - wide * { start: 0, middle: 0.5, end: 1 }[text.getAttribute("text-anchor")];
        return { left, right: left + wide, top: y - 0.7 * size, bottom: y, words: text.textContent };
      }).filter(({ words }) => words.trim());
      const leaves = ({ left, right, top, bottom }) => left < 0 || right > width || top < 0 || bottom > height;
      const covers = (a, b) => a.right > b.left && b.right > a.left && a.bottom > b.top && b.bottom > a.top;
      return boxes.filter((box, k) => leaves(box) || boxes.slice(0, k).some((other) => covers(box, other)))
        .map(({ words }) => `${words} at ${width} px`);
    };"#;

/// Every figure of a run is saved as wide as a column and as a page, and no text leaves the paper or covers another.
#[test]
fn every_figure_is_saved() {
    let shown = run(&shipped("run-up-7205c"));
    let script = format!(
        r#"{CATCH}
        {COVERED}
        for (const body of document.querySelectorAll("details")) body.open = true;
        setTimeout(async () => {{
          const figures = [...document.querySelectorAll("figure")].filter((figure) => figure.querySelector(".save"));
          for (const width of [0, 1]) for (const figure of figures) {{
            figure.querySelector(".save select").selectedIndex = width;
            press(figure, "SVG");
          }}
          const texts = await Promise.all(saved.map((blob) => blob.text()));
          const amiss = texts.flatMap(covered);
          const starts = await Promise.all(saved.map((blob) => blob.slice(0, 8).text()));
          tell({{ figures: figures.length, starts, amiss }});
        }}, 500);"#
    );
    let Some(text) = found(&shown, &script) else {
        return;
    };
    let told: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let count = told["figures"].as_u64().expect("a number") as usize;
    let starts = told["starts"].as_array().expect("texts");
    // the spectra, histories, maps, scene, motion, orbit and balls
    assert!(count >= 8, "{count} figures");
    assert_eq!(starts.len(), 2 * count);
    assert_eq!(told["amiss"], serde_json::json!([]));
    assert!(starts.iter().all(|start| start == "<svg xml"));
}

/// The motion can be stepped through, and the curves follow.
#[test]
fn the_motion_moves_by_steps_and_the_curves_follow() {
    let shown = run(&shipped("back-to-back-7205c"));
    let script = r#"
        for (const name of ["figure-trace", "film"]) document.getElementById(name).firstElementChild.open = true;
        const film = document.getElementById("film");
        const slider = film.querySelector("input");
        setTimeout(() => {
          slider.value = "100";
          slider.dispatchEvent(new Event("input"));
          film.querySelector("[aria-label='one step on']").click();
          const curve = document.getElementById("figure-trace").querySelector("output").textContent.replace(/^.*time /, "");
          document.documentElement.dataset.found = JSON.stringify({ at: slider.value, place: film.querySelector("output").textContent, curve });
        }, 500);"#;
    let Some(text) = found(&shown, script) else {
        return;
    };
    let told: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(told["at"], "101");
    let seconds = |name: &str| -> f64 {
        let text = told[name].as_str().expect("a text");
        let (number, _) = text.split_once(" s").expect("seconds");
        number.parse().expect("a number")
    };
    assert!((seconds("place") - seconds("curve")).abs() < 2e-4, "{told}");
}

/// Nothing plays for whoever asks the system for less motion.
#[test]
fn nothing_plays_where_less_motion_is_asked_for() {
    let shown = run(&shipped("linear-7205c"));
    let Some((still, _)) = shown.opened(&shown.page, &["--force-prefers-reduced-motion"]) else {
        eprintln!("skipped: no Chromium is installed");
        return;
    };
    let (moving, _) = shown.in_browser().expect("a browser");
    let play = "aria-label=\"play or pause\"";
    assert!(moving.contains(&format!("{play}>")));
    assert!(still.contains(&format!("{play} disabled=\"\">")));
}

/// Several runs stand on one page, a curve each.
#[test]
fn runs_stand_side_by_side_on_one_page() {
    let folder = TempDir::new().expect("a folder");
    let files = ["steady-7205c", "linear-7205c"].map(shipped);
    done(
        verb("run", &files, folder.path(), &["--no-verify"])
            .output()
            .expect("it starts"),
    );
    let page = folder.path().join("report.html");
    let folders = ["steady-7205c", "linear-7205c"].map(|name| folder.path().join(name));
    let mut command = support::jeffcott();
    command
        .arg("compare")
        .args(&folders)
        .arg("--report")
        .arg(&page);
    let output = command.output().expect("it starts");
    assert_eq!(output.status.code(), Some(1), "they differ");
    let shown = Shown { folder, page };
    if let Some(document) = document(&shown) {
        assert_eq!(document.matches("data-figure=").count(), 3);
    }
    looks_well(&shown, Path::new("compare"));
}

/// Opened from disk, the page shows the numbers of the summary, every curve and the named lines.
#[test]
fn a_browser_draws_every_part_of_the_page() {
    let shown = run(&shipped("back-to-back-7205c"));
    let Some(document) = document(&shown) else {
        return;
    };
    for section in [
        "numbers",
        "figure-velocity_spectrum",
        "figure-trace",
        "figure-scene",
        "film",
        "figure-orbit",
        "table-peaks",
        "scenario",
        "document",
    ] {
        assert!(
            document.contains(&format!("<section id=\"{section}\"")),
            "{section}"
        );
    }
    // trace, further histories, orbit, scene and balls; spectra of velocities, displacements, tilts, forces and moments
    assert_eq!(document.matches("data-figure=").count(), 10);
    let summary = json(&shown.page.with_file_name("summary.json"));
    let shown_text = document.split("<script").next().expect("a start");
    for sign in ["undefined", "NaN", "[object"] {
        assert!(!shown_text.contains(sign), "{sign} is shown");
    }
    let frequency = summary["natural_frequencies"][0]["undamped_frequency_Hz"]
        .as_f64()
        .expect("a number");
    assert!(
        document.contains(&format!("{frequency:.2} Hz")),
        "{frequency}"
    );
}

/// What a person asks first is answered before anything is opened.
#[test]
fn the_first_screen_answers() {
    let shown = run(&shipped("steady-7205c"));
    let Some(document) = document(&shown) else {
        return;
    };
    let (_, first) = document
        .split_once("<section id=\"numbers\"")
        .expect("key numbers");
    let (first, rest) = first
        .split_once("<section id=\"figure-velocity_spectrum\"")
        .expect("a spectrum");
    for text in [
        "vibration x",
        "vibration y",
        "mm/s RMS from 10 to 1000 Hz",
        "repeats every",
        "life L10r",
        "1×",
    ] {
        assert!(first.contains(text), "{text} is not on the first screen");
    }
    let (spectrum, rest) = rest.split_once("</section>").expect("its end");
    assert!(spectrum.contains("data-figure=\"velocity_spectrum\""));
    // the rest waits to be opened
    let sections = rest.matches("<section").count();
    assert_eq!(rest.matches("<details><summary><h2>").count(), sections);
}

/// The spectra that a scenario asks for besides have charts on the page and a figure each.
#[test]
fn further_spectra_are_drawn() {
    let shown = run(&shipped("coal-impact-7205c"));
    let figure = shown.page.with_file_name("spectrum_velocity.svg");
    let figure = fs::read_to_string(figure).expect("a figure");
    for text in [
        "density in m²/s²/Hz",
        "density in rad²/s²/Hz",
        "tilt y velocity",
    ] {
        assert!(figure.contains(text), "{text}");
    }
    let Some(document) = document(&shown) else {
        return;
    };
    let (_, section) = document
        .split_once("<section id=\"figure-spectrum_velocity\"")
        .expect("a section");
    let (section, _) = section.split_once("</section>").expect("its end");
    assert_eq!(
        section.matches("data-figure=\"spectrum_velocity\"").count(),
        1
    );
}

/// The page of a million samples of five freedoms stays small, and is read as soon as any.
#[test]
fn a_million_samples_make_a_small_page() {
    let folder = TempDir::new().expect("a folder");
    let scenario = changed(
        folder.path(),
        "back-to-back-7205c",
        &[
            (
                "[output]",
                "[output]\nsample_rate = \"2 MHz\"\ntrace = false",
            ),
            ("samples_per_revolution", "# "),
        ],
    );
    let shown = run(&scenario);
    let size = fs::metadata(&shown.page).expect("the page").len();
    assert!(size < LARGEST, "{size} bytes");
    document(&shown);
}

/// A title can neither end the element it stands in nor start another.
#[test]
fn a_title_stays_text() {
    let folder = TempDir::new().expect("a folder");
    let title = "</script><script>document.title = 'taken'</script> & <b>\\\"";
    let scenario = changed(
        folder.path(),
        "linear-7205c",
        &[("title = \"", &format!("title = \"{title} "))],
    );
    let shown = run(&scenario);
    let text = shown.text();
    assert_eq!(
        text.matches("</script>").count(),
        2,
        "the data and the script"
    );
    assert!(text.contains("&lt;/script&gt;"));
    if let Some(document) = document(&shown) {
        assert!(document.contains("<title>&lt;/script&gt;"));
    }
}

/// Without a mouse a reader finds the value of a curve, zooms in and sees all again.
#[test]
fn the_keyboard_reads_and_zooms_a_chart() {
    let shown = run(&shipped("linear-7205c"));
    let script = r#"<script>
        const body = document.getElementById("figure-trace").firstElementChild;
        body.open = true;
        const chart = body.querySelector(".over");
        const press = (key) => chart.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
        const told = () => body.querySelector("output").textContent.replace(/^.*time /, "");
        const first = () => { press("."); return told(); };
        setTimeout(() => {
          const pressed = first();
          for (let k = 0; k < 5; k += 1) press(".");
          document.documentElement.dataset.keys = JSON.stringify({ pressed, later: told(), tabs: chart.tabIndex });
        }, 500);
    </script>"#;
    let text = shown.text().replace("</html>", &format!("{script}</html>"));
    fs::write(&shown.page, text).expect("a writable folder");
    let Some(document) = document(&shown) else {
        return;
    };
    let keys = document
        .split_once("data-keys=\"")
        .expect("the script ran")
        .1;
    let keys = keys
        .split_once('"')
        .expect("an end")
        .0
        .replace("&quot;", "\"");
    let keys: serde_json::Value = serde_json::from_str(&keys).expect("JSON");
    let seconds = |name: &str| -> f64 {
        let told = keys[name].as_str().expect("a text");
        let (number, _) = told.split_once(" s").expect("seconds");
        number.parse().expect("a number")
    };
    assert_eq!(keys["tabs"], 0, "the chart can be reached");
    // five samples of 128 a revolution at 500 rad/s further
    let step = std::f64::consts::TAU / 500.0 / 128.0;
    let moved = seconds("later") - seconds("pressed");
    assert!((moved - 5.0 * step).abs() < 0.1 * step, "{keys}");
}

/// No part of the page is to be fetched, and a browser would refuse to.
#[test]
fn the_page_asks_nothing_of_any_network() {
    let text = run(&shipped("linear-7205c")).text();
    assert!(text.contains(
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
    ));
    for sign in [
        "src=\"",
        "href=\"http",
        "url(",
        "@import",
        "fetch(",
        "XMLHttpRequest",
        "WebSocket",
    ] {
        assert!(!text.contains(sign), "{sign}");
    }
}

/// A scene that wants no page gets none.
#[test]
fn a_page_can_be_left_out() {
    let folder = TempDir::new().expect("a folder");
    let scenario = changed(
        folder.path(),
        "linear-7205c",
        &[("[output]", "[output]\nreport = false")],
    );
    assert!(!run(&scenario).page.exists());
}

/// The page of a study shows what it found, its figures and its plan.
#[test]
fn a_browser_draws_every_part_of_a_studys_page() {
    for (name, first, figures) in [
        ("resonance-7205c", "figure-response", 1),
        ("tolerances-7205c", "figure-sensitivity", 2),
        ("hysteresis-6306", "figure-response", 2),
    ] {
        let shown = study(&shipped_study(name));
        let text = shown.text();
        assert!(text.len() < 1_000_000, "{name}: {} bytes", text.len());
        let Some(document) = document(&shown) else {
            continue;
        };
        for section in ["numbers", first, "study", "document"] {
            let start = format!("<section id=\"{section}\"");
            assert!(document.contains(&start), "{name}: {section}");
        }
        assert_eq!(document.matches("data-figure=").count(), figures, "{name}");
        assert!(!document.contains(" failed; alone again"), "{name}");
        let shown_text = document.split("<script").next().expect("a start");
        for sign in ["undefined", "NaN", "[object"] {
            assert!(!shown_text.contains(sign), "{name}: {sign} is shown");
        }
    }
}

/// Of many failed runs the first stand in the page with their errors, and no text of a study gets out of its place.
#[test]
fn a_studys_page_stays_small_and_its_texts_stay_texts() {
    let folder = TempDir::new().expect("a folder");
    let values: Vec<_> = (0..150).map(|k| format!("'{} rad/s'", 100 + k)).collect();
    let text = format!(
        "title = \"</script><script>document.title = 'taken'</script><b>\"\n\
         base = '{}'\n\
         [[axis]]\nkey = 'speed.constant'\nvalues = [{}]\n\
         [[axis]]\nkey = 'time.settle'\nvalues = ['0 s', '0.6 s']\n",
        shipped("linear-7205c").display(),
        values.join(", "),
    );
    let file = folder.path().join("hostile.toml");
    fs::write(&file, text).expect("a writable folder");
    let shown = study(&file);
    let text = shown.text();
    assert!(text.len() < 400_000, "{} bytes", text.len());
    assert_eq!(
        text.matches("</script>").count(),
        2,
        "a title ends a script"
    );
    let Some(document) = document(&shown) else {
        return;
    };
    assert!(document.contains("<title>&lt;/script&gt;"));
    let (_, failures) = document
        .split_once("150 done, 150 failed; alone again by --only I")
        .expect("failed runs");
    let (failures, _) = failures.split_once("</dl>").expect("their end");
    assert_eq!(failures.matches("<dd>run ").count(), 20);
    assert!(failures.contains("settle time") || failures.contains("settle"));
}
