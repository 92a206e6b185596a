//! Hit counts, which clients show as messages of the breakpoints.

use std::collections::BTreeMap;

use val3_debug::{BreakpointId, Debugger};

use crate::protocol::Breakpoint;

/// Breakpoints that one request replaces together.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum BreakpointGroup {
    /// Breakpoints of a file, by its path in the client's spelling.
    File(String),
    /// Breakpoints on programs.
    Programs,
    /// Breakpoints on data.
    Data,
}

/// Breakpoints with their messages, as the client has them.
#[derive(Debug, Default)]
pub(crate) struct ShownHits(BTreeMap<BreakpointGroup, Vec<Breakpoint>>);

impl ShownHits {
    /// Replaces the breakpoints of a group, and adds hit counts to breakpoints that were already hit.
    pub(crate) fn replace(&mut self, group: BreakpointGroup, breakpoints: &mut [Breakpoint], debugger: &Debugger) {
        for breakpoint in breakpoints.iter_mut().filter(|breakpoint| breakpoint.verified) {
            breakpoint.message = hits_of(breakpoint, debugger).filter(|hits| *hits > 0).map(message);
        }
        self.0.insert(group, breakpoints.to_vec());
    }

    /// Stores new states of breakpoints.
    pub(crate) fn update(&mut self, breakpoints: &[Breakpoint]) {
        for known in self.0.values_mut().flatten() {
            if let Some(new) = breakpoints.iter().find(|new| new.id == known.id) {
                known.clone_from(new);
            }
        }
    }

    /// Returns the breakpoints whose message has changed since the last call.
    pub(crate) fn changes(&mut self, debugger: &Debugger) -> Vec<Breakpoint> {
        let mut changed = Vec::new();
        for known in self.0.values_mut().flatten().filter(|breakpoint| breakpoint.verified) {
            let message = hits_of(known, debugger).map(message);
            if message != known.message {
                known.message = message;
                changed.push(known.clone());
            }
        }
        changed
    }
}

fn hits_of(breakpoint: &Breakpoint, debugger: &Debugger) -> Option<u64> {
    let id = u32::try_from(breakpoint.id?).ok()?;
    Some(debugger.hits(BreakpointId(id)))
}

fn message(hits: u64) -> String {
    match hits {
        0 => "not hit yet".to_owned(),
        1 => "hit once".to_owned(),
        hits => format!("hit {hits} times"),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{MAIN_THREAD, TestClient, source};

    const ROUNDS: &str = "num nCount\n\nprogram start()\nbegin\n  for nCount=1 to 3\n    delay(1)\n  endFor\n  nCount=9\n  \
                          delay(1)\nend\n";

    fn arguments() -> Value {
        json!({ "source": source("start"), "breakpoints": [{ "line": 6 }, { "line": 8 }] })
    }

    /// Continues, and returns line and message of the changed breakpoints.
    fn changes(client: &mut TestClient, command: &str) -> Vec<(u64, String)> {
        let mut events = client.events(command, json!({ "threadId": MAIN_THREAD }));
        events.extend(client.run());
        let changed =
            events.into_iter().filter(|(event, _)| event == "breakpoint").map(|(_, body)| body["breakpoint"].clone());
        let shown = changed.map(|breakpoint| {
            assert_eq!(breakpoint["verified"], true);
            (breakpoint["line"].as_u64().unwrap(), breakpoint["message"].as_str().unwrap().to_owned())
        });
        shown.collect()
    }

    #[test]
    fn a_stop_updates_the_hits_of_breakpoints() {
        let mut client = TestClient::stopped(ROUNDS);
        let set = client.body("setBreakpoints", arguments());
        assert_eq!(set["breakpoints"][0]["message"], json!(null));
        let message = |line, text: &str| (line, text.to_owned());
        assert_eq!(changes(&mut client, "continue"), [message(6, "hit once"), message(8, "not hit yet")]);
        assert_eq!(changes(&mut client, "continue"), [message(6, "hit 2 times")]);
        let set = client.body("setBreakpoints", arguments());
        assert_eq!(set["breakpoints"][0]["message"], "hit 2 times");
        assert_eq!(changes(&mut client, "reverseContinue"), [message(6, "hit once"), message(8, "not hit yet")]);
        client.body("setBreakpoints", json!({ "source": source("start"), "breakpoints": [] }));
        assert_eq!(changes(&mut client, "next"), []);
    }
}
