//! Tasks and libraries as the running task accesses them.

use val3_bytecode::Program;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::View;
use val3_lang::ports::{CodePlace, RuntimeRequest, TaskChange, TaskNumber, Tasks};
use val3_lang::runtime_errors::{NO_LINE, NO_TASK, TaskStatusCode as Number};

use crate::roster::Roster;
use crate::{Instance, InstanceId, TaskState};

/// Changes of tasks, with their names and code locations.
pub(crate) type TaskChanges = Vec<(TaskNumber, String, TaskChange, Option<CodePlace>)>;

/// Tasks and libraries that the programs of `owner` can access.
pub(crate) struct Services<'v> {
    pub(crate) roster: &'v mut Roster,
    pub(crate) instances: &'v [Instance],
    /// Changes of tasks.
    pub(crate) changes: TaskChanges,
    /// Request to the virtual machine.
    pub(crate) request: Option<Box<RuntimeRequest>>,
    pub(crate) owner: InstanceId,
}

impl Tasks for Services<'_> {
    fn status(&self, name: &str) -> i16 {
        let found = self.roster.find(self.owner, name).and_then(|at| self.roster.tasks.get(at));
        found.map_or(Number::Absent.number(), |task| task.status())
    }

    fn suspend(&mut self, name: &str) -> Result<()> {
        let at = self.roster.find(self.owner, name).ok_or(Fault(NO_TASK))?;
        if let Some(task) = self.roster.tasks.get_mut(at)
            && task.is_running()
        {
            task.state = TaskState::Halted;
            self.changes.push((task.id, task.name.clone(), TaskChange::Halted, task.thread.place()));
        }
        Ok(())
    }

    fn resume(&mut self, name: &str, skip: f64) -> Result<()> {
        let at = self.roster.find(self.owner, name).ok_or(Fault(NO_TASK))?;
        let Some(task) = self.roster.tasks.get_mut(at) else { return Err(Fault(NO_TASK)) };
        if task.is_running() {
            return Ok(());
        }
        let frame = task.thread.frames.last().ok_or(Fault::INTERPRETER)?;
        let instance = self.instances.get(usize::from(frame.instance.0)).ok_or(Fault::INTERPRETER)?;
        let program = instance.program(frame.program).ok_or(Fault::INTERPRETER)?;
        let op = line_to_resume(program, task.thread.line, skip)?;
        // A task that was halted within a line resumes there; every other task begins a line.
        if skip != 0.0 || task.state != TaskState::Halted {
            task.thread.go_to_line(op);
        }
        task.state = TaskState::Running;
        self.changes.push((task.id, task.name.clone(), TaskChange::Resumed, task.thread.place()));
        Ok(())
    }

    fn kill(&mut self, name: &str) {
        let found = self.roster.find(self.owner, name);
        if let Some(task) = found.and_then(|at| self.roster.end(at)) {
            self.changes.push((task.id, task.name.clone(), TaskChange::Killed, task.thread.place()));
        }
    }

    fn data(&self, name: &str) -> std::result::Result<View, i16> {
        const NO_DATA: i16 = -1;
        const NO_LIBRARY: i16 = -2;
        let own = self.instances.get(usize::from(self.owner.0)).ok_or(NO_DATA)?;
        let (instance, name, public) = match name.split_once(':') {
            None => (own, name, false),
            Some((alias, name)) => {
                let library = own.image.libraries.iter().position(|library| library.alias == alias);
                let library = library.and_then(|at| own.libraries.get(at)).ok_or(NO_LIBRARY)?;
                let id = library.ok_or(NO_DATA)?;
                (self.instances.get(usize::from(id.0)).ok_or(NO_DATA)?, name, true)
            }
        };
        let number = instance.image.data(name).map(usize::from).ok_or(NO_DATA)?;
        instance.image.data.get(number).filter(|data| data.public || !public).ok_or(NO_DATA)?;
        instance.data.get(number).copied().map(View::whole).ok_or(NO_DATA)
    }

    fn request(&mut self, request: RuntimeRequest) {
        self.request = Some(Box::new(request));
    }

    fn path(&self, library: Option<u16>) -> String {
        self.target(library).map(|instance| instance.path.clone()).unwrap_or_default()
    }

    fn exports(&self, library: u16, symbol: &str) -> bool {
        let (name, of_program) = match symbol.strip_suffix("()") {
            Some(name) => (name, true),
            None => (symbol, false),
        };
        self.target(Some(library)).is_some_and(|instance| instance.export(self.owner, name, of_program).is_some())
    }
}

impl Services<'_> {
    /// Returns the library under an identifier, or the application itself.
    fn target(&self, library: Option<u16>) -> Option<&Instance> {
        let own = self.instances.get(usize::from(self.owner.0))?;
        match library {
            None => Some(own),
            Some(number) => {
                let id = (*own.libraries.get(usize::from(number))?)?;
                self.instances.get(usize::from(id.0))
            }
        }
    }
}

/// Returns the first operation at which a halted task resumes (5.2, 5.10): of the line `skip` lines after the line that begins at `line`, in source order.
///
/// The position after the last line is the end of the program.
///
/// # Errors
/// 90 if there is no such line.
fn line_to_resume(program: &Program, line: u32, skip: f64) -> Result<u32> {
    let number = program.line_of(line).ok_or(Fault(NO_LINE))?;
    #[allow(clippy::cast_precision_loss, reason = "programs have fewer lines than 2^52")]
    let wanted = number as f64 + (skip + 0.5).floor();
    let lines = program.lines.iter().map(|line| line.op);
    let end = u32::try_from(program.code.len()).unwrap_or(u32::MAX).saturating_sub(1);
    #[allow(clippy::cast_precision_loss, reason = "programs have fewer lines than 2^52")]
    let found = (0u32..).zip(lines.chain([end])).find(|(number, _)| f64::from(*number) == wanted);
    found.map(|(_, op)| op).ok_or(Fault(NO_LINE))
}
