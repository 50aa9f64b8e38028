//! Energy that the contacts of a bearing store.

use super::{Bearing, CageAngle, ContactLaw, FilmThickness, HertzSpring, Support, Vector5};
use crate::physics::{FilmContact, HertzContact};

/// Elastic contacts of both races, inner first. Where one stiffness is given for both together each
/// has half of the approach.
pub(super) fn race_springs(bearing: &Bearing, contacts: &[HertzContact; 2]) -> [HertzSpring; 2] {
    let stiffness = match bearing.contact_stiffness {
        // K_n = [2 K^(−2/3)]^(−3/2)
        Some(series) => [series * 2f64.powf(1.5); 2],
        None => contacts.each_ref().map(HertzContact::stiffness),
    };
    stiffness.map(|stiffness| HertzSpring { stiffness })
}

/// Energy in J that a contact under a load in N stores behind a film of thickness `film` in m.
///
/// ```text
/// U = ∫ Q ds = 2/5 Q δ + (0.067/0.933) Q h   δ = (Q/K)^(2/3),  s(Q) = δ(Q) − h(Q)
/// ```
///
/// The second part is the film's: its thickness falls with the load as Q^(−0.067).
pub(super) fn stored_energy(spring: &HertzSpring, load: f64, film: Option<&FilmThickness>) -> f64 {
    const SHARE: f64 = FilmContact::LOAD_EXPONENT / (1.0 - FilmContact::LOAD_EXPONENT);
    if load <= 0.0 {
        return 0.0;
    }
    let approach = (load / spring.stiffness).cbrt().powi(2);
    let film = film.map_or(0.0, |film| film.central);
    0.4 * load * approach + SHARE * load * film
}

impl Support {
    /// Energy in J that the contacts store with the shaft at `displacement`: of a linear bearing that
    /// of its frozen force, zero where it was frozen; of a floating ring less the work of its spring.
    ///
    /// Its derivative by the displacement is [`Support::force`] where the law has a potential: under
    /// every law without ball inertia.
    pub fn stored_energy(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> f64 {
        let imposed = self.imposed(displacement);
        if let Some(linear) = &self.frozen {
            return linear.energy(&imposed);
        }
        let place = self.seat.settle(&self.ring, &imposed, cage, speed);
        let mut energy = self.seat.stored_energy(&imposed, &place);
        let films = self.ring.films();
        self.ring
            .for_each_contact(&place, cage, speed, &mut |ball| {
                let loads = [ball.load_inner, ball.load_outer];
                let films = films.map(|films| films.thickness(loads, speed));
                for race in 0..2 {
                    let film = films.as_ref().map(|films| &films[race]);
                    energy += stored_energy(&self.springs[race], loads[race], film);
                }
            });
        energy
    }

    /// Whether the force is the derivative of [`Support::stored_energy`], the speed being steady or
    /// not.
    pub fn has_potential(&self, steady: bool) -> bool {
        match self.definition().law {
            ContactLaw::Linear => true,
            ContactLaw::Hertz => steady || self.definition().oil.is_none(),
            ContactLaw::Jones(_) => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{BallLaw, HertzFilmLaw, HertzLaw, Oil, catalogue};

    fn bearing() -> Bearing {
        catalogue::find("7205C").unwrap().bearing().unwrap()
    }

    /// Work of the law's force along A2 from far apart to `end`, by Simpson's rule.
    fn work(law: &impl BallLaw, from: f64, end: f64, speed: f64) -> f64 {
        const STEPS: usize = 200_000;
        let step = (end - from) / STEPS as f64;
        let force = |k: usize| law.force(0.0, from + step * k as f64, speed).radial;
        let sum: f64 = (0..=STEPS)
            .map(|k| match k {
                0 | STEPS => force(k),
                _ if k % 2 == 1 => 4.0 * force(k),
                _ => 2.0 * force(k),
            })
            .sum();
        sum * step / 3.0
    }

    #[test]
    fn the_energy_of_dry_contacts_is_the_work_of_the_force() {
        let bearing = bearing();
        let law = HertzLaw {
            load_deflection_constant: bearing.load_deflection_constant().unwrap(),
            distance: bearing.geometry.groove_centre_distance(),
        };
        let end = law.distance + 10e-6;
        let springs = race_springs(&bearing, &bearing.contacts().unwrap());
        let load = law.contact(0.0, end, 0.0).load_inner;
        let stored: f64 = springs.iter().map(|s| stored_energy(s, load, None)).sum();
        let expected = work(&law, law.distance, end, 0.0);
        assert!(
            (stored / expected - 1.0).abs() < 1e-12,
            "{stored} {expected}"
        );
    }

    #[test]
    fn the_energy_behind_films_is_the_work_of_the_force() {
        let bearing = bearing();
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let law = HertzFilmLaw::new(&bearing, oil, 1000.0).unwrap();
        let distance = bearing.geometry.groove_centre_distance();
        // two heights, for the tail of the film reaches to infinity
        let (low, high) = (distance - 1e-6, distance + 10e-6);
        let springs = race_springs(&bearing, &bearing.contacts().unwrap());
        let energy = |place: f64| {
            let contact = law.contact(0.0, place, 1000.0);
            let loads = [contact.load_inner, contact.load_outer];
            let films = law.films().thickness(loads, 1000.0);
            (0..2)
                .map(|race| stored_energy(&springs[race], loads[race], Some(&films[race])))
                .sum::<f64>()
        };
        let expected = work(&law, low, high, 1000.0);
        let stored = energy(high) - energy(low);
        assert!(
            (stored / expected - 1.0).abs() < 1e-9,
            "{stored} {expected}"
        );
    }
}
