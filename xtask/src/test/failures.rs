//! Failed tests, repeated at the end of the output, because often only the end of a long log is read.

use std::collections::VecDeque;

/// Largest number of repeated lines per failed test.
const LINES: usize = 40;

/// The failed tests of all steps.
#[derive(Debug, Default)]
pub(super) struct Failures {
    tests: Vec<String>,
    outputs: Vec<Output>,
    /// Whether the next lines are those of the last output.
    is_output: bool,
    part: Part,
}

/// A part of a step, such as the tests of an editor.
#[derive(Debug, Default)]
struct Part {
    name: String,
    /// Its last lines, which are repeated if it fails without a failed test.
    last: VecDeque<String>,
    has_failed_test: bool,
}

/// Output of a failed test, or of a failed part.
#[derive(Debug)]
struct Output {
    title: String,
    lines: Vec<String>,
}

impl Failures {
    /// Reads the next line of a step.
    pub(super) fn read(&mut self, step: &str, line: &str) {
        let title = line.strip_prefix("--- ").and_then(|title| title.split(',').next());
        if let Some(name) = title {
            self.part = Part { name: name.to_owned(), ..Part::default() };
        }
        if let Some(test) = failed_test(line) {
            self.tests.push(format!("{step}: {test}"));
            self.part.has_failed_test = true;
        }
        if line.strip_suffix(" failed") == Some(&*self.part.name) && !self.part.has_failed_test {
            self.tests.push(format!("{step}: {}", self.part.name));
            let lines = self.part.last.drain(..).collect();
            self.outputs.push(Output { title: format!("---- last lines of {} ----", self.part.name), lines });
        }
        if line.starts_with("FAILED ") || line.starts_with("---- ") && line.ends_with(" stdout ----") {
            self.outputs.push(Output { title: line.to_owned(), lines: Vec::new() });
            self.is_output = true;
        } else if title.is_some() || line == "failures:" || line.starts_with("test result: ") || line.starts_with("ok ")
        {
            self.is_output = false;
        } else if let (true, Some(output)) = (self.is_output, self.outputs.last_mut()) {
            output.lines.push(line.to_owned());
        }
        self.part.last.push_back(line.to_owned());
        if self.part.last.len() > LINES {
            self.part.last.pop_front();
        }
    }

    /// Prints the failed tests, each with the beginning of its output.
    pub(super) fn print(&self) {
        for output in &self.outputs {
            println!("{}", output.title);
            for line in output.lines.iter().take(LINES) {
                println!("{line}");
            }
        }
        for test in &self.tests {
            println!("failed test of {test}");
        }
    }
}

/// Returns the name in Rust's `test NAME ... FAILED`, or the text after `FAILED ` in the editor tests.
fn failed_test(line: &str) -> Option<&str> {
    let of_rust = line.strip_prefix("test ").and_then(|test| test.strip_suffix(" ... FAILED"));
    of_rust.or_else(|| line.strip_prefix("FAILED "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failed_tests_are_kept_with_their_output() {
        let log = "test a::one ... ok\n\
                   test a::two ... FAILED\n\
                   \n\
                   failures:\n\
                   \n\
                   ---- a::two stdout ----\n\
                   left: 1\n\
                   \n\
                   failures:\n    a::two\n\
                   \n\
                   test result: FAILED. 1 passed; 1 failed\n\
                   FAILED the click opens a page (12 ms)";
        let failures = read("tests", log);
        assert_eq!(failures.tests, ["tests: a::two", "tests: the click opens a page (12 ms)"]);
        assert_eq!(failures.outputs.len(), 2);
        assert_eq!(failures.outputs[0].lines, ["left: 1", ""]);
    }

    #[test]
    fn the_lines_after_a_failed_editor_test_are_its_output() {
        let log = "--- view, 3 s\n\
                   ok the page opens (4 ms)\n\
                   FAILED the click opens a page\n\
                   AssertionError: 1 != 2\n\
                   ok the page closes (5 ms)\n\
                   test result: FAILED. 2 passed; 1 failed; view\n\
                   view failed";
        let failures = read("editors", log);
        assert_eq!(failures.tests, ["editors: the click opens a page"]);
        assert_eq!(failures.outputs[0].lines, ["AssertionError: 1 != 2"]);
    }

    #[test]
    fn a_part_that_fails_without_a_failed_test_is_named_with_its_last_lines() {
        let log = "--- tree, 3 s\n\
                   ok a click (4 ms)\n\
                   --- view, 3 s\n\
                   4 passed, 0 failed\n\
                   Error: no browser\n\
                   view failed\n\
                   --- trust, 2 s";
        let failures = read("editors", log);
        assert_eq!(failures.tests, ["editors: view"]);
        assert_eq!(failures.outputs.len(), 1);
        assert_eq!(failures.outputs[0].lines, ["--- view, 3 s", "4 passed, 0 failed", "Error: no browser"]);
    }

    fn read(step: &str, log: &str) -> Failures {
        let mut failures = Failures::default();
        log.lines().for_each(|line| failures.read(step, line));
        failures
    }
}
