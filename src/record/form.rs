//! The form of a file, recognised by its first bytes.

use std::path::Path;

use super::Problem;

/// First bytes that are looked at.
pub(super) const HEAD: u64 = 1 << 16;

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Form {
    /// Numbers in columns: CSV and its kin.
    Text,
    /// RIFF WAVE, or RF64 for long records.
    Wav,
    /// MATLAB version 5: `-v6` and `-v7`.
    Mat,
    /// No file: arrays of a program.
    Memory,
    /// Universal file with datasets 58, text or binary.
    Universal,
    /// A table of this program as Parquet.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// How files of forms that are not read begin, what they are, and what to do.
#[rustfmt::skip]
const FOREIGN: [(&[u8], &str, &str); 9] = [
    (b"MATLAB 7.3", "a MATLAB file of version 7.3 (HDF5)", "in MATLAB, save with `-v7`: `save(name, 'x', '-v7')`"),
    (b"\x89HDF", "HDF5", "write its data from Python with `scipy.io.savemat` or as CSV, from MATLAB with `-v7`"),
    (b"TDSm", "TDMS", "export it as CSV, from Python with `nptdms.TdmsFile(name).as_dataframe().to_csv`"),
    (b"PK\x03\x04", "a ZIP archive (also XLSX and NPZ)", "unpack it, or save the table as CSV"),
    (b"\x1f\x8b", "compressed (gzip)", "unpack it with `gunzip`"),
    (b"\x93NUMPY", "NumPy's own form", "write it with `numpy.savetxt` or `scipy.io.savemat`"),
    (b"PAR1", "Parquet", "write it as CSV, or build jeffcott with `--features parquet`"),
    (b"\xff\xfe", "text in UTF-16", "save it as UTF-8"),
    (b"\xfe\xff", "text in UTF-16", "save it as UTF-8"),
];

/// Length of the header of a MATLAB file, which ends with its version and the order of bytes.
const MATLAB_HEADER: usize = 128;

impl Form {
    /// The form of a file that begins with these bytes.
    pub(super) fn recognise(head: &[u8], path: &Path) -> Result<Self, Problem> {
        #[cfg(feature = "parquet")]
        if head.starts_with(b"PAR1") {
            return Ok(Self::Parquet);
        }
        if let Some((_, what, way)) = FOREIGN.iter().find(|(mark, ..)| head.starts_with(mark)) {
            return Err(Problem::Foreign { what, way });
        }
        let is_riff = [b"RIFF", b"RF64", b"BW64"]
            .iter()
            .any(|mark| head.starts_with(*mark));
        if is_riff && head.get(8..12) == Some(b"WAVE") {
            return Ok(Self::Wav);
        }
        if let Some([.., 1, 0, b'M', b'I'] | [.., 0, 1, b'I', b'M']) = head.get(..MATLAB_HEADER) {
            return Ok(Self::Mat);
        }
        if is_universal(head) {
            return Ok(Self::Universal);
        }
        if !head.contains(&0) {
            return Ok(Self::Text);
        }
        // MATLAB 4 has no mark but its name
        if path
            .extension()
            .is_some_and(|it| it.eq_ignore_ascii_case("mat"))
        {
            let what = "a MATLAB file of version 4, or broken";
            let way = "save it again in MATLAB with `-v7`";
            return Err(Problem::Foreign { what, way });
        }
        Err(Problem::Unknown)
    }
}

/// Whether a file begins with a line `-1` and one with the number of a dataset, both in six columns.
fn is_universal(head: &[u8]) -> bool {
    let lines = head
        .split(|byte| *byte == b'\n')
        .map(<[u8]>::trim_ascii_end);
    let mut filled = lines.skip_while(|line| line.is_empty());
    let opens = filled.next() == Some(b"    -1");
    let dataset = filled
        .next()
        .and_then(|line| line.get(..6))
        .unwrap_or(b"none");
    opens && dataset.trim_ascii_start().iter().all(u8::is_ascii_digit)
}
