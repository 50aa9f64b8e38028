//! What designations say besides the number of a bearing: names of makers, and suffixes.

use crate::bearing::ClearanceClass;

/// Suffixes that change neither balls nor races: seals and shields, cages, tolerances, snap rings, greases, quality of
/// electric motors, and names of makers.
const SUFFIXES: &str = "2RS1 2RS2 2RSR 2RSH 2RSL 2RSD 2RS 2HRS 2BRS 2RZ 2RU 2RD 2RK 2ZR 2Z RS1 RS2 RSR RSH RSL RS HRS RZ RU RD ZZ ZR ZNR Z DDU DDW DD DU VV \
    LLU LLB LLH LLC LU LB EE TN9 TNH TVH TVP TYN TN JEM JN J MA M EM QE6 NR N P6 P5 P4 P2 P0 GJN WT HT MT33 MT47 LHT23 5K 2AS";

/// Those of them that name seals whose lips rub.
const RUBBING_SEALS: &str =
    "2RS1 2RS2 2RSR 2RSH 2RS 2HRS RS1 RS2 RSR RSH RS HRS DDU DD DU LLU LU EE";

/// Suffixes of roller bearings that change neither rollers nor races of these designations: cages, surfaces, grooves for
/// oil, and designs with the ratings of the catalogue. A tapered bore, K, is another bearing: its clearance differs.
const ROLLER_SUFFIXES: &str =
    "CC CJ CA CW33 W33 W20 TVP2 TVPB TVPA TVP T W XL J2 JR JP A Q RHR MB MA ML MP M PA PH P C";

/// Letters that suffixes of other rollers begin with: E, EC, EW, E1 … and Koyo's R are high-capacity designs, V is full of
/// rollers, without a cage.
const OTHER_ROLLERS: [char; 3] = ['E', 'R', 'V'];

/// Makers whose names come before or after designations.
const MAKERS: &str =
    "SKF FAG INA NSK NTN SNR KOYO JTEKT NACHI TIMKEN MRC RHP NKE ZVL ZKL FKL FYH ORS GMN KBC URB";

/// Capital letters without blanks, and without the name of a maker before them.
pub(super) fn normal(designation: &str) -> String {
    let letters = designation.chars().filter(|c| !c.is_whitespace());
    let normal = letters.collect::<String>().to_uppercase();
    let mut makers = MAKERS.split_whitespace();
    let named = makers.find_map(|maker| normal.strip_prefix(maker));
    let number = named.map(|rest| rest.trim_start_matches(['-', '_']));
    let is_name = |rest: &&str| {
        let digits = rest.strip_prefix("NU").unwrap_or(rest);
        digits.starts_with(|c: char| c.is_ascii_digit())
    };
    let number = number.filter(is_name);
    number.map(str::to_owned).unwrap_or(normal)
}

/// What the suffixes of a designation say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Suffixes {
    /// Class of the clearance that they name.
    pub class: Option<ClearanceClass>,
    /// Whether they name seals whose lips rub.
    pub rubs: bool,
}

/// What rolls in the bearing that suffixes belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Elements {
    Balls,
    Rollers,
}

impl Elements {
    /// The longest suffix at the beginning of `rest` that changes neither what rolls nor the races.
    fn harmless(self, rest: &str) -> Option<&'static str> {
        let own = match self {
            Self::Balls => "",
            // EM is a quality of motors with balls, and a cage of the design E with rollers
            Self::Rollers if rest.starts_with(['E', 'V']) => return None,
            Self::Rollers => ROLLER_SUFFIXES,
        };
        let known = [SUFFIXES, MAKERS, own].into_iter();
        let known = known.flat_map(str::split_whitespace);
        let known = known.filter(|known| rest.starts_with(known));
        known.max_by_key(|known| known.len())
    }
}

/// Whether a suffix that is not known stands for a design with other rollers.
pub(super) fn has_other_rollers(suffix: &str) -> bool {
    suffix.starts_with(OTHER_ROLLERS)
}

/// What suffixes say, or the part of them that is not known of these elements.
pub(super) fn suffixes(mut rest: &str, elements: Elements) -> Result<Suffixes, &str> {
    let mut said = Suffixes::default();
    loop {
        rest = rest.trim_start_matches(['-', '/', '.', ',', '_', '(', ')']);
        if rest.is_empty() {
            return Ok(said);
        }
        let named = ClearanceClass::ALL
            .into_iter()
            .find(|class| rest.starts_with(class.name()));
        let suffix = named
            .map(ClearanceClass::name)
            .or_else(|| elements.harmless(rest))
            .ok_or(rest)?;
        said.class = named.or(said.class);
        said.rubs |= RUBBING_SEALS.split_whitespace().any(|seal| seal == suffix);
        rest = &rest[suffix.len()..];
    }
}
