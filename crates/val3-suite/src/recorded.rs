//! Motion of a test, which is compared with a recorded motion or recorded itself.

use val3_machine::controller::CodeSource;
use val3_machine::event::seconds;
use val3_plot::Picture;
use val3_trace::{Comparison, MotionRecording, Trace, TraceError, TraceFile, amount, compare, describe};

use crate::failure::{Failure, FailureLocation};

/// Help for failures that a new recording resolves.
const RECORD: &str = "`val3 test --update` records this motion";

/// Prefix of failures about motion if the arm has not moved.
pub(crate) const AT_REST: &str = "the arm has not moved (`power = true` in a script gives it power)";

/// Motion of a test.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedMotion {
    pub(crate) recording: MotionRecording,
    pub(crate) picture: Picture,
    pub(crate) file: TraceFile,
    /// Place of the expectation.
    pub(crate) place: FailureLocation,
}

/// Result of a comparison.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Judgement {
    /// Failure; `None` if the motion equals the recorded motion.
    pub failure: Option<Failure>,
    /// Both motions as an SVG file, if they differ.
    pub picture: Option<String>,
}

impl From<Failure> for Judgement {
    fn from(failure: Failure) -> Self {
        Self { failure: Some(failure), picture: None }
    }
}

impl RecordedMotion {
    /// Path of the file with the recorded motion, relative to the file with the expectation.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file.file
    }

    /// Text of the file that records this motion.
    #[must_use]
    pub fn text(&self) -> String {
        self.recording.trace.thinned().to_text()
    }

    /// Failure of a test in which the arm has not moved, so that there is nothing to compare or to record.
    #[must_use]
    pub fn at_rest(&self) -> Option<Failure> {
        let message = format!("{AT_REST}, so there is nothing to compare with `{}`", self.file());
        self.recording.is_empty().then(|| self.failure(message))
    }

    /// Compares the motion with its file's content.
    #[must_use]
    pub fn judge(&self, text: &str) -> Judgement {
        let recorded = match Trace::parse(text) {
            Ok(recorded) => recorded,
            Err(error) => return self.unreadable(&error).into(),
        };
        if let Some(failure) = self.other_arm(&recorded) {
            return failure.into();
        }
        let comparison = compare(&recorded.rows, &self.recording.trace.rows, self.file.tolerances);
        let failure = self.difference(&comparison);
        let picture = failure.is_some().then(|| self.drawn(&recorded, &comparison));
        Judgement { failure, picture }
    }

    /// Failure of a motion that was never recorded.
    #[must_use]
    pub fn missing(&self) -> Failure {
        self.failure(format!("there is no recorded motion `{}`: {RECORD}", self.file()))
    }

    /// Failure of a file that cannot be read.
    #[must_use]
    pub fn refused(&self, reason: &str) -> Failure {
        self.failure(format!("the recorded motion `{}` cannot be read: {reason}", self.file()))
    }

    fn unreadable(&self, error: &TraceError) -> Failure {
        self.failure(format!("the recorded motion `{}` cannot be read: {error}; {RECORD}", self.file()))
    }

    fn failure(&self, message: String) -> Failure {
        Failure { message, places: vec![self.place.clone()] }
    }

    /// Failure of a motion that was recorded with another arm. A trace of `val3 run` does not name its arm.
    fn other_arm(&self, recorded: &Trace) -> Option<Failure> {
        let present = &self.recording.trace;
        let is_same = recorded.axes == present.axes && (recorded.arm.is_none() || recorded.arm == present.arm);
        let name = |trace: &Trace| trace.arm.clone().unwrap_or_else(|| format!("arm with {} axes", trace.axes));
        let message = format!(
            "`{}` was recorded with a {}, and this arm is a {}: choose the arm with --arm or in val3.toml; {RECORD}",
            self.file(),
            name(recorded),
            name(present)
        );
        (!is_same).then(|| self.failure(message))
    }

    /// Failure of a motion that differs.
    fn difference(&self, comparison: &Comparison) -> Option<Failure> {
        let mut findings = describe(comparison, &self.recording).into_iter();
        let first = findings.next()?;
        let further = findings.map(|finding| format!("\n{}", finding.message));
        let message = format!("the motion is not that of `{}`\n{}", self.file(), first.message);
        let places = first.source.map(place_of).into_iter().chain([self.place.clone()]).collect();
        Some(Failure { message: message + &further.collect::<String>(), places })
    }

    /// Draws both motions in one picture.
    fn drawn(&self, recorded: &Trace, comparison: &Comparison) -> String {
        let largest = comparison.largest().filter(|(_, deviation)| deviation.is_beyond());
        let deviation = largest.map(|(_, deviation)| val3_plot::Deviation {
            label: amount(&deviation.distance, &comparison.tolerances),
            at: deviation.at.into(),
            nearest: deviation.distance.nearest.into(),
            t: seconds(deviation.time),
        });
        let reference = recorded.rows.iter().map(val3_plot::Sample::from).collect();
        Picture { reference, deviation, ..self.picture.clone() }.to_svg()
    }
}

/// An instruction's line.
pub(crate) fn place_of(CodeSource { program, file, line, .. }: CodeSource) -> FailureLocation {
    FailureLocation { program, file, line }
}
