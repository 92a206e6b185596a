//! The names by which programs are tests, applications have tests, and tests assert.

/// The beginning of the names of tests.
const TEST: &str = "test";

/// The program that is executed before each test of its application.
pub const SETUP: &str = "setup";

/// The program that is executed after each test.
pub const TEARDOWN: &str = "teardown";

/// The folder below which applications have tests, and scenarios lie.
pub const TESTS: &str = "tests";

/// The library by which tests assert.
pub const ASSERTIONS: &str = "val3assert";

/// Its program that every failed assertion calls, with the message.
pub const FAILURE: &str = "fail";

/// Whether a program of an application with tests is a test.
#[must_use]
pub fn is_test(program: &str) -> bool {
    program.starts_with(TEST)
}

/// Whether a program of an application with tests is executed by name: a test, `setup` or `teardown`.
#[must_use]
pub fn is_executed(program: &str) -> bool {
    is_test(program) || [SETUP, TEARDOWN].contains(&program)
}

/// Whether the name of an application says that it has tests.
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
