//! Writes values that operators have changed into memory.

use val3_machine::controller::Controller;

use crate::positions::GlobalValue;
use crate::wire::CommandError;

/// Writes the numbers of a value, by lane.
pub(super) fn write(
    datum: &GlobalValue,
    numbers: impl IntoIterator<Item = (u32, f64)>,
    controller: &mut Controller,
) -> Result<(), CommandError> {
    let memory = &mut controller.vm.space.memory;
    let written = numbers.into_iter().try_for_each(|(lane, number)| memory.set_num(datum.place, lane, number));
    written.map_err(|fault| CommandError(format!("`{}` cannot be changed (error {})", datum.name, fault.0)))
}
