//! WAV: chunks of a RIFF file, of which `fmt ` says how the numbers in `data` are written.

use super::bytes::{Bytes, Kind, Number};
use super::{MOST_CHANNELS, Problem, Record, RecordChannel, Sampling};

/// Tags of the forms of samples.
const PCM: u16 = 1;
const FLOAT: u16 = 3;
const EXTENSIBLE: u16 = 0xfffe;

/// What the chunk `fmt ` says.
struct Layout {
    channels: u16,
    rate: u32,
    number: Number,
    /// The number that stands for nothing, and how far full scale is above it.
    zero: f64,
    full_scale: f64,
}

/// Reads the channels, integers as fractions of full scale.
pub(super) fn read(record: &mut Record, mut bytes: Bytes<'_>) -> Result<(), Problem> {
    let (mut layout, mut long) = (None, None);
    bytes.skip(12)?;
    loop {
        let id: [u8; 4] = bytes.array()?;
        let length = u32::from_le_bytes(bytes.array()?);
        match &id {
            b"data" => {
                let layout =
                    layout.ok_or_else(|| bytes.problem("no chunk `fmt ` before `data`"))?;
                let length = long.filter(|_| length == u32::MAX).unwrap_or(length.into());
                return samples(record, &mut bytes, &layout, length);
            }
            b"fmt " => {
                let chunk = bytes.take(length.into())?;
                layout = Some(Layout::parse(&chunk).map_err(|what| bytes.problem(what))?);
            }
            // the lengths of a file of more than 4 GiB
            b"ds64" => {
                let chunk = bytes.take(length.into())?;
                long = chunk
                    .get(8..)
                    .and_then(|it| Some(u64::from_le_bytes(*it.first_chunk()?)));
            }
            _ => bytes.skip(length.into())?,
        }
        // chunks begin at even places
        bytes.skip(u64::from(length % 2))?;
    }
}

impl Layout {
    fn parse(chunk: &[u8]) -> Result<Self, String> {
        let Some(&[t0, t1, c0, c1, r0, r1, r2, r3, _, _, _, _, b0, b1, ..]) =
            chunk.first_chunk::<16>()
        else {
            return Err("the chunk `fmt ` has fewer than 16 bytes".to_owned());
        };
        let [tag, channels, block] = [[t0, t1], [c0, c1], [b0, b1]].map(u16::from_le_bytes);
        let rate = u32::from_le_bytes([r0, r1, r2, r3]);
        // the tag proper begins the identifier at the end of the longer form
        let tag = match chunk.get(24..26) {
            Some(&[low, high]) if tag == EXTENSIBLE => u16::from_le_bytes([low, high]),
            _ => tag,
        };
        if channels == 0 || rate == 0 || usize::from(channels) > MOST_CHANNELS {
            return Err(format!("{channels} channels at {rate} Hz cannot be"));
        }
        // bits that are not used are the lowest ones of a sample
        let bits = 8 * u32::from(block / channels);
        let kind = match (tag, bits) {
            (PCM, 8) => Kind::U8,
            (PCM, 16) => Kind::I16,
            (PCM, 24) => Kind::I24,
            (PCM, 32) => Kind::I32,
            (FLOAT, 32) => Kind::F32,
            (FLOAT, 64) => Kind::F64,
            _ => {
                let way = "save the file as PCM of 8, 16, 24 or 32 bits, or as floating point";
                return Err(format!(
                    "samples of form {tag} with {bits} bits are not read; {way}"
                ));
            }
        };
        let half = f64::from(bits.saturating_sub(1)).exp2();
        Ok(Self {
            channels,
            rate,
            number: Number {
                kind,
                big_endian: false,
            },
            zero: if kind == Kind::U8 { half } else { 0.0 },
            full_scale: if tag == FLOAT { 1.0 } else { half },
        })
    }
}

fn samples(
    record: &mut Record,
    bytes: &mut Bytes<'_>,
    layout: &Layout,
    stated: u64,
) -> Result<(), Problem> {
    let count = usize::from(layout.channels);
    let frame = count as u64 * layout.number.size();
    let frames = stated.min(bytes.left()) / frame;
    if stated > bytes.left() {
        let all = stated / frame;
        record.warn(format!(
            "the file ends after {frames} of {all} samples a channel"
        ));
    }
    let empty = |_| Vec::with_capacity(frames as usize);
    let mut channels: Vec<_> = (0..count).map(empty).collect();
    let mut next = 0;
    bytes.numbers(frames * count as u64, layout.number, |number| {
        channels[next].push((number - layout.zero) / layout.full_scale);
        next = if next + 1 == count { 0 } else { next + 1 };
    })?;
    let rate = layout.rate.into();
    for (number, samples) in (1..).zip(channels) {
        record.add(RecordChannel {
            sampling: Sampling::Even { rate, start: 0.0 },
            ..RecordChannel::new(format!("channel{number}"), samples)
        })?;
    }
    Ok(())
}
