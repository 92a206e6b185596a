//! Positions of the application and its libraries in memory, and the names of data that are linked to signals.

use rustc_hash::FxHashMap;
use val3_debug::subscript;
use val3_lang::call::{FrameRef, PointRef, ToolRef};
use val3_lang::memory::{KindBase, LinkPlace, Memory, Place};
use val3_lang::references::{self, Poses};
use val3_lang::types::{Arm, BaseType, fields};
use val3_machine::controller::Controller;
use val3_machine::io::{LinkId, SignalId};

use crate::wire::{CellPoint, JointValue};
use crate::{configuration, coordinates, units};

/// A global value in an application or library.
#[derive(Debug, Clone)]
pub(crate) struct GlobalValue {
    /// Data name, prefixed by the library.
    pub(crate) name: String,
    /// Index or key; `None` for data with a single value.
    pub(crate) key: Option<String>,
    pub(crate) base: BaseType,
    pub(crate) place: Place,
}

impl GlobalValue {
    /// Name with index or key.
    fn whole_name(&self) -> String {
        match &self.key {
            Some(key) => format!("{}[{key}]", self.name),
            None => self.name.clone(),
        }
    }
}

/// Global values of the application and its libraries, for the types that pages display.
pub(crate) fn data(controller: &Controller) -> Vec<GlobalValue> {
    let space = &controller.vm.space;
    let mut found = Vec::new();
    for (number, (_, instance)) in space.loaded().enumerate() {
        let prefix = if number == 0 { String::new() } else { format!("{}:", instance.image.name) };
        for (definition, id) in instance.image.data.iter().zip(instance.data.iter()) {
            let Ok(store) = space.memory.store(*id) else { continue };
            let Some(base) = store.kind.base_type().filter(is_shown) else { continue };
            for index in store.shape.numbers() {
                let Some(key) = subscript(&store.shape, index) else { continue };
                let key = key.strip_prefix('[').and_then(|key| key.strip_suffix(']')).map(str::to_owned);
                let name = prefix.clone() + &definition.name;
                found.push(GlobalValue { name, key, base, place: store.place(*id, index) });
            }
        }
    }
    found
}

fn is_shown(base: &BaseType) -> bool {
    matches!(base, BaseType::Frame | BaseType::Tool | BaseType::Point | BaseType::Joint | BaseType::Dio | BaseType::Aio)
}

/// Names of the data linked to each signal.
pub(crate) fn names_by_signal(data: &[GlobalValue], controller: &Controller) -> FxHashMap<SignalId, Vec<String>> {
    let (memory, io) = (&controller.vm.space.memory, &controller.devices.state.io);
    let mut names: FxHashMap<SignalId, Vec<String>> = FxHashMap::default();
    for datum in data.iter().filter(|datum| matches!(datum.base, BaseType::Dio | BaseType::Aio)) {
        let Ok(LinkPlace::Port(port)) = memory.link(datum.place, 0) else { continue };
        if let Some(id) = io.target_of(LinkId::from_number(port)) {
            names.entry(id).or_default().push(datum.whole_name());
        }
    }
    names
}

/// Name of the tool in memory whose pose on the flange, in mm, satisfies the predicate. The flange itself is also a tool.
pub(crate) fn tool_at(controller: &Controller, is_there: impl Fn(&[f64; 6]) -> bool) -> Option<String> {
    if is_there(&[0.0; 6]) {
        return Some("flange".to_owned());
    }
    let mut poses = units::poses(controller);
    let mut tools = data(controller).into_iter().filter(|datum| datum.base == BaseType::Tool);
    let tool = tools.find(|tool| poses.of_tool(ToolRef(tool.place)).is_ok_and(|pose| is_there(&coordinates(&pose))));
    tool.as_ref().map(GlobalValue::whole_name)
}

/// Computes names and poses of all values. The time per value does not depend on the number of fathers up to `world`.
pub(crate) struct PositionComputer<'a> {
    data: &'a [GlobalValue],
    memory: &'a Memory,
    by_place: FxHashMap<Place, &'a GlobalValue>,
    poses: Poses<'a>,
}

impl<'a> PositionComputer<'a> {
    pub(crate) fn new(data: &'a [GlobalValue], controller: &'a Controller) -> Self {
        let by_place = data.iter().rev().map(|datum| (datum.place, datum)).collect();
        Self { data, memory: &controller.vm.space.memory, by_place, poses: units::poses(controller) }
    }

    /// Values of this type (frames, tools or points) whose pose can be computed.
    pub(crate) fn of_type(&mut self, base: BaseType) -> Vec<CellPoint> {
        let of_base = self.data.iter().filter(|datum| datum.base == base);
        of_base.filter_map(|datum| self.described(datum)).collect()
    }

    fn described(&mut self, datum: &GlobalValue) -> Option<CellPoint> {
        let GlobalValue { name, key, base, place } = datum;
        let memory = self.memory;
        let pose = match base {
            BaseType::Tool => self.poses.of_tool(ToolRef(*place)),
            BaseType::Frame => self.poses.of_frame(FrameRef(*place)),
            _ => self.poses.of_point(PointRef(*place)),
        }
        .ok()?;
        let father = references::reference(memory, *place).ok().flatten();
        let father = father.and_then(|father| self.by_place.get(&father)).map(|father| father.whole_name());
        let config = (*base == BaseType::Point).then(|| configuration(memory, *place));
        Some(CellPoint {
            name: name.clone(),
            key: key.clone(),
            father,
            pose: coordinates(&pose),
            local: nums(memory, *place, 6),
            config,
        })
    }
}

/// Names and values of all joint positions, in the length unit of the application.
pub(crate) fn joints(data: &[GlobalValue], memory: &Memory) -> Vec<JointValue> {
    let joints = data.iter().filter(|datum| datum.base == BaseType::Joint);
    let values = joints.filter_map(|GlobalValue { name, key, place, .. }| {
        let axes = fields(BaseType::Joint, arm_of(memory, *place)).len();
        let values = all_nums(memory, *place)?.into_iter().take(axes).collect();
        Some(JointValue { name: name.clone(), key: key.clone(), values })
    });
    values.collect()
}

/// Configuration of a point as text; empty if the point does not exist.
fn configuration(memory: &Memory, point: Place) -> String {
    let is_scara = is_for_scara(memory, point);
    configuration::of_point(memory, point, is_scara)
        .map_or_else(String::new, |config| configuration::words(&config, is_scara))
}

/// Whether a point or joint position is for a SCARA arm.
pub(crate) fn is_for_scara(memory: &Memory, place: Place) -> bool {
    arm_of(memory, place) == Some(Arm::Scara)
}

/// Arm kind for which the type exists; `None` for a type without one.
fn arm_of(memory: &Memory, place: Place) -> Option<Arm> {
    match memory.store(place.store).ok()?.kind.base {
        KindBase::Builtin(_, arm) => arm,
        _ => None,
    }
}

/// All numbers of a value; `None` if it does not exist.
pub(crate) fn all_nums(memory: &Memory, place: Place) -> Option<Vec<f64>> {
    nums(memory, place, memory.store(place.store).ok()?.kind.size.num)
}

/// First numbers of a value.
pub(crate) fn nums(memory: &Memory, place: Place, count: u32) -> Option<Vec<f64>> {
    (0..count).map(|lane| memory.num(place, lane).ok()).collect()
}
