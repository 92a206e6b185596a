//! Applies the entries of a script to a controller.

use val3_lang::call::StoredValue;
use val3_lang::memory::{LinkPlace, StoreId};
use val3_lang::ports::Time;
use val3_lang::types::BaseType;
use val3_lang::values::number_text::shown;
use val3_lang::values::{Text, printed};
use val3_motion::ExternalForce;
use val3_vm::Instance;

use super::reaction::Reaction;
use super::values::{FaultEntry, Force, Locks, ScriptValue};
use super::{Misfit, Pending, Script, ScriptAction, ScriptEntry};
use crate::arm::RobotArm;
use crate::controller::Controller;
use crate::controller_state::MessageSeverity;
use crate::devices::DeviceState;
use crate::event::EventKind;
use crate::io::{IoTable, SignalFault, SignalId};

impl Controller {
    /// Sets the script, in place of the previous script. It becomes the other end of the lines that it sends to.
    pub fn follow(&mut self, script: Script) {
        script.lines().for_each(|link| self.devices.lines.connect_script(link));
        self.script = script;
    }

    /// Links of the serial lines and sockets whose other end is the script.
    pub fn script_lines(&self) -> impl Iterator<Item = &str> {
        self.script.lines()
    }

    /// Evaluates the conditions of reactions before the first cycle.
    pub(crate) fn begin_reactions(&mut self, now: Time) {
        if !self.script.has_begun {
            self.react(now);
        }
    }

    /// Evaluates the conditions of reactions after a cycle, when outputs are at their terminals. Only cycles change
    /// signals and data, so nothing has to be evaluated in skipped time.
    ///
    /// Entries without delay are applied at the beginning of the next cycle, so reactions that cause each other need
    /// one cycle each.
    pub(crate) fn react(&mut self, now: Time) {
        let holding: Vec<bool> = self.script.reactions().map(|reaction| self.triggers(reaction)).collect();
        self.script.react(&holding, now);
        self.devices.lines.forget_output();
    }

    /// Whether the signals, variables and sent text of a reaction hold.
    fn triggers(&self, reaction: &Reaction) -> bool {
        self.meets(reaction.condition())
            && reaction.sent().is_none_or(|text| text.is_in(self.devices.lines.output(text.link())))
    }

    /// Applies the script entries that are due. An entry without effect is an error in the event log.
    pub(crate) fn follow_script(&mut self, now: Time) {
        while let Some(Pending { place, entry, .. }) = self.script.take_due(now) {
            for problem in self.apply(&entry, now) {
                let text = format!("script, {place}: {problem}");
                self.devices.report(&text, MessageSeverity::Error, now);
                self.script.problems.push(text);
            }
        }
    }

    /// The entries that had no effect so far, and the reactions whose signals, variables or lines do not exist.
    #[must_use]
    pub fn script_problems(&self) -> Vec<String> {
        let unmet = self.unmet_reactions(&self.script).into_iter().map(|fault| format!("script, {fault}"));
        self.script.problems.iter().cloned().chain(unmet).collect()
    }

    /// Reports reactions whose signals, variables or lines do not exist, at the end of a run.
    pub fn report_unmet_reactions(&mut self) {
        for fault in self.unmet_reactions(&self.script) {
            self.devices.report(&format!("script, {fault}"), MessageSeverity::Error, self.now());
        }
    }

    /// Executes an external action now. Inputs have their new values from the next cycle on.
    ///
    /// # Errors
    /// The problems. The action has no effect if a variable or signal does not exist.
    pub fn act(&mut self, ScriptAction(entry): &ScriptAction) -> Result<(), Vec<String>> {
        let faults = self.entry_faults(entry, &|_| false, false);
        let problems = match faults.is_empty() {
            true => self.apply(entry, self.now()),
            false => faults.iter().map(Misfit::with_proposals).collect(),
        };
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    /// Applies an entry, and returns the problems with it.
    fn apply(&mut self, entry: &ScriptEntry, now: Time) -> Vec<String> {
        self.devices.record_outside(now, EventKind::Act { keys: entry.keys() });
        let mut problems = self.unknown_names(entry);
        entry.io.keys().for_each(|path| self.note_script_input(path, now));
        problems.extend(entry.apply_io(&mut self.devices.state.io));
        problems.extend(self.apply_parts(entry, now));
        for (name, value) in &entry.set {
            problems.extend(self.set(name, value).err());
        }
        entry.apply_robot(&mut self.devices.state, now);
        problems.extend(entry.apply_arm(&mut self.devices.state.arm));
        if let Some(key) = &entry.key {
            self.devices.state.pendant.tap(key.0, now);
        }
        if let Some(keys) = &entry.keys {
            self.devices.state.pendant.type_on_request(keys.0.iter().copied());
        }
        if let Some(element) = &entry.click {
            problems.extend(self.click(element).err());
        }
        let lines = &self.devices.lines;
        let known: Vec<_> = entry.receive.iter().filter(|(link, _)| lines.has(link)).collect();
        for (link, bytes) in known {
            problems.extend(self.devices.lines.receive_from_script(link, bytes.as_slice()).err());
        }
        if entry.stop {
            self.stop();
        }
        problems
    }

    /// Sets a global variable.
    fn set(&mut self, name: &str, value: &ScriptValue) -> Result<(), String> {
        let (place, base) = self.variable(name).ok_or_else(|| format!("there is no variable `{name}`"))?;
        let memory = &mut self.vm.space.memory;
        let set = match (value, base) {
            (ScriptValue::Num(number), BaseType::Num) => number.write(memory, place),
            (ScriptValue::Bool(truth), BaseType::Bool) => truth.write(memory, place),
            (ScriptValue::Text(text), BaseType::String) => Text::from(text.as_str()).write(memory, place),
            _ => return Err(format!("`{name}` is of type {} and does not take this value", base.name())),
        };
        set.map_err(|fault| format!("`{name}`: error {}", fault.0))
    }

    /// Returns the value of a global variable of type `bool`, `num` or `string` as a text; `None` for other data.
    #[must_use]
    pub fn shown_value(&self, name: &str) -> Option<String> {
        let (place, base) = self.variable(name)?;
        let memory = &self.vm.space.memory;
        match base {
            BaseType::Bool => bool::read(memory, place).ok().map(|truth| printed::bool(truth).to_owned()),
            BaseType::Num => f64::read(memory, place).ok().map(|number| shown(number).to_string()),
            BaseType::String => Text::read(memory, place).ok().map(|text| text.to_string()),
            _ => None,
        }
    }

    /// Returns the path of the signal to which a global `dio` or `aio` is linked; `None` for other data, and without a
    /// link.
    #[must_use]
    pub fn linked_signal(&self, name: &str) -> Option<&str> {
        let (place, base) = self.variable(name)?;
        let LinkPlace::Port(port) = self.vm.space.memory.link(place, 0).ok()? else { return None };
        self.devices.port_name(base, port).filter(|_| matches!(base, BaseType::Dio | BaseType::Aio))
    }

    pub(super) fn data(&self, name: &str) -> Option<StoreId> {
        let (instance, name) = match name.split_once(':') {
            None => (self.vm.space.instance(self.application())?, name),
            Some((alias, name)) => (self.library(alias)?, name),
        };
        instance.data.get(usize::from(instance.image.data(name)?)).copied()
    }

    /// The library that is loaded under an identifier of the application.
    pub(super) fn library(&self, alias: &str) -> Option<&Instance> {
        let own = self.vm.space.instance(self.application())?;
        let number = own.image.libraries.iter().position(|library| library.alias == alias)?;
        self.vm.space.instance((*own.libraries.get(number)?)?)
    }
}

/// Message for an invalid fault code of a signal.
pub(super) fn no_fault(link: &str, code: i32) -> String {
    format!("`{link}` fails with -2 or -3 and works again with 0, not with {code}")
}

impl ScriptEntry {
    /// Changes the signals that exist, and returns the problem with a fault.
    fn apply_io(&self, io: &mut IoTable) -> Option<String> {
        for (link, level) in &self.io {
            change(io, link, |io, signal| io.set(signal, level.number()));
        }
        match &self.lock {
            Locks::AsIs(links) => {
                links.all().iter().for_each(|link| change(io, link, |io, signal| io.lock(signal, None)))
            }
            Locks::At(links) => links
                .iter()
                .for_each(|(link, level)| change(io, link, |io, signal| io.lock(signal, Some(level.number())))),
        }
        for link in self.unlock.all() {
            change(io, link, IoTable::unlock);
        }
        for (link, simulated) in &self.simulate {
            change(io, link, |io, signal| io.simulate(signal, *simulated));
        }
        for (link, protected) in &self.protect {
            change(io, link, |io, signal| io.protect(signal, *protected));
        }
        self.fault.as_ref().and_then(|fault| fail(io, fault).err())
    }

    fn apply_robot(&self, state: &mut DeviceState, now: Time) {
        match self.estop {
            Some(true) => state.robot.press_emergency_stop(),
            Some(false) => state.robot.release_emergency_stop(),
            None => {}
        }
        if let Some(fault) = &self.safety_fault {
            state.robot.set_safety_fault(fault.signal());
        }
        if let Some(calibrated) = self.calibrated {
            state.robot.set_calibrated(calibrated);
        }
        if let Some(mode) = self.mode {
            state.robot.set_mode(mode.0, now);
        }
        if let Some(on) = self.power {
            state.robot.set_power(on);
        }
        if let Some(allowed) = self.lets_move {
            state.robot.let_move(allowed);
        }
        if let Some(speed) = self.monitor_speed {
            state.robot.turn_speed(speed.0);
        }
    }

    fn apply_arm(&self, arm: &mut RobotArm) -> Vec<String> {
        let placed = self.joints.map_or(Ok(()), |joints| arm.start_at(joints.0));
        let jogged = self.jog.map_or(Ok(()), |joints| arm.jog(joints.0));
        match self.force {
            Some(Force::Path(force)) => arm.push(ExternalForce::Path(force)),
            Some(Force::World(force)) => arm.push(ExternalForce::World(force.into())),
            None => {}
        }
        if self.connect {
            arm.request_connection();
        }
        [("joints", placed), ("jog", jogged)]
            .into_iter()
            .filter_map(|(key, result)| result.err().map(|violation| format!("{key}: {violation}")))
            .collect()
    }
}

/// Changes a signal if it exists.
fn change(io: &mut IoTable, link: &str, change: impl FnOnce(&mut IoTable, SignalId)) {
    if let Some(signal) = io.find(link) {
        change(io, signal);
    }
}

/// Sets a fault. A path without a signal is a device path; devices have separate fault numbers.
fn fail(io: &mut IoTable, FaultEntry { link, code }: &FaultEntry) -> Result<(), String> {
    let Some(signal) = io.find(link) else {
        io.set_device_fault(link, Some(*code).filter(|code| *code != 0));
        return Ok(());
    };
    let fault = i8::try_from(*code).ok().and_then(SignalFault::from_number);
    if fault.is_none() && *code != 0 {
        return Err(no_fault(link, *code));
    }
    io.set_fault(signal, fault);
    Ok(())
}
