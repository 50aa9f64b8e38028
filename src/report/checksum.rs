//! A checksum: finds bytes that a disk or a copy has changed.

use std::io;

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

    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.begun[(self.bytes % 8) as usize] = *byte;
            self.bytes += 1;
            if self.bytes.is_multiple_of(8) {
                self.end_word();
            }
        }
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

/// So that anything that can be written or copied can be summed up.
impl io::Write for Checksum {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.add(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
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
