//! Breakpoints at lines of files, and the hits of all breakpoints.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt;
use std::ops::Range;
use std::str::FromStr;
use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_vm::{FragmentContext, InstanceId, Space};

use crate::conditions::{CompiledExpression, LogMessage};
use crate::program_breakpoints::{ProgramBreakpoint, ProgramBreakpoints, file_of};

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
    /// A hit counts only if this holds.
    pub condition: Option<CompiledExpression>,
    /// At which of its hits tasks stop; at each without one.
    pub hits: Option<HitCondition>,
    /// The message that it writes in place of a stop.
    pub log: Option<LogMessage>,
}

impl Breakpoint {
    /// A breakpoint without conditions.
    #[must_use]
    pub fn new(id: BreakpointId, row: u32) -> Self {
        Self { id, row, condition: None, hits: None, log: None }
    }
}

/// A condition that cannot be evaluated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConditionFault {
    /// Its breakpoint.
    pub id: BreakpointId,
    /// The reason.
    pub message: String,
}

/// A message that a log point has written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoggedMessage {
    /// The log point.
    pub id: BreakpointId,
    /// The task.
    pub task: TaskNumber,
    /// The message.
    pub text: String,
}

/// The effects of the breakpoints at a line on a task that arrives there.
#[derive(Debug, Default)]
pub(crate) struct Arrival {
    /// The breakpoints that stop it.
    pub(crate) ids: Vec<BreakpointId>,
    /// The conditions that cannot be evaluated. Their breakpoints stop it too.
    pub(crate) faults: Vec<ConditionFault>,
    pub(crate) logged: Vec<LoggedMessage>,
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
    pub(crate) fn holds(self, hit: u64) -> bool {
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
    /// At the beginning of programs.
    pub(crate) programs: ProgramBreakpoints,
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

    /// Replaces the breakpoints at the beginning of programs. Those that stay keep their number of hits.
    pub(crate) fn set_programs(&mut self, breakpoints: Vec<ProgramBreakpoint>) {
        for removed in self.programs.set(breakpoints) {
            self.hits.remove(&removed);
        }
    }

    /// The breakpoints at a line of a program that stop a task there if the number of hits does not matter.
    pub(crate) fn at(&self, controller: &mut Controller, task: TaskNumber) -> Arrival {
        let mut arrival = Arrival::default();
        let Some(next) = NextLine::of(controller, task) else { return arrival };
        for rule in self.rules(&controller.vm.space, &next).into_iter().filter(|rule| rule.log.is_none()) {
            if rule.counts(controller, task, &mut arrival) {
                arrival.ids.push(rule.id);
            }
        }
        arrival
    }

    /// A task has arrived at a line: counts the hits of the breakpoints there.
    pub(crate) fn hit(&mut self, controller: &mut Controller, task: TaskNumber) -> Arrival {
        let mut arrival = Arrival::default();
        let Some(next) = NextLine::of(controller, task) else { return arrival };
        let mut hits = std::mem::take(&mut self.hits);
        for rule in self.rules(&controller.vm.space, &next) {
            if !rule.counts(controller, task, &mut arrival) {
                continue;
            }
            let hit = hits.entry(rule.id).or_default();
            *hit += 1;
            if !rule.hits.is_none_or(|condition| condition.holds(*hit)) {
                continue;
            }
            match rule.log {
                Some(message) => {
                    let text = message.text(controller, FragmentContext::Frame(task, 0));
                    arrival.logged.push(LoggedMessage { id: rule.id, task, text });
                }
                None => arrival.ids.push(rule.id),
            }
        }
        self.hits = hits;
        arrival
    }

    /// The breakpoints at a line: those of its file, and those of its program if the task has just entered it.
    fn rules<'a>(&'a self, space: &Space, next: &'a NextLine) -> Vec<Rule<'a>> {
        let Some(program) = next.image.programs.get(usize::from(next.program)) else { return Vec::new() };
        let in_file = here(&self.files, (&next.image, program), next.line).map(|breakpoint| Rule {
            id: breakpoint.id,
            condition: breakpoint.condition.as_ref(),
            hits: breakpoint.hits,
            log: breakpoint.log.as_ref(),
        });
        if !next.is_entry {
            return in_file.collect();
        }
        let file = file_of(&next.image, program);
        let entered = self.programs.of(space, (next.instance, &program.name)).into_iter().map(|breakpoint| Rule {
            id: breakpoint.id,
            condition: breakpoint.conditions.get(file),
            hits: breakpoint.hits,
            log: None,
        });
        in_file.chain(entered).collect()
    }
}

/// The effect of a breakpoint on a task that arrives.
struct Rule<'a> {
    id: BreakpointId,
    condition: Option<&'a CompiledExpression>,
    hits: Option<HitCondition>,
    log: Option<&'a LogMessage>,
}

impl Rule<'_> {
    /// Whether its condition holds for a task that is before its line. One that cannot be evaluated stops the task.
    fn counts(&self, controller: &mut Controller, task: TaskNumber, arrival: &mut Arrival) -> bool {
        let Some(condition) = self.condition else { return true };
        condition.holds(controller, FragmentContext::Frame(task, 0)).unwrap_or_else(|message| {
            arrival.ids.push(self.id);
            arrival.faults.push(ConditionFault { id: self.id, message });
            false
        })
    }
}

/// The line that a task begins next.
struct NextLine {
    instance: InstanceId,
    image: Arc<Image>,
    program: u16,
    line: usize,
    /// The task has just entered the program.
    is_entry: bool,
}

impl NextLine {
    fn of(controller: &Controller, task: TaskNumber) -> Option<Self> {
        let thread = &controller.vm.tasks().iter().find(|known| known.id == task)?.thread;
        let frame = thread.frames.last()?;
        let image = Arc::clone(&controller.vm.space.instance(frame.instance)?.image);
        let line = image.programs.get(usize::from(frame.program))?.line_of(thread.next)?;
        let is_entry = controller.vm.begins_program(task);
        Some(Self { instance: frame.instance, image, program: frame.program, line, is_entry })
    }
}

/// The breakpoints at a line of a program.
fn here<'a>(
    files: &'a BTreeMap<String, Vec<Breakpoint>>,
    (image, program): (&Image, &'a Program),
    line: usize,
) -> impl Iterator<Item = &'a Breakpoint> {
    let own = files.get(file_of(image, program)).into_iter().flatten();
    let rows = rows_of(program, line);
    own.filter(move |breakpoint| rows.contains(&breakpoint.row))
}

/// The rows from which [`Program::line_from`] leads to a line.
fn rows_of(program: &Program, line: usize) -> Range<u32> {
    let Some(own) = program.lines.get(line) else { return 0..0 };
    let is_first = program.lines.iter().all(|other| other.row != own.row || other.op >= own.op);
    let before = program.lines.iter().map(|line| line.row).filter(|row| *row < own.row).max();
    if is_first { before.map_or(0, |row| row + 1)..own.row + 1 } else { 0..0 }
}
