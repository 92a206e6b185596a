//! Actions of a script, an operator or a client in an event record. A replay repeats them at their times.

use serde::Deserialize;
use serde_json::{Map, Value};
use val3_machine::controller::Controller;
use val3_machine::script::{Script, ScriptAction};
use val3_session::json_fault;

use crate::user_error::UserError;

/// Actions of a recorded run.
#[derive(Debug, Default, PartialEq)]
pub(super) struct RecordedActions {
    /// Actions before the start of the application.
    before: Vec<ScriptAction>,
    /// Actions during the run, with their times in seconds.
    during: Vec<(f64, ScriptAction)>,
    /// First action that cannot be repeated: its time in seconds and its keys.
    unrepeatable: Option<(f64, String)>,
}

/// Fields of an event that is an action.
#[derive(Deserialize)]
struct RecordedLine {
    t: f64,
    kind: String,
    #[serde(default)]
    keys: Map<String, Value>,
}

impl RecordedActions {
    /// Returns the actions in the lines of a record.
    ///
    /// # Errors
    /// A line is no event.
    pub(super) fn of(lines: &[String]) -> Result<Self, String> {
        let mut actions = Self::default();
        let mut has_started = false;
        for (number, line) in (1..).zip(lines) {
            let RecordedLine { t, kind, keys } =
                serde_json::from_str(line).map_err(|error| json_fault(&error, number))?;
            has_started |= kind == "task";
            if kind != "act" {
                continue;
            }
            match ScriptAction::from_json(keys.clone()) {
                Ok(action) if has_started => actions.during.push((t, action)),
                Ok(action) => actions.before.push(action),
                Err(_) => actions.unrepeatable = actions.unrepeatable.or(Some((t, Value::Object(keys).to_string()))),
            }
        }
        Ok(actions)
    }

    /// Lets a controller, whose application has not started, repeat the actions. `silent` are the lines whose other end
    /// was the script.
    ///
    /// # Errors
    /// An action before the start has no effect, because the application has changed.
    pub(super) fn arrange(self, silent: Vec<String>, controller: &mut Controller) -> Result<(), UserError> {
        controller.follow(Script::of_actions(self.during, silent));
        for action in self.before {
            controller.act(&action).map_err(|problems| {
                UserError::new(format!("an action of the recording cannot be repeated: {}", problems.join("; ")))
                    .with_help("use the files of the application with which the run was recorded")
            })?;
        }
        Ok(())
    }

    /// Note about an action that cannot be repeated.
    pub(super) fn note(&self) -> Option<String> {
        let (t, keys) = self.unrepeatable.as_ref()?;
        Some(format!("the recording contains an action that a replay cannot repeat, at {t} s: {keys}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> RecordedActions {
        RecordedActions::of(&text.lines().map(str::to_owned).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn actions_before_the_start_are_apart() {
        let actions = of("{\"t\":0.0,\"kind\":\"act\",\"keys\":{\"set\":{\"nA\":1}}}\n\
             {\"t\":0.0,\"kind\":\"task\",\"state\":\"created\"}\n\
             {\"t\":0.5,\"kind\":\"act\",\"keys\":{\"key\":271}}\n\
             {\"t\":0.7,\"kind\":\"print\",\"text\":\"x\"}\n\
             {\"t\":1.5,\"kind\":\"act\",\"keys\":{\"userPage\":\"x\"}}\n");
        assert_eq!((actions.before.len(), actions.during.len(), actions.during[0].0), (1, 1, 0.5));
        assert_eq!(
            actions.note().unwrap(),
            "the recording contains an action that a replay cannot repeat, at 1.5 s: {\"userPage\":\"x\"}"
        );
    }

    #[test]
    fn a_line_that_is_no_event_is_named() {
        let fault = RecordedActions::of(&["{\"t\":0.0,\"kind\":\"task\"}".to_owned(), "{}".to_owned()]).unwrap_err();
        assert!(fault.contains("line 2"), "{fault}");
    }
}
