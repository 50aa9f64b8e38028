//! The answer to a static question: text for people, JSON, CSV and a figure of the balls.

use super::rolling_elements::{SHOWN, balls_figure, balls_table};
use super::shaft_shapes::deflection;
use super::terminal::{
    Lines, MICRO, MILLI, NAMES, clearance_text, decimal, digits, displacement_text, listed,
    mark_estimated,
};
use super::{FileSet, Findings};
use crate::bearing::{BallLine, BearingState, Elements, GeometryState, LaminaLine, Matrix5};
use crate::physics::{BallPass, PER_MINUTE};
use crate::quasi_static::{QuasiStatic, StaticQuestion};
use crate::rotor::{FREEDOMS, Freedoms, RotorDefinition};
use crate::scenario::Scenario;
use crate::table::{Named, Table};

/// Equilibrium, stiffness and every bearing with its balls.
pub fn answer_findings(
    scenario: &Scenario,
    question: &StaticQuestion,
    answer: &QuasiStatic,
) -> Findings {
    let title = &scenario.title;
    let bearings: Vec<_> = answer.bearings.iter().collect();
    let figures = balls_figure(title, &bearings).into_iter();
    let mut tables = vec![("balls", balls_table((1..).zip(&answer.bearings)))];
    let slices = (1..).zip(&answer.bearings).flat_map(|(bearing, state)| {
        let rollers = (1..).zip(&state.balls);
        rollers.flat_map(move |(roller, line)| {
            line.laminae
                .iter()
                .map(move |lamina| (bearing, roller, line.row, lamina))
        })
    });
    let slices: Vec<_> = slices.collect();
    if !slices.is_empty() {
        tables.push(("laminae", laminae_table(slices)));
    }
    Findings {
        tables,
        figures: figures.chain(deflection(title, question)).collect(),
        ..Findings::new(
            FileSet::sealed("bearing.json"),
            scenario,
            answer,
            text(title, &question.rotor, answer),
        )
    }
}

/// A coupling below this part of its diagonal terms is what round-off left of zero.
const ROUND_OFF: f64 = 1e-12;

/// Forces along the freedoms, and their units.
const FORCES: [(&str, &str); FREEDOMS] = [
    ("Fx", "N"),
    ("Fy", "N"),
    ("Fz", "N"),
    ("Mx", "N m"),
    ("My", "N m"),
];

fn text(title: &str, rotor: &RotorDefinition, answer: &QuasiStatic) -> Lines {
    let mut out = Lines::titled(title);
    let speed = format!("{} rpm", decimal(rotor.speed * PER_MINUTE));
    out.line(
        "speed",
        match rotor.changes_speed() {
            true => format!("{speed}, at the start; --set speed.constant=\"…\" asks at another"),
            false => speed,
        },
    );
    out.line(
        "equilibrium",
        displacement_text(Freedoms::All.axes(), &answer.displacement),
    );
    let held = NAMES.iter().zip(answer.free).filter(|(_, free)| !free);
    out.line("held", listed(held.map(|(name, _)| (*name).to_owned())));
    let force = FORCES.iter().zip(answer.force);
    let force = force.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(value)));
    out.line("force", listed(force));
    if let Some(twist) = answer.twist {
        let (moment, angle) = (MILLI * twist.moment, MICRO * twist.angle);
        let text = format!("Mz {} N mm, θz {} µrad", decimal(moment), decimal(angle));
        out.line("twist", text);
    }
    out.line("stiffness", diagonal(&answer.stiffness));
    let condition = match answer.condition.is_finite() {
        true => digits(answer.condition),
        false => "infinite: the stiffness is singular".to_owned(),
    };
    out.line("condition", condition);
    let steps = answer.newton_steps;
    let search = format!(
        "{steps} Newton steps, residual {:.1e}, displacement to {:.1e} m",
        answer.residual, answer.displacement_error
    );
    out.detail("search", search);
    add_stiffness(&mut out, &answer.stiffness);
    for (index, state) in answer.bearings.iter().enumerate() {
        add_bearing(&mut out, index + 1, state);
    }
    out
}

/// K_x … K_θy in N/µm and N m/mrad.
fn diagonal(stiffness: &Matrix5) -> String {
    let shown = |axes: std::ops::Range<usize>, scale: f64| {
        let term = |axis| digits(stiffness[(axis, axis)] / scale);
        listed(axes.map(|axis| format!("K_{} {}", NAMES[axis], term(axis))))
    };
    let (along, about) = (shown(0..3, MICRO), shown(3..FREEDOMS, MILLI));
    format!("{along} N/µm; {about} N m/mrad")
}

/// K, a micrometre or a milliradian a column.
fn add_stiffness(out: &mut Lines, stiffness: &Matrix5) {
    let columns = ["x\n/µm", "y\n/µm", "z\n/µm", "θx\n/mrad", "θy\n/mrad"];
    let header = std::iter::once("K").chain(columns);
    let rows = FORCES.iter().enumerate().map(|(row, (name, unit))| {
        let cells = (0..FREEDOMS).map(|column| {
            let scale = if column < 3 { MICRO } else { MILLI };
            let term = stiffness[(row, column)];
            let diagonal = stiffness[(row, row)] * stiffness[(column, column)];
            let is_noise = term.abs() < ROUND_OFF * diagonal.abs().sqrt();
            digits(if is_noise { 0.0 } else { term / scale })
        });
        std::iter::once(format!("{name} in {unit}"))
            .chain(cells)
            .collect()
    });
    out.table(header, rows);
}

fn add_bearing(out: &mut Lines, number: usize, state: &BearingState) {
    out.put(format_args!("bearing {number}"));
    let name = add_elements(out, &state.geometry);
    out.each("clearance", state.clearance.as_ref().map(clearance_text));
    add_fit(out, state);
    out.line(&format!("{name} loaded"), state.balls_loaded);
    let life = state.life;
    let life = life.map(|life| format!("{life:.4e} million revolutions"));
    out.each("life L10r", life);
    add_lives(out, state);
    let safety = state.static_safety;
    out.each("static safety", safety.map(|safety| format!("{safety:.3}")));
    let friction = &state.friction_moment;
    let [total, load, viscous] =
        [friction.total(), friction.load, friction.viscous].map(|moment| decimal(MILLI * moment));
    let viscous = match state.has_oil {
        true => viscous,
        false => "not known without oil".to_owned(),
    };
    let text = format!("{total} N mm: load {load}, viscous {viscous} (Palmgren)");
    out.line("friction", text);
    if let Some(skf) = &state.friction_moment_skf {
        let [rolling, sliding] = [skf.rolling, skf.sliding].map(|moment| MILLI * moment);
        let [total, rolling, sliding] = [rolling + sliding, rolling, sliding].map(decimal);
        out.more(format!(
            "{total} N mm: rolling {rolling}, sliding {sliding} (SKF)"
        ));
    }
    let element = state.geometry.elements.name();
    let [pass, nominal] =
        [&state.ball_pass, &state.nominal_ball_pass].map(|pass| ball_pass_text(pass, element));
    let differs = pass != nominal;
    out.line("ball pass", pass);
    if differs {
        out.more(format!("nominal: {nominal}"));
    }
    if let Some(shares) = &state.shares {
        out.line("of contacts", diagonal(&shares.contacts));
        out.line("of films", diagonal(&shares.films));
    }
    if !state.balls.is_empty() {
        let has_rows = state.balls.iter().any(|line| line.row > 1);
        let shown = SHOWN
            .into_iter()
            .filter(|(head, _)| has_rows || *head != "row");
        let heads = shown.map(|(head, column)| match head {
            "ball" => (element, column),
            _ => (head, column),
        });
        let heads: Vec<_> = heads.collect();
        out.show(&balls_table([(number, state)]), &heads, 4);
    }
    let load = |line: &&BallLine| line.inner.load;
    let most = (1..).zip(&state.balls);
    let most = most.max_by(|a, b| load(&a.1).total_cmp(&load(&b.1)));
    let Some((roller, line)) = most.filter(|(_, line)| !line.laminae.is_empty()) else {
        return;
    };
    out.line("most loaded", format!("roller {roller}, slice by slice:"));
    let slices = line.laminae.iter();
    let slices = slices.map(|lamina| (number, roller, line.row, lamina));
    out.show(&laminae_table(slices), &SHOWN_LAMINA, 4);
}

/// What is reported of the slices of a roller.
const SHOWN_LAMINA: [(&str, &str); 5] = [
    ("s", "position"),
    ("δ", "approach"),
    ("q", "load"),
    ("pi", "inner_peak_pressure"),
    ("po", "outer_peak_pressure"),
];

/// Columns of a slice.
const LAMINA: [Named<LaminaLine>; 5] = [
    ("position", "m", |own| own.position),
    ("approach", "m", |own| own.approach),
    ("load", "N", |own| own.load),
    ("inner_peak_pressure", "Pa", |own| own.peak_pressure[0]),
    ("outer_peak_pressure", "Pa", |own| own.peak_pressure[1]),
];

/// Slices of rollers with the numbers of their bearings, rollers and rows.
fn laminae_table<'a>(
    slices: impl IntoIterator<Item = (usize, i32, usize, &'a LaminaLine)>,
) -> Table<'static> {
    let slices: Vec<_> = slices.into_iter().collect();
    Table::from_items(&slices)
        .count("bearing", |(bearing, ..)| *bearing as f64)
        .count("row", |(_, _, row, _)| *row as f64)
        .count("roller", |(_, roller, ..)| f64::from(*roller))
        .named("", &LAMINA, |(.., lamina)| Some(lamina))
        .end()
}

/// Adds what rolls in a bearing, and what it is called.
fn add_elements(out: &mut Lines, geometry: &GeometryState) -> &'static str {
    let size = |count: usize, size: String, pitch: f64| {
        let estimated = mark_estimated(geometry.estimated);
        format!("{count} of {size} mm on {:.3} mm{estimated}", MILLI * pitch)
    };
    match &geometry.elements {
        Elements::Balls(own) => {
            let diameter = format!("{:.3}", MILLI * own.ball_diameter);
            out.line("balls", size(own.balls, diameter, own.pitch_diameter));
            "balls"
        }
        Elements::Rollers(own) => {
            let (diameter, length) = (MILLI * own.diameter, MILLI * own.length);
            let dimensions = format!("{diameter:.3} × {length:.3}");
            let rows = if own.rows > 1 { " a row, two rows" } else { "" };
            let all = size(own.rollers, dimensions, own.pitch_diameter);
            let kind = format!("{}, {all}{rows}, {} slices", own.kind.name(), own.laminae);
            out.line("rollers", kind);
            let [dynamic, statical] = [own.dynamic_rating, own.static_rating].map(digits);
            out.more(format!(
                "C {dynamic} N (ISO 281), C_0 {statical} N (ISO 76)"
            ));
            if own.contact_angle == 0.0 {
                out.more("hold nothing along z: another bearing must locate the shaft");
            }
            "rollers"
        }
    }
}

/// `outer race 107.364 Hz, inner race 162.186 Hz, ball spin 70.594 Hz, cage 11.929 Hz`, or of what rolls instead.
pub(super) fn ball_pass_text(pass: &BallPass, element: &str) -> String {
    format!(
        "outer race {:.3} Hz, inner race {:.3} Hz, {element} spin {:.3} Hz, cage {:.3} Hz",
        pass.outer, pass.inner, pass.spin, pass.cage
    )
}

/// What fits and temperatures have done.
fn add_fit(out: &mut Lines, state: &BearingState) {
    let Some(fit) = &state.fit else { return };
    let [inner, outer] = fit.clearance_loss.map(|loss| decimal(-MICRO * loss));
    let clearance = format!(
        "clearance {} µm: inner ring {inner}, outer ring {outer}, temperature {}",
        decimal(MICRO * fit.clearance_change),
        decimal(MICRO * fit.thermal_change)
    );
    out.line("fits", clearance);
    let [inner, outer] = fit.pressure.map(|pressure| digits(pressure / 1e6));
    let pressure = format!("pressure in the seats: inner {inner}, outer {outer} MPa");
    out.more(pressure);
    out.more(format!(
        "free contact angle {:.3}°, {:.3}° before; preload in operation {} N",
        fit.angle.to_degrees(),
        fit.angle_before.to_degrees(),
        digits(state.preload)
    ));
    for (name, interference) in ["inner", "outer"].iter().zip(fit.interference) {
        if interference < 0.0 {
            let gap = decimal(-MICRO * interference);
            out.more(format!("the {name} ring is loose by {gap} µm"));
        }
    }
}

/// Lives in hours, and what lubrication makes of them.
fn add_lives(out: &mut Lines, state: &BearingState) {
    let Some(lives) = &state.rating_lives else {
        return;
    };
    let shown = |life: f64, hours: Option<f64>| {
        let hours = hours.map_or(String::new(), |hours| format!(", {} h", digits(hours)));
        format!("{life:.4e} million revolutions{hours}")
    };
    if let Some(hours) = lives.reference_hours {
        out.more(format!("{} h at this speed (ISO/TS 16281)", digits(hours)));
    }
    if let (Some(basic), Some(load)) = (lives.basic, lives.equivalent_load) {
        let life = shown(basic, lives.basic_hours);
        let [rating, load] = [lives.dynamic_rating, load].map(digits);
        out.line(
            "life L10",
            format!("{life} (ISO 281, C {rating} N, P {load} N)"),
        );
    } else {
        let reason =
            "not known: P of ISO 281 counts radial and axial forces only, and there are none";
        out.line("life L10", reason);
    }
    let Some(modified) = &lives.modified else {
        return;
    };
    let text = match modified.life {
        Some(life) => {
            let life = shown(life, modified.hours);
            format!("{life} at {} %", modified.reliability)
        }
        None if modified.viscosity_ratio.is_none() => "not known at rest".to_owned(),
        None => "not known: it needs `contamination` in [bearing.oil]".to_owned(),
    };
    out.line("life L_nm", text);
    let factors = [
        ("κ", modified.viscosity_ratio),
        ("e_C", modified.contamination_factor),
        ("C_u in N", Some(modified.fatigue_load_limit)),
        ("a_ISO", modified.life_modification_factor),
        ("a_1", Some(modified.reliability_factor)),
    ];
    let factors = factors.iter().filter_map(|(name, value)| {
        let value = (*value)?;
        Some(format!("{name} {}", digits(value)))
    });
    out.more(listed(factors));
}
