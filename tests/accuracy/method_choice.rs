//! `method = "auto"`: the cheapest method by trial.

use jeffcott::integrate::Method;
use jeffcott::scenario::{Scenario, methods};
use jeffcott::study::MethodChoice;

use crate::support::try_run;
use crate::{read, text};

/// A scene of half a second that leaves its method open.
fn open(speed: &str, changes: &[(&str, &str)]) -> Scenario {
    let mut scene = text(
        speed,
        "contact = \"hertz\"",
        "[integrator]\nmethod = \"auto\"\n",
    );
    scene = scene.replace("0.03 s", "0.5 s");
    for (from, to) in changes {
        assert!(scene.contains(from), "{from}");
        scene = scene.replace(from, to);
    }
    read(&scene)
}

fn choice(scenario: &Scenario) -> &MethodChoice {
    scenario.method_choice.as_ref().unwrap()
}

#[test]
fn a_shaft_that_turns_slowly_under_load_steps_with_its_forcing() {
    let scenario = open("100 rad/s", &[]);
    assert_eq!(choice(&scenario).chosen, Method::Exponential);
    let mut model = scenario.model.unwrap();
    assert_eq!(model.integrator.method, Method::Exponential);
    let (chosen, _) = try_run(&model, 0.0);
    model.integrator.method = Method::Verner76;
    let (explicit, _) = try_run(&model, 0.0);
    let [chosen, explicit] = [chosen, explicit].map(|run| run.unwrap().counters.evaluations);
    assert!(2 * chosen < explicit, "{chosen} against {explicit}");
}

#[test]
fn balls_that_unload_at_every_turn_are_left_to_the_explicit_method() {
    let scenario = open("1000 rad/s", &[("5 um", "50 um"), ("1000 N", "50 N")]);
    assert_eq!(choice(&scenario).chosen, Method::Verner76);
}

#[test]
fn stiff_contact_damping_is_not_left_to_the_explicit_method() {
    let damping = "ratio = 0.02\ncontact = { inner = \"5000 s/m\", outer = \"5000 s/m\" }\n";
    let scenario = open("1000 rad/s", &[("ratio = 0.02\n", damping)]);
    let choice = choice(&scenario);
    assert_ne!(choice.chosen, Method::Verner76, "{choice:?}");
    assert_eq!(choice.tried.len(), 3);
}

#[test]
fn the_same_scene_gets_the_same_method_and_a_named_method_is_kept() {
    let scene = || open("300 rad/s", &[]);
    assert_eq!(choice(&scene()), choice(&scene()));
    let named = text(
        "1000 rad/s",
        "contact = \"hertz\"",
        "[integrator]\nmethod = \"dop853\"\n",
    );
    let named = read(&named);
    assert!(named.method_choice.is_none());
    assert_eq!(named.model.unwrap().integrator.method, Method::Dop853);
    assert!(methods().iter().all(|named| named.name != "auto"));
}
