//! Fathers of points, frames and tools, by their names.

use val3_lang::memory::{LinkPlace, Memory, Place};
use val3_lang::references;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;

use super::lookup::frame_named;
use crate::positions::{self, GlobalValue};
use crate::wire::{CommandError, FrameName, PointName};

/// Name of the frame that exists in every application.
const WORLD: &str = "world";

/// Place of the frame that a command names as the new father of a point.
pub(super) fn of_command(
    FrameName { name, key }: FrameName,
    point: &GlobalValue,
    controller: &Controller,
) -> Result<Place, CommandError> {
    if point.base != BaseType::Point {
        return Err(CommandError(format!("`{}` is no point, so it has no frame", point.name)));
    }
    if name == WORLD {
        return world(controller).ok_or_else(|| "`world` does not exist".into());
    }
    frame_named(&name, key, controller).map(|frame| frame.place)
}

/// Name of the father of a value; `None` if it has none that is named.
pub(super) fn name_of(datum: &GlobalValue, controller: &Controller) -> Option<PointName> {
    let father = references::reference(&controller.vm.space.memory, datum.place).ok().flatten()?;
    if Some(father) == world(controller) {
        return Some(PointName { name: WORLD.to_owned(), key: None });
    }
    let found = positions::data(controller).into_iter().find(|datum| is_frame(datum) && datum.place == father)?;
    Some(PointName { name: found.name, key: found.key })
}

/// Gives a value the father with this name.
///
/// # Errors
/// The father does not exist any more, or the value cannot refer to it.
pub(super) fn set(datum: &GlobalValue, father: &PointName, controller: &mut Controller) -> Result<(), CommandError> {
    let place = match (father.name.as_str(), &father.key) {
        (WORLD, None) => world(controller),
        (name, key) => {
            let mut frames = positions::data(controller).into_iter().filter(is_frame);
            frames.find(|frame| frame.name == name && frame.key == *key).map(|frame| frame.place)
        }
    };
    let place = place.ok_or_else(|| CommandError(format!("the frame `{}` does not exist any more", father.name)))?;
    link(datum, place, controller)
}

/// Links a value to its new father, as the instruction `link` does.
pub(super) fn link(datum: &GlobalValue, father: Place, controller: &mut Controller) -> Result<(), CommandError> {
    let linked = controller.vm.space.memory.set_link(datum.place, 0, LinkPlace::Data(father));
    linked.map_err(|fault| CommandError(format!("`{}` cannot refer to the frame (error {})", datum.name, fault.0)))
}

fn is_frame(datum: &GlobalValue) -> bool {
    datum.base == BaseType::Frame
}

fn world(controller: &Controller) -> Option<Place> {
    let memory = &controller.vm.space.memory;
    memory.store(Memory::WORLD).ok().map(|store| store.place(Memory::WORLD, 0))
}
