//! Names that identify tests, applications with tests, and assertions.

/// Prefix of test names.
const TEST: &str = "test";

/// Program that is executed before each test in its application.
pub const SETUP: &str = "setup";

/// Program that is executed after each test.
pub const TEARDOWN: &str = "teardown";

/// Folder that contains applications with tests, and scenarios.
pub const TESTS: &str = "tests";

/// Library with assertions.
pub const ASSERTIONS: &str = "val3assert";

/// Program of the library that every failed assertion calls with its message.
pub const FAILURE: &str = "fail";

/// Whether a program in an application with tests is a test.
#[must_use]
pub fn is_test(program: &str) -> bool {
    program.starts_with(TEST)
}

/// Whether a program in an application with tests is executed by name: a test, `setup` or `teardown`.
#[must_use]
pub fn is_executed(program: &str) -> bool {
    is_test(program) || [SETUP, TEARDOWN].contains(&program)
}

/// Whether the name identifies an application with tests.
#[must_use]
pub fn is_test_application(name: &str) -> bool {
    name.ends_with("Test")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn test_applications_have_a_name() {
        assert!(is_test_application("palletiserTest"));
        assert!(!is_test_application("palletiser") && !is_test_application("Testing") && !is_test_application(""));
    }
}
