//! The breakpoints of a client.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use val3_debug::{
    Breakpoint, BreakpointId, DataAccess, DataBreakpoint, Debugger, HitCondition, Placed, ProgramBreakpoint,
    ProgramName, StopErrors, WatchedData,
};
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;

use crate::assertions;
use crate::capabilities::{ALL_ERRORS, ASSERTIONS, CONTACTS, LISTED_ERRORS, MOTION_ERRORS, UNHANDLED_ERRORS, filters};
use crate::condition_text::ConditionText;
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;
use crate::protocol::{
    self, BreakpointLocation, BreakpointLocationsArguments, BreakpointReason, DataBreakpointAccessType,
    FunctionBreakpoint, SetBreakpointsArguments, SetExceptionBreakpointsArguments, Source, SourceBreakpoint,
};

/// Breakpoints of a client, by file path in the client's spelling.
#[derive(Debug, Default)]
pub(crate) struct BreakpointTable {
    files: BTreeMap<String, SourceBreakpoints>,
    programs: Vec<(BreakpointId, FunctionBreakpoint)>,
    /// Results of `dataBreakpointInfo`, by data id.
    known_data: BTreeMap<String, WatchedData>,
    data: Vec<BreakpointId>,
    /// Breakpoints on local variables that were reported to the client as ended with their program.
    ended: BTreeSet<BreakpointId>,
    errors: StopErrors,
    /// Whether failed assertions stop the run.
    stops_at_assertions: bool,
    last_id: u32,
}

/// Reason why a breakpoint is not verified, for users.
#[derive(Debug, Clone)]
struct Unverified(String);

impl Unverified {
    /// Converts an error from a different crate.
    fn new(error: impl fmt::Display) -> Self {
        Self(error.to_string())
    }
}

/// The breakpoints of a file.
#[derive(Debug, Clone)]
struct SourceBreakpoints {
    source: Source,
    breakpoints: Vec<(BreakpointId, SourceBreakpoint)>,
}

impl BreakpointTable {
    /// Creates a table without breakpoints, in which the default filters select errors until the client sets filters.
    pub(crate) fn with_default_filters() -> Self {
        let mut table = Self::default();
        let defaults = filters().into_iter().filter(|filter| filter.default == Some(true));
        for filter in defaults {
            // The adapter's own filters are valid.
            let _ = table.add_filter(&filter.filter, None);
        }
        table
    }

    /// Replaces the breakpoints of a file.
    pub(crate) fn set(
        &mut self,
        arguments: SetBreakpointsArguments,
        run: &mut DebuggedRun<'_>,
        conventions: &Conventions,
    ) -> Vec<protocol::Breakpoint> {
        let SetBreakpointsArguments { source, breakpoints, lines, .. } = arguments;
        let at_line = |line| SourceBreakpoint { line, ..SourceBreakpoint::default() };
        let wanted = breakpoints.unwrap_or_else(|| lines.unwrap_or_default().into_iter().map(at_line).collect());
        let path = source.path.clone().unwrap_or_default();
        let before = self.files.remove(&path).map(|file| file.breakpoints).unwrap_or_default();
        let breakpoints = self.identified(wanted, &before);
        let file = SourceBreakpoints { source, breakpoints };
        let placed = file.place(run, conventions);
        self.files.insert(path, file);
        placed
    }

    /// Places all breakpoints again, after libraries have been loaded or the application has been opened again.
    pub(crate) fn place_all(&self, run: &mut DebuggedRun<'_>, conventions: &Conventions) -> Vec<protocol::Breakpoint> {
        let mut placed: Vec<_> = self.files.values().flat_map(|file| file.place(run, conventions)).collect();
        placed.extend(self.place_programs(run, conventions));
        placed
    }

    /// Replaces the breakpoints at the beginning of programs.
    pub(crate) fn set_programs(
        &mut self,
        wanted: Vec<FunctionBreakpoint>,
        run: &mut DebuggedRun<'_>,
        conventions: &Conventions,
    ) -> Vec<protocol::Breakpoint> {
        let before = std::mem::take(&mut self.programs);
        self.programs = self.identified(wanted, &before);
        self.place_programs(run, conventions)
    }

    fn place_programs(&self, run: &mut DebuggedRun<'_>, conventions: &Conventions) -> Vec<protocol::Breakpoint> {
        let parsed: Vec<(BreakpointId, Result<ProgramBreakpoint, Unverified>)> =
            self.programs.iter().map(|(id, breakpoint)| (*id, program(*id, breakpoint))).collect();
        let mut valid: Vec<ProgramBreakpoint> = parsed.iter().filter_map(|(_, parsed)| parsed.clone().ok()).collect();
        let placed = run.debugger.set_program_breakpoints(valid.clone());
        let places: BTreeMap<BreakpointId, Vec<(String, u32)>> =
            placed.into_iter().map(|placed| (placed.id, placed.places)).collect();
        let mut faults = BTreeMap::new();
        for breakpoint in &mut valid {
            let condition = self.programs.iter().find(|(id, _)| *id == breakpoint.id);
            let condition = condition.and_then(|(_, wanted)| written(wanted.condition.as_deref()));
            for (file, _) in places.get(&breakpoint.id).into_iter().flatten() {
                let Some(text) = condition else { continue };
                match ConditionText::compiled(text, file, run) {
                    Ok(ConditionText { task, condition }) => {
                        breakpoint.task = task;
                        breakpoint.conditions.extend(condition.map(|compiled| (file.clone(), compiled)));
                    }
                    Err(error) => _ = faults.insert(breakpoint.id, Unverified::new(error)),
                }
            }
        }
        valid.retain(|breakpoint| !faults.contains_key(&breakpoint.id));
        valid.extend(self.stops_at_assertions.then(assertions::breakpoint));
        // The places are needed to compile the conditions.
        run.debugger.set_program_breakpoints(valid);
        let answer = parsed.into_iter().map(|(id, parsed)| {
            let place = places.get(&id).and_then(|places| places.first());
            let row = match (parsed, faults.get(&id), place) {
                (Err(message), ..) => Err(message),
                (_, Some(message), _) => Err(message.clone()),
                (.., None) => {
                    return unplaced(id, BreakpointReason::Pending, "nothing in memory has such a program yet");
                }
                (.., Some((_, row))) => Ok(*row),
            };
            shown(id, row, place.map_or("", |(file, _)| file), conventions)
        });
        answer.collect()
    }

    /// Replaces the breakpoints on data.
    pub(crate) fn set_data(
        &mut self,
        wanted: &[protocol::DataBreakpoint],
        run: &mut DebuggedRun<'_>,
    ) -> Vec<protocol::Breakpoint> {
        let mut set = Vec::new();
        let mut answer = Vec::new();
        for breakpoint in wanted {
            let id = self.new_id();
            let parsed = self.data_breakpoint(id, breakpoint, run);
            answer.push(protocol::Breakpoint {
                id: Some(number(id)),
                verified: parsed.is_ok(),
                message: parsed.as_ref().err().map(|reason| reason.0.clone()),
                ..protocol::Breakpoint::default()
            });
            set.extend(parsed);
        }
        self.data = set.iter().map(|breakpoint| breakpoint.id).collect();
        run.debugger.set_data_breakpoints(set);
        // A breakpoint that the client sets again may be about a program that has ended.
        for ended in self.ended_data(run.debugger) {
            answer.iter_mut().filter(|breakpoint| breakpoint.id == ended.id).for_each(|known| *known = ended.clone());
        }
        answer
    }

    fn data_breakpoint(
        &self,
        id: BreakpointId,
        wanted: &protocol::DataBreakpoint,
        run: &mut DebuggedRun<'_>,
    ) -> Result<DataBreakpoint, Unverified> {
        let vm = &run.debugger.controller.vm;
        let condition = written(wanted.condition.as_deref());
        let condition = condition.map(|text| run.evaluator.global_condition(vm, text).map_err(Unverified::new));
        let data = self.known_data.get(&wanted.data_id).cloned();
        let access = match wanted.access_type {
            Some(DataBreakpointAccessType::Read) => DataAccess::Read,
            Some(DataBreakpointAccessType::ReadWrite) => DataAccess::ReadWrite,
            Some(DataBreakpointAccessType::Write) | None => DataAccess::Write,
        };
        Ok(DataBreakpoint {
            id,
            data: data.ok_or_else(|| Unverified(format!("`{}` is not known in this run", wanted.data_id)))?,
            access,
            condition: condition.transpose()?,
            hits: hits(wanted.hit_condition.as_deref())?,
        })
    }

    /// Stores data for a later `setDataBreakpoints`, and returns the data id.
    pub(crate) fn know_data(&mut self, data: WatchedData) -> String {
        let id = data.id().to_owned();
        self.known_data.insert(id.clone(), data);
        id
    }

    /// Returns stored data.
    pub(crate) fn known_data(&self, id: &str) -> Option<&WatchedData> {
        self.known_data.get(id)
    }

    /// Chooses the run-time errors that stop the run.
    pub(crate) fn set_errors(
        &mut self,
        arguments: &SetExceptionBreakpointsArguments,
        run: &mut DebuggedRun<'_>,
        conventions: &Conventions,
    ) -> Vec<protocol::Breakpoint> {
        (self.errors, self.stops_at_assertions) = (StopErrors::default(), false);
        let options = arguments.filter_options.iter().flatten();
        let options = options.map(|option| (option.filter_id.as_str(), option.condition.as_deref()));
        let filters = arguments.filters.iter().map(|filter| (filter.as_str(), None)).chain(options);
        let mut answer = Vec::new();
        for (filter, condition) in filters {
            let added = self.add_filter(filter, condition);
            let (verified, message) = (added.is_ok(), added.err().map(|reason| reason.0));
            answer.push(protocol::Breakpoint { verified, message, ..protocol::Breakpoint::default() });
        }
        self.apply_errors(run, conventions);
        answer
    }

    /// Whether an error with this number stops the run even if a task can handle it.
    pub(crate) fn always_stops_at(&self, number: u16) -> bool {
        let StopErrors { all, motion, numbers, .. } = &self.errors;
        *all || numbers.contains(&number) || (*motion && runtime_errors::is_motion(number))
    }

    /// Adds the errors of a filter.
    fn add_filter(&mut self, filter: &str, condition: Option<&str>) -> Result<(), Unverified> {
        match filter {
            ALL_ERRORS => self.errors.all = true,
            UNHANDLED_ERRORS => self.errors.unhandled = true,
            MOTION_ERRORS => self.errors.motion = true,
            CONTACTS => self.errors.contacts = true,
            ASSERTIONS => self.stops_at_assertions = true,
            LISTED_ERRORS => self.errors.numbers.extend(numbers(condition.unwrap_or_default())?),
            _ => return Err(Unverified(format!("there is no filter `{filter}`"))),
        }
        Ok(())
    }

    /// Applies the selected run-time errors and failed assertions to the run.
    pub(crate) fn apply_errors(&self, run: &mut DebuggedRun<'_>, conventions: &Conventions) {
        run.debugger.set_errors(self.errors.clone());
        self.place_programs(run, conventions);
    }

    /// Returns the breakpoints on local variables whose program has ended since the last call, or exists again because
    /// the run has gone back.
    pub(crate) fn ended_data(&mut self, debugger: &Debugger) -> Vec<protocol::Breakpoint> {
        let now = debugger.ended_data();
        let before = std::mem::replace(&mut self.ended, now.clone());
        let message = "the program of this variable has ended: a later call has a new variable";
        let ended = now.difference(&before).map(|id| unplaced(*id, BreakpointReason::Failed, message));
        let alive = before.difference(&now).filter(|id| self.data.contains(id)).map(|id| protocol::Breakpoint {
            id: Some(number(*id)),
            verified: true,
            ..protocol::Breakpoint::default()
        });
        ended.chain(alive).collect()
    }

    /// Removes the breakpoints on data, because an application that is opened again has new data.
    pub(crate) fn remove_data(&mut self) -> Vec<protocol::Breakpoint> {
        self.known_data.clear();
        let message = "the application was opened again: set the breakpoint again";
        let removed = std::mem::take(&mut self.data).into_iter();
        removed.map(|id| unplaced(id, BreakpointReason::Failed, message)).collect()
    }

    /// Returns the breakpoints with their ids. An unchanged breakpoint keeps its id, and therefore its hit count.
    fn identified<T: PartialEq>(&mut self, wanted: Vec<T>, before: &[(BreakpointId, T)]) -> Vec<(BreakpointId, T)> {
        let identified = wanted.into_iter().map(|wanted| {
            let known = before.iter().find(|(_, breakpoint)| *breakpoint == wanted);
            (known.map_or_else(|| self.new_id(), |(id, _)| *id), wanted)
        });
        identified.collect()
    }

    /// Returns an identity that no breakpoint has had.
    pub(crate) fn new_id(&mut self) -> BreakpointId {
        self.last_id += 1;
        BreakpointId(self.last_id)
    }
}

/// Returns a breakpoint without a line, for the client, with the reason.
fn unplaced(id: BreakpointId, reason: BreakpointReason, message: &str) -> protocol::Breakpoint {
    protocol::Breakpoint {
        id: Some(number(id)),
        message: Some(message.to_owned()),
        reason: Some(reason),
        ..protocol::Breakpoint::default()
    }
}

impl SourceBreakpoints {
    fn place(&self, run: &mut DebuggedRun<'_>, conventions: &Conventions) -> Vec<protocol::Breakpoint> {
        let Some(file) = file_of(&self.source, &run.debugger.controller) else {
            let message = "the application has loaded no program of this file yet";
            let pending = self.breakpoints.iter();
            return pending.map(|(id, _)| unplaced(*id, BreakpointReason::Pending, message)).collect();
        };
        let parsed =
            self.breakpoints.iter().map(|(id, breakpoint)| (*id, parse(*id, breakpoint, &file, run, conventions)));
        let parsed: Vec<(BreakpointId, Result<Breakpoint, Unverified>)> = parsed.collect();
        let valid = parsed.iter().filter_map(|(_, parsed)| parsed.clone().ok()).collect();
        let rows: BTreeMap<BreakpointId, Option<u32>> =
            run.debugger.set_breakpoints(&file, valid).into_iter().map(|Placed { id, row, .. }| (id, row)).collect();
        let placed = parsed.into_iter().map(|(id, parsed)| {
            let row = parsed.and_then(|_| {
                let row = rows.get(&id).copied().flatten();
                row.ok_or_else(|| Unverified::new("no instruction follows this line"))
            });
            shown(id, row, &file, conventions)
        });
        placed.collect()
    }
}

fn parse(
    id: BreakpointId,
    breakpoint: &SourceBreakpoint,
    file: &str,
    run: &mut DebuggedRun<'_>,
    conventions: &Conventions,
) -> Result<Breakpoint, Unverified> {
    let condition = written(breakpoint.condition.as_deref());
    let condition = condition.map(|text| ConditionText::compiled(text, file, run)).transpose();
    let ConditionText { task, condition } = condition.map_err(Unverified::new)?.unwrap_or_default();
    let vm = &run.debugger.controller.vm;
    let log = written(breakpoint.log_message.as_deref());
    let log = log.map(|text| run.evaluator.log_message(vm, file, text)).transpose();
    Ok(Breakpoint {
        task,
        condition,
        hits: hits(breakpoint.hit_condition.as_deref())?,
        log: log.map_err(Unverified::new)?,
        ..Breakpoint::new(id, conventions.row(breakpoint.line))
    })
}

/// Returns the text if it is not blank.
fn written(text: Option<&str>) -> Option<&str> {
    text.filter(|text| !text.trim().is_empty())
}

fn hits(text: Option<&str>) -> Result<Option<HitCondition>, Unverified> {
    let parsed = written(text).map(str::parse).transpose();
    parsed.map_err(|error: val3_debug::InvalidHitCondition| Unverified::new(error))
}

/// Parses the condition of an exception filter: run-time error numbers.
fn numbers(text: &str) -> Result<BTreeSet<u16>, Unverified> {
    let parts = text.split([',', ' ', ';']).filter(|part| !part.is_empty());
    parts.map(error_number).collect()
}

fn error_number(text: &str) -> Result<u16, Unverified> {
    text.parse().map_err(|_| Unverified(format!("`{text}` is not the number of a run-time error")))
}

fn program(id: BreakpointId, wanted: &FunctionBreakpoint) -> Result<ProgramBreakpoint, Unverified> {
    let Ok(name) = wanted.name.parse::<ProgramName>();
    Ok(ProgramBreakpoint { hits: hits(wanted.hit_condition.as_deref())?, ..ProgramBreakpoint::new(id, name) })
}

/// Returns a breakpoint for the client: its row, or the reason why it has none.
fn shown(
    id: BreakpointId,
    row: Result<u32, Unverified>,
    file: &str,
    conventions: &Conventions,
) -> protocol::Breakpoint {
    let id = Some(number(id));
    match row {
        Ok(row) => protocol::Breakpoint {
            verified: true,
            id,
            line: Some(conventions.line(row)),
            source: Some(conventions.source(file)),
            ..protocol::Breakpoint::default()
        },
        Err(Unverified(message)) => protocol::Breakpoint {
            id,
            message: Some(message),
            reason: Some(BreakpointReason::Failed),
            ..protocol::Breakpoint::default()
        },
    }
}

/// Returns this number of unverified breakpoints, for a run that is not debugged.
pub(crate) fn ignored(count: usize) -> Vec<protocol::Breakpoint> {
    let message = Some("the run is not debugged".to_owned());
    vec![protocol::Breakpoint { message, ..protocol::Breakpoint::default() }; count]
}

/// Returns the breakpoint's id for the client.
pub(crate) fn number(BreakpointId(id): BreakpointId) -> i32 {
    i32::try_from(id).unwrap_or(i32::MAX)
}

/// Returns the possible breakpoint lines in the requested range.
pub(crate) fn locations(
    arguments: &BreakpointLocationsArguments,
    controller: &Controller,
    conventions: &Conventions,
) -> Vec<BreakpointLocation> {
    let Some(file) = file_of(&arguments.source, controller) else { return Vec::new() };
    let first = conventions.row(arguments.line);
    let last = arguments.end_line.map_or(first, |line| conventions.row(line));
    let location = |row| BreakpointLocation { line: conventions.line(row), ..BreakpointLocation::default() };
    instruction_rows(&file, controller).range(first..=last.max(first)).copied().map(location).collect()
}

/// Returns the rows of a file at which a task can stop: instruction lines and closing keywords.
fn instruction_rows(file: &str, controller: &Controller) -> BTreeSet<u32> {
    let images = controller.vm.space.loaded().map(|(_, instance)| &instance.image);
    let programs = images.flat_map(|image| image.programs.iter().map(move |program| (image, program)));
    let own = programs.filter(|(image, program)| image.files.get(program.file as usize).is_some_and(|own| own == file));
    own.flat_map(|(_, program)| program.lines.iter().chain(&program.closings).map(|line| line.row)).collect()
}

/// Returns the file of a loaded application or library for a source from the client.
pub(crate) fn file_of(source: &Source, controller: &Controller) -> Option<String> {
    let images = controller.vm.space.loaded().map(|(_, instance)| &instance.image);
    let files: Vec<&String> = images.flat_map(|image| &image.files).collect();
    let named = files.iter().find(|file| Conventions::is_file(source, file));
    let found = named.or_else(|| {
        let wanted = Conventions::path(source)?;
        files.iter().find(|file| val3_session::is_same_file(&wanted, file))
    });
    found.map(|file| (*file).clone())
}
