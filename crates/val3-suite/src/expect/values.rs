//! Values of signals and global data, states of sensors and parts: the keys `io`, `data`, `seen` and `held`.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_machine::controller::Controller;
use val3_machine::event::shown_seconds;
use val3_machine::script::{Comparison, Condition, LevelComparison, NamedStates};

use super::filled::NOTHING;
use super::fit::{ExpectationFault, Fit};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Expected values of signals or variables. Each is a condition with the name's source range.
#[derive(Debug, Clone, Default)]
pub(super) struct ExpectedValues(Vec<(Condition, Range<usize>)>);

/// Deserialises signals by path.
pub(super) fn signals<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ExpectedValues, D::Error> {
    let levels: BTreeMap<Spanned<String>, LevelComparison> = Deserialize::deserialize(deserializer)?;
    ExpectedValues::new(levels, |path, level| Condition::new([(path, level)].into(), BTreeMap::new()))
}

/// Deserialises global variables by name.
pub(super) fn variables<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ExpectedValues, D::Error> {
    let comparisons: BTreeMap<Spanned<String>, Comparison> = Deserialize::deserialize(deserializer)?;
    ExpectedValues::new(comparisons, |name, comparison| Condition::new(BTreeMap::new(), [(name, comparison)].into()))
}

/// Deserialises sensors that detect something.
pub(super) fn sensors<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ExpectedValues, D::Error> {
    let states = Spanned::<NamedStates>::deserialize(deserializer)?;
    ExpectedValues::of_cell(states, |seen| Condition::of_cell(seen, NamedStates::default()))
}

/// Deserialises parts that grippers hold.
pub(super) fn parts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ExpectedValues, D::Error> {
    let states = Spanned::<NamedStates>::deserialize(deserializer)?;
    ExpectedValues::of_cell(states, |held| Condition::of_cell(NamedStates::default(), held))
}

impl ExpectedValues {
    fn of_cell<E: Error>(
        states: Spanned<NamedStates>,
        condition: fn(NamedStates) -> Result<Condition, String>,
    ) -> Result<Self, E> {
        let span = states.span();
        Ok(Self(vec![(condition(states.into_inner()).map_err(E::custom)?, span)]))
    }

    fn new<T, E: Error>(
        values: BTreeMap<Spanned<String>, T>,
        condition: fn(String, T) -> Result<Condition, String>,
    ) -> Result<Self, E> {
        if values.is_empty() {
            return Err(E::custom(NOTHING));
        }
        let conditions = values.into_iter().map(|(name, value)| {
            let span = name.span();
            Ok((condition(name.into_inner(), value).map_err(E::custom)?, span))
        });
        conditions.collect::<Result<_, E>>().map(Self)
    }

    /// Whether there are no values.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Unknown names, and values of the wrong type.
    pub(super) fn faults(&self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        self.0.iter().flat_map(|(condition, span)| fit.condition(condition, span)).collect()
    }

    /// Values that differ from the current values.
    pub(super) fn failures(&self, key: &str, controller: &Controller, source: &ExpectationSource) -> Vec<Failure> {
        let now = shown_seconds(controller.now());
        let failures = self.0.iter().filter_map(|(condition, span)| {
            let mismatches = controller.mismatches(condition);
            let places = vec![source.place(key, span.clone())];
            let texts: Vec<String> = mismatches.iter().map(ToString::to_string).collect();
            (!texts.is_empty()).then(|| Failure { message: format!("{}, at {now} s", texts.join("; ")), places })
        });
        failures.collect()
    }
}
