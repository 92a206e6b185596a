//! Tasks, breakpoints, steps and code.

use expect_test::expect;
use val3_soap::v0::{Login, Logout};
use val3_soap::v2::{
    BreakpointResponse, ClearAllBreakpoints, ClearBreakpoints, ExecVal3, ExecutionResult, GetBreakpoints, GetCallStack,
    GetRobotDhParameters, GetTasks, LineReference, ProgramLine, SetBreakpoints, TaskKill, TaskResume, TaskState,
    TaskStatus, TaskStep, TaskStepKind, TaskSuspend,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;

pub(super) const PROJECT: &str = "Disk://palletiser/palletiser.pjx";

pub(super) fn some(text: &str) -> Option<String> {
    Some(text.to_owned())
}

pub(super) fn tasks(client: &mut Client) -> Vec<TaskStatus> {
    match client.ask(SoapRequest::GetTasks(GetTasks)) {
        SoapAnswer::GetTasks(answer) => answer.tasks,
        other => panic!("{other:?}"),
    }
}

/// State of a task and its line: number and code.
pub(super) fn task(client: &mut Client, name: &str) -> (TaskState, i32, String) {
    let tasks = tasks(client);
    let task = tasks.iter().find(|task| task.name.as_deref() == Some(name)).unwrap();
    (task.state, task.line.number, task.line.content.clone().unwrap().trim().to_owned())
}

pub(super) fn line(program: &str, number: i32, content: &str) -> ProgramLine {
    ProgramLine { project: some(PROJECT), program: some(program), number, content: some(content) }
}

pub(super) fn set(client: &mut Client, lines: &[ProgramLine]) -> Vec<ExceptionCode> {
    let breakpoints = lines.iter().map(|line| LineReference { line: line.clone() }).collect();
    match client.ask(SoapRequest::SetBreakpoints(SetBreakpoints { breakpoints })) {
        SoapAnswer::SetBreakpoints(answer) => {
            let indexes: Vec<i32> = answer.responses.iter().map(|response| response.index).collect();
            assert_eq!(indexes, (0..indexes.len() as i32).collect::<Vec<_>>());
            answer.responses.iter().map(|BreakpointResponse { code, .. }| *code).collect()
        }
        other => panic!("{other:?}"),
    }
}

pub(super) fn suspend(name: &str) -> SoapRequest {
    SoapRequest::TaskSuspend(TaskSuspend { task: some(name), created_by: some(PROJECT) })
}

pub(super) fn resume(name: &str) -> SoapRequest {
    SoapRequest::TaskResume(TaskResume { task: some(name), created_by: some(PROJECT) })
}

fn step(client: &mut Client, name: &str, step: TaskStepKind) {
    client.ask(SoapRequest::TaskStep(TaskStep { task: some(name), created_by: some(PROJECT), step }));
    client.run(1);
}

pub(super) fn execute(client: &mut Client, task: &str, code: &str) -> (ExecutionResult, String) {
    let request =
        ExecVal3 { project: some(PROJECT), task: some(task), created_by: some(PROJECT), frame: 0, command: some(code) };
    match client.ask(SoapRequest::ExecVal3(request)) {
        SoapAnswer::ExecVal3(answer) => (answer.code, answer.output.unwrap()),
        other => panic!("{other:?}"),
    }
}

#[test]
fn tasks_have_their_lines() {
    let mut client = Client::logged_in();
    client.run(2);
    let list: Vec<String> = tasks(&mut client).iter().map(|task| format!("{task:?}\n")).collect();
    expect![[r#"
        TaskStatus { name: Some("sensors"), state: Running, priority: 0, created_by: Some("Disk://palletiser/palletiser.pjx"), error: 0, error_description: Some(""), line: ProgramLine { project: Some("Disk://palletiser/palletiser.pjx"), program: Some("sensors"), number: 12, content: Some("    delay(0)") } }
        TaskStatus { name: Some("supervisor"), state: Running, priority: 10, created_by: Some("Disk://palletiser/palletiser.pjx"), error: 0, error_description: Some(""), line: ProgramLine { project: Some("Disk://palletiser/palletiser.pjx"), program: Some("supervisor"), number: 10, content: Some("    delay(0.2)") } }
        TaskStatus { name: Some("host"), state: Running, priority: 10, created_by: Some("Disk://palletiser/palletiser.pjx"), error: 0, error_description: Some(""), line: ProgramLine { project: Some("Disk://palletiser/palletiser.pjx"), program: Some("host"), number: 4, content: Some("    l_sLine=io:siHost") } }
        TaskStatus { name: Some("production"), state: Running, priority: 50, created_by: Some("Disk://palletiser/palletiser.pjx"), error: 0, error_description: Some(""), line: ProgramLine { project: Some("Disk://palletiser/palletiser.pjx"), program: Some("home"), number: 14, content: Some("    waitEndMove()") } }
    "#]].assert_eq(&list.concat());
}

#[test]
fn a_suspended_task_stops_alone() {
    let mut client = Client::logged_in();
    client.run(2);
    client.ask(suspend("supervisor"));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Stopped);
    assert_eq!(task(&mut client, "sensors").0, TaskState::Running);
    client.ask(resume("supervisor"));
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Running);
    client.ask(SoapRequest::TaskKill(TaskKill { task: some("host"), created_by: some(PROJECT) }));
    assert!(tasks(&mut client).iter().all(|task| task.name.as_deref() != Some("host")));
    assert_eq!(client.code(suspend("host")), ExceptionCode::TaskNotFound);
    let other = TaskSuspend { task: some("sensors"), created_by: some("Disk://other/other.pjx") };
    assert_eq!(client.code(SoapRequest::TaskSuspend(other)), ExceptionCode::TaskNotFound);
}

#[test]
fn a_task_that_the_application_has_suspended_is_not_resumed() {
    let mut client = Client::logged_in();
    client.run(1);
    assert_eq!(execute(&mut client, "", "taskSuspend(\"supervisor\")").0, ExecutionResult::NoError);
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Stopped);
    let fault = client.fault(resume("supervisor"));
    let reason = "UNKNOWN-CODE: the application has suspended the task, and only the application resumes it";
    assert_eq!(fault.reason, reason);
}

#[test]
fn a_breakpoint_holds_the_task() {
    let mut client = Client::logged_in();
    let at = line("start", 4, "taskCreate \"supervisor\",10,supervisor()");
    assert_eq!(set(&mut client, &[at.clone(), at.clone()]), [ExceptionCode::Unknown; 2]);
    client.run(1);
    let lead = "palletiser~";
    assert_eq!(task(&mut client, lead), (TaskState::Stopped, 4, at.content.clone().unwrap()));
    let stack = GetCallStack { task: some(lead), created_by: some(PROJECT) };
    match client.ask(SoapRequest::GetCallStack(stack)) {
        SoapAnswer::GetCallStack(answer) => assert_eq!(answer.frames[0].current.line.number, 4),
        other => panic!("{other:?}"),
    }
    step(&mut client, lead, TaskStepKind::Over);
    assert_eq!(task(&mut client, lead).1, 5);
    let known = match client.ask(SoapRequest::GetBreakpoints(GetBreakpoints)) {
        SoapAnswer::GetBreakpoints(answer) => answer.breakpoints,
        other => panic!("{other:?}"),
    };
    assert_eq!(known, [LineReference { line: at.clone() }]);
    let clear = ClearBreakpoints { breakpoints: known };
    client.ask(SoapRequest::ClearBreakpoints(clear));
    client.ask(SoapRequest::ClearAllBreakpoints(ClearAllBreakpoints));
    client.ask(resume(lead));
    client.run(1);
    assert!(tasks(&mut client).iter().all(|task| task.name.as_deref() != Some(lead)));
}

#[test]
fn a_breakpoint_needs_a_line_with_an_instruction() {
    let mut client = Client::logged_in();
    let wrong = [
        ProgramLine { project: some("Disk://other/other.pjx"), ..line("start", 4, "") },
        line("other", 4, ""),
        line("start", 99, ""),
        line("start", 0, ""),
        line("start", 4, "x=1"),
        line("production", 2, ""),
    ];
    use ExceptionCode as E;
    let codes = [
        E::ApplicationNotFound,
        E::ProgramNotFound,
        E::ProgramLineNotFound,
        E::ProgramLineNotFound,
        E::MismatchedCode,
        E::ProgramLineNotFound,
    ];
    assert_eq!(set(&mut client, &wrong), codes);
}

#[test]
fn only_one_session_debugs() {
    let mut client = Client::logged_in();
    set(&mut client, &[line("start", 4, "")]);
    let login = SoapRequest::Login(Login { user: some("default"), password: None });
    client.ask(login);
    let request = || SoapRequest::ClearAllBreakpoints(ClearAllBreakpoints);
    assert_eq!(client.code(request()), ExceptionCode::ClientAlreadyConnected);
    client.session = Some(1);
    client.ask(SoapRequest::Logout(Logout));
    client.session = Some(2);
    client.ask(request());
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Running);
}

#[test]
fn code_is_executed_in_a_stack_frame() {
    let mut client = Client::logged_in();
    client.run(1);
    assert_eq!(execute(&mut client, "", "1+2"), (ExecutionResult::NoError, "3".to_owned()));
    assert_eq!(execute(&mut client, "production", "nLayer=7").0, ExecutionResult::NoError);
    assert_eq!(execute(&mut client, "production", "nLayer"), (ExecutionResult::NoError, "7".to_owned()));
    assert_eq!(execute(&mut client, "", "nOther=1").0, ExecutionResult::CompilationError);
    assert_eq!(execute(&mut client, "", "nLayer=1/0").0, ExecutionResult::RuntimeError);
    let request =
        ExecVal3 { project: None, task: some("production"), created_by: some(PROJECT), frame: 9, command: None };
    assert_eq!(client.code(SoapRequest::ExecVal3(request)), ExceptionCode::StackFrameNotFound);
}

#[test]
fn the_geometry_is_in_metres_and_radians() {
    let mut client = Client::logged_in();
    match client.ask(SoapRequest::GetRobotDhParameters(GetRobotDhParameters { robot: 0 })) {
        SoapAnswer::GetRobotDhParameters(answer) => {
            assert_eq!(answer.joints.len(), 6);
            assert_eq!(answer.last_d, client.controller().arm().model().dh().d[6] / 1000.0);
            assert!(answer.joints.iter().all(|joint| joint.d.abs() < 2.0 && joint.alpha.abs() <= 3.2));
        }
        other => panic!("{other:?}"),
    }
}
