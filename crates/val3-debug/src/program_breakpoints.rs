//! Breakpoints on programs, by name.

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

use val3_bytecode::{Image, Program};
use val3_vm::{InstanceId, Space};

use crate::breakpoints::{BreakpointId, HitCondition};
use crate::conditions::CompiledExpression;

/// Name of a program in a breakpoint, case-sensitive as in VAL 3.
///
/// `prog` matches every program of this name, in the application and all libraries. `lib:prog` matches only the program
/// of the application or library called `lib`, or of a library that programs use under the identifier `lib`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProgramName {
    /// Application or library name, or library identifier.
    pub library: Option<String>,
    /// Program name.
    pub program: String,
}

impl FromStr for ProgramName {
    type Err = Infallible;

    /// Parses the name. Spaces and the parentheses of a call are ignored: `lib : prog()`.
    fn from_str(text: &str) -> Result<Self, Infallible> {
        let text = text.trim();
        let text = text.strip_suffix(')').map_or(text, |text| text.trim_end().trim_end_matches('(')).trim();
        Ok(match text.split_once(':') {
            Some((library, program)) => {
                Self { library: Some(library.trim().to_owned()), program: program.trim().to_owned() }
            }
            None => Self { library: None, program: text.to_owned() },
        })
    }
}

impl fmt::Display for ProgramName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.library {
            Some(library) => write!(f, "{library}:{}", self.program),
            None => f.write_str(&self.program),
        }
    }
}

/// Breakpoint on the first line of programs. A task stops there when it calls such a program or begins with it, not
/// when a loop returns to the first line. Exception: if the first line is an empty `do … until` loop, each iteration is
/// a hit.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgramBreakpoint {
    /// Identity, unique among all breakpoints.
    pub id: BreakpointId,
    /// Name of the programs.
    pub name: ProgramName,
    /// Name of the only task that the breakpoint affects; `None` for all tasks.
    pub task: Option<String>,
    /// Condition for a hit to count, compiled for each matching program, by program file. A program without an entry
    /// has no condition.
    pub conditions: BTreeMap<String, CompiledExpression>,
    /// Hits at which tasks stop; `None` for every hit.
    pub hits: Option<HitCondition>,
}

impl ProgramBreakpoint {
    /// Creates a breakpoint without conditions.
    #[must_use]
    pub fn new(id: BreakpointId, name: ProgramName) -> Self {
        Self { id, name, task: None, conditions: BTreeMap::new(), hits: None }
    }
}

/// Resolved lines of a breakpoint on programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedProgram {
    /// Identity of the breakpoint.
    pub id: BreakpointId,
    /// File of each matching program in memory, with the row of the program's first line with an instruction. Empty if
    /// no program in memory matches; a library that is loaded later may contain one.
    pub places: Vec<(String, u32)>,
}

impl ProgramBreakpoint {
    /// Returns the resolved lines of the breakpoint.
    fn placed(&self, space: &Space) -> PlacedProgram {
        let owners = space.loaded().filter(|(id, _)| self.name.is_of(space, *id));
        let places = owners.filter_map(|(_, owner)| {
            let program = owner.image.programs.get(usize::from(owner.image.program(&self.name.program)?))?;
            Some((file_of(&owner.image, program).to_owned(), first_row(program)?))
        });
        PlacedProgram { id: self.id, places: places.collect() }
    }
}

/// All breakpoints on programs.
#[derive(Debug, Default)]
pub(crate) struct ProgramBreakpoints(Vec<ProgramBreakpoint>);

impl ProgramBreakpoints {
    /// Replaces all breakpoints. Returns the removed ones.
    pub(crate) fn set(&mut self, breakpoints: Vec<ProgramBreakpoint>) -> Vec<BreakpointId> {
        let ids: BTreeSet<_> = breakpoints.iter().map(|breakpoint| breakpoint.id).collect();
        let before = std::mem::replace(&mut self.0, breakpoints);
        before.into_iter().map(|breakpoint| breakpoint.id).filter(|id| !ids.contains(id)).collect()
    }

    /// Returns the program names without library names.
    pub(crate) fn names(&self) -> BTreeSet<String> {
        self.0.iter().map(|breakpoint| breakpoint.name.program.clone()).collect()
    }

    /// Returns the hit conditions of all breakpoints.
    pub(crate) fn hit_conditions(&self) -> impl Iterator<Item = (BreakpointId, Option<HitCondition>)> {
        self.0.iter().map(|breakpoint| (breakpoint.id, breakpoint.hits))
    }

    /// Returns the resolved lines of all breakpoints.
    pub(crate) fn placed(&self, space: &Space) -> Vec<PlacedProgram> {
        self.0.iter().map(|breakpoint| breakpoint.placed(space)).collect()
    }

    /// Returns the breakpoints of a program.
    pub(crate) fn of(&self, space: &Space, owner: InstanceId, program: &str) -> Vec<&ProgramBreakpoint> {
        let named = self.0.iter().filter(|breakpoint| breakpoint.name.program == program);
        named.filter(|breakpoint| breakpoint.name.is_of(space, owner)).collect()
    }
}

impl ProgramName {
    /// Whether the name can mean a program of this application or library.
    fn is_of(&self, space: &Space, owner: InstanceId) -> bool {
        let Some(library) = &self.library else { return true };
        space.instance(owner).is_some_and(|owner| owner.image.name == *library) || is_identifier(space, library, owner)
    }
}

/// Whether an application or library uses the identifier for a library that is in memory as `owner`.
fn is_identifier(space: &Space, identifier: &str, owner: InstanceId) -> bool {
    space.loaded().any(|(_, user)| {
        let mut bound = user.image.libraries.iter().zip(&user.libraries);
        bound.any(|(found, loaded)| found.alias == identifier && *loaded == Some(owner))
    })
}

fn first_row(program: &Program) -> Option<u32> {
    program.lines.get(program.line_of(program.entry()?)?).map(|line| line.row)
}

pub(crate) fn file_of<'i>(image: &'i Image, program: &Program) -> &'i str {
    image.files.get(program.file as usize).map_or("", String::as_str)
}
