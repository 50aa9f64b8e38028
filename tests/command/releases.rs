//! What a release is made of fits together.

use std::fs;

use crate::support::root;

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).expect(path)
}

#[test]
fn archives_have_the_names_that_binstall_looks_for() {
    let manifest: toml::Table = read("Cargo.toml").parse().expect("a manifest");
    let binstall = &manifest["package"]["metadata"]["binstall"];
    let url = binstall["pkg-url"].as_str().expect("an address");
    let (_, archive) = url.rsplit_once('/').expect("a path");
    let made = archive.replace("v{ version }", "$GITHUB_REF_NAME");
    let made = made.replace("{ target }", "${{ matrix.target }}");
    let (name, ending) = made.rsplit_once('.').expect("an ending");
    let workflow = read(".github/workflows/release.yml");
    assert!(workflow.contains(&format!("name=\"{name}\"")), "{name}");
    assert!(
        workflow.contains(&format!("\"$name.{ending}\"")),
        "{ending}"
    );
    assert!(workflow.contains("tags: [\"v*\"]"));
}

#[test]
fn every_change_and_release_is_checked_by_the_same_script() {
    assert!(read(".github/workflows/ci.yml").contains("run: bash .ci/run"));
    let release = read(".github/workflows/release.yml");
    assert!(
        release.contains("uses: ./.github/workflows/ci.yml") && release.contains("needs: [checked")
    );
}
