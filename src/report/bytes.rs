//! Numbers and texts to bytes and back.

/// Appends numbers and texts to bytes.
pub(super) trait Put {
    fn put_u64(&mut self, value: u64);
    fn put_f64(&mut self, value: f64);
    fn put_text(&mut self, text: &str);
}

impl Put for Vec<u8> {
    fn put_u64(&mut self, value: u64) {
        self.extend(value.to_le_bytes());
    }

    fn put_f64(&mut self, value: f64) {
        self.extend(value.to_le_bytes());
    }

    fn put_text(&mut self, text: &str) {
        self.put_u64(text.len() as u64);
        self.extend(text.as_bytes());
    }
}

/// Takes numbers and texts from bytes; `None` where they end too early or make no sense.
pub(super) struct Take<'a>(pub &'a [u8]);

impl<'a> Take<'a> {
    pub fn bytes(&mut self, count: u64) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(usize::try_from(count).ok()?)?;
        self.0 = rest;
        Some(taken)
    }

    pub fn array<const COUNT: usize>(&mut self) -> Option<[u8; COUNT]> {
        self.bytes(COUNT as u64)?.try_into().ok()
    }

    pub fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    pub fn f64(&mut self) -> Option<f64> {
        self.array().map(f64::from_le_bytes)
    }
}

/// FNV-1a, 64 bits, over words of eight bytes, the last one filled up with zeros: finds bytes that a disk or a copy
/// has changed. The number of bytes goes with it.
///
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, *The FNV Non-Cryptographic Hash Algorithm* (1991).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Checksum {
    hash: u64,
    bytes: u64,
    /// The bytes of a word that is not whole yet.
    begun: [u8; 8],
}

impl Checksum {
    pub const START: Self = Self {
        hash: 0xcbf2_9ce4_8422_2325,
        bytes: 0,
        begun: [0; 8],
    };

    pub fn add(&mut self, mut bytes: &[u8]) {
        let filled = (self.bytes % 8) as usize;
        self.bytes += bytes.len() as u64;
        if filled > 0 {
            let (first, rest) = bytes.split_at(bytes.len().min(8 - filled));
            self.begun[filled..filled + first.len()].copy_from_slice(first);
            if filled + first.len() < 8 {
                return;
            }
            self.end_word();
            bytes = rest;
        }
        let words = bytes.chunks_exact(8);
        let rest = words.remainder();
        for word in words {
            self.begun.copy_from_slice(word);
            self.end_word();
        }
        self.begun[..rest.len()].copy_from_slice(rest);
    }

    fn end_word(&mut self) {
        let word = u64::from_le_bytes(self.begun);
        self.hash = (self.hash ^ word).wrapping_mul(0x0100_0000_01b3);
        self.begun = [0; 8];
    }

    /// Number of bytes.
    pub fn bytes(self) -> u64 {
        self.bytes
    }

    pub fn value(mut self) -> u64 {
        if !self.bytes.is_multiple_of(8) {
            self.end_word();
        }
        self.hash
    }
}

/// So that anything that can be shown can be summed up.
impl std::fmt::Write for Checksum {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_of_a_file_is_that_of_its_pieces() {
        let bytes: Vec<u8> = (0..=255).cycle().take(1003).collect();
        let mut whole = Checksum::START;
        whole.add(&bytes);
        for piece in 1..20 {
            let mut sum = Checksum::START;
            bytes.chunks(piece).for_each(|piece| sum.add(piece));
            assert_eq!((sum.bytes(), sum.value()), (1003, whole.value()));
        }
        let mut other = Checksum::START;
        other.add(&bytes[..1002]);
        assert_ne!(other.value(), whole.value());
    }

    #[test]
    fn the_sum_of_a_word_is_the_published_step() {
        let mut sum = Checksum::START;
        sum.add(b"a");
        assert_eq!(sum.value(), 0xaf63_dc4c_8601_ec8c);
    }
}
