//! The still of the animation in the manual, as the Save button of a page gives it. `JEFFCOTT_BLESS=1` takes it anew.

use std::fs;

use super::run;
use super::support::{root, shipped};

/// Presses the SVG button of the animation and tells the text of the file that it offers.
const SAVED: &str = r##"<iframe src="report.html" width="1280" height="900"></iframe><pre id="saved"></pre><script>
const frame = document.querySelector("iframe");
addEventListener("load", () => {
  const { contentDocument: page, contentWindow: inside } = frame;
  for (const body of page.querySelectorAll("details")) body.open = true;
  setTimeout(() => {
    inside.URL.createObjectURL = (blob) => {
      blob.text().then((text) => { document.getElementById("saved").textContent = text; });
      return "#";
    };
    const slider = page.querySelector("input.time");
    slider.value = String(Math.floor(slider.max / 2));
    slider.dispatchEvent(new Event("input"));
    const buttons = [...slider.closest("figure").querySelectorAll("details.save button")];
    buttons.find((button) => button.textContent === "SVG").click();
  }, 1000);
});
</script>"##;

#[test]
fn the_still_of_the_animation_is_that_of_a_page() {
    let shown = run(&shipped("fan-6205"));
    let frame = shown.page.with_file_name("saved.html");
    fs::write(&frame, SAVED).expect("a written file");
    let Some((document, told)) = shown.opened(&frame, &[]) else {
        eprintln!("skipped: no Chromium is installed");
        return;
    };
    let saved = document
        .rsplit_once("<pre id=\"saved\">")
        .expect("a place")
        .1;
    let saved = saved.split("</pre>").next().unwrap_or_default();
    let saved = saved
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&");
    assert!(saved.starts_with("<svg"), "{told}\n{saved}");
    let picture = root().join("docs/images/gallery/motion.svg");
    if std::env::var_os("JEFFCOTT_BLESS").is_some() {
        fs::write(&picture, &saved).expect("a writable manual");
    }
    // coordinates differ in their last digits between machines
    let elements = |svg: &str| svg.matches("<circle").count() + svg.matches("<text").count();
    let kept = fs::read_to_string(&picture).expect("docs/images/gallery/motion.svg");
    assert_eq!(
        elements(&kept),
        elements(&saved),
        "take it anew: JEFFCOTT_BLESS=1"
    );
    assert!(elements(&saved) > 20);
}
