//! Where a run stands, to bytes and back.

use crate::integrate::{Checkpoint, Counters, Stiffness};
use crate::report::bytes::{Put, Take};
use crate::simulate::{ReferenceStanding, Standing};

pub(super) fn encode(standing: &Standing) -> Vec<u8> {
    let mut bytes = Vec::new();
    bytes.put_f64(standing.time);
    put_checkpoint(&mut bytes, &standing.main);
    bytes.put_option(standing.reference.as_ref(), |bytes, reference| {
        put_checkpoint(bytes, &reference.pass);
        bytes.put_f64(reference.difference);
        bytes.put_f64(reference.excursion);
        bytes.put_option(reference.failure.as_ref(), |bytes, text| {
            bytes.put_text(text)
        });
    });
    bytes
}

/// `None` where the bytes are no standing, or go on after it.
pub(super) fn decode(bytes: &[u8]) -> Option<Standing> {
    let mut take = Take(bytes);
    let standing = Standing {
        time: take.f64()?,
        main: take_checkpoint(&mut take)?,
        reference: take.option(|take| {
            Some(ReferenceStanding {
                pass: take_checkpoint(take)?,
                difference: take.f64()?,
                excursion: take.f64()?,
                failure: take.option(Take::text)?,
            })
        })?,
    };
    take.0.is_empty().then_some(standing)
}

fn put_checkpoint(bytes: &mut Vec<u8>, checkpoint: &Checkpoint) {
    bytes.put_u64(checkpoint.scaled.len() as u64);
    for value in &checkpoint.scaled {
        bytes.put_f64(*value);
    }
    bytes.put_u64(checkpoint.next);
    bytes.put_f64(checkpoint.step);
    bytes.put_u64(checkpoint.latest_step.len() as u64);
    for value in &checkpoint.latest_step {
        bytes.put_f64(*value);
    }
    let Counters {
        steps,
        rejected,
        evaluations,
    } = checkpoint.counters;
    for count in [steps, rejected, evaluations] {
        bytes.put_u64(count);
    }
    bytes.put_option(checkpoint.stiffness.as_ref(), |bytes, stiffness| {
        let Stiffness {
            time,
            step,
            eigenvalue,
            implicit_step,
        } = *stiffness;
        for value in [time, step, eigenvalue, implicit_step] {
            bytes.put_f64(value);
        }
    });
}

fn numbers(take: &mut Take<'_>) -> Option<Vec<f64>> {
    let count = take.u64()?;
    (0..count).map(|_| take.f64()).collect()
}

fn take_checkpoint(take: &mut Take<'_>) -> Option<Checkpoint> {
    Some(Checkpoint {
        scaled: numbers(take)?,
        next: take.u64()?,
        step: take.f64()?,
        latest_step: numbers(take)?,
        counters: Counters {
            steps: take.u64()?,
            rejected: take.u64()?,
            evaluations: take.u64()?,
        },
        stiffness: take.option(|take| {
            Some(Stiffness {
                time: take.f64()?,
                step: take.f64()?,
                eigenvalue: take.f64()?,
                implicit_step: take.f64()?,
            })
        })?,
    })
}
