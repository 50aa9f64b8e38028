//! A run: its document, text, figures and tables, and the files that it writes while it goes on.

pub(super) mod answer;
pub(super) mod defects;
pub(super) mod files;
pub(super) mod film;
pub(crate) mod histories;
pub(super) mod method_use;
pub(super) mod motion;
pub(super) mod order_tracks;
pub(crate) mod recorded;
pub(super) mod run_up;
pub(crate) mod tables;
pub(super) mod text;
