//! Failed tests, repeated at the end of the output, because often only the end of a long log is read.

/// Largest number of repeated lines per failed test.
const LINES: usize = 40;

/// The failed tests of all steps.
#[derive(Debug, Default)]
pub(super) struct Failures {
    tests: Vec<String>,
    outputs: Vec<Output>,
    is_output: bool,
}

/// Output of a failed Rust test.
#[derive(Debug)]
struct Output {
    title: String,
    lines: Vec<String>,
}

impl Failures {
    /// Reads the next line of a step.
    pub(super) fn read(&mut self, step: &str, line: &str) {
        if let Some(test) = failed_test(line) {
            self.tests.push(format!("{step}: {test}"));
        }
        if line.starts_with("---- ") && line.ends_with(" stdout ----") {
            self.outputs.push(Output { title: line.to_owned(), lines: Vec::new() });
            self.is_output = true;
        } else if line == "failures:" || line.starts_with("test result: ") {
            self.is_output = false;
        } else if let (true, Some(output)) = (self.is_output, self.outputs.last_mut()) {
            output.lines.push(line.to_owned());
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
        let mut failures = Failures::default();
        for line in log.lines() {
            failures.read("tests", line);
        }
        assert_eq!(failures.tests, ["tests: a::two", "tests: the click opens a page (12 ms)"]);
        assert_eq!(failures.outputs.len(), 1);
        assert_eq!(failures.outputs[0].lines, ["left: 1", ""]);
    }
}
