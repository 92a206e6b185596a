//! Stops before the end of a run, so that the user can inspect it, end the waits of its tasks, or go back.

use val3_debug::Stop;
use val3_machine::controller::RunStatus;

use super::{DebugSession, SessionState};
use crate::debugged_run::DebuggedRun;
use crate::stop_event;

/// Time at which a run ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeEnd {
    /// End of the recording that the run repeats.
    Recording,
    /// The limit `until`.
    Limit,
}

impl DebugSession {
    /// Stops a run that would end with this status. Returns `false` if the run ends.
    ///
    /// A run in which no task can continue stops each time it gets stuck, because a change from outside can end the
    /// waits.
    pub fn stop_at_end(&mut self, status: RunStatus, run: &mut DebuggedRun<'_>) -> bool {
        if self.start.is_plain_run || !self.client.is_connected() {
            return false;
        }
        let controller = &run.debugger.controller;
        let has_waiting_tasks = status == RunStatus::Stuck && !controller.has_only_failed_tasks();
        let is_failed = status == RunStatus::Stuck && !has_waiting_tasks;
        let stops_at_failure = is_failed && self.start.settings.stops_on_exit && !self.is_at_failed_end;
        if self.is_running_to_end() && !has_waiting_tasks || stops_at_failure {
            self.is_at_failed_end = is_failed;
            run.debugger.abandon_step();
            self.end_run_to_end(run);
            self.report_stop(stop_event::ended(&run.debugger.controller), run);
            return true;
        }
        if status != RunStatus::Stuck {
            return false;
        }
        if controller.has_only_failed_tasks() || !run.debugger.paused_tasks().is_empty() {
            return false;
        }
        let tasks: String = stop_event::waits(controller).map(|task| format!("  {task}\n")).collect();
        let remedy = stop_event::arm_remedy(controller).map(|remedy| format!("  {remedy}\n")).unwrap_or_default();
        self.client.say(&format!("no task can continue:\n{tasks}{remedy}"));
        run.debugger.abandon_step();
        self.end_run_to_end(run);
        self.report_stop(stop_event::stuck(&run.debugger.controller), run);
        true
    }

    /// Stops a run that has reached a time at which it ends. Returns `false` if the run ends, because
    /// the client has continued it from there, or has requested no stop at the end.
    pub fn stop_at_time(&mut self, end: TimeEnd, run: &mut DebuggedRun<'_>) -> bool {
        let settings = &self.start.settings;
        let is_wanted = settings.stops_on_exit || settings.starts_at_end;
        if self.start.is_plain_run || !self.client.is_connected() || !is_wanted || self.is_at_recorded_end {
            return false;
        }
        run.debugger.abandon_step();
        self.end_run_to_end(run);
        let controller = &run.debugger.controller;
        let event = match end {
            TimeEnd::Recording => stop_event::recorded_end(controller),
            TimeEnd::Limit => stop_event::time_limit(controller),
        };
        self.report_stop(event, run);
        self.is_at_recorded_end = true;
        true
    }

    /// Whether the run goes to its end without stops.
    #[must_use]
    pub fn is_running_to_end(&self) -> bool {
        self.runs_to_end && !self.start.is_plain_run && self.phase == SessionState::Running
    }

    /// Whether the stop is ignored, because the run goes to its end, or because `terminate` stops the application at the
    /// end of the cycle. The program `stop` has stops again.
    pub(crate) fn passes(&self, stop: &Stop, run: &DebuggedRun<'_>) -> bool {
        let is_new = !run.debugger.is_in_past();
        if is_new && run.debugger.controller.is_about_to_stop() && !matches!(stop, Stop::Pause { .. }) {
            return true;
        }
        let is_end = |task| run.debugger.controller.vm.is_at_end(task);
        let is_at_end = matches!(stop, Stop::Exit { .. } | Stop::Pause { .. }) || stop.task_alone().is_some_and(is_end);
        self.is_running_to_end() && !is_at_end
    }

    /// Ends the run to the end (`startAtEnd`) at its first stop. From now on, the other stops apply too.
    pub(super) fn end_run_to_end(&mut self, run: &mut DebuggedRun<'_>) {
        if std::mem::take(&mut self.runs_to_end) {
            self.end_progress.end(&mut self.client);
            self.start.settings.apply_modes(run.debugger);
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::TimeEnd;
    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient};

    const WAITING: &str = "bool bGo\nnum nDone\n\nprogram start()\nbegin\n  wait(bGo)\n  nDone=1\n  delay(1)\nend\n";

    fn bodies(events: &[(String, Value)], name: &str) -> Vec<Value> {
        events.iter().filter(|(event, _)| event == name).map(|(_, body)| body.clone()).collect()
    }

    #[test]
    fn a_run_stops_when_no_task_can_continue_and_continues_after_a_change() {
        let mut client = TestClient::launched(WAITING, json!({}));
        let events = client.run();
        let task = "task `main~` waits for a condition at start() line 5";
        let expected = json!({
            "reason": "pause",
            "description": "Paused because no task can continue",
            "text": task,
            "threadId": MAIN_THREAD,
            "allThreadsStopped": true,
        });
        assert_eq!(bodies(&events, "stopped"), [expected]);
        let shown = bodies(&events, "output");
        assert_eq!(shown[0]["output"], format!("no task can continue:\n  {task}\n"));
        client.body("evaluate", json!({ "expression": "bGo=true", "context": "repl" }));
        client.body(
            "setBreakpoints",
            json!({
                "source": crate::test_client::source("start"),
                "breakpoints": [{ "line": 7 }],
            }),
        );
        assert_eq!(client.stop_after("continue", json!({ "threadId": MAIN_THREAD }))["reason"], "breakpoint");
        assert_eq!(client.value("nDone"), "1");
    }

    #[test]
    fn an_arm_without_power_has_a_remedy_for_the_operator() {
        let listing = "mdesc mNorm\njoint jA\n\nprogram start()\nbegin\n  jA.j1=10\n  movej(jA,flange,mNorm)\n  \
                       waitEndMove()\nend\n";
        let events = TestClient::launched(listing, json!({})).run();
        let task = "task `main~` waits for the arm (`waitEndMove`): no power, at start() line 7";
        let remedy = "The arm has no power. Switch the power on.";
        assert_eq!(bodies(&events, "stopped")[0]["text"], format!("{task}. {remedy}"));
        let shown: Vec<Value> = bodies(&events, "output").into_iter().map(|mut body| body["output"].take()).collect();
        let expected = format!("no task can continue:\n  {task}\n  {remedy}\n");
        assert!(shown.contains(&json!(expected)), "{shown:?}");
    }

    #[test]
    fn each_step_over_an_endless_wait_stops() {
        let mut client = TestClient::stopped(WAITING);
        for _ in 0..2 {
            let stop = client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
            assert_eq!((&stop["reason"], client.place()), (&json!("pause"), ("main:start()".to_owned(), 5)));
        }
    }

    #[test]
    fn a_run_stops_before_its_end_with_its_past() {
        let listing = "num nCount\nnum nOther\n\nprogram start()\nbegin\n  taskCreate \"other\",100,other()\n  \
                       nCount=1\n  nCount=2\nend\n\nprogram other()\nbegin\n  nOther=1\n  return\nend\n";
        let mut client = TestClient::launched(listing, json!({ "stopOnExit": true }));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!(stops.len(), 1);
        assert_eq!(stops[0]["description"], "Paused before the end of the application");
        assert_eq!((client.value("nCount"), client.value("nOther")), (json!("2"), json!("1")));
        client.body("evaluate", json!({ "expression": "nOther=5", "context": "repl" }));
        assert_eq!(client.value("nOther"), "5", "statements have an end that is no stop");
        client.stop_after("stepBack", json!({ "threadId": stops[0]["threadId"] }));
        let again = client.stop_after("continue", json!({ "threadId": stops[0]["threadId"] }));
        assert_eq!(again["description"], "Paused before the end of the application");
        client.body("continue", json!({ "threadId": stops[0]["threadId"] }));
        assert_eq!(bodies(&client.run(), "stopped"), Vec::<Value>::new());
    }

    #[test]
    fn a_breakpoint_on_the_last_line_counts_once() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\nend\n";
        let mut client = TestClient::launching(listing, json!({ "stopOnExit": true }));
        let breakpoints = json!({ "source": crate::test_client::source("start"), "breakpoints": [{ "line": 5 }] });
        client.body("setBreakpoints", breakpoints);
        client.body("configurationDone", json!({}));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!(stops[0]["reason"], "breakpoint");
        let exit = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&exit["reason"], client.place().1), (&json!("pause"), 6));
    }

    #[test]
    fn a_breakpoint_on_the_last_end_is_the_only_stop_there() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\nend\n";
        let mut client = TestClient::launching(listing, json!({ "stopOnExit": true }));
        let breakpoints = json!({ "source": crate::test_client::source("start"), "breakpoints": [{ "line": 6 }] });
        client.body("setBreakpoints", breakpoints);
        client.body("configurationDone", json!({}));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!((&stops[0]["reason"], client.place().1), (&json!("breakpoint"), 6));
        client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.place().1, 5);
        let again = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&again["reason"], client.place().1), (&json!("breakpoint"), 6));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(bodies(&client.run(), "stopped"), Vec::<Value>::new());
    }

    const ROUNDS: &str = "num nCount\nnum nDone\n\nprogram start()\nbegin\n  for nCount=1 to 3\n    delay(1)\n  endFor\n  \
                          nDone=1\nend\n";

    #[test]
    fn a_run_that_starts_at_its_end_passes_breakpoints_on_the_way() {
        let mut client = TestClient::launching(ROUNDS, json!({ "startAtEnd": true, "stopOnEntry": true }));
        client.body(
            "setBreakpoints",
            json!({ "source": crate::test_client::source("start"), "breakpoints": [{ "line": 6 }, { "line": 8 }] }),
        );
        client.body("configurationDone", json!({}));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!(stops.len(), 1);
        assert_eq!(stops[0]["description"], "Paused before the end of the application");
        assert_eq!((client.value("nDone"), client.place().1), (json!("1"), 9));
        let back = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&back["reason"], client.place().1), (&json!("breakpoint"), 8));
        let back = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&back["reason"], client.value("nCount")), (&json!("breakpoint"), json!("3")));
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        let again = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(again["description"], "Paused before the end of the application");
    }

    #[test]
    fn a_breakpoint_on_the_last_end_is_the_end() {
        let mut client = TestClient::launching(ROUNDS, json!({ "startAtEnd": true }));
        client.body(
            "setBreakpoints",
            json!({ "source": crate::test_client::source("start"), "breakpoints": [{ "line": 9 }] }),
        );
        client.body("configurationDone", json!({}));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!((stops.len(), &stops[0]["reason"], client.place().1), (1, &json!("breakpoint"), 9));
    }

    #[test]
    fn a_run_that_starts_at_its_end_stops_where_no_task_can_continue() {
        let mut client = TestClient::launched(WAITING, json!({ "startAtEnd": true }));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!(stops[0]["description"], "Paused because no task can continue");
        let failing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  nCount=1/(nCount-1)\nend\n";
        let mut client = TestClient::launched(failing, json!({ "startAtEnd": true }));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!((stops.len(), &stops[0]["description"]), (1, &json!("Paused at the end of the run")));
        assert_eq!(client.value("nCount"), "1");
        client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.place().1, 6);
    }

    /// The failed tasks remain, so that the user can go back from the error.
    #[test]
    fn a_run_whose_tasks_have_failed_stops_before_its_end() {
        let failing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  nCount=1/(nCount-1)\nend\n";
        for filters in [json!([]), json!(["unhandled"])] {
            let mut client = TestClient::launching(failing, json!({ "stopOnExit": true }));
            client.body("setExceptionBreakpoints", json!({ "filters": filters }));
            client.body("configurationDone", json!({}));
            let mut stop = bodies(&client.run(), "stopped").remove(0);
            if filters != json!([]) {
                assert_eq!(stop["reason"], "exception");
                stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
            }
            assert_eq!(stop["description"], "Paused at the end of the run");
            client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD }));
            assert_eq!((client.place().1, client.value("nCount")), (6, json!("1")));
            client.body("evaluate", json!({ "expression": "nCount=3", "context": "repl" }));
            let exit = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(exit["description"], "Paused before the end of the application");
            assert_eq!(client.value("nCount"), "0.5");
        }
        let mut client = TestClient::launched(failing, json!({ "stopOnExit": true }));
        client.run();
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(bodies(&client.run(), "stopped"), Vec::<Value>::new(), "continue at the end ends the run");
    }

    #[test]
    fn the_stop_at_a_time_names_its_reason() {
        for (end, description) in [
            (TimeEnd::Recording, "Paused at the end of the recording"),
            (TimeEnd::Limit, "Paused at the time limit of the run"),
        ] {
            let mut client = TestClient::stopped_at_time(ROUNDS, end);
            let stops = bodies(&client.run(), "stopped");
            assert_eq!((stops.len(), &stops[0]["description"]), (1, &json!(description)));
        }
    }

    #[test]
    fn a_long_way_to_the_end_reports_progress() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  for nCount=1 to 6000\n    delay(0.004)\n  endFor\nend\n";
        let mut client = TestClient::launching(listing, json!({ "startAtEnd": true })).knowing_progress();
        client.body("configurationDone", json!({}));
        let events = client.run();
        let all: Vec<&str> = events.iter().map(|(event, _)| event.as_str()).collect();
        assert_eq!(all.iter().rev().take(2).rev().copied().collect::<Vec<_>>(), ["progressEnd", "stopped"]);
        let start = bodies(&events, "progressStart");
        assert_eq!((start.len(), &start[0]["title"]), (1, &json!("Going to the end of the run")));
        let updates = bodies(&events, "progressUpdate");
        assert!(updates.len() >= 2, "{updates:?}");
        assert!(updates.iter().all(|update| update["progressId"] == start[0]["progressId"]));
        let message = updates.last().unwrap()["message"].as_str().unwrap();
        let time: f64 = message.strip_suffix(" s of the run").unwrap().parse().unwrap();
        assert!((10.0..25.0).contains(&time), "{message}");
        let mut other = TestClient::launched(listing, json!({ "startAtEnd": true }));
        assert_eq!(bodies(&other.run(), "progressStart"), Vec::<Value>::new(), "the client supports no progress");
    }

    #[test]
    fn a_pause_ends_the_way_to_the_end() {
        let mut client = TestClient::launched(ROUNDS, json!({ "startAtEnd": true }));
        let pause = client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&pause["reason"], client.value("nDone")), (&json!("pause"), json!("0")));
        client.body(
            "setBreakpoints",
            json!({ "source": crate::test_client::source("start"), "breakpoints": [{ "line": 8 }] }),
        );
        let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["reason"], "breakpoint");
    }

    #[test]
    fn a_run_that_ends_does_not_stop() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        assert_eq!(bodies(&client.run(), "stopped"), Vec::<Value>::new());
    }

    #[test]
    fn unhandled_errors_stop_the_run_of_a_client_that_sets_no_filters() {
        let mut client =
            TestClient::launched("num nCount\n\nprogram start()\nbegin\n  nCount=1/nCount\nend\n", json!({}));
        let stops = bodies(&client.run(), "stopped");
        assert_eq!(stops[0]["text"], "error 10: division by zero");
        assert_eq!(client.value("nCount"), "0");
    }
}
