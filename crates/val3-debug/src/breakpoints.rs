//! Breakpoints on lines of files, and the hit counts of all breakpoints.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt;
use std::ops::Range;
use std::str::FromStr;
use std::sync::Arc;

use val3_bytecode::{Image, Program, SourceLine};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_vm::{CounterId, FragmentContext, GuardedOp, InstanceId, Space, StopGuard, StopReason};

use crate::conditions::{CompiledExpression, LogMessage};
use crate::program_breakpoints::{ProgramBreakpoint, ProgramBreakpoints, file_of};

/// Identity of a breakpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BreakpointId(pub u32);

/// Breakpoint on a line of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Breakpoint {
    /// Identity, unique among all breakpoints.
    pub id: BreakpointId,
    /// Requested line of the file, from 1.
    pub row: u32,
    /// Name of the only task that the breakpoint affects; `None` for all tasks.
    pub task: Option<String>,
    /// Condition for a hit to count.
    pub condition: Option<CompiledExpression>,
    /// Hits at which tasks stop; `None` for every hit.
    pub hits: Option<HitCondition>,
    /// Message that is logged instead of a stop.
    pub log: Option<LogMessage>,
}

impl Breakpoint {
    /// Creates a breakpoint without conditions.
    #[must_use]
    pub fn new(id: BreakpointId, row: u32) -> Self {
        Self { id, row, task: None, condition: None, hits: None, log: None }
    }
}

/// A condition that cannot be evaluated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConditionFault {
    /// Breakpoint of the condition.
    pub id: BreakpointId,
    /// Reason, for users.
    pub message: String,
}

/// Message of a log point that a task has passed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoggedMessage {
    /// Log point.
    pub id: BreakpointId,
    /// Task that passed the log point.
    pub task: TaskNumber,
    /// Message text.
    pub text: String,
}

/// Effects of the breakpoints on a line when a task arrives there.
#[derive(Debug, Default)]
pub(crate) struct Arrival {
    /// Breakpoints at which the task stops.
    pub(crate) ids: Vec<BreakpointId>,
    /// Conditions that cannot be evaluated. Their breakpoints stop the task too.
    pub(crate) faults: Vec<ConditionFault>,
    pub(crate) logged: Vec<LoggedMessage>,
}

/// Hits of a breakpoint at which a task stops, counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HitCondition {
    /// `5`: only the fifth hit.
    Exactly(u64),
    /// `>=5`: the fifth hit and all later hits.
    From(u64),
    /// `<=5`: the first five hits.
    Until(u64),
    /// `%5`: every fifth hit.
    Every(u64),
}

/// Error for a text that is no [`HitCondition`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InvalidHitCondition;

impl fmt::Display for InvalidHitCondition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("write a number of hits such as 5, >5, >=5, <5, <=5 or %5")
    }
}

impl Error for InvalidHitCondition {}

impl FromStr for HitCondition {
    type Err = InvalidHitCondition;

    fn from_str(text: &str) -> Result<Self, InvalidHitCondition> {
        let text = text.trim();
        let end = text.find(|letter: char| letter.is_ascii_digit()).ok_or(InvalidHitCondition)?;
        let (operator, number) = text.split_at(end);
        let number: u64 = number.parse().map_err(|_| InvalidHitCondition)?;
        let condition = match operator.trim_end() {
            "" | "=" | "==" => Self::Exactly(number),
            ">=" => Self::From(number),
            ">" => Self::From(number.checked_add(1).ok_or(InvalidHitCondition)?),
            "<=" => Self::Until(number),
            "<" => Self::Until(number.saturating_sub(1)),
            "%" => Self::Every(number),
            _ => return Err(InvalidHitCondition),
        };
        if condition.is_valid() { Ok(condition) } else { Err(InvalidHitCondition) }
    }
}

impl HitCondition {
    /// Whether the number is at least 1, because hits are counted from 1: `<1` would select no hit, and `>=0` every
    /// hit.
    const fn is_valid(self) -> bool {
        matches!(self, Self::Exactly(1..) | Self::From(1..) | Self::Until(1..) | Self::Every(1..))
    }

    /// Returns the number of next hits at which tasks do not stop, after `hits` hits.
    fn passes(self, hits: u64) -> u64 {
        match self {
            Self::Exactly(number) | Self::From(number) if hits < number => number - 1 - hits,
            Self::Exactly(_) => u64::MAX,
            Self::From(_) => 0,
            Self::Until(number) => {
                if hits < number {
                    0
                } else {
                    u64::MAX
                }
            }
            Self::Every(number) => number - 1 - hits % number,
        }
    }

    pub(crate) fn holds(self, hit: u64) -> bool {
        match self {
            Self::Exactly(number) => hit == number,
            Self::From(number) => hit >= number,
            Self::Until(number) => hit <= number,
            Self::Every(number) => hit.is_multiple_of(number),
        }
    }
}

/// Resolved line of a breakpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placed {
    /// Identity of the breakpoint.
    pub id: BreakpointId,
    /// Row of the line at which tasks stop: the requested line, or the next line with an instruction. `None` if no
    /// application or library in memory has such a line.
    pub row: Option<u32>,
}

/// Hit counts by breakpoint.
pub(crate) type Hits = BTreeMap<BreakpointId, u64>;

/// All breakpoints of a run on lines and programs.
#[derive(Debug, Default)]
pub(crate) struct Breakpoints {
    /// Line breakpoints by file path.
    files: BTreeMap<String, Vec<Breakpoint>>,
    /// Breakpoints on the first line of programs.
    pub(crate) programs: ProgramBreakpoints,
    /// Number of arrivals at each breakpoint.
    pub(crate) hits: Hits,
}

impl Breakpoints {
    /// Replaces the breakpoints of a file. A breakpoint whose identity already existed keeps its hit count.
    pub(crate) fn set(&mut self, file: &str, breakpoints: Vec<Breakpoint>) {
        let ids: BTreeSet<_> = breakpoints.iter().map(|breakpoint| breakpoint.id).collect();
        let before = self.files.insert(file.to_owned(), breakpoints).unwrap_or_default();
        for breakpoint in before.iter().filter(|breakpoint| !ids.contains(&breakpoint.id)) {
            self.hits.remove(&breakpoint.id);
        }
    }

    /// Returns the rows of the file that have breakpoints.
    pub(crate) fn rows(&self, file: &str) -> BTreeSet<u32> {
        self.files.get(file).into_iter().flatten().map(|breakpoint| breakpoint.row).collect()
    }

    /// Returns the resolved lines of the file's breakpoints.
    pub(crate) fn placed(&self, file: &str, space: &Space) -> Vec<Placed> {
        let breakpoints = self.files.get(file).into_iter().flatten();
        let placed =
            breakpoints.map(|breakpoint| Placed { id: breakpoint.id, row: resolved_row(space, file, breakpoint.row) });
        placed.collect()
    }

    /// Returns the files that have breakpoints or had some earlier.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// Replaces the breakpoints on programs. A breakpoint whose identity already existed keeps its hit count.
    pub(crate) fn set_programs(&mut self, breakpoints: Vec<ProgramBreakpoint>) {
        for removed in self.programs.set(breakpoints) {
            self.hits.remove(&removed);
        }
    }

    /// Returns the breakpoints that stop the task at its next line, ignoring hit conditions.
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

    /// Counts the hits of the breakpoints on the line at which the task has arrived.
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

    /// Returns the numbers of next hits at which tasks do not stop, for the breakpoints with hit conditions.
    pub(crate) fn passes(&self) -> impl Iterator<Item = (CounterId, u64)> {
        let of_lines = self.files.values().flatten().map(|breakpoint| (breakpoint.id, breakpoint.hits));
        let passes = of_lines.chain(self.programs.hit_conditions()).filter_map(|(id, condition)| {
            let hits = self.hits.get(&id).copied().unwrap_or_default();
            Some((counter(id), condition?.passes(hits)))
        });
        passes.filter(|(_, passes)| *passes > 0)
    }

    /// Adds the hits that the virtual machine has counted.
    pub(crate) fn add_hits(&mut self, counted: impl IntoIterator<Item = (CounterId, u64)>) {
        for (CounterId(id), hits) in counted {
            *self.hits.entry(BreakpointId(id)).or_default() += hits;
        }
    }

    /// Returns guards for the stop marks at which the virtual machine can exclude stops by the task, the condition or the
    /// hit count of each breakpoint.
    pub(crate) fn guards(&self, space: &Space) -> Vec<StopGuard> {
        let mut guards = Vec::new();
        for (instance, owner) in space.loaded() {
            for (number, program) in (0..).zip(&owner.image.programs) {
                let stops = (0..).zip(&program.code).filter(|(_, step)| step.mark.is_stop());
                guards
                    .extend(stops.filter_map(|(op, _)| self.guard(space, GuardedOp { instance, program: number, op })));
            }
        }
        guards
    }

    fn guard(&self, space: &Space, place: GuardedOp) -> Option<StopGuard> {
        let image = Arc::clone(&space.instance(place.instance)?.image);
        let program = image.programs.get(usize::from(place.program))?;
        let line = program.halt_at(place.op)?;
        let is_entry = place.op == 0 || program.entry() == Some(place.op);
        let next =
            NextLine { instance: place.instance, program: place.program, line, is_entry, image: Arc::clone(&image) };
        let rules = self.rules(space, &next);
        let reasons = rules.iter().map(|rule| StopReason {
            task: rule.task,
            condition: rule.condition.map(|condition| &condition.fragment),
            counter: rule.hits.map(|_| counter(rule.id)),
        });
        StopGuard::new(space, place, reasons)
    }

    /// Returns the breakpoints on a line: the file's breakpoints, and the program's breakpoints if the task has just
    /// entered it.
    fn rules<'a>(&'a self, space: &Space, next: &'a NextLine) -> Vec<StopRule<'a>> {
        let Some(program) = next.image.programs.get(usize::from(next.program)) else { return Vec::new() };
        let in_file = here(&self.files, &next.image, program, next.line).map(|breakpoint| StopRule {
            id: breakpoint.id,
            task: breakpoint.task.as_deref(),
            condition: breakpoint.condition.as_ref(),
            hits: breakpoint.hits,
            log: breakpoint.log.as_ref(),
        });
        if !next.is_entry {
            return in_file.collect();
        }
        let file = file_of(&next.image, program);
        let entered = self.programs.of(space, next.instance, &program.name).into_iter().map(|breakpoint| StopRule {
            id: breakpoint.id,
            task: breakpoint.task.as_deref(),
            condition: breakpoint.conditions.get(file),
            hits: breakpoint.hits,
            log: None,
        });
        in_file.chain(entered).collect()
    }
}

/// Properties of a line or program breakpoint that determine whether a task stops.
struct StopRule<'a> {
    id: BreakpointId,
    task: Option<&'a str>,
    condition: Option<&'a CompiledExpression>,
    hits: Option<HitCondition>,
    log: Option<&'a LogMessage>,
}

impl StopRule<'_> {
    /// Whether the breakpoint affects the task, and its condition holds before the line. If the condition cannot be
    /// evaluated, returns false, and adds the breakpoint and the fault to `arrival`, so that the task stops.
    fn counts(&self, controller: &mut Controller, task: TaskNumber, arrival: &mut Arrival) -> bool {
        if self.task.is_some_and(|name| !is_named(controller, task, name)) {
            return false;
        }
        let Some(condition) = self.condition else { return true };
        condition.holds(controller, FragmentContext::Frame(task, 0)).unwrap_or_else(|message| {
            arrival.ids.push(self.id);
            arrival.faults.push(ConditionFault { id: self.id, message });
            false
        })
    }
}

/// Returns the number of the breakpoint's hit counter in the virtual machine.
const fn counter(BreakpointId(id): BreakpointId) -> CounterId {
    CounterId(id)
}

fn is_named(controller: &Controller, task: TaskNumber, name: &str) -> bool {
    controller.vm.tasks().iter().any(|known| known.id == task && known.name == name)
}

/// Next line of a task.
struct NextLine {
    instance: InstanceId,
    image: Arc<Image>,
    program: u16,
    line: SourceLine,
    /// Whether the task has just entered the program.
    is_entry: bool,
}

impl NextLine {
    fn of(controller: &Controller, task: TaskNumber) -> Option<Self> {
        if controller.vm.is_at_end(task) {
            return None;
        }
        let thread = &controller.vm.tasks().iter().find(|known| known.id == task)?.thread;
        let frame = thread.frames.last()?;
        let image = Arc::clone(&controller.vm.space.instance(frame.instance)?.image);
        let line = image.programs.get(usize::from(frame.program))?.halt_at(thread.next)?;
        let is_entry = controller.vm.begins_program(task);
        Some(Self { instance: frame.instance, image, program: frame.program, line, is_entry })
    }
}

/// Returns the row of the line with code to which a row of a file resolves.
fn resolved_row(space: &Space, file: &str, row: u32) -> Option<u32> {
    let images = space.loaded().map(|(_, instance)| &instance.image);
    let programs = images.flat_map(|image| image.programs.iter().filter(|program| file_of(image, program) == file));
    programs.filter_map(|program| Some(program.halt_from(row)?.row)).next()
}

/// Returns the breakpoints on a line of a program.
fn here<'a>(
    files: &'a BTreeMap<String, Vec<Breakpoint>>,
    image: &Image,
    program: &'a Program,
    line: SourceLine,
) -> impl Iterator<Item = &'a Breakpoint> {
    let own = files.get(file_of(image, program)).into_iter().flatten();
    let rows = rows_of(program, line);
    own.filter(move |breakpoint| rows.contains(&breakpoint.row))
}

/// Returns the rows that [`Program::halt_from`] resolves to a line or closing keyword.
fn rows_of(program: &Program, own: SourceLine) -> Range<u32> {
    let is_first = program.halt_from(own.row) == Some(own);
    let rows = program.lines.iter().chain(&program.closings).map(|line| line.row);
    let before = rows.filter(|row| *row < own.row).max();
    if is_first { before.map_or(0, |row| row + 1)..own.row + 1 } else { 0..0 }
}
