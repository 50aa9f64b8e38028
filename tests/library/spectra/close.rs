//! `assert_spectra_close!`: what it takes, and what it says.

use std::fs::{self, File};

use crate::analysis::{Channel, ChannelSpectrum, Spectrum, Window};
use crate::assert_spectra_close;
use crate::report::write_spectrum;

fn spectrum(amplitude: f64) -> Spectrum {
    Spectrum {
        resolution: 10.0,
        shaft_frequency: 20.0,
        length: 8,
        start: 0.0,
        window: Window::Rectangular,
        channels: vec![ChannelSpectrum {
            channel: Channel::Displacement(0),
            amplitude: vec![0.0, 2e-9, amplitude, 1e-9],
            phase: vec![0.0, 0.1, 0.2, 0.3],
        }],
    }
}

#[test]
#[should_panic(expected = "spectra are not close
&spectrum(1e-6) against &spectrum(1.001e-6)

 column          |a−b|  allowed  f_Hz     a         b  differs in
 f_Hz            0.0e0   3.0e-5     0     0         0     nowhere
 order           0.0e0   1.5e-6     0     0         0     nowhere
 x_amplitude_m  1.0e-9  1.0e-12    20  1e-6  1.001e-6       1 row
 x_phase_rad     0.0e0   4.1e-6    20   0.2       0.2     nowhere

different: most of all x_amplitude_m, at f_Hz = 20
look there first; if that is meant, a relative tolerance of 1e-3 allows it:
--column x_amplitude_m=1e-3")]
fn the_message_is_what_compare_prints() {
    assert_spectra_close!(&spectrum(1e-6), &spectrum(1.001e-6));
}

#[test]
#[should_panic(expected = "the relative tolerance is -1")]
fn a_tolerance_must_be_one() {
    assert_spectra_close!(&spectrum(1e-6), &spectrum(1e-6), relative = -1.0);
}

#[test]
#[should_panic(expected = "cannot read gone/spectrum.csv: ")]
fn a_missing_file_is_named() {
    assert_spectra_close!(&spectrum(1e-6), "gone/spectrum.csv");
}

#[test]
fn a_spectrum_in_memory_is_close_to_its_file_and_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("spectrum.csv");
    write_spectrum(&spectrum(1e-6), File::create(&file).unwrap()).unwrap();
    assert_spectra_close!(&spectrum(1e-6), &file, relative = 0.0);
    assert_spectra_close!(
        folder.path(),
        &spectrum(1.001e-6),
        relative = 2e-3,
        absolute = 0.0
    );
    assert!(fs::exists(file).unwrap());
}
