//! The gallery shows what its commands draw. `JEFFCOTT_BLESS=1` draws its pictures anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::documents::Page;
use crate::support::root;

/// Most bytes of a picture of the manual.
const LARGEST: usize = 120_000;

/// Pictures of the gallery, each with the file that the commands write; the one of the animation comes from a browser.
fn pictures(page: &Page) -> Vec<(String, String)> {
    let mut drawn = None;
    let mut found = Vec::new();
    for line in page.text.lines() {
        let words = line.split('`').skip(1).step_by(2);
        drawn = words.filter(|word| word.ends_with(".svg")).last().or(drawn);
        let Some((_, picture)) = line
            .strip_prefix("![")
            .and_then(|rest| rest.split_once("]("))
        else {
            continue;
        };
        if let Some(file) = drawn.take() {
            found.push((
                file.to_owned(),
                format!("docs/{}", picture.trim_end_matches(')')),
            ));
        }
    }
    found
}

/// Words of a drawing and the number of its elements of each kind. Coordinates differ in their last digits between machines;
/// where times are drawn, so do numbers and their count.
fn content(svg: &str, timed: bool) -> (Vec<String>, BTreeMap<&str, usize>) {
    let words = svg.split("<text ").skip(1);
    let words = words.filter_map(|rest| rest.split_once('>')?.1.split_once('<'));
    let words = words.map(|(word, _)| word.to_owned());
    let words = words.filter(|word| !timed || word.parse::<f64>().is_err());
    let mut elements = BTreeMap::new();
    for element in svg.split('<').skip(1).filter(|_| !timed) {
        let kind = element.split([' ', '>']).next().unwrap_or_default();
        *elements.entry(kind).or_insert(0) += 1;
    }
    (words.collect(), elements)
}

#[test]
fn the_gallery_shows_what_its_commands_draw() {
    let page = Page::read("docs/gallery.md".into());
    let folder = page.folder();
    page.run_commands(folder.path());
    let pictures = pictures(&page);
    assert!(pictures.len() >= 18, "{pictures:?}");
    for (file, picture) in pictures {
        let drawn = fs::read_to_string(folder.path().join(&file)).expect(&file);
        assert!(drawn.len() <= LARGEST, "{file}: {} bytes", drawn.len());
        let path: &Path = &root().join(&picture);
        if std::env::var_os("JEFFCOTT_BLESS").is_some() {
            fs::write(path, &drawn).expect("a writable manual");
        }
        let shown = fs::read_to_string(path).expect(&picture);
        let timed = file.ends_with("accuracy.svg");
        assert!(
            content(&shown, timed) == content(&drawn, timed),
            "{picture} is of an older drawing: JEFFCOTT_BLESS=1 cargo test --test command gallery"
        );
    }
}
