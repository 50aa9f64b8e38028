//! Which values of quantities explain what was measured.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::AskError;
use crate::fit::{Effort, NoAnswer, Point, Problem, Work};
use crate::report::{Findings, fit_findings};
use crate::scenario::FitFile;

/// Which values of quantities of a scenario explain what was measured.
#[derive(Debug, Clone, Copy)]
pub struct FitQuestion<'a> {
    file: &'a FitFile,
    /// Number of threads.
    threads: usize,
}

impl<'a> FitQuestion<'a> {
    /// Asks for the unknowns of a file, on so many threads, or on all of the machine.
    pub fn new(file: &'a FitFile, threads: Option<usize>) -> Self {
        Self {
            file,
            threads: threads.unwrap_or_else(super::sensitivity::all_threads),
        }
    }

    /// Searches until its end or `stop` is set, then with the best so far; counts the places at which the scene is answered.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the scene has no answer at any start, or it was stopped before there was one.
    pub fn answer(&self, stop: &AtomicBool, answered: &AtomicU64) -> Result<Findings, AskError> {
        let file = self.file;
        let scene = |values: &[f64], near: Option<&Point>, effort: Effort| {
            answered.fetch_add(1, Ordering::Relaxed);
            self.point(values, near, effort, stop)
        };
        let problem = Problem {
            unknowns: &file.unknowns,
            observations: &file.observations,
            scene: &scene,
            starts: file.starts,
            work: Work {
                threads: self.threads,
                stop,
            },
        };
        let found = problem.fit().map_err(AskError::failed)?;
        Ok(fit_findings(file, &found, answered.load(Ordering::Relaxed)))
    }

    /// What is computed at values of the unknowns: the numbers of every question.
    fn point(
        &self,
        values: &[f64],
        near: Option<&Point>,
        effort: Effort,
        stop: &AtomicBool,
    ) -> Result<Point, NoAnswer> {
        let mut numbers = vec![None; self.file.readings.len()];
        let mut orbits = Vec::new();
        for place in 0..self.file.questions() {
            let question = self.file.question(place, values, effort);
            let question = question.map_err(|issue| NoAnswer::Failed(issue.to_string()))?;
            let near = near.and_then(|near| near.orbits[place].as_ref());
            let answer = question.answer(near, stop)?;
            for (number, (of, wanted)) in numbers.iter_mut().zip(&self.file.readings) {
                if *of == place {
                    *number = Some(answer.number(wanted)?);
                }
            }
            orbits.push(answer.orbit);
        }
        Ok(Point {
            numbers: numbers.into_iter().flatten().collect(),
            orbits,
        })
    }
}
