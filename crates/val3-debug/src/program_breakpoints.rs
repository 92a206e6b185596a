//! Breakpoints at the beginning of programs, by name.

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

use val3_bytecode::{Image, Program};
use val3_vm::{InstanceId, Space};

use crate::breakpoints::{BreakpointId, HitCondition};
use crate::conditions::CompiledExpression;

/// The name of a program. Letter case counts, as in VAL 3.
///
/// `prog` is each program of this name, of the application and of all libraries. `lib:prog` is only that of the application
/// or library called `lib`, or of those that programs reach under the identifier `lib`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProgramName {
    /// The name of an application or library, or the identifier of a library.
    pub library: Option<String>,
    /// The name of the program.
    pub program: String,
}

impl FromStr for ProgramName {
    type Err = Infallible;

    /// Spaces and the parentheses of a call do not count: `lib : prog()`.
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

/// A breakpoint at the beginning of programs: a task stops there when it has called one or begins with it, not when a loop
/// returns to its first line. A first line that consists of an empty `do … until` loop is the exception: each round is one.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgramBreakpoint {
    /// Its identity, unique among all breakpoints.
    pub id: BreakpointId,
    /// The name of the programs.
    pub name: ProgramName,
    /// A hit counts only if this holds. It is compiled for each of the programs, by their files; a program without one has
    /// no condition.
    pub conditions: BTreeMap<String, CompiledExpression>,
    /// At which of its hits tasks stop; at each without one.
    pub hits: Option<HitCondition>,
}

impl ProgramBreakpoint {
    /// A breakpoint without conditions.
    #[must_use]
    pub fn new(id: BreakpointId, name: ProgramName) -> Self {
        Self { id, name, conditions: BTreeMap::new(), hits: None }
    }
}

/// Where a breakpoint at the beginning of programs is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedProgram {
    /// The breakpoint.
    pub id: BreakpointId,
    /// The files of the programs in memory, and the row of the first line with an instruction. Empty while nothing in
    /// memory has such a program; libraries that are loaded later may.
    pub places: Vec<(String, u32)>,
}

/// The breakpoints at the beginning of programs.
#[derive(Debug, Default)]
pub(crate) struct ProgramBreakpoints(Vec<ProgramBreakpoint>);

impl ProgramBreakpoints {
    /// Replaces all breakpoints. Gives those that were removed.
    pub(crate) fn set(&mut self, breakpoints: Vec<ProgramBreakpoint>) -> Vec<BreakpointId> {
        let ids: BTreeSet<_> = breakpoints.iter().map(|breakpoint| breakpoint.id).collect();
        let before = std::mem::replace(&mut self.0, breakpoints);
        before.into_iter().map(|breakpoint| breakpoint.id).filter(|id| !ids.contains(id)).collect()
    }

    /// The names of the programs, without those of libraries.
    pub(crate) fn names(&self) -> BTreeSet<String> {
        self.0.iter().map(|breakpoint| breakpoint.name.program.clone()).collect()
    }

    /// Where they are.
    pub(crate) fn placed(&self, space: &Space) -> Vec<PlacedProgram> {
        let placed = |breakpoint: &ProgramBreakpoint| {
            let owners = space.loaded().filter(|(id, _)| breakpoint.name.is_of(space, *id));
            let places = owners.filter_map(|(_, owner)| {
                let program = owner.image.programs.get(usize::from(owner.image.program(&breakpoint.name.program)?))?;
                Some((file_of(&owner.image, program).to_owned(), first_row(program)?))
            });
            PlacedProgram { id: breakpoint.id, places: places.collect() }
        };
        self.0.iter().map(placed).collect()
    }

    /// The breakpoints of a program.
    pub(crate) fn of(&self, space: &Space, (owner, program): (InstanceId, &str)) -> Vec<&ProgramBreakpoint> {
        let named = self.0.iter().filter(|breakpoint| breakpoint.name.program == program);
        named.filter(|breakpoint| breakpoint.name.is_of(space, owner)).collect()
    }
}

impl ProgramName {
    /// Whether it may name a program of an application or library.
    fn is_of(&self, space: &Space, owner: InstanceId) -> bool {
        let Some(library) = &self.library else { return true };
        let is_identifier = || {
            space.loaded().any(|(_, user)| {
                let mut bound = user.image.libraries.iter().zip(&user.libraries);
                bound.any(|(found, loaded)| found.alias == *library && *loaded == Some(owner))
            })
        };
        space.instance(owner).is_some_and(|owner| owner.image.name == *library) || is_identifier()
    }
}

fn first_row(program: &Program) -> Option<u32> {
    program.lines.get(program.line_of(program.entry()?)?).map(|line| line.row)
}

pub(crate) fn file_of<'i>(image: &'i Image, program: &Program) -> &'i str {
    image.files.get(program.file as usize).map_or("", String::as_str)
}
