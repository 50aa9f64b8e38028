//! Arrays as NPZ, which NumPy, SciPy, Julia and MATLAB's readers of NumPy load.

use nalgebra::DMatrix;

/// Arrays in one file: a ZIP archive without compression of one NPY file each.
///
/// Source: NEP 1, *A Simple File Format for NumPy Arrays* (version 1.0); PKWARE, *.ZIP File Format Specification* 6.3,
/// sections 4.3.7, 4.3.12 and 4.3.16.
#[derive(Debug, Default)]
pub struct Npz {
    /// Local headers, each with its file.
    files: Vec<u8>,
    /// The central directory.
    directory: Vec<u8>,
    count: u16,
}

impl Npz {
    /// Adds a matrix of numbers.
    #[must_use]
    pub fn matrix(self, name: &str, matrix: &DMatrix<f64>) -> Self {
        let (rows, columns) = matrix.shape();
        let bytes = matrix.iter().flat_map(|entry| entry.to_le_bytes());
        self.array(name, "<f8", &format!("({rows}, {columns})"), bytes)
    }

    /// Adds a number.
    #[must_use]
    pub fn number(self, name: &str, number: f64) -> Self {
        self.array(name, "<f8", "()", number.to_le_bytes())
    }

    /// Adds words: in UTF-32, all of the length of the longest.
    #[must_use]
    pub fn words<'a>(self, name: &str, words: impl Iterator<Item = &'a str> + Clone) -> Self {
        let longest = words.clone().map(|word| word.chars().count()).max();
        let longest = longest.unwrap_or(0).max(1);
        let count = words.clone().count();
        let bytes = words.flat_map(|word| {
            let padded = word.chars().map(u32::from).chain(std::iter::repeat(0));
            padded.take(longest).flat_map(u32::to_le_bytes)
        });
        self.array(name, &format!("<U{longest}"), &format!("({count},)"), bytes)
    }

    /// Adds an array whose entries stand column by column.
    fn array(
        mut self,
        name: &str,
        kind: &str,
        shape: &str,
        bytes: impl IntoIterator<Item = u8>,
    ) -> Self {
        let mut header =
            format!("{{'descr': '{kind}', 'fortran_order': True, 'shape': {shape}, }}");
        // magic, version and length take ten bytes; the data begins at a multiple of 64
        let filled = (10 + header.len() + 1).next_multiple_of(64) - 11;
        header = format!("{header:filled$}\n");
        let mut file = b"\x93NUMPY\x01\x00".to_vec();
        file.extend((header.len() as u16).to_le_bytes());
        file.extend(header.bytes());
        file.extend(bytes);
        self.add(&format!("{name}.npy"), &file);
        self
    }

    fn add(&mut self, name: &str, file: &[u8]) {
        let offset = self.files.len() as u32;
        let size = (file.len() as u32).to_le_bytes();
        // version 2.0, no flags, stored, midnight of 1 January 1980
        let mut common = [20_u16, 0, 0, 0, 0x21].map(u16::to_le_bytes).concat();
        common.extend(crc32fast::hash(file).to_le_bytes());
        common.extend([size, size].concat());
        common.extend((name.len() as u16).to_le_bytes());
        common.extend([0, 0]);
        self.files.extend([&b"PK\x03\x04"[..], &common].concat());
        self.files.extend([name.as_bytes(), file].concat());
        self.directory.extend(b"PK\x01\x02\x14\x00");
        self.directory.extend(common);
        // no comment, disk 0, no attributes
        self.directory.extend([0; 10]);
        self.directory.extend(offset.to_le_bytes());
        self.directory.extend(name.bytes());
        self.count += 1;
    }

    /// The file.
    pub fn bytes(self) -> Vec<u8> {
        let (offset, size) = (self.files.len() as u32, self.directory.len() as u32);
        let count = self.count.to_le_bytes();
        let mut whole = [self.files, self.directory].concat();
        whole.extend(b"PK\x05\x06\x00\x00\x00\x00");
        whole.extend([count, count].concat());
        whole.extend([size.to_le_bytes(), offset.to_le_bytes()].concat());
        whole.extend([0, 0]);
        whole
    }
}
