//! Statements of the debug console, which stop at breakpoints in the programs that they call.

use std::cell::Cell;

use val3_debug::{DisplayFormat, Stop};
use val3_lang::ports::TaskNumber;
use val3_session::{Evaluation, ExecutionRequests};

use super::DebugSession;
use crate::client::Interruption;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{StandardEvent, StoppedEvent};
use crate::stop_event;

impl DebugSession {
    /// Executes code in a stack frame of a stopped task, until it stops at a breakpoint in a called program, the client
    /// requests `pause`, or it cancels the present request. A stop is reported after the response.
    ///
    /// # Errors
    /// The code is invalid, fails or is cancelled.
    pub(crate) fn execute(
        &mut self,
        task: TaskNumber,
        depth: usize,
        code: &str,
        format: DisplayFormat,
        run: &mut DebuggedRun<'_>,
    ) -> Result<Evaluation, RequestFailure> {
        let is_alone = self.check_task_stopped(task, run)?;
        let (client, request) = (&mut self.client, self.request);
        let interruption = Cell::new(None);
        let requests = ExecutionRequests {
            may_go_on: &mut || {
                interruption.set(client.interruption(request, ""));
                interruption.get().is_none()
            },
            is_paused: &|| interruption.get() == Some(Interruption::Pause),
        };
        let executed = run.evaluator.execute(run.debugger, task, depth, code, format, requests);
        let is_cancelled = interruption.get().is_some();
        let evaluation = self.evaluated(executed, is_cancelled, run)?;
        self.follow_log_points(run);
        if let Some(stop) = &evaluation.stop {
            self.stop_in_call(task, is_alone, stop, run);
        }
        Ok(evaluation)
    }

    /// Ends the innermost call of the debug console in a task. The stop is reported after the response.
    ///
    /// # Errors
    /// The task does not exist, is not stopped, or executes no such call.
    pub(crate) fn end_call(&mut self, thread: i32, run: &mut DebuggedRun<'_>) -> Result<(), RequestFailure> {
        let task = Self::task(thread, run)?;
        let is_alone = self.check_task_stopped(task, run)?;
        self.report_new_future(run);
        let stop = run.debugger.end_call(task).ok_or(RequestFailure::NoCall)?;
        self.stop_in_call(task, is_alone, &stop, run);
        Ok(())
    }

    /// Reports a stop of the task in the call, or after it, instead of the changed values at the previous stop.
    fn stop_in_call(&mut self, task: TaskNumber, is_alone: bool, stop: &Stop, run: &mut DebuggedRun<'_>) {
        self.following.retain(|event| !matches!(event, StandardEvent::Invalidated(_)));
        let changes = self.hit_changes(run);
        self.following.extend(changes);
        let event = stop_event::stopped(stop, &mut run.debugger.controller);
        let event = StoppedEvent { all_threads_stopped: Some(!is_alone), ..event };
        if is_alone {
            self.handles.forget_frames(task);
            self.following.push(StandardEvent::Stopped(event));
        } else {
            self.stopped_elsewhere(event);
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{MAIN_THREAD, TestClient, source};

    /// Calls `work` with a number. The lines of `work` have the rows 11 to 14, those of `divide` 8 and 9.
    const LISTING: &str = "\
num nA
num nB

program start()
begin
  nB=1
  nB=2
  nB=3
  delay(1)
end

program work(num x_nCount)
num l_nI
begin
  for l_nI=1 to x_nCount
    nA=nA+l_nI
  endFor
  nA=nA*10
end

program divide(num x_nBy)
begin
  nA=10
  nA=nA/x_nBy
end
";

    fn stopped() -> TestClient {
        let mut client = TestClient::stopped(LISTING);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client
    }

    fn set(client: &mut TestClient, program: &str, breakpoints: Value) {
        let lines = client.body("setBreakpoints", json!({ "source": source(program), "breakpoints": breakpoints }));
        assert!(lines["breakpoints"].as_array().unwrap().iter().all(|point| point["verified"] == true), "{lines}");
    }

    /// Names and lines of the stack frames of the first task.
    fn stack(client: &mut TestClient) -> Vec<String> {
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        let frames = trace["stackFrames"].as_array().unwrap().iter();
        frames.map(|frame| format!("{} {}", frame["name"].as_str().unwrap(), frame["line"])).collect()
    }

    fn stop_of(events: Vec<(String, Value)>) -> Value {
        let mut stops = events.into_iter().filter(|(event, _)| event == "stopped");
        stops.next().expect("a stop").1
    }

    fn go_on(client: &mut TestClient) -> Value {
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }))
    }

    const AFTER: &str = "Paused after the call from the debug console";

    #[test]
    fn a_breakpoint_in_a_called_program_stops_the_call_on_the_stack_of_the_task() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 12 }]));
        let (result, events) = client.console("call work(2)");
        assert_eq!(result, "stopped in the called program; the task returns here after the call");
        let stop = stop_of(events);
        assert_eq!((&stop["reason"], &stop["threadId"]), (&json!("breakpoint"), &json!(MAIN_THREAD)));
        let frames = ["main:work() 12", "called from the debug console 0", "main:start() 6"];
        assert_eq!(stack(&mut client), frames);
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(trace["stackFrames"][1]["presentationHint"], "label");
        assert_eq!((client.value("l_nI"), client.value("nB")), (json!("1"), json!("1")));
        client.console("l_nI=2");
        let stop = client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["reason"], "step");
        assert_eq!((client.value("nA"), client.value("l_nI")), (json!("2"), json!("2")));
        let stop = go_on(&mut client);
        assert_eq!((&stop["reason"], &stop["description"]), (&json!("pause"), &json!(AFTER)));
        assert_eq!(stack(&mut client), ["main:start() 6"]);
        assert_eq!((client.value("nA"), client.value("nB")), (json!("20"), json!("1")));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((client.place().1, client.value("nB")), (7, json!("2")));
    }

    #[test]
    fn the_frame_of_the_console_has_scopes() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(2)");
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        let label = trace["stackFrames"][1]["id"].clone();
        let scopes = client.body("scopes", json!({ "frameId": label }));
        assert!(scopes["scopes"].as_array().unwrap().iter().any(|scope| scope["name"] == "Globals"), "{scopes}");
        let value = client.body("evaluate", json!({ "expression": "nA+1", "frameId": label, "context": "watch" }));
        assert_eq!(value["result"], "4");
    }

    #[test]
    fn statements_without_a_breakpoint_end_at_once() {
        let mut client = stopped();
        let now = client.debugger.controller.now();
        let (result, events) = client.console("call work(3)\n? nA");
        assert_eq!(result, "60");
        assert!(!events.iter().any(|(event, _)| event == "stopped"));
        assert_eq!((client.value("nA"), client.debugger.controller.now()), (json!("60"), now));
        assert_eq!(stack(&mut client), ["main:start() 6"]);
    }

    #[test]
    fn conditions_hit_counts_and_log_points_hold_in_a_call() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 12, "condition": "l_nI==3" }, { "line": 14, "hitCondition": "2" }]));
        client.console("call work(4)");
        assert_eq!(client.value("l_nI"), "3");
        assert_eq!(go_on(&mut client)["description"], AFTER);
        client.console("call work(1)");
        assert_eq!(client.place(), ("main:work()".to_owned(), 14));
        set(&mut client, "work", json!([{ "line": 12, "logMessage": "at {l_nI}" }]));
        client.stop_after("val3/endCall", json!({ "threadId": MAIN_THREAD }));
        let (_, events) = client.console("call work(2)");
        let outputs: Vec<&Value> = events.iter().filter_map(|(_, body)| body.get("output")).collect();
        assert_eq!(outputs, ["at 1\n", "at 2\n"]);
        let (_, events) = client.console("call work(1000)");
        assert_eq!(events.iter().filter(|(event, _)| event == "output").count(), 1000);
    }

    #[test]
    fn a_step_out_returns_to_the_next_statement_of_the_console() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)\nnB=nA\ncall work(1)");
        client.stop_after("stepOut", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stack(&mut client)[0], "called from the debug console 0");
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.value("nB"), "10");
        assert_eq!(go_on(&mut client)["reason"], "breakpoint");
        assert_eq!(client.stop_after("stepOut", json!({ "threadId": MAIN_THREAD }))["description"], AFTER);
        assert_eq!(client.value("nA"), "110");
    }

    #[test]
    fn a_call_within_a_call_returns_to_the_first_one() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)");
        client.console("call work(2)");
        assert_eq!(stack(&mut client).len(), 5);
        assert_eq!(go_on(&mut client)["description"], AFTER);
        assert_eq!((stack(&mut client).len(), client.value("x_nCount")), (3, json!("1")));
        assert_eq!(go_on(&mut client)["description"], AFTER);
        assert_eq!((stack(&mut client).len(), client.value("nA")), (1, json!("400")));
    }

    #[test]
    fn an_error_ends_the_call_and_not_the_task() {
        let mut client = stopped();
        let (result, _) = client.console("call divide(0)");
        assert_eq!(result, "error 10: division by zero (main:divide(), line 9)");
        assert_eq!(stack(&mut client), ["main:start() 6"]);
        set(&mut client, "divide", json!([{ "line": 8 }]));
        client.console("call divide(0)");
        let stop = go_on(&mut client);
        assert_eq!(stop["reason"], "exception");
        assert_eq!(stack(&mut client)[0], "main:divide() 9");
        let info = client.body("exceptionInfo", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(info["exceptionId"], "error 10");
        let stop = go_on(&mut client);
        let text = "error 10 has ended the call from the debug console: division by zero (main:divide(), line 9)";
        assert_eq!((&stop["description"], &stop["text"]), (&json!(AFTER), &json!(text)));
        client.body("setExceptionBreakpoints", json!({ "filters": [] }));
        client.console("call divide(0)");
        assert_eq!(go_on(&mut client)["text"], text);
        set(&mut client, "divide", json!([]));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((client.place().1, client.value("nB")), (7, json!("2")));
    }

    #[test]
    fn pause_stops_an_endless_call_where_it_is() {
        let mut client = stopped();
        let (_, frame) = client.thread_and_frame();
        let endless = json!({ "expression": "call work(1e9)", "frameId": frame, "context": "repl" });
        client.send(7, "evaluate", endless);
        let events = client.events_of_all("pause", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop_of(events)["reason"], "pause");
        assert_eq!(stack(&mut client)[0], "called from the debug console 0");
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.stop_after("pause", json!({ "threadId": MAIN_THREAD }))["reason"], "pause");
        assert_eq!(stack(&mut client)[1], "called from the debug console 0");
        assert_eq!(client.stop_after("val3/endCall", json!({ "threadId": MAIN_THREAD }))["description"], AFTER);
        assert_eq!(stack(&mut client), ["main:start() 6"]);
    }

    #[test]
    fn cancel_ends_an_endless_call() {
        let mut client = stopped();
        let (_, frame) = client.thread_and_frame();
        client.send(7, "evaluate", json!({ "expression": "call work(1e9)", "frameId": frame, "context": "repl" }));
        let messages = client.exchange("cancel", json!({ "requestId": 7 }));
        assert!(format!("{messages:?}").contains("cancelled"), "{messages:?}");
        assert_eq!(stack(&mut client), ["main:start() 6"]);
    }

    #[test]
    fn the_run_goes_back_into_the_call_and_out_of_it() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 12 }]));
        let back = |client: &mut TestClient| client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD }));
        client.console("call work(1)");
        for line in [11, 14] {
            client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(client.place().1, line);
        }
        let before = (client.place(), client.value("nA"), client.debugger.controller.now());
        assert_eq!(go_on(&mut client)["description"], AFTER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.value("nA"), "10");
        back(&mut client);
        assert_eq!((client.place().1, client.value("nB")), (6, json!("1")));
        client.stop_after("val3/stepBackInto", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((client.place(), client.value("nA"), client.debugger.controller.now()), before);
        assert_eq!(stack(&mut client)[1], "called from the debug console 0");
        // Forward again, the call ends as before.
        assert_eq!(go_on(&mut client)["description"], AFTER);
        assert_eq!((client.value("nA"), client.value("nB")), (json!("10"), json!("1")));
        let stop = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&stop["reason"], client.place()), (&json!("breakpoint"), ("main:work()".to_owned(), 12)));
        assert_eq!(client.value("nA"), "0");
        // Before the first stop in the call, the task has not called it.
        back(&mut client);
        assert_eq!(stack(&mut client), ["main:start() 5"]);
    }

    #[test]
    fn each_step_back_in_a_call_undoes_a_step() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 11 }]));
        client.console("call work(3)\ncall divide(2)\ncall work(1)");
        set(&mut client, "work", json!([]));
        let state = |client: &mut TestClient| (stack(client), client.value("nA"), client.debugger.controller.now());
        let mut states = vec![state(&mut client)];
        while stack(&mut client).len() > 1 {
            client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
            states.push(state(&mut client));
        }
        assert!(states.len() > 12, "{states:?}");
        for expected in states.iter().rev().skip(1) {
            client.stop_after("val3/stepBackInto", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(state(&mut client), *expected);
        }
        for expected in states.iter().skip(1) {
            client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(state(&mut client), *expected);
        }
    }

    #[test]
    fn a_program_of_the_call_is_restarted_only_if_its_beginning_is_recorded() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 12 }]));
        client.console("call work(1)\ncall divide(2)");
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        let reason = client.failure("restartFrame", json!({ "frameId": trace["stackFrames"][0]["id"] }));
        assert_eq!(reason, "the moment is further back than the recorded past reaches");
        set(&mut client, "divide", json!([{ "line": 9 }]));
        go_on(&mut client);
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("restartFrame", json!({ "frameId": trace["stackFrames"][0]["id"] }));
        assert_eq!(client.place(), ("main:divide()".to_owned(), 8));
        assert_eq!(client.value("nA"), "10");
    }

    #[test]
    fn another_task_continues_during_the_call() {
        let listing = LISTING.replace("  nB=1\n", "  taskCreate \"other\",10,other()\n");
        let other = "\nprogram other()\nbegin\n  while true\n    nB=nB+1\n    delay(0.004)\n  endWhile\nend\n";
        let mut client = TestClient::stopped(&(listing + other));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)\ndelay(1)\nnA=nB");
        assert_eq!(client.value("nB"), "0");
        assert_eq!(go_on(&mut client)["description"], AFTER);
        let count: f64 = client.value("nA").as_str().unwrap().parse().unwrap();
        assert!((240.0..260.0).contains(&count), "{count}");
        set(&mut client, "other", json!([{ "line": 7 }]));
        let stop = go_on(&mut client);
        assert_ne!(stop["threadId"], json!(MAIN_THREAD));
        let main = client.body("stackTrace", json!({ "threadId": stop["threadId"] }));
        let frame = main["stackFrames"][0]["id"].clone();
        let call = json!({ "expression": "call work(2)", "frameId": frame, "context": "repl" });
        let stop = stop_of(client.events("evaluate", call));
        assert_ne!(stop["threadId"], json!(MAIN_THREAD));
    }

    #[test]
    fn a_waiting_task_waits_again_after_the_call() {
        let mut client = stopped();
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        for _ in 0..3 {
            client.debugger.advance();
        }
        client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stack(&mut client), ["main:start() 8"]);
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)");
        assert_eq!(go_on(&mut client)["description"], AFTER);
        assert_eq!(stack(&mut client), ["main:start() 8"]);
        let thread = &client.body("threads", json!({}))["threads"][0];
        assert!(thread["name"].as_str().unwrap().contains("waits for time"), "{thread}");
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        client.run();
        let end = client.debugger.controller.now();
        assert!((1_000_000_000..1_010_000_000).contains(&end), "{end}");
    }

    #[test]
    fn a_call_before_the_end_of_the_run_returns_there() {
        let mut client = TestClient::launched(LISTING, json!({ "stopOnExit": true }));
        let stop = stop_of(client.run());
        assert_eq!(stop["description"], "Paused before the end of the application");
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)");
        assert_eq!(stack(&mut client).len(), 3);
        assert_eq!(go_on(&mut client)["description"], AFTER);
        assert_eq!((stack(&mut client).len(), client.value("nA")), (1, json!("10")));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        let events = client.run();
        assert!(!events.iter().any(|(event, _)| event == "stopped"), "{events:?}");
    }

    #[test]
    fn a_task_that_is_ended_in_the_call_leaves_nothing() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)");
        client.body("terminateThreads", json!({ "threadIds": [MAIN_THREAD] }));
        assert!(client.debugger.controller.vm.tasks().is_empty());
        assert_eq!(client.body("threads", json!({}))["threads"], json!([]));
    }

    #[test]
    fn a_detached_run_continues_where_it_was_before_the_call() {
        let mut client = stopped();
        set(&mut client, "work", json!([{ "line": 14 }]));
        client.console("call work(1)");
        client.debugger.detach();
        assert_eq!(stack(&mut client), ["main:start() 6"]);
    }
}
