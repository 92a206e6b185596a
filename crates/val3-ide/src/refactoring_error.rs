//! Reasons against a refactoring.

/// Reason why a refactoring is not possible, as a sentence for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RefactoringError(pub String);

impl From<String> for RefactoringError {
    fn from(reason: String) -> Self {
        Self(reason)
    }
}

impl From<&str> for RefactoringError {
    fn from(reason: &str) -> Self {
        Self(reason.to_owned())
    }
}
