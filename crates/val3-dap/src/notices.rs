//! Events of the specification about the run: output, tasks, libraries.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;
use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;
use val3_machine::event::{ClearanceMove, Event as MachineEvent, EventKind};
use val3_machine::missing_instruction;

use crate::conventions::Conventions;
use crate::protocol::{
    LoadedSourceEvent, LoadedSourceEventReason, Module, ModuleEvent, ModuleEventReason, OutputEvent,
    OutputEventCategory, Source, StandardEvent, ThreadEvent, ThreadEventReason,
};
use crate::screen_text::{PutText, ScreenText};
use crate::stop_event::cause;

/// Tasks and libraries that were reported to the client.
#[derive(Debug, Default)]
pub(crate) struct Notices {
    tasks: BTreeSet<TaskNumber>,
    files: BTreeSet<String>,
    /// Names by the paths of the project files.
    modules: BTreeMap<String, String>,
    screen: ScreenText,
}

impl Notices {
    /// Returns the notices since the last call.
    pub(crate) fn of(
        &mut self,
        events: &[MachineEvent],
        controller: &mut Controller,
        conventions: &Conventions,
    ) -> Vec<StandardEvent> {
        let output = events.iter().filter_map(|event| self.output(event, controller, conventions));
        let mut notices: Vec<StandardEvent> = output.map(StandardEvent::Output).collect();
        if events.iter().any(|event| matches!(event.kind, EventKind::Task { .. })) {
            notices.extend(self.task_changes(controller));
        }
        if events.iter().any(|event| matches!(event.kind, EventKind::Lib { .. })) {
            notices.extend(self.source_changes(controller, conventions));
        }
        notices
    }

    /// Sets whether the text on user pages is output.
    pub(crate) fn show_screen_output(&mut self, is_shown: bool) {
        self.screen.is_hidden = !is_shown;
    }

    /// Sets whether the run repeats a part that was already reported. Text on user pages is not output again.
    pub(crate) fn repeat(&mut self, is_repeated: bool) {
        self.screen.is_repeated = is_repeated;
    }

    /// Converts an event to output for the debug console, with the line that caused it. `None` for events without a
    /// text.
    fn output(
        &mut self,
        event: &MachineEvent,
        controller: &mut Controller,
        conventions: &Conventions,
    ) -> Option<OutputEvent> {
        let (output, category) = match &event.kind {
            EventKind::Put { screen, x, y, text, ends_line } => {
                let put = PutText { x: *x, y: *y, text, ends_line: *ends_line, time: event.t };
                (self.screen.put(screen, put)?, OutputEventCategory::Stdout)
            }
            EventKind::Cls { screen } => {
                self.screen.clear(screen, event.t);
                return None;
            }
            EventKind::Error { code, .. } => {
                (error_text(*code, event.task.as_deref(), controller) + "\n", OutputEventCategory::Stderr)
            }
            _ => message(event).map(|(text, category)| (text + "\n", category))?,
        };
        let place = place(event, controller);
        Some(OutputEvent {
            output,
            category: Some(category),
            line: place.as_ref().map(|(line, _)| conventions.line(*line)),
            source: place.map(|(_, file)| conventions.source(&file)),
            ..OutputEvent::default()
        })
    }

    /// Returns the events for tasks that were created or have ended since the last report.
    pub(crate) fn task_changes(&mut self, controller: &Controller) -> Vec<StandardEvent> {
        let present: BTreeSet<TaskNumber> = controller.vm.tasks().iter().map(|task| task.id).collect();
        let ended = self.tasks.difference(&present).map(|task| thread_event(ThreadEventReason::Exited, *task));
        let started = present.difference(&self.tasks).map(|task| thread_event(ThreadEventReason::Started, *task));
        let changes = ended.chain(started).collect();
        self.tasks = present;
        changes
    }

    /// Returns the events for applications, libraries and files that were loaded or unloaded since the last report.
    pub(crate) fn source_changes(&mut self, controller: &Controller, conventions: &Conventions) -> Vec<StandardEvent> {
        let images = || controller.vm.space.loaded().map(|(_, instance)| &instance.image);
        let modules: BTreeMap<String, String> =
            images().map(|image| (image.path.clone(), image.name.clone())).collect();
        let files: BTreeSet<String> = images().flat_map(|image| image.files.iter().cloned()).collect();
        let mut changes = Vec::new();
        for (path, name) in self.modules.iter().filter(|(path, _)| !modules.contains_key(*path)) {
            changes.push(module_event(ModuleEventReason::Removed, name, path));
        }
        for (path, name) in modules.iter().filter(|(path, _)| !self.modules.contains_key(*path)) {
            changes.push(module_event(ModuleEventReason::New, name, path));
        }
        for file in self.files.difference(&files) {
            changes.push(source_event(LoadedSourceEventReason::Removed, conventions.source(file)));
        }
        for file in files.difference(&self.files) {
            changes.push(source_event(LoadedSourceEventReason::New, conventions.source(file)));
        }
        (self.modules, self.files) = (modules, files);
        changes
    }

    /// Returns the events for the end of all reported tasks, because the application is opened again.
    pub(crate) fn forget_tasks(&mut self) -> Vec<StandardEvent> {
        let ended = self.tasks.iter().map(|task| thread_event(ThreadEventReason::Exited, *task)).collect();
        self.tasks.clear();
        ended
    }
}

/// Returns an application or library as a module for the client.
pub(crate) fn module(name: &str, path: &str) -> Module {
    Module {
        id: module_id(path),
        name: name.to_owned(),
        path: Some(path.to_owned()),
        is_user_code: Some(true),
        ..Module::default()
    }
}

/// Returns the module id of an application or library, by the path of its project file.
pub(crate) fn module_id(path: &str) -> Value {
    Value::String(path.to_owned())
}

/// Returns the thread id of a task.
pub(crate) fn thread(TaskNumber(number): TaskNumber) -> i32 {
    // Some clients do not accept 0 as a thread id.
    i32::try_from(number.saturating_add(1)).unwrap_or(i32::MAX)
}

/// Returns the task with this thread id.
pub(crate) fn task(thread: i32) -> Option<TaskNumber> {
    u64::try_from(thread).ok()?.checked_sub(1).map(TaskNumber)
}

/// Returns the console text and category for an event, except for text on user pages and run-time errors.
fn message(event: &MachineEvent) -> Option<(String, OutputEventCategory)> {
    Some(match &event.kind {
        EventKind::Print { text } => (text.clone(), OutputEventCategory::Stdout),
        EventKind::Log { level, text } => (format!("{level}: {text}"), OutputEventCategory::Console),
        EventKind::Popup { text } => (format!("pop-up: {text}"), OutputEventCategory::Console),
        EventKind::Notice { text } => (format!("note: {text}"), OutputEventCategory::Console),
        EventKind::Fault { instruction, text, .. } => {
            (format!("the arm cannot follow the path of this {instruction}: {text}"), OutputEventCategory::Stderr)
        }
        EventKind::Clearance { state: "contact", a, b, .. } => {
            (format!("`{a}` touches `{b}`"), OutputEventCategory::Stderr)
        }
        EventKind::Grip { .. } | EventKind::Release { .. } => {
            (event.kind.handling_problem()?, OutputEventCategory::Console)
        }
        EventKind::Lacking { instruction, .. } => {
            (format!("{}: the run ends here", missing_instruction(instruction)), OutputEventCategory::Stderr)
        }
        _ => return None,
    })
}

/// Returns the line and file that caused an event.
fn place(event: &MachineEvent, controller: &Controller) -> Option<(u32, String)> {
    match &event.kind {
        EventKind::Error { line, file, .. }
        | EventKind::Fault { line, file, .. }
        | EventKind::Lacking { line, file, .. }
        | EventKind::Clearance { of: Some(ClearanceMove { line, file, .. }), .. } => Some((*line, file.clone())),
        _ => {
            let (_, line, file) = controller.devices.place(event.at?);
            Some((line, file)).filter(|(_, file)| !file.is_empty())
        }
    }
}

/// Formats a run-time error with its task, and with the data in the task's line that caused it.
fn error_text(code: u16, name: Option<&str>, controller: &mut Controller) -> String {
    let short = runtime_errors::find(code).map_or("unknown run-time error", |error| error.short);
    let failed = controller.vm.tasks().iter().find(|task| Some(task.name.as_str()) == name).map(|task| task.id);
    let cause = failed.map(|task| cause(Fault(code), task, controller)).unwrap_or_default();
    let task = name.map(|name| format!(" (task `{name}`)")).unwrap_or_default();
    format!("error {code}: {short}{cause}{task}")
}

fn module_event(reason: ModuleEventReason, name: &str, path: &str) -> StandardEvent {
    StandardEvent::Module(ModuleEvent { module: module(name, path), reason })
}

fn source_event(reason: LoadedSourceEventReason, source: Source) -> StandardEvent {
    StandardEvent::LoadedSource(LoadedSourceEvent { reason, source })
}

fn thread_event(reason: ThreadEventReason, task: TaskNumber) -> StandardEvent {
    StandardEvent::Thread(ThreadEvent { reason, thread_id: thread(task) })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::test_client::{FIRST_LINE, MAIN_THREAD, TestClient, source};

    const PRINTING: &str = "program start()\nbegin\n  put(\"a\")\n  putln(\"b\")\n  logMsg(\"c\")\n  delay(1)\nend\n";

    fn outputs(arguments: Value) -> Vec<Value> {
        let events = TestClient::launched(PRINTING, arguments).run();
        events.into_iter().filter(|(event, _)| event == "output").map(|(_, body)| body).collect()
    }

    fn expected(text: &str, category: &str, line: u64) -> Value {
        json!({ "output": text, "category": category, "line": FIRST_LINE + line, "source": source("start") })
    }

    #[test]
    fn output_of_programs_has_its_line() {
        let shown = outputs(json!({}));
        assert_eq!(shown[..2], [expected("a", "stdout", 0), expected("b\n", "stdout", 1)]);
        assert_eq!((&shown[2]["line"], &shown[2]["category"]), (&json!(FIRST_LINE + 2), &json!("console")));
        assert!(shown[2]["output"].as_str().unwrap().ends_with("c\n"), "{shown:?}");
    }

    #[test]
    fn loaded_and_unloaded_libraries_are_reported_once() {
        let client = TestClient::launched(PRINTING, json!({}));
        let unloaded = ("/cell/usr/usrapp/part/part.pjx".to_owned(), "part".to_owned());
        let mut notices = Notices { modules: [unloaded].into(), ..Notices::default() };
        let mut changes = || {
            let changes = notices.source_changes(&client.debugger.controller, &Conventions::default());
            let modules = changes.into_iter().filter_map(|change| match change {
                StandardEvent::Module(event) => Some((event.reason, event.module.name)),
                _ => None,
            });
            modules.collect::<Vec<_>>()
        };
        let expected = [(ModuleEventReason::Removed, "part".to_owned()), (ModuleEventReason::New, "main".to_owned())];
        assert_eq!(changes(), expected);
        assert_eq!(changes(), []);
    }

    /// Text of a part that the run passes once more was already output.
    #[test]
    fn redrawn_pages_and_repeated_parts_are_output_once() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  for nCount=1 to 4\n    gotoxy(0,0)\n    put(\"State \")\n    \
                       put(toString(\"\",roundDown(nCount/3)))\n  endFor\n  ? \"end\"\nend\n";
        let shown = |client: &mut TestClient| {
            let events = client.run().into_iter().filter(|(event, _)| event == "output");
            events.map(|(_, body)| body["output"].as_str().unwrap().to_owned()).collect::<String>()
        };
        let mut client = TestClient::launched(listing, json!({ "stopOnExit": true }));
        assert_eq!(shown(&mut client), "State 0\nState 1end\n");
        client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(shown(&mut client), "end\n");
    }

    #[test]
    fn patterns_of_skipped_code_that_match_nothing_are_reported() {
        let notes = |patterns: Value| {
            let mut client = TestClient::launching(PRINTING, json!({ "skip": patterns, "stopOnEntry": true }));
            let events = client.events("configurationDone", json!({})).into_iter();
            events.filter(|(event, _)| event == "output").map(|(_, body)| body["output"].clone()).collect::<Vec<_>>()
        };
        assert_eq!(notes(json!(["main", "main:st*"])), Vec::<Value>::new());
        let found = notes(json!(["zz", "main:none"]));
        assert_eq!(found.len(), 2);
        assert!(found[0].as_str().unwrap().starts_with("note: `skip`: `zz` is no library"), "{found:?}");
    }

    /// The output event names the variable, as the stop does.
    #[test]
    fn an_error_of_an_unlinked_tool_is_output_with_the_tool() {
        let listing = "tool tGripper\n\nprogram start()\nbegin\n  close(tGripper)\nend\n";
        let mut client = TestClient::launched(listing, json!({}));
        let events = client.run();
        let find = |name: &str, key: &str| {
            let found = events.iter().find(|(event, _)| event == name).map(|(_, body)| body[key].clone());
            found.unwrap().as_str().unwrap().to_owned()
        };
        let error = "error 123: input or output not linked: `tGripper` has no link";
        assert_eq!(find("stopped", "text"), error);
        assert_eq!(find("output", "output"), format!("{error} (task `main~`)\n"));
    }

    #[test]
    fn text_on_pages_is_no_output_if_the_client_shows_pages() {
        let shown = outputs(json!({ "screenOutput": false }));
        assert_eq!(shown.len(), 1, "{shown:?}");
    }
}
