//! Text of a recorded scenario.

use val3_machine::controller::Controller;
use val3_machine::event::EndReason;
use val3_machine::io::{Direction, SignalKind};
use val3_machine::script::LineBytes;
use val3_suite::Failure;

use super::run_record::{Given, RecordedError, RunRecord};
use super::toml_text::{key, number, pendant_key, quoted, value};
use crate::args::{ControllerArgs, START};

/// Maximum number of texts per output that become expectations. Further texts are mostly similar.
const TEXTS: usize = 20;

/// Maximum number of last bytes on a line that become an expectation.
const BYTES: usize = 200;

/// Time in seconds up to which an application that ends by itself needs no explicit limit.
const BY_ITSELF: f64 = 50.0;

/// Sentence about a scenario without expectations.
pub(super) const NOTHING_EXPECTED: &str =
    "Nothing is expected: the run has shown, printed, logged, sent and set nothing that a scenario repeats";

/// Draft of a scenario.
pub(super) struct Draft<'r> {
    run: &'r RunRecord,
    heading: String,
    /// Keys before the first table.
    head: Vec<String>,
    /// External events.
    events: Vec<String>,
    /// Expected texts and errors.
    expected: Vec<String>,
    outputs: Vec<String>,
    /// Expected bytes sent on lines.
    sent: Vec<String>,
    screen: Vec<String>,
    /// Differences from the run that the scenario does not repeat.
    remarks: Vec<String>,
}

impl<'r> Draft<'r> {
    /// Creates a draft from a run. `application` is the path of the application relative to the scenario.
    pub(super) fn new(heading: &str, application: &str, run: &'r RunRecord, controller: ControllerArgs) -> Self {
        let mut draft = Self {
            run,
            heading: heading.to_owned(),
            head: head(application, run, &controller),
            events: Vec::new(),
            expected: expected(run),
            outputs: Vec::new(),
            sent: run.sent.iter().map(|(link, bytes)| format!("{} = {}", key(link), last_bytes(bytes))).collect(),
            screen: Vec::new(),
            remarks: Vec::new(),
        };
        for (t, given) in &run.given {
            draft.add_event(*t, given);
        }
        let unusual = run
            .unusual
            .iter()
            .map(|link| format!("`{link}` was closed or failed during the run, which no script repeats"));
        draft.remarks.extend(unusual);
        if run.reason.is_none() && !run.continues {
            draft.remark(format!("the record breaks off at {} s", number(run.end)));
        }
        draft
    }

    /// Adds the final output values, formatted by the signal types of the controller.
    pub(super) fn add_outputs(&mut self, controller: &Controller) {
        let io = &controller.devices.state.io;
        for (link, level) in &self.run.signals {
            let signal =
                io.find(link).and_then(|id| io.signal(id)).filter(|signal| signal.direction == Direction::Output);
            let Some(signal) = signal.filter(|_| !self.run.is_set(link)) else { continue };
            let level = if signal.kind == SignalKind::Digital { (*level != 0.0).to_string() } else { number(*level) };
            self.outputs.push(format!("{} = {level}", key(link)));
        }
    }

    /// Adds the final user page.
    pub(super) fn add_screen(&mut self, lines: &[String]) {
        self.screen = list("screen =", lines.iter().map(|line| quoted(line)));
    }

    /// Adds a remark about a difference from the run.
    pub(super) fn remark(&mut self, remark: String) {
        self.remarks.push(remark);
    }

    /// Differences from the run that the scenario does not repeat.
    pub(super) fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Whether no line is an expectation, so that the scenario only proves that the application runs.
    pub(super) fn expects_nothing(&self) -> bool {
        let mut expected = [&self.screen, &self.expected, &self.outputs, &self.sent].into_iter().flatten();
        expected.all(|line| is_comment(line))
    }

    /// Turns unmet expectations into comments. Returns the first failure that belongs to no expectation.
    pub(super) fn comment_out<'f>(&mut self, failures: &'f [Failure]) -> Option<&'f Failure> {
        let text = self.text();
        let lines: Vec<&str> = text.lines().collect();
        let mut other = None;
        for failure in failures {
            let place = failure.places.first().filter(|place| place.program.starts_with("expect"));
            let line = place.and_then(|place| lines.get((place.line as usize).checked_sub(1)?));
            let Some(line) = line.filter(|line| self.disable(line)) else {
                other = other.or(Some(failure));
                continue;
            };
            self.remark(format!("the execution does not repeat {}", line.trim().trim_end_matches(',')));
        }
        other
    }

    /// Turns a line into a comment. Returns whether the line is an expectation.
    fn disable(&mut self, line: &str) -> bool {
        let all = [&mut self.screen, &mut self.expected, &mut self.outputs, &mut self.sent].into_iter().flatten();
        let found: Vec<&mut String> = all.filter(|own| own.as_str() == line).collect();
        let is_found = !found.is_empty();
        let text = line.trim_start();
        let indent = line.get(..line.len() - text.len()).unwrap_or_default();
        found.into_iter().for_each(|own| *own = format!("{indent}# not repeated: {text}"));
        is_found
    }

    /// Text of the file.
    pub(super) fn text(&self) -> String {
        let remarks = self.remarks.iter().map(|remark| format!("# Not repeated: {remark}"));
        let mut lines: Vec<String> = [format!("# {}", self.heading)].into_iter().chain(remarks).collect();
        if self.expects_nothing() {
            lines.push(format!("# {NOTHING_EXPECTED}"));
        }
        lines.extend_from_slice(&self.head);
        lines.extend_from_slice(&self.events);
        lines.extend([String::new(), "[expect]".to_owned()]);
        lines.extend(self.screen.chunk_by(is_same_list).chain(self.expected.chunk_by(is_same_list)).flat_map(filled));
        for (table, keys) in [("io", &self.outputs), ("sent", &self.sent)] {
            if !keys.is_empty() {
                let mark = if keys.iter().all(|line| is_comment(line)) { "# " } else { "" };
                lines.extend([String::new(), format!("{mark}[expect.{table}]")]);
                lines.extend_from_slice(keys);
            }
        }
        lines.into_iter().flat_map(|line| [line, "\n".to_owned()]).collect()
    }

    fn add_event(&mut self, t: f64, given: &Given) {
        let t = number(milliseconds(t));
        let keys = match given {
            Given::Keys(keys) => keys,
            Given::Other(action) => {
                let remark = format!("at {t} s the operator has done what no script does: {action}");
                self.events.extend([String::new(), format!("# t = {t}: no key of a script is {action}")]);
                self.remarks.push(remark);
                return;
            }
        };
        self.events.extend([String::new(), "[[at]]".to_owned(), format!("t = {t}")]);
        self.events.extend(keys.iter().map(|(name, item)| match name.as_str() {
            "key" => format!("key = {}", pendant_key(item)),
            name => format!("{name} = {}", value(item)),
        }));
    }
}

/// Keys before the first table.
fn head(application: &str, run: &RunRecord, controller: &ControllerArgs) -> Vec<String> {
    let mut head = vec![format!("application = {}", quoted(application))];
    let mut add = |key: &str, text: String| head.push(format!("{key} {text}"));
    if let Some(program) = run.program.as_ref().filter(|program| *program != START) {
        add("program =", quoted(program));
    }
    let ends_by_itself = run.reason == Some(EndReason::Finished) || run.is_stopped();
    match ends_by_itself {
        true if run.end > BY_ITSELF => add("limit =", number((run.end * 1.5).ceil())),
        true => {}
        false => add("until =", number((run.end * 1000.0).ceil() / 1000.0)),
    }
    if let Some(arm) = &controller.arm {
        add("arm =", quoted(arm));
    }
    if let Some(start) = &controller.start {
        add("start =", format!("[{}]", start.iter().map(|axis| number(*axis)).collect::<Vec<_>>().join(", ")));
    }
    if controller.power {
        add("power =", true.to_string());
    }
    if let Some(speed) = controller.monitor_speed {
        add("monitor_speed =", speed.to_string());
    }
    if !run.silent.is_empty() {
        add("silent =", format!("[{}]", run.silent.iter().map(|link| quoted(link)).collect::<Vec<_>>().join(", ")));
    }
    head
}

/// Printed and logged texts, messages, and run-time errors of the run, as expectations.
fn expected(run: &RunRecord) -> Vec<String> {
    let texts = [("print =", &run.prints), ("log =", &run.logs), ("popup =", &run.popups)];
    let lists = texts.into_iter().flat_map(|(key, texts)| {
        let mut lines = list(key, texts.iter().filter(|text| !text.is_empty()).take(TEXTS).map(|text| quoted(text)));
        let more = texts.len().saturating_sub(TEXTS);
        if more > 0 && !lines.is_empty() {
            lines.insert(lines.len() - 1, format!("  # and {more} more in the record"));
        }
        lines
    });
    lists.chain(list("errors =", run.errors.iter().map(error))).collect()
}

fn error(RecordedError { code, task, program }: &RecordedError) -> String {
    let task = task.as_ref().map(|task| format!(", task = {}", quoted(task))).unwrap_or_default();
    format!("{{ code = {code}{task}, program = {} }}", quoted(program))
}

/// Key with a list, one item per line; empty without items.
fn list(key: &str, items: impl Iterator<Item = String>) -> Vec<String> {
    let items: Vec<String> = items.map(|item| format!("  {item},")).collect();
    if items.is_empty() {
        return items;
    }
    [format!("{key} [")].into_iter().chain(items).chain(["]".to_owned()]).collect()
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with('#')
}

/// Whether two successive lines of lists belong to the same list.
fn is_same_list(line: &String, _next: &String) -> bool {
    line != "]"
}

/// Lines of a list. An expectation that compares nothing is an error, so a list of comments becomes a comment.
fn filled(list: &[String]) -> Vec<String> {
    let [first, items @ .., last] = list else { return list.to_vec() };
    if items.iter().all(|item| is_comment(item)) {
        let items = items.iter().cloned();
        return [format!("# {first}")].into_iter().chain(items).chain([format!("# {last}")]).collect();
    }
    list.to_vec()
}

/// Last bytes on a line, as text.
fn last_bytes(bytes: &[u8]) -> String {
    let last = bytes.get(bytes.len().saturating_sub(BYTES)..).unwrap_or(bytes);
    value(&serde_json::to_value(LineBytes::from(last)).unwrap_or_default())
}

/// Time rounded down to whole milliseconds.
fn milliseconds(seconds: f64) -> f64 {
    const ROUNDING: f64 = 1e-6;
    (seconds * 1000.0 + ROUNDING).floor() / 1000.0
}
