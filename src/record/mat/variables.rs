//! The variables of a MATLAB file, each compressed or not.

use flate2::bufread::ZlibDecoder;

use super::Value;
use super::reader::{COMPRESSED, MATRIX, Reader};
use crate::record::Problem;
use crate::record::bytes::Bytes;

/// How many times its length a file may unpack to, and how many bytes more. Deflate can reach a thousandfold, of a file of
/// nothing but zeros.
const MOST_UNPACKED: (u64, u64) = (100, 1 << 20);

/// The variables of a file.
pub(super) struct Variables<'a> {
    bytes: Bytes<'a>,
    big_endian: bool,
    /// Bytes that may still be unpacked.
    unpacked: u64,
    /// What is not read, and why.
    pub left_out: Vec<String>,
}

impl<'a> Variables<'a> {
    /// Behind the header.
    pub fn new(mut bytes: Bytes<'a>) -> Result<Self, Problem> {
        let (times, more) = MOST_UNPACKED;
        let unpacked = bytes.left().saturating_mul(times).saturating_add(more);
        bytes.skip(126)?;
        let big_endian = bytes.array()? == *b"MI";
        Ok(Self {
            bytes,
            big_endian,
            unpacked,
            left_out: Vec::new(),
        })
    }

    /// The next variable with its name; none at the end.
    pub fn next(&mut self) -> Result<Option<(String, Value)>, Problem> {
        while self.bytes.left() > 0 {
            let place = self.bytes.at();
            let mut reader = Reader::new(&mut self.bytes, self.big_endian, &mut self.left_out);
            let tag = reader.tag()?;
            match tag.kind {
                MATRIX => return reader.matrix(tag.length, 0).map(Some),
                COMPRESSED => return self.compressed(tag.length, place).map(Some),
                0..=18 => reader.skip_to(place + 8 + tag.length.next_multiple_of(8))?,
                _ => return Err(Problem::byte(place, "no MATLAB variable begins here")),
            }
        }
        Ok(None)
    }

    fn compressed(&mut self, length: u64, place: u64) -> Result<(String, Value), Problem> {
        let mut packed = self.bytes.part(length);
        let mut bytes = Bytes::unpacked(ZlibDecoder::new(&mut packed), self.unpacked, place);
        let mut reader = Reader::new(&mut bytes, self.big_endian, &mut self.left_out);
        let tag = reader.tag()?;
        if tag.kind != MATRIX {
            return Err(Problem::byte(place, "what is packed here is no variable"));
        }
        let variable = reader.matrix(tag.length, 0)?;
        self.unpacked = bytes.left();
        bytes.check_end()?;
        let unread = packed.limit();
        self.bytes.skip_rest(length, unread)?;
        Ok(variable)
    }
}
