//! What kind of bearing a designation stands for, where no catalogue has it.

/// Beginnings of designations, `#` a digit, and the kind of bearing. Those of digits alone are followed by no further digit.
const KINDS: [(&str, &str); 12] = [
    (
        "NU# NJ# NUP# N# NF# NH# NCF# NJG# NN# NNU# NNC# NNCF# NNCL# RNU# RN# SL#",
        "a cylindrical roller bearing",
    ),
    (
        "HK# BK# K# NK# NKI# NKS# NKIS# NA# NAO# RNA# RNAO# HN# SCE# HMK# DL#",
        "a needle roller bearing",
    ),
    (
        "302## 303## 313## 320## 322## 323## 329## 330## 331## 332## LM# HM# JL# JLM# T2# T4# T7#",
        "a tapered roller bearing",
    ),
    (
        "213## 222## 223## 230## 231## 232## 238## 239## 240## 241## BS2#",
        "a spherical roller bearing",
    ),
    ("C#", "a toroidal roller bearing"),
    (
        "811## 812## 893## 894## 292## 293## 294## AXK#",
        "a roller thrust bearing",
    ),
    (
        "12## 13## 22## 23## 112## 113##",
        "a self-aligning ball bearing with two rows",
    ),
    (
        "32## 33## 52## 53##",
        "an angular contact ball bearing with two rows",
    ),
    ("42## 43##", "a deep groove ball bearing with two rows"),
    (
        "511## 512## 513## 514## 522## 523## 524## 532## 533## 534##",
        "a thrust ball bearing",
    ),
    (
        "2344## 2347## 7602### 7603###",
        "an angular contact thrust ball bearing",
    ),
    ("QJ#", "a four-point contact bearing"),
];

/// Whether a kind is that of a radial roller bearing whose rollers can be given.
pub(super) fn has_rollers(kind: &str) -> bool {
    ["cylindrical", "needle", "tapered", "spherical"]
        .iter()
        .any(|name| kind == format!("a {name} roller bearing"))
}

/// Contact angles in degrees that suffixes of angular contact bearings name, longer ones first.
const ANGLES: [(&str, f64); 5] = [
    ("AC", 25.0),
    ("A5", 25.0),
    ("A", 30.0),
    ("B", 40.0),
    ("C", 15.0),
];

/// The kind of bearing that jeffcott finds in no catalogue; none of deep groove and angular contact bearings, and of names that
/// say nothing. Capital letters without blanks.
pub(super) fn not_modelled(designation: &str) -> Option<&'static str> {
    let begins = |pattern: &str| {
        let mut rest = designation.chars();
        let agrees = |due: char, found: char| match due {
            '#' => found.is_ascii_digit(),
            _ => due == found,
        };
        let all = pattern
            .chars()
            .all(|due| rest.next().is_some_and(|found| agrees(due, found)));
        let of_digits = !pattern.starts_with(char::is_alphabetic);
        all && !(of_digits && rest.next().is_some_and(|next| next.is_ascii_digit()))
    };
    let found = KINDS
        .iter()
        .find(|(patterns, _)| patterns.split(' ').any(begins));
    found.map(|(_, kind)| *kind)
}

/// Contact angle in degrees that the suffix of an angular contact bearing names. Capital letters without blanks.
pub(super) fn contact_angle(designation: &str) -> Option<f64> {
    let suffix = designation.trim_start_matches(|c: char| c.is_ascii_digit());
    let named = ANGLES
        .iter()
        .find(|(letters, _)| suffix.starts_with(letters));
    let is_angular = designation.starts_with('7') && designation.len() - suffix.len() >= 4;
    named.filter(|_| is_angular).map(|(_, angle)| *angle)
}
