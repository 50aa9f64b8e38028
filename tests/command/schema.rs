//! The schema and the catalogue that the command prints.

use jeffcott::bearing::CATALOGUE;

use crate::support::{done, jeffcott_in, root, scenarios};

fn printed(arguments: &[&str]) -> Vec<u8> {
    done(jeffcott_in(root(), arguments)).stdout
}

#[test]
fn the_command_prints_the_schema() {
    let committed = std::fs::read(scenarios().join("scenario.schema.json")).unwrap();
    assert!(printed(&["schema"]) == committed);
}

#[test]
fn the_command_lists_the_catalogue_with_its_sources() {
    let listed: serde_json::Value =
        serde_json::from_slice(&printed(&["catalogue", "--json"])).unwrap();
    assert_eq!(listed["schema_version"], 1);
    let listed = listed["bearings"].as_array().unwrap();
    let table = String::from_utf8(printed(&["catalogue"])).unwrap();
    // lines are broken where they would be wider than a terminal
    let table = table.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(listed.len() >= 115 && listed.len() <= CATALOGUE.balls.len());
    for record in listed {
        let entry = CATALOGUE
            .balls
            .iter()
            .find(|entry| record["designation"] == entry.designation);
        let entry = entry.expect("an entry");
        assert_eq!(record["source"], entry.source);
        assert!(table.contains(&entry.designation) && table.contains(&entry.source));
    }
}
