//! Why a file cannot be read as a record.

use std::io;

/// A file that cannot be read as a record.
#[derive(Debug, thiserror::Error)]
#[error("{name}: {problem}")]
pub struct RecordError {
    /// The file.
    pub name: String,
    /// What is wrong with it.
    pub problem: Problem,
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// It cannot be opened or read.
    #[error("it cannot be read: {0}")]
    Read(#[from] io::Error),
    /// It is of a known form that is not read.
    #[error("it is {what}, which is not read; {way}")]
    Foreign {
        /// What it is.
        what: &'static str,
        /// How to get a file that is read.
        way: &'static str,
    },
    /// It is of no known form.
    #[error(
        "it is no record that can be read: text in columns (CSV), WAV, MATLAB up to `-v7`, universal file 58, or a trace as Parquet"
    )]
    Unknown,
    /// It ends too early.
    #[error("byte {byte}: the file ends where more should follow; copy or export it again")]
    Cut {
        /// Its length.
        byte: u64,
    },
    /// It breaks its form at a byte.
    #[error("byte {byte}: {what}")]
    Byte {
        /// Number of bytes before it.
        byte: u64,
        /// What is wrong there.
        what: String,
    },
    /// It breaks its form in a line.
    #[error("line {line}: {what}")]
    Line {
        /// Line, from 1.
        line: u64,
        /// What is wrong there.
        what: String,
    },
    /// What it holds is no record.
    #[error("{0}")]
    Unfit(String),
}

impl Problem {
    /// A problem at a byte.
    pub(super) fn byte(byte: u64, what: impl Into<String>) -> Self {
        let what = what.into();
        Self::Byte { byte, what }
    }

    /// A problem of a line.
    pub(super) fn line(line: u64, what: impl Into<String>) -> Self {
        let what = what.into();
        Self::Line { line, what }
    }
}
