//! Values of signals and global data: the keys `io` and `data`.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_machine::controller::Controller;
use val3_machine::event::shown_seconds;
use val3_machine::script::{Comparison, Condition, LevelComparison};

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

impl ExpectedValues {
    fn new<T, E: Error>(
        values: BTreeMap<Spanned<String>, T>,
        condition: fn(String, T) -> Result<Condition, String>,
    ) -> Result<Self, E> {
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
            let mismatch = controller.mismatches(condition).into_iter().next()?;
            let places = vec![source.place(key, span.clone())];
            Some(Failure { message: format!("{mismatch}, at {now} s"), places })
        });
        failures.collect()
    }
}
