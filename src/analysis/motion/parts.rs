//! Which parts of a steady motion are looked at.

use super::section::SectionKind;

/// What is found out of a steady motion beside the moments of its displacements; by default everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotionParts {
    /// Moments of the bearing forces.
    pub forces: bool,
    /// RMS velocities in the band of the standards.
    pub velocity: bool,
    /// How the statistics move.
    pub drift: bool,
    /// Its kind, which rests on the points of all sections.
    pub kind: bool,
    /// The points of one section, where its kind is not asked for.
    pub section: Option<SectionKind>,
    /// x and y of the last samples.
    pub orbit: bool,
}

impl MotionParts {
    /// Everything.
    pub const ALL: Self = Self {
        forces: true,
        velocity: true,
        drift: true,
        kind: true,
        section: None,
        orbit: true,
    };

    /// The moments of the displacements alone.
    pub const DISPLACEMENTS: Self = Self {
        forces: false,
        velocity: false,
        drift: false,
        kind: false,
        section: None,
        orbit: false,
    };

    /// Whether the points of a section are looked for.
    pub fn has(&self, section: SectionKind) -> bool {
        self.kind || self.section == Some(section)
    }
}

impl Default for MotionParts {
    fn default() -> Self {
        Self::ALL
    }
}
