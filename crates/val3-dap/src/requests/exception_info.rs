//! `exceptionInfo`: run-time error or failed assertion that has stopped a task.

use val3_lang::runtime_errors;
use val3_vm::TaskState;

use crate::assertions;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ExceptionBreakMode, ExceptionDetails};
use crate::protocol::{ExceptionInfoArguments, ExceptionInfoResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::stop_event;

/// The request `exceptionInfo`.
pub(crate) enum ExceptionInfo {}

impl DebugRequest for ExceptionInfo {
    const COMMAND: &'static str = "exceptionInfo";
    type Arguments = ExceptionInfoArguments;
    type Body = ExceptionInfoResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ExceptionInfoArguments,
    ) -> Result<ExceptionInfoResponse, RequestFailure> {
        let task = DebugSession::task(arguments.thread_id, run)?;
        if let Some(message) = assertions::message(&mut run.debugger.controller, task) {
            return Ok(failed_assertion(message));
        }
        let known = run.debugger.controller.vm.tasks().iter().find(|known| known.id == task);
        match known.map(|task| task.state) {
            Some(TaskState::Failed(fault)) => {
                let break_mode = match session.breakpoints.always_stops_at(fault.0) {
                    true => ExceptionBreakMode::Always,
                    false => ExceptionBreakMode::Unhandled,
                };
                let cause = stop_event::cause(fault, task, &mut run.debugger.controller);
                Ok(ExceptionInfoResponse { break_mode, ..run_time_error(fault.0, &cause) })
            }
            _ => Err(RequestFailure::NoError),
        }
    }
}

fn failed_assertion(message: String) -> ExceptionInfoResponse {
    ExceptionInfoResponse {
        exception_id: "failed assertion".to_owned(),
        description: Some(message),
        break_mode: ExceptionBreakMode::Always,
        details: None,
    }
}

/// Describes a run-time error. `cause` is the variable that caused the error, preceded by a colon, or empty.
fn run_time_error(number: u16, cause: &str) -> ExceptionInfoResponse {
    let error = runtime_errors::find(number);
    let (short, long) = error.map_or(("unknown run-time error", ""), |error| (error.short, error.long));
    ExceptionInfoResponse {
        exception_id: format!("error {number}"),
        description: Some(format!("{short}{cause}\n{long}\n`val3 explain {number}` has its page")),
        break_mode: ExceptionBreakMode::Always,
        details: Some(ExceptionDetails {
            message: Some(short.to_owned()),
            type_name: Some(number.to_string()),
            ..ExceptionDetails::default()
        }),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient};

    #[test]
    fn the_mode_tells_whether_a_handled_error_would_stop_the_run() {
        for (filters, mode) in
            [(json!([]), "unhandled"), (json!(["unhandled"]), "unhandled"), (json!(["all"]), "always")]
        {
            let mut client = TestClient::stopped("program start()\nbegin\n  delay(1/0)\nend\n");
            client.body("setExceptionBreakpoints", json!({ "filters": filters }));
            client.body("continue", json!({ "threadId": MAIN_THREAD }));
            client.run();
            let info = client.body("exceptionInfo", json!({ "threadId": MAIN_THREAD }));
            assert_eq!((&info["exceptionId"], &info["breakMode"]), (&json!("error 10"), &json!(mode)), "{filters}");
        }
    }

    const SIGNALS: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="diIn" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\start" /></Data>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="diFree" access="private" xsi:type="array" type="dio" size="1"/>
    <Data name="doList" access="private" xsi:type="array" type="dio" size="2"><Value key="0" link="Io\start" /></Data>
  </Datas>
</Database>
"#;

    #[test]
    fn a_missing_signal_is_named_with_its_variable() {
        let gone = "`diIn` has the link `Io\\start`, but this controller has no such signal";
        for (code, cause) in [
            ("wait(diFree)", "`diFree` has no link"),
            ("doList[1]=diIn", "`doList[1]` has no link"),
            ("call work(diFree)", "`x_diOther` has no link; `diFree` has no link"),
            ("siHost=\"a\"", "`siHost` has the link `Socket\\host`, but this controller has no such line"),
            ("wait(diIn)", gone),
        ] {
            let work = "program work(dio& x_diOther)\nbegin\n  wait(x_diOther)\nend\n";
            let mut client = TestClient::stopped(&format!("program start()\nbegin\n  {code}\nend\n\n{work}{SIGNALS}"));
            if cause == gone {
                client.body("val3/operate", json!({ "fault": { "link": "Io\\start", "code": -2 } }));
            }
            let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(stop["text"], format!("error 123: input or output not linked: {cause}"));
            let info = client.body("exceptionInfo", json!({ "threadId": MAIN_THREAD }));
            let description = info["description"].as_str().unwrap();
            assert!(description.starts_with(&format!("input or output not linked: {cause}\n")), "{description}");
        }
    }

    #[test]
    fn a_missing_element_is_named_with_its_container() {
        for (code, cause) in [
            ("nA[nI+5]=1", "the index is 7, and `nA` has the size 3"),
            ("? nA[-nI]", "the index is -2, and `nA` has the size 3"),
            ("nM[1,nI]=nM[1,nI+1]", "the indexes are 1,3, and `nM` has the size 2,3"),
            ("pA[nI/4].trsf.x=1", "the index is 0.5, and `pA` has the size 1"),
            ("? colA[\"b\"]", "`colA` has no key \"b\""),
            ("call work(nA[nI])", "the index is 1, and `x_nList` has the size 1"),
        ] {
            let data = "num nA[3]\nnum nM[2,3]\npoint pA\nnum colA[\"\"]\nnum nI=2\n";
            let work = "program work(num& x_nList[])\nbegin\n  ? x_nList[1]\nend\n";
            let start = format!("program start()\nbegin\n  {code}\nend\n\n");
            let mut client = TestClient::stopped(&format!("{data}\n{start}{work}"));
            let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
            let text = stop["text"].as_str().unwrap();
            assert!(text.starts_with("error 2") && text.ends_with(&format!(": {cause}")), "{code}: {text}");
        }
    }

    #[test]
    fn a_task_without_an_error_has_no_information() {
        let mut client = TestClient::stopped(EMPTY);
        let (thread, _) = client.thread_and_frame();
        let reason = client.failure("exceptionInfo", json!({ "threadId": thread }));
        assert_eq!(reason, "no run-time error has stopped this task");
        assert!(client.failure("exceptionInfo", json!({ "threadId": 99 })).contains("no such task"));
    }
}
