//! Errors of a run's outputs. An output that cannot be written does not prevent the others.

use crate::user_error::UserError;

/// Errors of the outputs that could not be written.
#[derive(Debug, Default)]
pub(crate) struct OutputErrors(Vec<UserError>);

impl OutputErrors {
    /// Returns the value, or adds the error. The same error is added once: an output fails again when it is closed.
    pub(crate) fn collect<T>(&mut self, result: Result<T, UserError>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                if !self.0.contains(&error) {
                    self.0.push(error);
                }
                None
            }
        }
    }

    /// Whether all outputs were written.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns all errors as one error.
    pub(crate) fn into_result(self) -> Result<(), UserError> {
        UserError::joined(self.0).map_or(Ok(()), Err)
    }
}
