//! Numbers of watched data, for plots over time.

use std::sync::Arc;

use val3_lang::memory::{ContainerShape, KindBase, Lanes, Memory, Place, ValueType, field_offset};
use val3_lang::types::{self, Arm, BaseType, LengthUnit, NumberUnit};
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_machine::io;

use super::{NestingStep, ValueLocation, WatchedData, WatchedRoot};
use crate::values;

/// Type of watched data, and the numbers in each value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataForm {
    /// Type, including array sizes: `point[4]`. Inputs and outputs of the cell are `dio` or `aio`.
    pub type_name: String,
    /// Unit of the lengths.
    pub length_unit: LengthUnit,
    /// Numbers of a value; empty for strings, arrays, collections and user types.
    pub series: Vec<NumberSeries>,
}

/// A number in each value: the value itself, a joint axis, or a position's coordinate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NumberSeries {
    /// Field name, for example `j1` or `rx`; empty for the value itself.
    pub name: &'static str,
    /// Unit.
    pub unit: NumberUnit,
    /// Whether the number is 0 or 1 because the value is a `bool` or a digital input or output.
    pub is_digital: bool,
}

/// Location of a number relative to its value.
struct NumberPlace {
    series: NumberSeries,
    offset: Lanes,
    base: BaseType,
}

impl NumberPlace {
    /// Creates the location for a value that is itself a number.
    fn of_value(base: BaseType, unit: NumberUnit) -> Self {
        let is_digital = matches!(base, BaseType::Bool | BaseType::Dio);
        Self { series: NumberSeries { name: "", unit, is_digital }, offset: Lanes::default(), base }
    }
}

impl WatchedData {
    /// Returns the type and the numbers; `None` while the data are not in memory.
    pub(crate) fn form(&self, controller: &mut Controller) -> Option<DataForm> {
        let length_unit = controller.length_unit();
        if let WatchedRoot::Signal(signal) = &self.root {
            let signal = controller.devices.state.io.signal(*signal)?;
            let is_digital = matches!(signal.kind, io::SignalKind::Digital);
            let type_name = if is_digital { BaseType::Dio } else { BaseType::Aio }.name().to_owned();
            let series = vec![NumberSeries { name: "", unit: NumberUnit::None, is_digital }];
            return Some(DataForm { type_name, length_unit, series });
        }
        let unit = self.unit(controller);
        self.look(controller, |memory, _, found| {
            let type_name = match &found {
                ValueLocation::One(kind, _) => values::type_name(kind),
                ValueLocation::All(view) => values::type_of_all(memory, *view)?,
            };
            let places = single(memory, found).map_or_else(Vec::new, |(kind, _)| number_places(&kind, unit));
            Some(DataForm { type_name, length_unit, series: places.into_iter().map(|place| place.series).collect() })
        })
    }

    /// Returns the present numbers in the order of [`DataForm::series`]. A number is `None` if the signal of an input or
    /// output cannot be read, or if it is not finite.
    pub(crate) fn numbers(&self, controller: &mut Controller) -> Vec<Option<f64>> {
        if let WatchedRoot::Signal(signal) = &self.root {
            return vec![finite(controller.devices.state.io.image(*signal))];
        }
        let numbers = self.look(controller, |memory, devices, found| {
            let (kind, place) = single(memory, found)?;
            Some(numbers_of(memory, devices, &kind, place))
        });
        numbers.unwrap_or_default()
    }

    /// Returns the unit of a field of a built-in type, such as `pPick.trsf.x`.
    fn unit(&self, controller: &mut Controller) -> NumberUnit {
        let Some((NestingStep::Field(name), before)) = self.steps.split_last() else { return NumberUnit::None };
        let parent = Self { steps: before.to_vec(), ..self.clone() };
        let unit = parent.look(controller, |memory, _, found| match single(memory, found)?.0.base {
            KindBase::Builtin(base, arm) => Some(types::field(base, arm, name)?.unit),
            KindBase::User(_) => None,
        });
        unit.unwrap_or(NumberUnit::None)
    }
}

/// Returns the numbers in values of a type.
pub(super) fn series_of(kind: &ValueType) -> Vec<NumberSeries> {
    number_places(kind, NumberUnit::None).into_iter().map(|place| place.series).collect()
}

/// Reads the numbers of a value, in the order of [`series_of`]. A number is `None` if the signal of an input or output
/// cannot be read, or if it is not finite.
pub(super) fn numbers_of(memory: &Memory, devices: &Devices, kind: &ValueType, place: Place) -> Vec<Option<f64>> {
    let read = |number: NumberPlace| finite(read(memory, devices, number.base, place.after(number.offset)));
    number_places(kind, NumberUnit::None).into_iter().map(read).collect()
}

/// Returns the only value at a location; `None` for several values and for collections.
fn single(memory: &Memory, found: ValueLocation) -> Option<(Arc<ValueType>, Place)> {
    match found {
        ValueLocation::One(kind, place) => Some((kind, place)),
        ValueLocation::All(view) => {
            let store = memory.store(view.store).ok()?;
            let is_single = matches!(store.shape, ContainerShape::Array { .. }) && memory.len(view) == Ok(1);
            let place = memory.element(view, 0).ok().filter(|_| is_single)?;
            Some((Arc::clone(&store.kind), place))
        }
    }
}

/// Returns the numbers in values of a type. `unit` is the unit of a value that is itself a number.
fn number_places(kind: &ValueType, unit: NumberUnit) -> Vec<NumberPlace> {
    let KindBase::Builtin(base, arm) = kind.base else { return Vec::new() };
    match base {
        BaseType::Num => vec![NumberPlace::of_value(base, unit)],
        BaseType::Aio | BaseType::Bool | BaseType::Dio => vec![NumberPlace::of_value(base, NumberUnit::None)],
        _ => fields(base, arm, Lanes::default()),
    }
}

/// Returns the numbers in the fields of a structured type, also in nested fields: a point contains the numbers of `trsf`.
fn fields(base: BaseType, arm: Option<Arm>, start: Lanes) -> Vec<NumberPlace> {
    let numbers = types::fields(base, arm).iter().flat_map(|field| {
        let Some(offset) = field_offset(base, arm, field.name).map(|offset| start + offset) else { return Vec::new() };
        match field.ty {
            BaseType::Num => {
                let series = NumberSeries { name: field.name, unit: field.unit, is_digital: false };
                vec![NumberPlace { series, offset, base: BaseType::Num }]
            }
            BaseType::Trsf => fields(BaseType::Trsf, arm, offset),
            _ => Vec::new(),
        }
    });
    numbers.collect()
}

fn read(memory: &Memory, devices: &Devices, base: BaseType, place: Place) -> Option<f64> {
    use val3_lang::memory::LinkPlace::Port;
    match base {
        BaseType::Dio => match memory.link(place, 0).ok()? {
            Port(port) => devices.digital(port).ok().map(f64::from),
            _ => None,
        },
        BaseType::Aio => match memory.link(place, 0).ok()? {
            Port(port) => devices.analog(port).ok(),
            _ => None,
        },
        _ => memory.num(place, 0).ok(),
    }
}

fn finite(number: Option<f64>) -> Option<f64> {
    number.filter(|number| number.is_finite())
}
