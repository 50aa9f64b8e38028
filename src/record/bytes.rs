//! The bytes of a file, read once from front to back, and the numbers in them.

use std::io::{self, BufRead, BufReader, Read, Take};

use super::Problem;

/// Bytes that are turned into numbers at a time, a multiple of the size of every number.
const PIECE: u64 = 24 << 10;

/// Bytes that are read once, of which one knows where one is.
pub(super) struct Bytes<'a> {
    reader: BufReader<Box<dyn Read + 'a>>,
    /// Bytes in front of the next one.
    at: u64,
    /// Bytes that there are altogether, or that may be unpacked.
    end: u64,
    /// Place in the file of what is unpacked.
    packed_at: Option<u64>,
}

impl<'a> Bytes<'a> {
    /// The bytes of a file of this length.
    pub fn new(reader: impl Read + 'a, end: u64) -> Self {
        Self {
            reader: BufReader::with_capacity(1 << 16, Box::new(reader)),
            at: 0,
            end,
            packed_at: None,
        }
    }

    /// What is unpacked from a place of a file, at most `end` bytes.
    pub fn unpacked(reader: impl Read + 'a, end: u64, packed_at: u64) -> Self {
        let packed_at = Some(packed_at);
        Self {
            packed_at,
            ..Self::new(reader, end)
        }
    }

    /// Bytes in front of the next one.
    pub fn at(&self) -> u64 {
        self.at
    }

    /// Bytes that are left.
    pub fn left(&self) -> u64 {
        self.end - self.at
    }

    /// A problem here.
    pub fn problem(&self, what: impl Into<String>) -> Problem {
        Problem::byte(self.packed_at.unwrap_or(self.at), what)
    }

    /// Fails where fewer bytes are left.
    pub fn need(&self, count: u64) -> Result<(), Problem> {
        match self.packed_at {
            _ if count <= self.left() => Ok(()),
            None => Err(Problem::Cut { byte: self.end }),
            Some(_) => Err(self.problem("far more is packed here than a record can have")),
        }
    }

    /// So many bytes to be read by another reader, behind which [`skip_rest`](Self::skip_rest) goes on.
    pub fn part(&mut self, count: u64) -> Take<&mut BufReader<Box<dyn Read + 'a>>> {
        (&mut self.reader).take(count)
    }

    /// Goes on behind a part of which so many bytes were not read.
    pub fn skip_rest(&mut self, count: u64, unread: u64) -> Result<(), Problem> {
        self.at += count - unread;
        self.skip(unread)
    }

    /// Makes sure that nothing more is packed, which checks the sum at the end.
    pub fn check_end(mut self) -> Result<(), Problem> {
        match self.reader.read(&mut [0]) {
            Ok(0) => Ok(()),
            Ok(_) => Err(self.problem("a packed variable is longer than it says")),
            Err(error) => Err(self.problem(format!("a packed variable is broken: {error}"))),
        }
    }

    /// The next bytes.
    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], Problem> {
        let mut array = [0; N];
        self.fill(&mut array)?;
        Ok(array)
    }

    /// So many bytes.
    pub fn take(&mut self, count: u64) -> Result<Vec<u8>, Problem> {
        self.need(count)?;
        let mut taken = vec![0; count as usize];
        self.fill(&mut taken)?;
        Ok(taken)
    }

    /// Leaves bytes out.
    pub fn skip(&mut self, count: u64) -> Result<(), Problem> {
        self.need(count)?;
        self.at += io::copy(&mut (&mut self.reader).take(count), &mut io::sink())?;
        Ok(())
    }

    /// Puts the next line into a buffer, with the byte that ends it; false where there is none.
    pub fn line(&mut self, end: u8, into: &mut Vec<u8>) -> Result<bool, Problem> {
        into.clear();
        Ok(self.reader.read_until(end, into)? > 0)
    }

    /// Gives `take` so many numbers one by one.
    pub fn numbers(
        &mut self,
        count: u64,
        form: Number,
        mut take: impl FnMut(f64),
    ) -> Result<(), Problem> {
        let mut left = count.saturating_mul(form.size());
        self.need(left)?;
        let mut piece = vec![0; left.min(PIECE) as usize];
        while left > 0 {
            let now = left.min(PIECE);
            self.fill(&mut piece[..now as usize])?;
            form.each(&piece[..now as usize], &mut take);
            left -= now;
        }
        Ok(())
    }

    fn fill(&mut self, into: &mut [u8]) -> Result<(), Problem> {
        self.need(into.len() as u64)?;
        match self.reader.read_exact(into) {
            Err(error) if self.packed_at.is_some() => {
                return Err(self.problem(format!("a packed variable is broken: {error}")));
            }
            read => read?,
        }
        self.at += into.len() as u64;
        Ok(())
    }
}

/// How a number is written.
#[derive(Clone, Copy)]
pub(super) struct Number {
    pub kind: Kind,
    pub big_endian: bool,
}

/// Kind and width of a number.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I24,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    /// Bytes of one.
    pub fn size(self) -> u64 {
        match self.kind {
            Kind::I8 | Kind::U8 => 1,
            Kind::I16 | Kind::U16 => 2,
            Kind::I24 => 3,
            Kind::I32 | Kind::U32 | Kind::F32 => 4,
            Kind::I64 | Kind::U64 | Kind::F64 => 8,
        }
    }

    /// Gives `take` the numbers of these bytes.
    pub fn each(self, bytes: &[u8], take: &mut impl FnMut(f64)) {
        let big = self.big_endian;
        match self.kind {
            Kind::I8 => each(bytes, big, take, |it| i8::from_le_bytes(it).into()),
            Kind::U8 => each(bytes, big, take, |it| u8::from_le_bytes(it).into()),
            Kind::I16 => each(bytes, big, take, |it| i16::from_le_bytes(it).into()),
            Kind::U16 => each(bytes, big, take, |it| u16::from_le_bytes(it).into()),
            // as the upper three bytes of four, to which the sign belongs
            Kind::I24 => each(bytes, big, take, |[low, middle, high]| {
                (i32::from_le_bytes([0, low, middle, high]) >> 8).into()
            }),
            Kind::I32 => each(bytes, big, take, |it| i32::from_le_bytes(it).into()),
            Kind::U32 => each(bytes, big, take, |it| u32::from_le_bytes(it).into()),
            Kind::I64 => each(bytes, big, take, |it| i64::from_le_bytes(it) as f64),
            Kind::U64 => each(bytes, big, take, |it| u64::from_le_bytes(it) as f64),
            Kind::F32 => each(bytes, big, take, |it| f32::from_le_bytes(it).into()),
            Kind::F64 => each(bytes, big, take, f64::from_le_bytes),
        }
    }
}

fn each<const N: usize>(
    bytes: &[u8],
    big_endian: bool,
    take: &mut impl FnMut(f64),
    number: impl Fn([u8; N]) -> f64,
) {
    for piece in bytes.as_chunks::<N>().0 {
        let mut piece = *piece;
        if big_endian {
            piece.reverse();
        }
        take(number(piece));
    }
}
