//! Signals of a cell file.

use crate::build::CellMaker;
use crate::error::CellError;
use crate::file::{SignalLevel, SignalValues};
use crate::gripper::SignalWrite;
use crate::surroundings::{KnownSignal, SignalClass};

impl CellMaker<'_> {
    /// Checks signal values that the cell compares. Returns `None` if the application does not have one of the signals
    /// and the file may belong to another application.
    pub(super) fn compared(&self, values: &SignalValues, key: &str) -> Result<Option<Vec<SignalWrite>>, CellError> {
        values_of(values, key, |path, key| Ok(self.signal(path, key)?.map(|signal| signal.class)))
    }

    /// Checks input values that the cell sets; `None` as for [`Self::compared`].
    pub(super) fn inputs(&self, values: &SignalValues, key: &str) -> Result<Option<Vec<SignalWrite>>, CellError> {
        values_of(values, key, |path, key| self.input(path, key))
    }

    /// Returns the class of the input with this path, which the cell sets; `None` as for [`Self::compared`].
    pub(super) fn input(&self, path: &str, key: &str) -> Result<Option<SignalClass>, CellError> {
        match self.signal(path, key)? {
            Some(KnownSignal { is_output: true, .. }) => {
                let message = format!("`{path}` is an output, which only programs write");
                Err(CellError::new(key, message, "name an input"))
            }
            signal => Ok(signal.map(|signal| signal.class)),
        }
    }

    fn signal(&self, path: &str, key: &str) -> Result<Option<KnownSignal>, CellError> {
        match self.surroundings.signal(path) {
            Ok(signal) => Ok(Some(signal)),
            Err(_) if self.surroundings.may_lack_data() => Ok(None),
            Err(similar) => {
                let message = format!("there is no input or output `{path}`");
                let help = similar.map(|similar| format!("did you mean `{similar}`?"));
                Err(CellError::new(key, message, help.unwrap_or_else(|| "write the path of a signal".to_owned())))
            }
        }
    }
}

/// Checks that each value suits its signal. `class` returns the signal's class for a path and a key.
fn values_of(
    values: &SignalValues,
    key: &str,
    class: impl Fn(&str, &str) -> Result<Option<SignalClass>, CellError>,
) -> Result<Option<Vec<SignalWrite>>, CellError> {
    let writes = values.iter().map(|(path, level)| {
        let key = format!("{key}.{path}");
        match (class(path, &key)?, level) {
            (Some(SignalClass::Digital), SignalLevel::Analog(_)) => {
                let message = format!("`{path}` is digital, and {} is a number", level.number());
                Err(CellError::new(key, message, "write true or false"))
            }
            (Some(SignalClass::Analog), SignalLevel::Digital(value)) => {
                let message = format!("`{path}` is analog, and {value} is no number");
                Err(CellError::new(key, message, "write a number"))
            }
            (Some(_), _) => Ok(Some(SignalWrite { path: path.clone(), value: level.number() })),
            (None, _) => Ok(None),
        }
    });
    writes.collect()
}
