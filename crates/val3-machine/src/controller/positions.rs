//! Locations of the tasks, and the reasons why they do not continue.

use std::fmt;

use val3_bytecode::{Op, Program};
use val3_lang::call::Wait;
use val3_lang::fault::Fault;
use val3_lang::instruction::{Family, Instruction};
use val3_lang::ports::TaskNumber;
use val3_lang::{instructions, motion};
use val3_vm::{Task, TaskState};

use super::Controller;
use crate::arm::ArmHold;
use crate::event::EventKind;

/// Location of a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskPosition {
    /// The name of the task.
    pub name: String,
    /// Activity at this line.
    pub activity: Activity,
    /// The program.
    pub program: String,
    /// The line of the file, from 1.
    pub line: u32,
    /// The file.
    pub file: String,
}

/// The activity of a task at its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Activity {
    /// Executes lines.
    Running,
    /// Waits until a condition is true.
    AwaitsCondition,
    /// Waits until a condition about the arm is true; the arm does not move for this reason.
    AwaitsArmCondition(ArmHold),
    /// Waits in this instruction.
    Awaits(String),
    /// Waits in this instruction for another task, without a timeout.
    AwaitsTask(String),
    /// Waits in this instruction for the arm, which does not move for this reason.
    AwaitsArm(String, ArmHold),
    /// Waits for the duration of a file access.
    AwaitsMedium,
    /// Suspended, and no task resumes it.
    Suspended,
    /// Stopped by the run-time error with this number.
    Failed(u16),
}

/// Cause for which a task waits, in general.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WaitCause {
    /// A condition, a signal, another task, the operator, or a line to the outside.
    Outside,
    /// The arm or its power.
    Arm,
    /// A period of time.
    Time,
}

impl Activity {
    /// Cause for which the task waits; `None` if it does not wait, or only for a medium.
    #[must_use]
    pub fn wait_cause(&self) -> Option<WaitCause> {
        match self {
            Self::AwaitsCondition | Self::AwaitsTask(_) => Some(WaitCause::Outside),
            Self::AwaitsArmCondition(_) | Self::AwaitsArm(..) => Some(WaitCause::Arm),
            Self::Awaits(instruction) => Some(match instructions::find(instruction) {
                Some(found) if motion::needs_arm(found) || found.family == Family::Controller => WaitCause::Arm,
                Some(Instruction { family: Family::Tasks, .. }) => WaitCause::Time,
                _ => WaitCause::Outside,
            }),
            Self::Running | Self::AwaitsMedium | Self::Suspended | Self::Failed(_) => None,
        }
    }

    /// Returns the word in the record.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::AwaitsCondition
            | Self::AwaitsArmCondition(_)
            | Self::Awaits(_)
            | Self::AwaitsTask(_)
            | Self::AwaitsArm(..)
            | Self::AwaitsMedium => "waiting",
            Self::Suspended => "suspended",
            Self::Failed(_) => "error",
        }
    }

    /// Whether the activity ends without an event from outside: computing, time, a medium, or an arm that moves.
    #[must_use]
    pub fn ends_by_itself(&self) -> bool {
        match self {
            Self::Running | Self::AwaitsMedium => true,
            Self::Awaits(instruction) => instructions::find(instruction)
                .is_some_and(|found| found.family == Family::Tasks || motion::needs_arm(found)),
            Self::AwaitsCondition
            | Self::AwaitsArmCondition(_)
            | Self::AwaitsTask(_)
            | Self::AwaitsArm(..)
            | Self::Suspended
            | Self::Failed(_) => false,
        }
    }

    /// Returns the awaited condition or object; `None` if the task does not wait.
    #[must_use]
    pub fn awaited(&self) -> Option<String> {
        let awaited = self.awaited_thing()?;
        Some(self.hold().map_or_else(|| awaited.clone(), |hold| format!("{awaited}, {}", hold.text())))
    }

    /// Returns the awaited condition or object, without the reason why the arm does not move.
    #[must_use]
    pub fn awaited_thing(&self) -> Option<String> {
        match self {
            Self::AwaitsCondition => Some("a condition".to_owned()),
            Self::AwaitsArmCondition(_) => Some("a condition of the arm".to_owned()),
            Self::Awaits(instruction) => Some(awaited_in(instruction)),
            Self::AwaitsTask(instruction) => Some(format!("another task (`{instruction}`)")),
            Self::AwaitsArm(instruction, _) => Some(format!("the arm (`{instruction}`)")),
            Self::AwaitsMedium => Some("a file".to_owned()),
            Self::Running | Self::Suspended | Self::Failed(_) => None,
        }
    }

    /// Reason why the awaited arm does not move.
    #[must_use]
    pub fn hold(&self) -> Option<ArmHold> {
        match self {
            Self::AwaitsArmCondition(hold) | Self::AwaitsArm(_, hold) => Some(*hold),
            _ => None,
        }
    }
}

/// Returns the object for which an instruction waits.
fn awaited_in(instruction: &str) -> String {
    let subject = match instructions::find(instruction) {
        Some(found) if motion::needs_arm(found) => "the arm",
        Some(Instruction { family: Family::Screen | Family::Additions, .. }) => "the operator",
        Some(Instruction { family: Family::Io, .. }) => "an input, an output or a serial line",
        Some(Instruction { family: Family::Tasks, .. }) => "time",
        Some(Instruction { family: Family::Controller, .. }) => "the power of the arm",
        None if instruction == "=" => "a serial line or socket",
        _ => return format!("`{instruction}`"),
    };
    format!("{subject} (`{instruction}`)")
}

impl fmt::Display for Activity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self, self.awaited()) {
            (_, Some(awaited)) => write!(f, "waits for {awaited}"),
            (Self::Suspended, _) => f.write_str("is suspended"),
            (Self::Failed(code), _) => write!(f, "was stopped by error {code}"),
            _ => f.write_str("is running"),
        }
    }
}

impl Controller {
    /// Locations of all tasks, in the order of creation.
    #[must_use]
    pub fn task_positions(&self) -> Vec<TaskPosition> {
        self.vm.tasks().iter().map(|task| self.position(task)).collect()
    }

    /// The line to the outside that has a peer, and the name of the task that has used it last.
    #[must_use]
    pub fn outside_peer(&self) -> Option<(String, Option<String>)> {
        let (link, user) = self.devices.lines.outside_peer()?;
        let task = self.vm.tasks().iter().find(|task| Some(task.id) == user);
        Some((link.to_owned(), task.map(|task| task.name.clone())))
    }

    /// Records the tasks of a run that cannot continue.
    pub fn record_stuck_tasks(&mut self) {
        let now = self.now();
        for position in self.task_positions() {
            let TaskPosition { name, activity, program, line, file } = position;
            let kind =
                EventKind::Stuck { name, state: activity.word(), awaits: activity.awaited(), program, line, file };
            self.devices.record_outside(now, kind);
        }
    }

    fn position(&self, task: &Task) -> TaskPosition {
        let (program, line, file) = self.devices.place(task.thread.place().unwrap_or_default());
        TaskPosition { name: task.name.clone(), activity: self.activity(task), program, line, file }
    }

    fn activity(&self, task: &Task) -> Activity {
        match task.state {
            TaskState::Failed(Fault(code)) => Activity::Failed(code),
            TaskState::Halted => Activity::Suspended,
            _ if task.thread.wait.is_none() => Activity::Running,
            _ if task.thread.waiting.is_none() => match task.thread.wait {
                Some(Wait { sleeps: true, .. }) => Activity::AwaitsMedium,
                _ => self.wait_for_condition(task),
            },
            _ => self
                .instruction_at(task)
                .map_or(Activity::AwaitsCondition, |instruction| self.wait_in(task, instruction)),
        }
    }

    fn wait_for_condition(&self, task: &Task) -> Activity {
        let asks_for_arm = |_: &ArmHold| self.line_asks_for_arm(task).unwrap_or(false);
        self.devices
            .state
            .arm_hold()
            .filter(asks_for_arm)
            .map_or(Activity::AwaitsCondition, Activity::AwaitsArmCondition)
    }

    fn wait_in(&self, task: &Task, instruction: String) -> Activity {
        let called = instructions::find(&instruction);
        let is_for_arm = called.is_some_and(motion::needs_arm);
        let is_for_task = called.is_some_and(|called| called.family == Family::Tasks) && !ends_at_a_time(task);
        match self.devices.state.arm_hold().filter(|_| is_for_arm) {
            Some(hold) => Activity::AwaitsArm(instruction, hold),
            None if is_for_task => Activity::AwaitsTask(instruction),
            None => Activity::Awaits(instruction),
        }
    }

    /// Whether a task waits, without a timeout, in a line that requires the arm.
    #[must_use]
    pub fn awaits_arm(&self, id: TaskNumber) -> bool {
        let waits = |task: &&Task| task.id == id && task.thread.wait.is_some() && !ends_at_a_time(task);
        let task = self.vm.tasks().iter().map(Box::as_ref).find(waits);
        task.is_some_and(|task| self.line_asks_for_arm(task).unwrap_or(false))
    }

    fn line_asks_for_arm(&self, task: &Task) -> Option<bool> {
        let frame = task.thread.frames.last()?;
        let program = self.vm.space.instance(frame.instance)?.program(frame.program)?;
        let line = program.line_of(task.thread.next);
        let mut of_line = (0..).zip(&program.code).filter(|(number, _)| program.line_of(*number) == line);
        Some(of_line.any(|(_, step)| needs_arm(program, step.op)))
    }

    /// The name of the instruction that a task executes next.
    fn instruction_at(&self, task: &Task) -> Option<String> {
        let frame = task.thread.frames.last()?;
        let program = self.vm.space.instance(frame.instance)?.program(frame.program)?;
        let Op::Instruction { site } = program.code.get(task.thread.next as usize)?.op else { return None };
        program.instructions.get(site as usize).map(|site| site.callee.name().to_owned())
    }
}

/// Whether the wait of a task ends at a known time.
fn ends_at_a_time(task: &Task) -> bool {
    task.thread.wait.is_some_and(|wait| wait.wake.is_some())
}

/// Whether an operation is an instruction that needs the arm.
fn needs_arm(program: &Program, op: Op) -> bool {
    let Op::Instruction { site } = op else { return false };
    let site = program.instructions.get(site as usize);
    site.and_then(|site| instructions::find(site.callee.name())).is_some_and(motion::needs_arm)
}
