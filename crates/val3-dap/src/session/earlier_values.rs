//! Earlier values of a variable, for the hover over it.

use val3_debug::{DataWrite, DataWrites, WriteLimits};
use val3_machine::event::seconds;

use super::{DebugSession, NamedData};
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;

/// Number of earlier values.
const VALUES: usize = 4;

/// Limits of the search: some 10 ms.
const LIMITS: WriteLimits = WriteLimits { writes: VALUES + 1, lines: 20_000 };

/// Largest number of characters of an earlier value.
const LENGTH: usize = 40;

impl DebugSession {
    /// Describes the last writes of a variable, element or field in a stopped run: `since 0.032 s, start() line 14 ·
    /// before: 4 (0.020 s, start() line 12), 0 (initially)`. `…` stands for values before the searched part of the
    /// history. Returns `None` for other expressions, and for a variable that was never written.
    pub(crate) fn earlier_values(
        &mut self,
        expression: &str,
        frame: Option<i32>,
        run: &mut DebuggedRun<'_>,
    ) -> Option<String> {
        self.check_stopped().ok()?;
        let named = NamedData { name: expression, variables_reference: None, frame };
        let data = self.named_data(&named, run).ok()?.ok()?;
        let found = self.quick_writes(&data, LIMITS, run)?;
        if found.writes.is_empty() && found.initial.is_none() && found.since == run.debugger.controller.now() {
            // Too many lines were executed since the last snapshot.
            return None;
        }
        described(&found, &self.conventions)
    }
}

fn described(DataWrites { writes, initial, since, .. }: &DataWrites, conventions: &Conventions) -> Option<String> {
    let Some(last) = writes.first() else {
        let is_whole = initial.is_some();
        return (!is_whole).then(|| format!("unchanged since {:.3} s", seconds(*since)));
    };
    let before = writes.iter().skip(1).take(VALUES);
    let before = before.map(|write| format!("{} ({})", short(&write.value), place(write, conventions)));
    let first = match initial {
        Some(initial) => format!("{} (initially)", short(&initial.value)),
        None => "…".to_owned(),
    };
    let values: Vec<String> = before.chain([first]).collect();
    Some(format!("since {} · before: {}", place(last, conventions), values.join(", ")))
}

/// Formats the time and the line of a write.
fn place(write: &DataWrite, conventions: &Conventions) -> String {
    let time = seconds(write.time);
    match &write.line {
        Some(line) => format!("{time:.3} s, {}() line {}", line.program, conventions.line(line.row)),
        None => format!("{time:.3} s, from outside"),
    }
}

fn short(value: &str) -> String {
    match value.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{}…", value.get(..end).unwrap_or(value)),
        None => value.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{MAIN_THREAD, TestClient};

    const LISTING: &str = "\
num nA
num nB
string sText
dio diFree

program start()
begin
  nA=3
  delay(0.01)
  nA=4
  delay(0.01)
  nA=5
  sText=\"abc\"
  delay(1)
end
";

    fn hover(client: &mut TestClient, expression: &str) -> String {
        let (_, frame) = client.thread_and_frame();
        let arguments = json!({ "expression": expression, "frameId": frame, "context": "hover" });
        client.body("evaluate", arguments)["result"].as_str().unwrap().to_owned()
    }

    fn stopped_after(listing: &str, steps: usize) -> TestClient {
        let mut client = TestClient::stopped(listing);
        for _ in 0..steps {
            client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        }
        client
    }

    #[test]
    fn hover_shows_the_last_writes_of_a_variable() {
        let mut client = stopped_after(LISTING, 6);
        let expected = "5 · since 0.020 s, start() line 9 · before: 4 (0.010 s, start() line 7), \
                        3 (0.000 s, start() line 5), 0 (initially)";
        assert_eq!(hover(&mut client, "nA"), expected);
        assert_eq!(hover(&mut client, "sText"), "\"abc\" · since 0.020 s, start() line 10 · before: \"\" (initially)");
        assert_eq!((hover(&mut client, "nB"), hover(&mut client, "nA+1")), ("0".to_owned(), "6".to_owned()));
        let (_, frame) = client.thread_and_frame();
        for context in ["watch", "clipboard", "variables"] {
            let arguments = json!({ "expression": "nA", "frameId": frame, "context": context });
            assert_eq!(client.body("evaluate", arguments)["result"], "5", "{context}");
        }
    }

    #[test]
    fn more_writes_than_are_shown_end_with_an_ellipsis() {
        let listing = "num nA\n\nprogram start()\nbegin\n  while true\n    nA=nA+1\n  endWhile\nend\n";
        let mut client = stopped_after(listing, 30);
        let shown = hover(&mut client, "nA");
        assert_eq!((shown.matches("line 6").count(), shown.ends_with(", …")), (5, true), "{shown}");
    }

    #[test]
    fn the_search_ends_in_a_long_history() {
        let listing = "num nA\nnum nB\nbool bGo\n\nprogram start()\nbegin\n  nB=1\n  while !bGo\n    nA=nA+1\n  \
                       endWhile\nend\n";
        let mut client = TestClient::launched(listing, json!({}));
        let cycles = |client: &mut TestClient| client.debugger.advance();
        for _ in 0..200 {
            cycles(&mut client);
        }
        client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        let shown = hover(&mut client, "nB");
        assert!(shown.starts_with("1 · unchanged since 0."), "{shown}");
    }
}
