//! Evaluation and validation of conditions on a controller.

use std::fmt;

use val3_lang::call::StoredValue;
use val3_lang::types::BaseType;
use val3_lang::values::Text;

use super::super::check::Misfit;
use super::{Comparison, Condition, ConditionPart, Subject};
use crate::controller::Controller;
use crate::io::SignalKind;
use crate::script::ScriptValue;

/// A signal or variable that does not have its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Mismatch {
    /// Path or name.
    pub name: String,
    /// The value that it should have: `3`, `"bolt"`, `above 2 and below 5`.
    pub expected: String,
    /// Value; `None` if the signal or variable does not exist.
    pub actual: Option<ScriptValue>,
    /// Word for the state of a sensor or part, in place of true.
    participle: Option<&'static str>,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.actual, self.participle) {
            (Some(ScriptValue::Bool(holds)), Some(word)) => {
                write!(f, "`{}` is {}{word}", self.name, if *holds { "" } else { "not " })
            }
            (Some(actual), _) => write!(f, "`{}` is {actual}, not {}", self.name, self.expected),
            (None, _) => write!(f, "`{}` does not exist, so it is not {}", self.name, self.expected),
        }
    }
}

impl Controller {
    /// Whether all signals and variables of a condition have their values.
    #[must_use]
    pub fn meets(&self, condition: &Condition) -> bool {
        condition.parts.iter().all(|ConditionPart { subject, comparison }| {
            let value = self.value_of(subject);
            value.is_some_and(|value| comparison.accepts(&value))
        })
    }

    /// The signals and variables of a condition that do not have their values: signals, then variables, by name.
    #[must_use]
    pub fn mismatches(&self, condition: &Condition) -> Vec<Mismatch> {
        let mismatches = condition.parts.iter().filter_map(|ConditionPart { subject, comparison }| {
            let actual = self.value_of(subject);
            let differs = actual.as_ref().is_none_or(|actual| !comparison.accepts(actual));
            let (name, expected, participle) =
                (subject.name().to_owned(), comparison.to_string(), subject.participle());
            differs.then_some(Mismatch { name, expected, actual, participle })
        });
        mismatches.collect()
    }

    /// The parts of a condition that name no variable or no signal of the application, or compare it with a value of
    /// another type. `is_resized` returns whether data of the application change their size, so that an index may
    /// become valid later.
    ///
    /// Data and signals of libraries that are loaded while the application runs are not checked.
    #[must_use]
    pub fn condition_faults(&self, condition: &Condition, is_resized: &dyn Fn(&str) -> bool) -> Vec<Misfit> {
        self.misfits(condition, is_resized, self.loads_libraries())
    }

    /// As [`condition_faults`](Self::condition_faults). `may_come` states whether a library may add signals that do not
    /// exist yet.
    pub(in crate::script) fn misfits(
        &self,
        condition: &Condition,
        is_resized: &dyn Fn(&str) -> bool,
        may_come: bool,
    ) -> Vec<Misfit> {
        let misfits = condition.parts.iter().filter_map(|ConditionPart { subject, comparison }| match subject {
            Subject::Signal(path) => self.check_level(path, comparison, may_come).err(),
            Subject::Variable(name) => self.check_variable(name, is_resized, |base| comparison.suits(base)).err(),
            Subject::Sensor(name) => self.sensor_misfit(name),
            Subject::Part(name) => self.part_misfit(name),
        });
        misfits.collect()
    }

    fn check_level(&self, path: &str, comparison: &Comparison, may_come: bool) -> Result<(), Misfit> {
        self.check_signal(path, may_come)?;
        let io = &self.devices.state.io;
        let kind = io.find(path).and_then(|id| io.signal(id)).map(|signal| signal.kind);
        let is_truth = matches!(comparison, Comparison::Is(ScriptValue::Bool(_)));
        match kind {
            Some(SignalKind::Digital) if !is_truth => {
                Err(format!("`{path}` is digital: compare it with true or false").into())
            }
            Some(SignalKind::Analog(_)) if is_truth => {
                Err(format!("`{path}` is analog: compare it with a number or a range").into())
            }
            _ => Ok(()),
        }
    }

    fn value_of(&self, subject: &Subject) -> Option<ScriptValue> {
        match subject {
            Subject::Signal(path) => self.level(path),
            Subject::Variable(name) => self.variable_value(name),
            Subject::Sensor(name) => self.is_seen(name).map(ScriptValue::Bool),
            Subject::Part(name) => self.is_held(name).map(ScriptValue::Bool),
        }
    }

    fn level(&self, path: &str) -> Option<ScriptValue> {
        let io = &self.devices.state.io;
        let id = io.find(path)?;
        let value = io.hardware(id)?;
        Some(match io.signal(id)?.kind {
            SignalKind::Digital => ScriptValue::Bool(value != 0.0),
            SignalKind::Analog(_) => ScriptValue::Num(value),
        })
    }

    fn variable_value(&self, name: &str) -> Option<ScriptValue> {
        let (place, base) = self.variable(name)?;
        let memory = &self.vm.space.memory;
        match base {
            BaseType::Num => f64::read(memory, place).ok().map(ScriptValue::Num),
            BaseType::Bool => bool::read(memory, place).ok().map(ScriptValue::Bool),
            BaseType::String => Text::read(memory, place).ok().map(|text| ScriptValue::Text(text.as_str().to_owned())),
            _ => None,
        }
    }
}
