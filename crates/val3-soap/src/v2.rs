//! Server `/CS8ServerV2`: tasks, debugging, signals, applications.

mod clear_all_breakpoints;
mod clear_breakpoints;
mod debugging;
mod exec_val3;
mod geometry;
mod get_all_physical_ios;
mod get_breakpoints;
mod get_call_stack;
mod get_project;
mod get_robot_dh_parameters;
mod get_stack_frame;
mod get_tasks;
mod get_watches;
mod load_project_async;
mod lock_all_ios;
mod lock_ios;
mod mime;
mod read_ios;
mod replace_line;
mod set_breakpoints;
mod set_current_instruction;
mod set_project_as_modified;
mod signals;
mod start_application;
mod stop_and_unload_all;
mod stop_application;
mod subscribe_to_controller_events;
mod task_kill;
mod task_resume;
mod task_step;
mod task_suspend;
mod tasks;
mod unlock_all_ios;
mod unlock_ios;
mod unsubscribe_to_controller_events;
mod write_ios;

pub use clear_all_breakpoints::ClearAllBreakpoints;
pub use clear_breakpoints::{ClearBreakpoints, ClearBreakpointsAnswer};
pub use debugging::{
    BreakpointResponse, ExecutionResult, LineReference, ReplacementResult, StackFrameSummary, WatchedData,
};
pub use exec_val3::{ExecVal3, ExecVal3Answer};
pub use geometry::DhParameters;
pub use get_all_physical_ios::{GetAllPhysicalIos, GetAllPhysicalIosAnswer};
pub use get_breakpoints::{GetBreakpoints, GetBreakpointsAnswer};
pub use get_call_stack::{GetCallStack, GetCallStackAnswer};
pub use get_project::{GetProject, GetProjectAnswer};
pub use get_robot_dh_parameters::{GetRobotDhParameters, GetRobotDhParametersAnswer};
pub use get_stack_frame::{GetStackFrame, GetStackFrameAnswer};
pub use get_tasks::{GetTasks, GetTasksAnswer};
pub use get_watches::{GetWatches, GetWatchesAnswer};
pub use load_project_async::LoadProjectAsync;
pub use lock_all_ios::{LockAllIos, LockAllIosAnswer};
pub use lock_ios::{LockIos, LockIosAnswer};
pub use mime::MimeData;
pub use read_ios::{ReadIos, ReadIosAnswer};
pub use replace_line::{ReplaceLine, ReplaceLineAnswer};
pub use set_breakpoints::{SetBreakpoints, SetBreakpointsAnswer};
pub use set_current_instruction::SetCurrentInstruction;
pub use set_project_as_modified::SetProjectAsModified;
pub use signals::{
    AnalogueAttributes, DigitalAttributes, SignalAttributes, SignalResponse, SignalState, SignalStatus, UnlockedSignal,
};
pub use start_application::StartApplication;
pub use stop_and_unload_all::StopAndUnloadAll;
pub use stop_application::StopApplication;
pub use subscribe_to_controller_events::SubscribeToControllerEvents;
pub use task_kill::TaskKill;
pub use task_resume::TaskResume;
pub use task_step::TaskStep;
pub use task_suspend::TaskSuspend;
pub use tasks::{ProgramLine, TaskState, TaskStatus, TaskStepKind};
pub use unlock_all_ios::{UnlockAllIos, UnlockAllIosAnswer};
pub use unlock_ios::{UnlockIos, UnlockIosAnswer};
pub use unsubscribe_to_controller_events::UnsubscribeToControllerEvents;
pub use write_ios::{WriteIos, WriteIosAnswer};
