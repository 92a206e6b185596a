//! Numbers of differences.

use std::fmt::{self, Display};

use serde::Serialize;

use crate::model::ReportClass;
use crate::model::{ApplicationChange, Change, Comparison};

/// Numbers of items that differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct DifferenceCounts {
    /// Applications, libraries and user types.
    pub applications: usize,
    /// Number of programs.
    pub programs: usize,
    /// Values of points, joints, frames, tools and transformations.
    pub points: usize,
    /// Positions that moved with a frame or tool.
    pub moved_along: usize,
    /// Data except positions, inputs and outputs.
    pub data: usize,
    /// Data of inputs and outputs, and entries of files that describe them.
    pub io: usize,
    /// Library identifiers and user types.
    pub libraries: usize,
    /// Public items whose interface differs.
    pub interface: usize,
    /// Parameters of applications, and configuration files.
    pub configuration: usize,
    /// Files that were compared as text.
    pub texts: usize,
    /// VAL 3 files with attributes or texts that differ and belong to no item above.
    pub contents: usize,
    /// Other kinds of files.
    pub others: usize,
}

impl DifferenceCounts {
    /// Returns the numbers of a comparison.
    #[must_use]
    pub fn of(comparison: &Comparison) -> Self {
        let mut counts = comparison.applications.iter().fold(Self::default(), Self::with);
        for file in &comparison.settings {
            let count = if file.is_io { &mut counts.io } else { &mut counts.configuration };
            *count += file.entries.len().max(1);
        }
        counts.others = comparison.others.len();
        counts
    }

    /// Adds the numbers for `application`.
    pub(super) fn with(mut self, application: &ApplicationChange) -> Self {
        self.applications += 1;
        self.programs += application.programs.len();
        self.libraries += application.libraries.len() + application.types.len();
        self.interface += application.interface.len();
        self.configuration += application.project.len();
        self.texts += application.texts.len();
        self.contents += application.contents.len();
        for data in &application.data {
            let is_whole = data.change != Change::Changed || data.values.is_empty();
            self.add(data.class, usize::from(is_whole));
            for value in data.values.iter().filter(|_| !is_whole) {
                self.add(value.class, 1);
                self.moved_along += value.dependents.len();
            }
        }
        self
    }

    /// Subtracts the numbers of applications.
    pub(super) fn without<'c>(self, applications: impl Iterator<Item = &'c Self>) -> Self {
        applications.fold(Self { applications: 0, ..self }, |rest, counts| Self {
            applications: 0,
            programs: rest.programs - counts.programs,
            points: rest.points - counts.points,
            moved_along: rest.moved_along - counts.moved_along,
            data: rest.data - counts.data,
            io: rest.io - counts.io,
            libraries: rest.libraries - counts.libraries,
            interface: rest.interface - counts.interface,
            configuration: rest.configuration - counts.configuration,
            texts: rest.texts - counts.texts,
            contents: rest.contents - counts.contents,
            others: rest.others,
        })
    }

    /// Whether all numbers are 0.
    pub(super) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    fn add(&mut self, class: ReportClass, count: usize) {
        match class {
            ReportClass::Points => self.points += count,
            ReportClass::Io => self.io += count,
            _ => self.data += count,
        }
    }
}

/// Formats `2 applications differ: 3 programs, 12 points`.
impl Display for DifferenceCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [
            (self.programs, "program", "programs"),
            (self.points, "position", "positions"),
            (self.moved_along, "position that moved along", "positions that moved along"),
            (self.data, "value", "values"),
            (self.io, "input or output", "inputs and outputs"),
            (self.libraries, "library or type", "libraries and types"),
            (self.interface, "public item", "public items"),
            (self.configuration, "setting", "settings"),
            (self.texts, "file as text", "files as text"),
            (self.contents, "file with other XML", "files with other XML"),
            (self.others, "other file", "other files"),
        ];
        let parts: Vec<String> = parts
            .iter()
            .filter(|(count, ..)| *count > 0)
            .map(|(count, one, many)| counted(*count, one, many))
            .collect();
        match self.applications {
            // Only files of other kinds differ.
            0 if parts.len() == 1 && self.others > 0 => {
                let verb = if self.others == 1 { "differs" } else { "differ" };
                return write!(f, "{} {verb}", parts.concat());
            }
            0 => f.write_str("the configuration differs")?,
            1 => f.write_str("1 application differs")?,
            count => write!(f, "{count} applications differ")?,
        }
        if parts.is_empty() { Ok(()) } else { write!(f, ": {}", parts.join(", ")) }
    }
}

/// Formats `1 program`, `2 programs`.
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
