//! Validation of scripts for a controller: every named variable and signal must exist.

use std::fmt;

use val3_lang::instructions::LIB_LOAD;
use val3_lang::memory::ContainerShape;
use val3_lang::suggest::{proposals, question};
use val3_lang::types::BaseType;
use val3_vm::{Instance, InstanceId};

use super::data_path::{Located, Lost, root};
use super::values::{FaultEntry, Locks, ScriptValue};
use super::{Pending, Script, ScriptEntry, ScriptPlace};
use crate::controller::Controller;
use crate::io::NoSignal;
use crate::io::SignalFault;

/// Part of a script that no controller could execute.
#[derive(Debug, Clone, PartialEq)]
pub struct ScriptFault {
    /// The table of the script.
    pub place: ScriptPlace,
    /// The problem.
    pub misfit: Misfit,
}

impl fmt::Display for ScriptFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.misfit.with_proposals())
    }
}

/// Part in an entry or condition that does not fit the application.
#[derive(Debug, Clone, PartialEq)]
pub struct Misfit {
    /// The problem.
    pub message: String,
    /// Unknown name with the known names; `None` if the name is not the problem.
    pub unknown: Option<(String, Vec<String>)>,
}

impl From<String> for Misfit {
    fn from(message: String) -> Self {
        Self { message, unknown: None }
    }
}

impl Controller {
    /// Returns the parts of a script that name no variable or signal of the application, or that contain an invalid
    /// value. `is_resized` returns whether data of the application change their size, so that an index may become valid
    /// later.
    ///
    /// Data and signals of libraries that are loaded while the application runs are not checked.
    #[must_use]
    pub fn script_faults(&self, script: &Script, is_resized: &dyn Fn(&str) -> bool) -> Vec<ScriptFault> {
        let may_come = self.loads_libraries();
        let scheduled = script.pending.iter().flat_map(|Pending { place, entry, .. }| {
            let faults = self.entry_faults(entry, is_resized, may_come).into_iter();
            faults.map(|misfit| ScriptFault { place: *place, misfit })
        });
        let reactions = script.reactions.iter().flat_map(|reaction| {
            let condition = self.condition_faults(reaction.condition(), is_resized).into_iter();
            let entries = reaction.entries().flat_map(|entry| self.entry_faults(entry, is_resized, may_come));
            let line = reaction.sent().and_then(|text| self.line_misfit(text.link()));
            condition.chain(line).chain(entries).map(|misfit| ScriptFault { place: reaction.place(), misfit })
        });
        let silent = script.silent.iter().filter_map(|link| self.line_misfit(link));
        let silent = silent.map(|misfit| ScriptFault { place: ScriptPlace::Silent, misfit });
        scheduled.chain(reactions).chain(silent).collect()
    }

    /// Problems with an entry's signals and lines that do not exist now.
    pub(super) fn unknown_names(&self, entry: &ScriptEntry) -> Vec<String> {
        let signals = entry.signals().filter_map(|path| self.check_signal(path, false).err());
        let lines = entry.receive.keys().filter_map(|link| self.unknown_line(link, false));
        signals.chain(lines).map(|misfit| misfit.with_proposals()).collect()
    }

    /// Reactions that could not occur until now, because their condition needs a signal, variable or line that does not
    /// exist.
    pub(super) fn unmet_reactions(&self, script: &Script) -> Vec<ScriptFault> {
        let unmet = script.reactions.iter().flat_map(|reaction| {
            let condition = self.misfits(reaction.condition(), &|_| true, false).into_iter();
            let line = reaction.sent().and_then(|text| self.unknown_line(text.link(), false));
            condition.chain(line).map(|misfit| ScriptFault { place: reaction.place(), misfit })
        });
        unmet.collect()
    }

    /// Faults in an entry. `may_come` states whether a library may add devices that do not exist yet.
    pub(super) fn entry_faults(
        &self,
        entry: &ScriptEntry,
        is_resized: &dyn Fn(&str) -> bool,
        may_come: bool,
    ) -> Vec<Misfit> {
        let variables = entry.set.iter().filter_map(|(name, value)| {
            let checked = self.check_variable(name, is_resized, |base| value.suits(base));
            checked.err()
        });
        let signals = entry.signals().filter_map(|path| self.check_signal(path, may_come).err());
        let failing = entry.fault.iter().filter_map(|fault| self.check_fault(fault, may_come).err());
        let lines = entry.receive.keys().filter_map(|link| self.unknown_line(link, may_come));
        let clicked = entry.click.iter().filter_map(|element| self.check_element(element).err());
        let parts = self.part_faults(entry);
        variables.chain(signals).chain(failing).chain(lines).chain(clicked).chain(parts).collect()
    }

    /// Checks that an HTML page has an element whose click executes a program.
    fn check_element(&self, element: &str) -> Result<(), Misfit> {
        let pages = self.devices.state.pendant.html_pages();
        if pages.iter().any(|page| page.clicked(element).next().is_some()) {
            return Ok(());
        }
        let callbacks = pages.iter().flat_map(|page| &page.callbacks).filter(|callback| callback.event == "click");
        let known = callbacks.map(|callback| callback.element.clone()).collect();
        let message = format!("no page executes a program by a click on `{element}`");
        Err(Misfit { message, unknown: Some((element.to_owned(), known)) })
    }

    /// Checks that a global variable exists and has a type that `suits`.
    pub(super) fn check_variable(
        &self,
        name: &str,
        is_resized: &dyn Fn(&str) -> bool,
        suits: impl Fn(BaseType) -> bool,
    ) -> Result<(), Misfit> {
        let variable = root(name);
        if let Some((alias, _)) = variable.split_once(':')
            && self.awaits_library(alias)
        {
            return Ok(());
        }
        let Located { store, container, index, base, .. } = match self.locate(name) {
            Ok(located) => located,
            Err(Lost::Variable(unknown)) => return Err(Misfit::no_variable(name, unknown, self.variables(unknown))),
            Err(Lost::Field(unknown, known)) => return Err(Misfit::no_variable(name, unknown, known)),
            Err(Lost::Index(_, index)) if is_resized(variable) && index.is_some_and(is_index) => return Ok(()),
            Err(Lost::Index(container, _)) => {
                return Err(format!("there is no variable `{name}`: `{container}` does not have this index").into());
            }
        };
        let found = self.vm.space.memory.store(store);
        let found = found.map_err(|_| Misfit::no_variable(name, variable, Vec::new()))?;
        if !base.is_some_and(suits) {
            let ty = base.map_or("a user type", BaseType::name);
            let of = if name.contains('.') { name } else { container };
            return Err(format!("`{of}` is of type {ty} and does not take this value").into());
        }
        let may_exist = match &found.shape {
            ContainerShape::Collection(_) => index.is_some(),
            ContainerShape::Array { .. } => is_resized(variable) && index.is_some_and(is_index),
        };
        if may_exist || found.number_of_text(index.unwrap_or("0")).is_some() {
            return Ok(());
        }
        Err(match index {
            Some(_) => format!("there is no variable `{name}`: `{container}` does not have this index").into(),
            None => format!("`{container}` is a collection: name one of its keys, as in `{container}[\"key\"]`").into(),
        })
    }

    /// Possible names for an unknown name: data of the application, or of the library before the colon.
    fn variables(&self, name: &str) -> Vec<String> {
        let own = self.vm.space.instance(self.application());
        let (instance, prefix) = match name.split_once(':') {
            Some((alias, _)) => (self.library(alias), format!("{alias}:")),
            None => (own, String::new()),
        };
        let data = instance.into_iter().flat_map(|instance| &instance.image.data);
        data.map(|data| format!("{prefix}{}", data.name)).collect()
    }

    /// Names of the application's frames and tools.
    #[must_use]
    pub fn carrier_names(&self) -> Vec<String> {
        self.variables("").into_iter().filter(|name| self.carrier_kind(name).is_some()).collect()
    }

    /// Returns the problem if there is no such signal, and no library can add it.
    pub(crate) fn signal_misfit(&self, path: &str) -> Option<Misfit> {
        self.check_signal(path, self.loads_libraries()).err()
    }

    pub(super) fn check_signal(&self, path: &str, may_come: bool) -> Result<(), Misfit> {
        let io = &self.devices.state.io;
        let may_exist = may_come && !io.is_configured(path);
        if may_exist || io.find(path).is_some() {
            return Ok(());
        }
        let paths = io.signals().filter_map(|id| io.signal(id)).map(|signal| signal.path.clone());
        let known = paths.chain(io.names().map(str::to_owned)).collect();
        Err(Misfit { message: NoSignal(path.to_owned()).to_string(), unknown: Some((path.to_owned(), known)) })
    }

    /// Checks the device or signal that fails. A device may fail although the application does not use its signals.
    fn check_fault(&self, FaultEntry { link, code }: &FaultEntry, may_come: bool) -> Result<(), Misfit> {
        let io = &self.devices.state.io;
        let is_of_known_device = link.split_once('\\').is_some_and(|(device, _)| io.has_device(device));
        if io.has_device(link) || io.find(link).is_none() && !is_of_known_device {
            return Ok(());
        }
        self.check_signal(link, may_come)?;
        let known = *code == 0 || i8::try_from(*code).ok().and_then(SignalFault::from_number).is_some();
        if known { Ok(()) } else { Err(super::apply::no_fault(link, *code).into()) }
    }

    /// Whether the identifier is declared, and no library is loaded under it yet.
    fn awaits_library(&self, alias: &str) -> bool {
        let own = self.vm.space.instance(self.application());
        let declares = |image: &val3_bytecode::Image| image.libraries.iter().any(|library| library.alias == alias);
        own.is_some_and(|own| declares(&own.image)) && self.library(alias).is_none()
    }

    /// The application and the libraries in memory.
    fn instances(&self) -> impl Iterator<Item = &Instance> {
        (0u16..).map_while(|number| self.vm.space.instance(InstanceId(number)))
    }

    /// Returns the problem if the name is not a program's name.
    #[must_use]
    pub fn program_misfit(&self, name: &str) -> Option<Misfit> {
        let programs = || self.instances().flat_map(|instance| &instance.image.programs).map(|program| &program.name);
        if self.loads_libraries() || programs().any(|known| known == name) {
            return None;
        }
        let unknown = Some((name.to_owned(), programs().cloned().collect()));
        Some(Misfit { message: format!("there is no program `{name}`"), unknown })
    }

    /// Returns the problem if the text is not the link of a serial line or socket.
    #[must_use]
    pub fn line_misfit(&self, link: &str) -> Option<Misfit> {
        self.unknown_line(link, self.loads_libraries())
    }

    /// Like [`line_misfit`](Self::line_misfit). `may_come` states whether a library may add lines that do not exist
    /// yet.
    pub(super) fn unknown_line(&self, link: &str, may_come: bool) -> Option<Misfit> {
        let lines = &self.devices.lines;
        if may_come || lines.has(link) {
            return None;
        }
        let unknown = Some((link.to_owned(), lines.links().map(str::to_owned).collect()));
        Some(Misfit { message: format!("there is no serial line or socket `{link}`"), unknown })
    }

    /// Whether libraries are loaded while the application runs, with variables that name further signals.
    pub(super) fn loads_libraries(&self) -> bool {
        let mut programs = self.instances().flat_map(|instance| &instance.image.programs);
        programs.any(|program| program.instructions.iter().any(|site| site.callee.name() == LIB_LOAD))
    }
}

impl Misfit {
    /// The problem that no variable has this name, because its part `unknown` is none of the known names.
    fn no_variable(name: &str, unknown: &str, known: Vec<String>) -> Self {
        Self { message: format!("there is no variable `{name}`"), unknown: Some((unknown.to_owned(), known)) }
    }

    /// Returns the problem with the probable names for an unknown name.
    #[must_use]
    pub fn with_proposals(&self) -> String {
        match self.question() {
            Some(question) => format!("{}; {question}", self.message),
            None => self.message.clone(),
        }
    }

    /// The most probable name for an unknown name.
    pub(crate) fn proposal(&self) -> Option<String> {
        let (name, known) = self.unknown.as_ref()?;
        proposals(name, known.iter().map(String::as_str)).first().map(|&name| name.to_owned())
    }

    /// Returns the question whether another name was meant.
    fn question(&self) -> Option<String> {
        let (name, known) = self.unknown.as_ref()?;
        question(proposals(name, known.iter().map(String::as_str)))
    }
}

impl ScriptEntry {
    /// Paths of all signals that have to exist.
    fn signals(&self) -> impl Iterator<Item = &str> {
        let (held, locked) = match &self.lock {
            Locks::AsIs(links) => (links.all(), None),
            Locks::At(levels) => (&[][..], Some(levels.keys())),
        };
        let listed = held.iter().chain(self.unlock.all());
        let keys = self.io.keys().chain(locked.into_iter().flatten()).chain(self.simulate.keys());
        listed.chain(keys).chain(self.protect.keys()).map(String::as_str)
    }
}

impl ScriptValue {
    /// Whether a variable of this type accepts the value.
    pub(super) fn suits(&self, base: BaseType) -> bool {
        matches!(
            (self, base),
            (Self::Num(_), BaseType::Num) | (Self::Bool(_), BaseType::Bool) | (Self::Text(_), BaseType::String)
        )
    }
}

/// Whether the text is an index: whole numbers with commas between them.
fn is_index(text: &str) -> bool {
    text.split(',').all(|part| part.trim().parse::<u32>().is_ok())
}
