//! Signals of a cell's file.

use crate::build::CellMaker;
use crate::error::CellError;
use crate::file::{SignalLevel, SignalValues};
use crate::gripper::SignalWrite;
use crate::surroundings::SignalClass;

impl CellMaker<'_> {
    /// Checks the values of signals; `None` if the application does not have a signal, and the file may be about
    /// another one.
    pub(super) fn signals(&self, values: &SignalValues, key: &str) -> Result<Option<Vec<SignalWrite>>, CellError> {
        let writes = values.iter().map(|(path, level)| {
            let class = self.signal(path, &format!("{key}.{path}"))?;
            match (class, level) {
                (Some(SignalClass::Digital), SignalLevel::Analog(_)) => {
                    let message = format!("`{path}` is digital, and {} is a number", level.number());
                    Err(CellError::new(format!("{key}.{path}"), message, "write true or false"))
                }
                (Some(SignalClass::Analog), SignalLevel::Digital(value)) => {
                    let message = format!("`{path}` is analog, and {value} is no number");
                    Err(CellError::new(format!("{key}.{path}"), message, "write a number"))
                }
                (Some(_), _) => Ok(Some(SignalWrite { path: path.clone(), value: level.number() })),
                (None, _) => Ok(None),
            }
        });
        writes.collect()
    }

    /// Returns the kind of a signal; `None` if the application does not have it, and the file may be about another one.
    pub(super) fn signal(&self, path: &str, key: &str) -> Result<Option<SignalClass>, CellError> {
        match self.surroundings.signal(path) {
            Ok(class) => Ok(Some(class)),
            Err(_) if self.surroundings.may_lack_data() => Ok(None),
            Err(similar) => {
                let message = format!("there is no input or output `{path}`");
                let help = similar.map(|similar| format!("did you mean `{similar}`?"));
                Err(CellError::new(key, message, help.unwrap_or_else(|| "write the path of a signal".to_owned())))
            }
        }
    }
}
