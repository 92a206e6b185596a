//! Breakpoints at lines of files.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt;
use std::str::FromStr;

use val3_bytecode::{Image, Program};
use val3_vm::Space;

/// The identity of a breakpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BreakpointId(pub u32);

/// A breakpoint at a line of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Breakpoint {
    /// Its identity.
    pub id: BreakpointId,
    /// The line of the file that was asked for, from 1.
    pub row: u32,
    /// At which of its hits tasks stop; at each without one.
    pub hits: Option<HitCondition>,
}

/// At which hits of a breakpoint a task stops, the first hit being 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HitCondition {
    /// `5`: at this hit alone.
    Exactly(u64),
    /// `>=5`: from this hit on.
    From(u64),
    /// `%5`: at each multiple.
    Every(u64),
}

/// A text that is no [`HitCondition`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InvalidHitCondition;

impl fmt::Display for InvalidHitCondition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("write a number of hits such as 5, >=5 or %5")
    }
}

impl Error for InvalidHitCondition {}

impl FromStr for HitCondition {
    type Err = InvalidHitCondition;

    fn from_str(text: &str) -> Result<Self, InvalidHitCondition> {
        let text = text.trim();
        let (kind, number): (fn(u64) -> Self, &str) = if let Some(number) = text.strip_prefix(">=") {
            (Self::From, number)
        } else if let Some(number) = text.strip_prefix('%') {
            (Self::Every, number)
        } else {
            (Self::Exactly, text.trim_start_matches('='))
        };
        let number = number.trim().parse().ok().filter(|number| *number > 0);
        number.map(kind).ok_or(InvalidHitCondition)
    }
}

impl HitCondition {
    fn holds(self, hit: u64) -> bool {
        match self {
            Self::Exactly(number) => hit == number,
            Self::From(number) => hit >= number,
            Self::Every(number) => hit.is_multiple_of(number),
        }
    }
}

/// Where a breakpoint is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placed {
    /// The breakpoint.
    pub id: BreakpointId,
    /// The row of the line at which tasks stop: that of the breakpoint, or the next one with an instruction. `None` where
    /// no application or library in memory has such a line.
    pub row: Option<u32>,
}

/// Numbers of hits.
pub(crate) type Hits = BTreeMap<BreakpointId, u64>;

/// The breakpoints of a run.
#[derive(Debug, Default)]
pub(crate) struct Breakpoints {
    /// By the path of the file.
    files: BTreeMap<String, Vec<Breakpoint>>,
    /// How often tasks have arrived at each.
    pub(crate) hits: Hits,
}

impl Breakpoints {
    /// Replaces the breakpoints of a file. Those that stay keep their number of hits.
    pub(crate) fn set(&mut self, file: &str, breakpoints: Vec<Breakpoint>) {
        let ids: BTreeSet<_> = breakpoints.iter().map(|breakpoint| breakpoint.id).collect();
        let before = self.files.insert(file.to_owned(), breakpoints).unwrap_or_default();
        for breakpoint in before.iter().filter(|breakpoint| !ids.contains(&breakpoint.id)) {
            self.hits.remove(&breakpoint.id);
        }
    }

    /// The rows of a file with breakpoints.
    pub(crate) fn rows(&self, file: &str) -> BTreeSet<u32> {
        self.files.get(file).into_iter().flatten().map(|breakpoint| breakpoint.row).collect()
    }

    /// Where the breakpoints of a file are.
    pub(crate) fn placed(&self, file: &str, space: &Space) -> Vec<Placed> {
        let images = || space.loaded().map(|(_, instance)| &instance.image);
        let programs = || images().flat_map(|image| image.programs.iter().map(move |program| (image, program)));
        let row = |breakpoint: &Breakpoint| {
            let mut own = programs().filter(|(image, program)| file_of(image, program) == file);
            own.find_map(|(_, program)| Some(program.lines.get(program.line_from(breakpoint.row)?)?.row))
        };
        let breakpoints = self.files.get(file).into_iter().flatten();
        breakpoints.map(|breakpoint| Placed { id: breakpoint.id, row: row(breakpoint) }).collect()
    }

    /// The files that have or had breakpoints.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// The breakpoints at a line of a program.
    pub(crate) fn at(&self, image: &Image, program: &Program, line: usize) -> Vec<BreakpointId> {
        here(&self.files, (image, program), line).map(|breakpoint| breakpoint.id).collect()
    }

    /// A task has arrived at a line of a program: the breakpoints there that count it as a hit that they wait for.
    pub(crate) fn hit(&mut self, image: &Image, program: &Program, line: usize) -> Vec<BreakpointId> {
        let Self { files, hits } = self;
        let counted = here(files, (image, program), line).filter(|breakpoint| {
            let hit = hits.entry(breakpoint.id).or_default();
            *hit += 1;
            breakpoint.hits.is_none_or(|condition| condition.holds(*hit))
        });
        counted.map(|breakpoint| breakpoint.id).collect()
    }
}

/// The breakpoints at a line of a program.
fn here<'a>(
    files: &'a BTreeMap<String, Vec<Breakpoint>>,
    (image, program): (&Image, &'a Program),
    line: usize,
) -> impl Iterator<Item = &'a Breakpoint> {
    let own = files.get(file_of(image, program)).into_iter().flatten();
    own.filter(move |breakpoint| program.line_from(breakpoint.row) == Some(line))
}

fn file_of<'i>(image: &'i Image, program: &Program) -> &'i str {
    image.files.get(program.file as usize).map_or("", String::as_str)
}
