//! Lines, kinds of motion, maps of run-ups and natural frequencies over the speed: against closed forms,
//! signals of known answer and motions that are known.

mod campbell;
mod kinds;
mod maps;
mod named;
mod settling;
