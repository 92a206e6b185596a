//! The names by which programs are tests, applications have tests, and tests assert.

/// The beginning of the names of tests.
const TEST: &str = "test";

/// The program that is executed before each test of its application.
pub const SETUP: &str = "setup";

/// The program that is executed after each test.
pub const TEARDOWN: &str = "teardown";

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

/// Whether an application has tests: `folders` are the names of the folders that lead to it, its own last.
pub fn is_test_application<'n>(folders: impl IntoIterator<Item = &'n str>) -> bool {
    let folders: Vec<&str> = folders.into_iter().collect();
    let [above @ .., name] = folders.as_slice() else { return false };
    name.ends_with("Test") || above.contains(&"tests")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn test_applications_have_a_name_or_a_folder() {
        for (path, expected) in [
            ("cell/usr/usrapp/palletiserTest", true),
            ("cell/tests/palletiser", true),
            ("cell/usr/usrapp/palletiser", false),
            ("cell/usr/usrapp/tests", false),
            ("cell/usr/usrapp/Testing", false),
            ("", false),
        ] {
            assert_eq!(is_test_application(path.split('/')), expected, "{path}");
        }
    }
}
