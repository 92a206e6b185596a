//! List of the offered requests, each with the right that it requires.

mod clear_all_breakpoints;
mod clear_breakpoints;
mod exec_val3;
mod find_server;
mod forward_kin;
mod get_all_physical_ios;
mod get_application_datas;
mod get_applications;
mod get_breakpoints;
mod get_call_stack;
mod get_controller_parameters;
mod get_cs8_compatibility;
mod get_cs8_versions;
mod get_joint_range;
mod get_project;
mod get_record;
mod get_records;
mod get_robot_dh_parameters;
mod get_robot_jnt_cart_pos;
mod get_robot_joint_pos;
mod get_robots;
mod get_soap_server_version;
mod get_stack_frame;
mod get_tasks;
mod get_watches;
mod load_project_async;
mod lock_all_ios;
mod lock_ios;
mod login;
mod logout;
mod move_c;
mod move_jc;
mod move_jj;
mod move_l;
mod ping;
mod read_ios;
mod replace_line;
mod reset_motion;
mod restart_motion;
mod reverse_kin;
mod scheduler_refresh;
mod set_breakpoints;
mod set_current_instruction;
mod set_power;
mod set_project_as_modified;
mod set_robot_joint_pos;
mod set_scheduling_mode;
mod start_application;
mod stop_and_unload_all;
mod stop_application;
mod stop_motion;
mod subscribe_to_controller_events;
mod task_kill;
mod task_resume;
mod task_step;
mod task_suspend;
mod unlock_all_ios;
mod unlock_ios;
mod unsubscribe_to_controller_events;
mod write_ios;

use val3_soap::{SoapAnswer, SoapFault, SoapRequest};

use crate::context::{Context, Right};

/// Answers a request.
pub(crate) fn answer(request: &SoapRequest, context: &mut Context<'_, '_>) -> Result<SoapAnswer, SoapFault> {
    use {Right as R, SoapAnswer as A, SoapRequest as Q};
    match request {
        Q::GetSoapServerVersion(q) => {
            handle(q, context, R::None, get_soap_server_version::answer, A::GetSoapServerVersion)
        }
        Q::FindServer(q) => handle(q, context, R::None, find_server::answer, A::FindServer),
        Q::Ping(q) => handle(q, context, R::None, ping::answer, A::Ping),
        Q::Login(q) => handle(q, context, R::None, login::answer, A::Login),
        Q::Logout(q) => handle(q, context, R::None, logout::answer, A::Logout),
        Q::GetCs8Versions(q) => handle(q, context, R::Read, get_cs8_versions::answer, A::GetCs8Versions),
        Q::GetControllerParameters(q) => {
            handle(q, context, R::Read, get_controller_parameters::answer, A::GetControllerParameters)
        }
        Q::GetCs8Compatibility(q) => handle(q, context, R::Read, get_cs8_compatibility::answer, A::GetCs8Compatibility),
        Q::GetRobots(q) => handle(q, context, R::Read, get_robots::answer, A::GetRobots),
        Q::GetRobotJointPos(q) => handle(q, context, R::Read, get_robot_joint_pos::answer, A::GetRobotJointPos),
        Q::GetRobotJntCartPos(q) => handle(q, context, R::Read, get_robot_jnt_cart_pos::answer, A::GetRobotJntCartPos),
        Q::SetRobotJointPos(q) => handle(q, context, R::Write, set_robot_joint_pos::answer, A::SetRobotJointPos),
        Q::GetApplications(q) => handle(q, context, R::Read, get_applications::answer, A::GetApplications),
        Q::GetApplicationDatas(q) => handle(q, context, R::Read, get_application_datas::answer, A::GetApplicationDatas),
        Q::GetRecords(q) => handle(q, context, R::Read, get_records::answer, A::GetRecords),
        Q::GetRecord(q) => handle(q, context, R::Read, get_record::answer, A::GetRecord),
        Q::GetJointRange(q) => handle(q, context, R::Read, get_joint_range::answer, A::GetJointRange),
        Q::GetTasks(q) => handle(q, context, R::Read, get_tasks::answer, A::GetTasks),
        Q::TaskSuspend(q) => handle(q, context, R::Write, task_suspend::answer, A::TaskSuspend),
        Q::TaskResume(q) => handle(q, context, R::Write, task_resume::answer, A::TaskResume),
        Q::TaskKill(q) => handle(q, context, R::Write, task_kill::answer, A::TaskKill),
        Q::TaskStep(q) => handle(q, context, R::Write, task_step::answer, A::TaskStep),
        Q::SetBreakpoints(q) => handle(q, context, R::Write, set_breakpoints::answer, A::SetBreakpoints),
        Q::ClearBreakpoints(q) => handle(q, context, R::Write, clear_breakpoints::answer, A::ClearBreakpoints),
        Q::GetBreakpoints(q) => handle(q, context, R::Read, get_breakpoints::answer, A::GetBreakpoints),
        Q::ClearAllBreakpoints(q) => {
            handle(q, context, R::Write, clear_all_breakpoints::answer, A::ClearAllBreakpoints)
        }
        Q::GetCallStack(q) => handle(q, context, R::Read, get_call_stack::answer, A::GetCallStack),
        Q::GetStackFrame(q) => handle(q, context, R::Read, get_stack_frame::answer, A::GetStackFrame),
        Q::GetWatches(q) => handle(q, context, R::Read, get_watches::answer, A::GetWatches),
        Q::ExecVal3(q) => handle(q, context, R::Write, exec_val3::answer, A::ExecVal3),
        Q::SetCurrentInstruction(q) => {
            handle(q, context, R::Write, set_current_instruction::answer, A::SetCurrentInstruction)
        }
        Q::ReplaceLine(q) => handle(q, context, R::Write, replace_line::answer, A::ReplaceLine),
        Q::SetProjectAsModified(q) => {
            handle(q, context, R::Write, set_project_as_modified::answer, A::SetProjectAsModified)
        }
        Q::GetProject(q) => handle(q, context, R::Read, get_project::answer, A::GetProject),
        Q::SubscribeToControllerEvents(q) => {
            handle(q, context, R::Read, subscribe_to_controller_events::answer, A::SubscribeToControllerEvents)
        }
        Q::UnsubscribeToControllerEvents(q) => {
            handle(q, context, R::Read, unsubscribe_to_controller_events::answer, A::UnsubscribeToControllerEvents)
        }
        Q::LoadProjectAsync(q) => handle(q, context, R::Write, load_project_async::answer, A::LoadProjectAsync),
        Q::StartApplication(q) => handle(q, context, R::Write, start_application::answer, A::StartApplication),
        Q::StopApplication(q) => handle(q, context, R::Write, stop_application::answer, A::StopApplication),
        Q::StopAndUnloadAll(q) => handle(q, context, R::Write, stop_and_unload_all::answer, A::StopAndUnloadAll),
        Q::ReadIos(q) => handle(q, context, R::Read, read_ios::answer, A::ReadIos),
        Q::WriteIos(q) => handle(q, context, R::WriteIo, write_ios::answer, A::WriteIos),
        Q::LockIos(q) => handle(q, context, R::WriteIo, lock_ios::answer, A::LockIos),
        Q::UnlockIos(q) => handle(q, context, R::WriteIo, unlock_ios::answer, A::UnlockIos),
        Q::LockAllIos(q) => handle(q, context, R::WriteIo, lock_all_ios::answer, A::LockAllIos),
        Q::UnlockAllIos(q) => handle(q, context, R::WriteIo, unlock_all_ios::answer, A::UnlockAllIos),
        Q::GetAllPhysicalIos(q) => handle(q, context, R::Read, get_all_physical_ios::answer, A::GetAllPhysicalIos),
        Q::GetRobotDhParameters(q) => {
            handle(q, context, R::Read, get_robot_dh_parameters::answer, A::GetRobotDhParameters)
        }
        Q::ForwardKin(q) => handle(q, context, R::Read, forward_kin::answer, A::ForwardKin),
        Q::ReverseKin(q) => handle(q, context, R::Read, reverse_kin::answer, A::ReverseKin),
        Q::MoveJj(q) => handle(q, context, R::Write, move_jj::answer, A::MoveJj),
        Q::MoveJc(q) => handle(q, context, R::Write, move_jc::answer, A::MoveJc),
        Q::MoveL(q) => handle(q, context, R::Write, move_l::answer, A::MoveL),
        Q::MoveC(q) => handle(q, context, R::Write, move_c::answer, A::MoveC),
        Q::ResetMotion(q) => handle(q, context, R::Write, reset_motion::answer, A::ResetMotion),
        Q::StopMotion(q) => handle(q, context, R::Write, stop_motion::answer, A::StopMotion),
        Q::RestartMotion(q) => handle(q, context, R::Write, restart_motion::answer, A::RestartMotion),
        Q::SchedulerRefresh(q) => handle(q, context, R::Read, scheduler_refresh::answer, A::SchedulerRefresh),
        Q::SetSchedulingMode(q) => handle(q, context, R::Write, set_scheduling_mode::answer, A::SetSchedulingMode),
        Q::SetPower(q) => handle(q, context, R::Write, set_power::answer, A::SetPower),
    }
}

/// Checks the right, executes a request, and wraps the answer.
fn handle<Q, A>(
    request: &Q,
    context: &mut Context<'_, '_>,
    right: Right,
    handler: fn(&Q, &mut Context<'_, '_>) -> Result<A, SoapFault>,
    wrap: fn(A) -> SoapAnswer,
) -> Result<SoapAnswer, SoapFault> {
    context.check_right(right)?;
    handler(request, context).map(wrap)
}
