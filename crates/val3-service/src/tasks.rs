//! Tasks by the names of the interface.

use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_soap::v2::{TaskState, TaskStatus};
use val3_soap::{ExceptionCode, SoapFault};
use val3_vm::{Rate, Task};

use crate::applications;
use crate::context::{ServiceTarget, refused};

impl ServiceTarget<'_> {
    /// Finds a task by its name and by the project that has created it.
    ///
    /// # Errors
    /// There is no such task.
    pub(crate) fn task(&self, name: Option<&str>, created_by: Option<&str>) -> Result<TaskNumber, SoapFault> {
        let (name, created_by) = (name.unwrap_or_default(), created_by.unwrap_or_default());
        let mut tasks = self.debugger.controller.vm.tasks().iter();
        let task = tasks.find(|task| task.name == name && self.is_created_by(task, created_by)).map(|task| task.id);
        task.ok_or_else(|| refused(ExceptionCode::TaskNotFound, "getTasks lists the tasks with their creators"))
    }

    /// Depth of a stack frame of a task; 0 is the innermost.
    ///
    /// # Errors
    /// The task has no stack frame with this index.
    pub(crate) fn frame_depth(&self, task: TaskNumber, index: i32) -> Result<usize, SoapFault> {
        let count = val3_debug::frames(&self.debugger.controller.vm, task).len();
        let depth = usize::try_from(index).ok().filter(|depth| *depth < count);
        depth.ok_or_else(|| refused(ExceptionCode::StackFrameNotFound, "the task has no such stack frame"))
    }

    /// Checks that a client can continue a task: only a client or a breakpoint holds it.
    ///
    /// # Errors
    /// The application has suspended the task, or an error has stopped it.
    pub(crate) fn check_resumable(&self, task: TaskNumber) -> Result<(), SoapFault> {
        let state = self.debugger.controller.vm.tasks().iter().find(|known| known.id == task).map(|task| task.state);
        let reason = match state {
            Some(val3_vm::TaskState::Halted) => "the application has suspended the task".to_owned(),
            Some(val3_vm::TaskState::Failed(fault)) => format!("error {} has stopped the task", fault.0),
            _ => return Ok(()),
        };
        Err(refused(ExceptionCode::Unknown, &format!("{reason}, and only the application resumes it")))
    }

    /// Project that has created a task.
    fn creator(&self, task: &Task) -> Option<String> {
        self.debugger.controller.vm.space.instance(task.owner).map(applications::project_name)
    }

    /// Whether the project has created the task. The letter case of project names is ignored.
    fn is_created_by(&self, task: &Task, project: &str) -> bool {
        self.creator(task).is_some_and(|creator| creator.eq_ignore_ascii_case(project))
    }

    /// State of all tasks.
    pub(crate) fn task_statuses(&self) -> Vec<TaskStatus> {
        self.debugger.controller.vm.tasks().iter().map(|task| self.status(task)).collect()
    }

    fn status(&self, task: &Task) -> TaskStatus {
        let error = match task.state {
            val3_vm::TaskState::Failed(fault) => fault.0,
            _ => 0,
        };
        TaskStatus {
            name: Some(task.name.clone()),
            state: self.state(task),
            priority: match task.rate {
                Rate::Priority(priority) => i32::try_from(priority).unwrap_or(i32::MAX),
                Rate::Period { .. } => 0,
            },
            created_by: self.creator(task),
            error: error.into(),
            error_description: Some(runtime_errors::find(error).map_or_else(String::new, |row| row.short.to_owned())),
            line: self.line_of_task(task.id),
        }
    }

    fn state(&self, task: &Task) -> TaskState {
        match task.state {
            val3_vm::TaskState::Running if self.debugger.stepped_task() == Some(task.id) => TaskState::Stepping,
            val3_vm::TaskState::Running if !task.is_held => TaskState::Running,
            _ => TaskState::Stopped,
        }
    }
}
