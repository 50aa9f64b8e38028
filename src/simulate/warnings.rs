//! What the reader of a run should know.

use super::passes::Passes;
use super::run::Reduction;
use super::{MeasuredError, Model};
use crate::analysis::{Channel, Motion};
use crate::integrate::{Method, Stiffness};
use crate::physics::PER_MINUTE;
use crate::rotor::{
    Damping, FREEDOM_NAMES, GrowingMotion, Rotor, RotorDefinition, unconstrained_warning,
};

/// Balance quality grade of ISO 21940-11 beyond all that it lists but rigidly mounted marine engines, mm/s.
const COARSEST_BALANCE: f64 = 100.0;

/// Coefficients of damping so many times those of another speed, or the reverse, are worth a warning.
const OTHER_DAMPING: f64 = 1.1;

/// A measured error above this many tolerances is worth a warning.
pub(crate) const PROMISE: f64 = 10.0;

pub(super) fn warnings(
    model: &Model,
    passes: &Passes<'_>,
    error: Option<&MeasuredError>,
    motion: Option<&Motion>,
) -> Vec<String> {
    let rotor = passes.rotor;
    let mut warnings = Vec::new();
    if model.spectrum.is_some() && rotor.steady_from(model.settle).is_none() {
        warnings.push(format!(
            "the speed changes after the settle time of {} s: lines of shaft and bearings smear in \
             the spectra, which have no orders, and no peak is named after them; ball-pass \
             frequencies are those at the highest speed, {:.0} rpm ({:.1} rad/s)",
            model.settle,
            rotor.highest_speed() * PER_MINUTE,
            rotor.highest_speed()
        ));
    }
    let tolerance = model.integrator.tolerance;
    let named = model.integrator.method;
    let method_use = passes.main.method_use();
    let method = method_use.map_or(named, |used| used.latest());
    warnings.extend(error.filter(|error| error.relative > PROMISE * tolerance).map(|error| {
        format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: {}the motion may be irregular or rest on contact changes; trust \
             statistics rather than the single trace{}",
            error.relative,
            passes.overestimate().map_or_else(String::new, |times| format!(
                "the motion was taken for {times:.1e} times as large as it is after the settle time: a tolerance \
                 {times:.0e} times as fine is that of the motion; or "
            )),
            if method == Method::Verner76 {
                ""
            } else {
                ", or set method = \"verner76\" in [integrator], whose steps end where contacts part"
            }
        )
    }));
    warnings.extend(passes.reduction().as_ref().and_then(Reduction::warning));
    if let Some(failure) = passes.failure() {
        warnings.push(format!(
            "the second pass that measures the error failed, and the error of this run is unknown: \
             {failure}"
        ));
    }
    // a method that was left open is the faster one all the same
    let stiffness = passes.main.stiffness().filter(|_| method_use.is_none());
    warnings.extend(stiffness.as_ref().map(stiff));
    warnings.extend(assembled_warnings(&model.rotor, rotor));
    let growing = rotor.steady_from(0.0).and_then(|_| rotor.growing_motion());
    warnings.extend(growing.map(|growing| not_stable(rotor, growing)));
    let grows_for_ever = growing.is_some() && rotor.has_linear_forces();
    let settling = motion.filter(|_| !grows_for_ever);
    warnings.extend(settling.and_then(not_settled));
    warnings
}

/// Warnings of the speeds of a shaft before anything moves; none where it cannot be assembled.
pub(crate) fn speed_warnings(definition: &RotorDefinition) -> Vec<String> {
    warnings_between(definition, definition.speed_range())
}

/// Warnings of a shaft that is looked at between two speeds in rad/s: those of the higher, and of what the range leaves; none
/// where it cannot be assembled there.
pub(crate) fn range_warnings(definition: &RotorDefinition, range: [f64; 2]) -> Vec<String> {
    warnings_between(&definition.at_constant_speed(range[1]), range)
}

fn warnings_between(definition: &RotorDefinition, range: [f64; 2]) -> Vec<String> {
    let Ok(rotor) = Rotor::assemble(definition) else {
        return Vec::new();
    };
    let unconstrained = unconstrained_warning(&rotor).into_iter();
    let others = of_highest_speed(definition, &rotor).into_iter();
    let all = unconstrained.chain(definition.beyond_tables(range));
    all.chain(others).collect()
}

/// Warnings of the speeds of an assembled shaft.
pub(crate) fn assembled_warnings(definition: &RotorDefinition, rotor: &Rotor) -> Vec<String> {
    let tables = definition.beyond_tables(definition.speed_range());
    let others = of_highest_speed(definition, rotor);
    let damping = damping_of_start(definition, rotor);
    tables.into_iter().chain(others).chain(damping).collect()
}

/// Damping that follows from the stiffness at the start, where the speed makes another one of it.
fn damping_of_start(definition: &RotorDefinition, rotor: &Rotor) -> Option<String> {
    let key = match definition.damping {
        Damping::Ratio(_) => "ratio",
        Damping::StiffnessTime(_) => "stiffness_time",
        Damping::Undamped | Damping::Coefficients(_) => return None,
    };
    let [_, highest] = definition.speed_range();
    if highest == definition.speed {
        return None;
    }
    let there = Rotor::assemble(&definition.at_constant_speed(highest)).ok()?;
    let [own, other] = [rotor, &there].map(Rotor::damping_matrix);
    let axes = rotor.freedoms().axes().iter();
    let changes = axes.map(|&axis| (axis, own[axis][axis] / other[axis][axis]));
    let known = changes.filter(|(_, change)| change.is_finite());
    let changed = known.filter(|(_, change)| change.ln().abs() > OTHER_DAMPING.ln());
    let (axis, change) = changed.max_by(|a, b| a.1.ln().abs().total_cmp(&b.1.ln().abs()))?;
    Some(format!(
        "`damping.{key}` is that of the stiffness at the start, {:.0} rpm, and the run keeps its coefficients: at {:.0} rpm they are \
         {change:.2} times those that `{key}` makes of the stiffness there (along {}), and so are damping ratios and resonances of \
         the run, unlike those of `campbell`, `response` and `steady`; give damping.coefficients, or begin near the speed that \
         matters",
        definition.speed * PER_MINUTE,
        highest * PER_MINUTE,
        FREEDOM_NAMES[axis]
    ))
}

/// Warnings of the highest speed of an assembled shaft.
fn of_highest_speed(definition: &RotorDefinition, rotor: &Rotor) -> Vec<String> {
    let unbalance = unbalance(definition, rotor).into_iter();
    let doubtful = unbalance.chain(overdamped(definition));
    let doubtful = doubtful.chain(base_left_out(definition));
    let doubtful = doubtful.chain(rotor.axial_warning());
    doubtful.chain(bearings(rotor)).collect()
}

/// A damping ratio that no shaft on rolling bearings has: most often percent.
fn overdamped(definition: &RotorDefinition) -> Option<String> {
    let Damping::Ratio(ratio) = definition.damping else {
        return None;
    };
    (ratio >= 1.0).then(|| {
        format!(
            "`damping.ratio` is {ratio}: from 1 on the shaft is overdamped and creeps back without any free vibration; shafts on \
             ball bearings have 0.02 to 0.04; if {ratio} % is meant, write ratio = {}",
            ratio / 100.0
        )
    })
}

/// A base that shakes, whose own motion is no part of the answer.
fn base_left_out(definition: &RotorDefinition) -> Option<String> {
    definition.loads.iter().any(|load| load.acts_on_mass()).then(|| {
        "the base shakes (`[load.base]`), and every motion is given relative to it: what sensors on a housing measure, and the \
         zones of ISO 20816-3 judge, is that plus the motion of the base itself"
            .to_owned()
    })
}

/// What the bearings say of themselves at the static equilibrium and the highest speed.
fn bearings(rotor: &Rotor) -> Vec<String> {
    let states = rotor.bearing_states(rotor.highest_speed());
    let bearings = rotor.supports().zip(states).enumerate();
    let known = bearings.filter(|(_, (support, _))| support.known_balls() > 0);
    let texts = known.flat_map(|(index, (_, state))| {
        let number = index + 1;
        let say = move |text| format!("bearing {number}, at the static equilibrium: {text}");
        state.warnings.into_iter().map(say)
    });
    texts.collect()
}

/// An eccentricity that no balanced shaft has: most often a unit mistaken.
fn unbalance(definition: &RotorDefinition, rotor: &Rotor) -> Option<String> {
    let [eccentricity, _] = definition.shaft.mass_eccentricity();
    let grade = 1e3 * eccentricity * rotor.highest_speed().abs();
    (grade > COARSEST_BALANCE).then(|| {
        format!(
            "the eccentricity of {:.4} mm gives e·ω = {grade:.0} mm/s at {:.0} rpm, beyond balance grade G \
             {COARSEST_BALANCE} of ISO 21940-11 (shafts have G 2.5 to G 16): check its unit",
            1e3 * eccentricity,
            rotor.highest_speed() * PER_MINUTE
        )
    })
}

fn stiff(stiffness: &Stiffness) -> String {
    format!(
        "the problem is stiff: from t = {:.3e} s on stability held the step at {:.1e} s (largest eigenvalue \
         {:.1e} 1/s); method = \"rodas\" in [integrator] may take longer ones",
        stiffness.time, stiffness.step, stiffness.eigenvalue
    )
}

/// An equilibrium that free motions lead away from.
fn not_stable(rotor: &Rotor, growing: GrowingMotion) -> String {
    let outcome = match rotor.has_linear_forces() {
        true => "all forces are linear, and the motion grows for ever",
        false => "the motion leaves this equilibrium, and may settle to an orbit about it",
    };
    format!(
        "the shaft is not stable at its static equilibrium at {:.0} rpm: {growing}; {outcome}",
        rotor.speed() * PER_MINUTE
    )
}

/// The statistics of an irregular motion move by themselves, and nothing is said of them.
fn not_settled(motion: &Motion) -> Option<String> {
    let drift = motion
        .drift
        .filter(|_| motion.has_settled() == Some(false))?;
    let turns = if drift.rms < 0.0 { "falls" } else { "rises" };
    Some(format!(
        "the motion has not settled: over the last {:.4} s the mean of {} moves by {:.3} times the RMS of the whole record, and its \
         RMS {turns} by {:.3} times that; make `settle` and `duration` longer",
        drift.apart + drift.window,
        Channel::Displacement(drift.freedom),
        drift.mean.abs(),
        drift.rms.abs()
    ))
}
