//! Declarations of signals, and the error for an unknown path.

use val3_lang::types::BaseType;

use super::signal::Signal;
use super::table::IoTable;

impl IoTable {
    /// Declares the signals of a device in the cell's configuration: the last part of the path, and the type of
    /// variable, `dio` or `aio`. Signals of other types are lines, which are no inputs or outputs.
    pub fn declare_device<'s>(&mut self, device: &str, signals: impl IntoIterator<Item = (&'s str, BaseType)>) {
        let io = |base: &BaseType| matches!(base, BaseType::Dio | BaseType::Aio);
        for (name, base) in signals.into_iter().filter(|(_, base)| io(base)) {
            self.declare(Signal::from_path(&format!("{device}\\{name}"), base == BaseType::Dio));
        }
    }
}

/// No signal has this path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NoSignal(pub String);

impl std::fmt::Display for NoSignal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "no input or output is called `{}`", self.0)
    }
}

impl std::error::Error for NoSignal {}
